"""Prints __init__.pyi: what editors and type checkers know of the module, with every setting of the one list."""

import inspect

import isolux

_HEAD = '''"""Made by `python3 -m isolux._stub`; a test compares."""

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, Literal, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

Progress = bool | Callable[[float, str], Any] | None
Path = str | os.PathLike[str]
'''

_TYPES = {"true or false": "bool", "integer": "int", "number": "float", "text": "str | os.PathLike[str]"}

_ANNOTATIONS = {
    "isovalue": "float | None", "look": "Look | None", "size": "tuple[int, int] | None", "settings": "SettingsDict | Mapping[str, Any] | None",
    "aovs": "str | Iterable[str]", "camera": "str | Sequence[Any] | Mapping[str, Any] | None", "environment": "Path | None",
    "image": "bool", "linear": "bool", "light": "Path", "light_around": "bool", "accuracy": "bool", "explain": "bool",
    "context": 'Literal["auto", "software", "egl", "osmesa"]', "progress": "Progress", "view": "Any", "origins": "ArrayLike",
    "directions": "ArrayLike", "points": "ArrayLike", "index": "ArrayLike", "anyway": "bool", "smoothing": "float",
    "path": "Path", "overwrite": "bool", "mix_arithmetic": "bool",
    "knobs": "str | Iterable[str]", "repeat": "int", "array": "ArrayLike", "spacing": "float | Sequence[float]",
    "origin": "Sequence[float]", "axes": "str", "name": "str", "unit": "str", "anatomical": "bool", "raw": "str", "word": "str",
    "pictures": "Iterable[Picture | NDArray[np.uint8]]", "fps": "float", "dtype": "Any", "drawn": "Any"}

_RETURNS = {
    "render": "Picture", "forget_light": "None", "hits": "Record", "probe": "Record", "measure": "Record", "measure_labels": "Record",
    "bake": "Record", "study": "Record", "close": "None", "world": "NDArray[np.float64]", "axes": "str", "shape": "tuple[int, int, int]",
    "spacing": "tuple[float, float, float]", "directions": "NDArray[np.float64]", "origin": "tuple[float, float, float]",
    "name": "str", "unit": "str", "kind": "str", "range": "tuple[float, float]", "suggested_isovalue": "float", "warnings": "list[str]",
    "facts": "Record", "size": "tuple[int, int]", "image": "NDArray[np.uint8] | None", "linear": "NDArray[np.float32] | None",
    "aov": "Record", "stats": "Record", "session": "str", "save": "None", "settings": "Settings", "open": "Volume",
    "from_nibabel": "Volume", "doctor": "str", "film": "str", "allowed": "str", "text": "str", "__init__": "None"}


def _setting_type(setting):
    if setting.choices:
        kind = "Literal[" + ", ".join(f'"{choice}"' for choice in setting.choices) + "]"
    else:
        kind = _TYPES.get(setting.type, "Sequence[Any] | str")
    return f'{kind} | Literal["auto"] | None' if setting.automatic else kind


def _settings_dict():
    lines = ['SettingsDict = TypedDict("SettingsDict", {']
    for path, setting in isolux.settings().items():
        if ".ID." in path:  # of items of lists, whose ids are the user's
            continue
        lines.append(f'    "{path}": {_setting_type(setting)},  # {setting.meaning}')
    return "\n".join([*lines, "}, total=False)"])


def _words(function):
    words, star = [], False
    for name, parameter in inspect.signature(function).parameters.items():
        if parameter.kind is parameter.KEYWORD_ONLY and not star:
            words.append("*")
            star = True
        if name == "self":
            words.append(name)
            continue
        prefix = "**" if parameter.kind is parameter.VAR_KEYWORD else ""
        annotation = "Any" if function.__name__ == "from_nibabel" and name == "image" else _ANNOTATIONS[name]
        default = "" if parameter.default is parameter.empty else " = ..."
        words.append(f"{prefix}{name}: {annotation}{default}")
    return ", ".join(words)


def _function(function, indent=""):
    return f"{indent}def {function.__name__}({_words(function)}) -> {_RETURNS[function.__name__]}: ..."


def _class(kind, extra=()):
    lines = [f"class {kind.__name__}:"]
    for name, member in vars(kind).items():
        if isinstance(member, property):
            lines += ["    @property", f"    def {name}(self) -> {_RETURNS[name]}: ..."]
        elif inspect.isfunction(member) and (name == "__init__" or not name.startswith("_")):
            lines.append(_function(member, "    "))
    return "\n".join([*lines, *("    " + line for line in extra)])


def _stub():
    look = "Literal[" + ", ".join(f'"{choice}"' for choice in isolux.settings()["look.mode"].choices) + "]"
    return "\n\n".join([
        _HEAD + f"Look = {look}", _settings_dict(), "class IsoluxWarning(UserWarning): ...",
        "class Record(dict[str, Any]):\n    def __getattr__(self, name: str) -> Any: ...",
        "class Setting:\n    path: str\n    type: str\n    default: Any\n    unit: str\n    meaning: str\n    automatic: bool\n"
        "    of: str\n    choices: tuple[str, ...]\n    minimum: float | None\n    maximum: float | None\n"
        "    def allowed(self) -> str: ...\n    def text(self) -> str: ...",
        "class Settings(Mapping[str, Setting]):\n    def __getattr__(self, name: str) -> Any: ...\n"
        "    def __getitem__(self, path: str) -> Setting: ...\n    def __iter__(self) -> Iterator[str]: ...\n"
        "    def __len__(self) -> int: ...",
        _class(isolux.Picture, ["def _repr_png_(self) -> bytes | None: ...", "def __array__(self, dtype: Any = ...) -> NDArray[Any]: ..."]),
        _class(isolux.Volume, ['def __enter__(self) -> "Volume": ...', "def __exit__(self, *_: Any) -> None: ..."]),
        "\n".join(_function(one) for one in (isolux.open, isolux.from_nibabel, isolux.film, isolux.settings, isolux.doctor)),
        "__all__: list[str]\n__version__: str"]) + "\n"


if __name__ == "__main__":
    print(_stub(), end="")
