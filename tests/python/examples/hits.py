"""First hits, and how far they may be off."""

import numpy as np
import isolux
import matplotlib.pyplot as plt

axis = np.arange(48) - 23.5
z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
v = isolux.Volume((15 - np.sqrt(x**2 + y**2 + z**2)).astype(np.float32), origin=(-23.5,) * 3)
offset = np.linspace(0, 14.5, 300)
origins = np.stack([offset, 0 * offset, 0 * offset - 40], axis=-1)
hits = v.hits(origins, (0, 0, 1), isovalue=0)
truth = 40 - np.sqrt(15**2 - offset**2)
plt.figure(figsize=(5, 3))
plt.semilogy(offset, np.abs(hits.t - truth), label="error of t")
plt.semilogy(offset, hits.error, label="its bound")
plt.xlabel("distance of the ray from the ball's middle, mm"), plt.ylabel("mm"), plt.legend()
plt.tight_layout()
plt.savefig("python_hits.png", dpi=60)
