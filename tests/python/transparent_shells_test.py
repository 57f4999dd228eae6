"""A transparent ball about an opaque one under global illumination, against a path tracer of its own.

A transparent surface is a layer that meets light at the cosine c with the probability 1 - (1 - opacity)^(1/c), and scatters what it
meets back to the side it came from (docs/explanation/surfaces-in-baked-light.md).
"""

import os
import unittest

import numpy as np

import isolux
from support import ball, temporary_folder

OUTER, INNER = 18.0, 10.0  # radii, mm
ALBEDO_OUTER, ALBEDO_INNER = np.array([0.8, 0.6, 0.4]), np.array([0.3, 0.5, 0.8])
SIZE, PATHS, FOV = 96, 128, 30.0
EYE, UP = np.array([0.0, -85.0, 30.0]), np.array([0.0, 0.0, 1.0])


def sky(direction):
    return 1 + 0.9 * direction[:, 2]


def write_sky(path, rows=64):
    """The same as an equirectangular map, RGBE."""
    elevation = np.pi / 2 - (np.arange(rows) + 0.5) / rows * np.pi
    mantissa, exponent = np.frexp(np.repeat(1 + 0.9 * np.sin(elevation), 2 * rows))
    texels = np.stack([(256 * mantissa).astype(np.uint8)] * 3 + [(exponent + 128).astype(np.uint8)], -1)
    with open(path, "wb") as file:
        file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (rows, 2 * rows) + texels.tobytes())


def distance_to(origin, direction, radius):
    b, c = (origin * direction).sum(1), (origin * origin).sum(1) - radius * radius
    root = np.sqrt(np.maximum(b * b - c, 0))
    t = np.where(-b - root > 1e-6, -b - root, -b + root)
    return np.where((b * b > c) & (t > 1e-6), t, np.inf)


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def path_traced(opacity, random):
    """Mean radiance of each pixel; what no surface scatters is black."""
    forward = unit(-EYE)
    right = unit(np.cross(forward, UP))
    above, half = np.cross(right, forward), np.tan(np.radians(FOV / 2))
    row, column = np.mgrid[0:SIZE, 0:SIZE].reshape(2, -1)
    image = np.zeros((SIZE * SIZE, 3))
    for _ in range(PATHS):
        x = (2 * (column + random.random(SIZE * SIZE)) / SIZE - 1) * half
        y = (1 - 2 * (row + random.random(SIZE * SIZE)) / SIZE) * half
        d = unit(forward + x[:, None] * right + y[:, None] * above)
        p, pixel = np.tile(EYE, (len(d), 1)), np.arange(len(d))
        weight, scattered = np.ones((len(d), 3)), np.zeros(len(d), bool)
        while len(d):
            outer, inner = distance_to(p, d, OUTER), distance_to(p, d, INNER)
            t, leaves = np.minimum(outer, inner), np.isinf(np.minimum(outer, inner))
            image[pixel[leaves]] += weight[leaves] * (sky(d[leaves]) * scattered[leaves])[:, None]
            p, d, weight, pixel, scattered, outer, inner, t = (
                of[~leaves] for of in (p, d, weight, pixel, scattered, outer, inner, t))
            p = p + t[:, None] * d
            shell, normal = outer < inner, unit(p)
            cosine = (normal * d).sum(1)
            layer = 1 - (1 - opacity) ** (1 / np.maximum(np.abs(cosine), 1e-9))
            meets = random.random(len(d)) < np.where(shell, layer, 1)
            side = -np.sign(cosine)[:, None] * normal
            weight = np.where(meets[:, None], weight * np.where(shell[:, None], ALBEDO_OUTER, ALBEDO_INNER), weight)
            d = np.where(meets[:, None], unit(side + unit(random.normal(size=p.shape))), d)
            scattered = scattered | meets
    return image.reshape(SIZE, SIZE, 3) / PATHS


class AsPathsHaveIt(unittest.TestCase):
    def test_shell_and_what_it_encloses(self):
        volume = isolux.Volume(ball(49, OUTER), spacing=(1, 1, 1), origin=(-24, -24, -24))
        with temporary_folder() as folder:
            environment = os.path.join(folder, "sky.hdr")
            write_sky(environment)
            for opacity, most in ((0.3, 0.1), (0.6, 0.07), (0.9, 0.015)):
                with self.subTest(opacity):
                    picture = volume.render(
                        0.0, "gi", (SIZE, SIZE), (tuple(EYE), (0, 0, 0), tuple(UP), FOV), environment=environment, linear=True,
                        settings={"picture.exposure": 0.0, "picture.curve": "linear", "isosurface.opacity": opacity,
                                  "isosurface.albedo": list(ALBEDO_OUTER), "isosurface2.shown": True,
                                  "isosurface2.value": OUTER - INNER, "isosurface2.albedo": list(ALBEDO_INNER),
                                  "look.background_top": [0, 0, 0], "look.background_bottom": [0, 0, 0]})
                    found = np.asarray(picture.linear)[..., :3]
                    expected = path_traced(opacity, np.random.default_rng(3))
                    of = expected.max(2) > 0
                    error = found[of].mean(0) / expected[of].mean(0) - 1  # light from one surface to the other is missing
                    self.assertLess(np.abs(error).max(), most)


if __name__ == "__main__":
    unittest.main()
