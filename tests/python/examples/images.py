"""Deferred images: what each pixel knows."""

import numpy as np
import isolux
import matplotlib.pyplot as plt

p = isolux.open("phantom:torus:64").render(size=(200, 150), aovs=["depth", "normal", "kappa"], image=False,
                                           elevation=40, fit="surface", settings={"derivatives.scale": 4})
figure, panels = plt.subplots(1, 3, figsize=(9, 2.4))
for panel, image in zip(panels, (p.aov["depth"], np.nan_to_num(abs(p.aov["normal"])), p.aov["kappa"][..., 1])):
    panel.imshow(image, interpolation="nearest")
    panel.axis("off")
figure.tight_layout()
figure.savefig("python_images.png", dpi=60)
