"""What accuracy costs in time."""

import isolux
import matplotlib.pyplot as plt

study = isolux.open("phantom:torus:48").study("rate", size=(96, 96), repeat=3)
settings = [s for s in study.knobs[0]["settings"] if not s["comparison"]]
plt.figure(figsize=(5, 3))
plt.loglog([s["frame_milliseconds"] for s in settings], [s["errors"]["depth_mm"]["rms"] for s in settings], "o-")
plt.xlabel("ms of a frame"), plt.ylabel("depth error, mm (root mean square)")
plt.tight_layout()
plt.savefig("python_study.png", dpi=60)
