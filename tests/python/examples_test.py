"""Every example of docs/python.md runs, and gives the picture in the page."""

import os
import re
import subprocess
import sys
import unittest

import numpy as np
from PIL import Image

from support import SOURCE, temporary_folder

TIMED = {"python_study.png"}  # a plot of times, which no two runs share


def examples():
    with open(os.path.join(SOURCE, "docs", "python.md"), encoding="utf-8") as file:
        text = file.read()
    return re.findall(r"\*\*\d+\. (.*?)\*\*\n\n```python\n(.*?)```\n\n!\[.*?\]\(images/(.*?)\)", text, re.S)


class Examples(unittest.TestCase):
    def test_there_are_ten(self):
        self.assertEqual(len(examples()), 10)

    def test_each_gives_its_picture(self):
        kept = os.environ.get("ISOLUX_PYTHON_PICTURES")  # a folder: the pictures are made anew
        for title, code, picture in examples():
            with self.subTest(title), temporary_folder() as folder:
                done = subprocess.run([sys.executable, "-c", code],
                                      cwd=folder, capture_output=True, text=True, check=False,
                                      env=os.environ | {"MPLBACKEND": "agg"})
                self.assertEqual(done.returncode, 0, done.stderr)
                made = np.asarray(Image.open(os.path.join(folder, picture)).convert("RGB"), dtype=np.float64)
                if kept:
                    os.replace(os.path.join(folder, picture), os.path.join(kept, picture))
                    continue
                page = np.asarray(Image.open(os.path.join(SOURCE, "docs", "images", picture)).convert("RGB"), dtype=np.float64)
                self.assertEqual(made.shape, page.shape)
                if picture not in TIMED:
                    self.assertLess(np.abs(made - page).mean(), 1.0, "of 255")


if __name__ == "__main__":
    unittest.main()
