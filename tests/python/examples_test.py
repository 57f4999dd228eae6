"""Every script of examples/ runs, and gives the picture beside it."""

import os
import subprocess
import sys
import unittest

import numpy as np
from PIL import Image

from support import temporary_folder

TIMED = {"python_study.png"}  # a plot of times, which no two runs share


FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "examples")


def examples():
    return sorted(name.removesuffix(".py") for name in os.listdir(FOLDER) if name.endswith(".py"))


class Examples(unittest.TestCase):
    def test_there_are_ten(self):
        self.assertEqual(len(examples()), 10)

    def test_each_gives_its_picture(self):
        kept = os.environ.get("ISOLUX_PYTHON_PICTURES")  # a folder: the pictures are made anew
        for name in examples():
            picture = f"python_{name}.png"
            with self.subTest(name), temporary_folder() as folder:
                done = subprocess.run([sys.executable, os.path.join(FOLDER, name + ".py")],
                                      cwd=folder, capture_output=True, text=True, check=False,
                                      env=os.environ | {"MPLBACKEND": "agg"})
                self.assertEqual(done.returncode, 0, done.stderr)
                made = np.asarray(Image.open(os.path.join(folder, picture)).convert("RGB"), dtype=np.float64)
                if kept:
                    os.replace(os.path.join(folder, picture), os.path.join(kept, picture))
                    continue
                kept_picture = np.asarray(Image.open(os.path.join(FOLDER, picture)).convert("RGB"), dtype=np.float64)
                self.assertEqual(made.shape, kept_picture.shape)
                if picture not in TIMED:
                    self.assertLess(np.abs(made - kept_picture).mean(), 1.0, "of 255")


if __name__ == "__main__":
    unittest.main()
