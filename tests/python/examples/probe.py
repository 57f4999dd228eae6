"""The field at points: curvature against its formula."""

import numpy as np
import isolux
import matplotlib.pyplot as plt

axis = np.arange(64) * 0.5 - 15.75
z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
torus = 4 - np.hypot(np.hypot(x, y) - 9, z)
v = isolux.Volume(torus.astype(np.float32), 0.5, origin=(-15.75,) * 3)
angle = np.linspace(0, 2 * np.pi, 200)
ring = 9 + 4 * np.cos(angle)
points = np.stack([ring, 0 * angle + 0.13, 4 * np.sin(angle)], axis=-1)
found = v.probe(points, settings={"derivatives.field": "cubic_interpolating", "derivatives.scale": 0})
plt.figure(figsize=(5, 3))
plt.plot(angle, found.kappa, ".", markersize=3)
plt.plot(angle, np.cos(angle) / ring, "k", linewidth=0.7), plt.axhline(1 / 4, color="k", linewidth=0.7)
plt.xlabel("angle about the tube"), plt.ylabel("principal curvatures, 1/mm")
plt.tight_layout()
plt.savefig("python_probe.png", dpi=60)
