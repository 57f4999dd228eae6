"""The example notebook runs from its first cell to its last."""

import os
import unittest

import nbclient
import nbformat

from support import SOURCE, temporary_folder


class TheNotebook(unittest.TestCase):
    def test_it_runs(self):
        with open(os.path.join(SOURCE, "docs", "python_notebook.ipynb"), encoding="utf-8") as file:
            notebook = nbformat.read(file, as_version=4)
        nbformat.validate(notebook)
        with temporary_folder() as folder:
            client = nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": folder}})
            client.execute()
            self.assertTrue(os.path.exists(os.path.join(folder, "sweep.mp4")))
        shown = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
        pictures = [output for output in shown if "image/png" in output.get("data", {})]
        self.assertGreaterEqual(len(pictures), 4)
        self.assertFalse([output for output in shown if output.output_type == "error"])


if __name__ == "__main__":
    unittest.main()
