"""Every setting of a picture, from the list that the program has."""

import functools
import json
from collections.abc import Mapping

from . import _isolux


class Setting:
    """One setting: `path`, `type`, `default`, `unit`, `meaning`, and what it may be."""

    def __init__(self, entry):
        self.path = entry["path"]
        self.type = entry["type"]
        self.default = entry["default"]
        self.unit = entry["unit"]
        self.meaning = entry["meaning"]
        self.automatic = entry["automatic"]
        self.of = entry["of"]
        self.choices = tuple(entry.get("choices", ()))
        self.minimum, self.maximum = entry.get("minimum"), entry.get("maximum")
        self.__doc__ = self.text()

    def allowed(self):
        """What it may be, in words; "" where anything is."""
        if self.choices:
            text = ", ".join(self.choices)
        elif self.minimum is not None:
            text = f"{self.minimum:g} to {self.maximum:g}"
        else:
            text = ""
        return ", ".join(filter(None, (text, "or auto" if self.automatic else "")))

    def text(self):
        kind = ": ".join(filter(None, (self.type, self.allowed())))
        unit = f" ({self.unit})" if self.unit else ""
        return f"{self.meaning}\n\n{kind}{unit}; default {self.default!r}"

    def __repr__(self):
        return f"{self.path}: {self.text()}"


class Group:
    """Settings whose paths begin alike, as attributes."""

    def __init__(self, listed, prefix):
        self._listed, self._prefix = listed, prefix

    def __getattr__(self, name):
        path = self._prefix + name
        if path in self._listed:
            return self._listed[path]
        if not name.startswith("_") and any(one.startswith(path + ".") for one in self._listed):
            return Group(self._listed, path + ".")
        raise AttributeError(f"there is no setting {path}")

    def __dir__(self):
        return sorted({path[len(self._prefix):].split(".")[0] for path in self._listed if path.startswith(self._prefix)})

    def __repr__(self):
        return "\n\n".join(repr(setting) for path, setting in self._listed.items() if path.startswith(self._prefix))


class Settings(Group, Mapping):
    """All settings by their paths: `s["look.mode"]` or `s.look.mode`."""

    def __init__(self, listed):
        super().__init__(listed, "")

    def __getitem__(self, path):
        return self._listed[path]

    def __iter__(self):
        return iter(self._listed)

    def __len__(self):
        return len(self._listed)


@functools.lru_cache(maxsize=None)
def _all():
    return {entry["path"]: Setting(entry) for entry in json.loads(_isolux.settings())}


def settings(word=""):
    """Every setting, or those whose path or meaning contains `word`: what `settings=` of a Volume's methods takes."""
    return Settings({path: one for path, one in _all().items() if word in path or word in one.meaning})
