"""An array, and the curvature of its surface."""

import numpy as np
import isolux

z, y, x = np.meshgrid(*[np.linspace(-6, 6, 64)] * 3, indexing="ij")
gyroid = np.sin(x) * np.cos(y) + np.sin(y) * np.cos(z) + np.sin(z) * np.cos(x)
v = isolux.Volume(gyroid.astype(np.float32), spacing=0.5, name="gyroid")
print(v)
v.render(0.0, "gaussian_curvature", (320, 240)).save("python_curvature.png")
