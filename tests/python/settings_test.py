"""What says which settings there are: dir(), docstrings, and the stub, all of the one list."""

import json
import os
import subprocess
import sys
import unittest

import isolux
from support import SOURCE, command


class OneList(unittest.TestCase):
    def test_it_is_that_of_the_command(self):
        theirs = json.loads(command("settings", "--json"))
        ours = isolux.settings()
        self.assertEqual(list(ours), [entry["path"] for entry in theirs])
        for entry in theirs:
            setting = ours[entry["path"]]
            self.assertEqual((setting.default, setting.meaning, setting.unit, list(setting.choices)),
                             (entry["default"], entry["meaning"], entry["unit"], entry.get("choices", [])))

    def test_dir_and_docstrings(self):
        ours = isolux.settings()
        self.assertEqual(dir(ours), sorted({path.split(".")[0] for path in ours}))
        self.assertIn("mode", dir(ours.look))
        self.assertIs(ours.light.environment.file, ours["light.environment.file"])
        self.assertIn(ours["look.mode"].meaning, ours.look.mode.__doc__)
        self.assertIn("kappa1", ours.look.mode.__doc__)
        with self.assertRaises(AttributeError):
            ours.look.mod
        for path, setting in ours.items():
            self.assertIn(f"{path}  {setting.meaning}", isolux.Volume.render.__doc__)

    def test_a_word_chooses(self):
        self.assertEqual(set(isolux.settings("gi.samples")), {"gi.samples"})
        self.assertLess(len(isolux.settings("camera")), len(isolux.settings()))

    def test_the_stub_is_made_of_it(self):
        made = subprocess.run([sys.executable, "-m", "isolux._stub"], capture_output=True, text=True, check=True).stdout
        with open(os.path.join(SOURCE, "python", "isolux", "__init__.pyi"), encoding="utf-8") as file:
            self.assertEqual(file.read(), made, "PYTHONPATH=build/test/python python3 -m isolux._stub > python/isolux/__init__.pyi")
        compile(made, "__init__.pyi", "exec")

    def test_the_stub_has_every_name(self):
        with open(os.path.join(SOURCE, "python", "isolux", "__init__.pyi"), encoding="utf-8") as file:
            stub = file.read()
        for name in isolux.__all__:
            self.assertRegex(stub, rf"(class|def) {name}\b")
        for thing in (isolux.Volume, isolux.Picture, isolux.Setting):
            for name in vars(thing):
                if not name.startswith("_"):
                    self.assertRegex(stub, rf"\b{name}\b")

    def test_doctor(self):
        text = isolux.doctor()
        self.assertIn("Graphics contexts", text)
        self.assertIn("file reader", text)


if __name__ == "__main__":
    unittest.main()
