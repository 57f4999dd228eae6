"""What is asked for in Python, as the command line has it: settings as PATH=VALUE, in order."""

import json
import os

import numpy as np

from . import _isolux
from ._settings import settings


def _plain(part):
    """Of NumPy, for JSON."""
    if isinstance(part, (np.generic, np.ndarray)):
        return part.tolist()
    raise ValueError(f"a setting cannot hold {part!r}")


def text_of(words):
    """Text that files can hold; ValueError of names that are no Unicode."""
    if isinstance(words, bytes):
        words = os.fsdecode(words)
    try:
        words.encode()
    except UnicodeEncodeError:
        raise ValueError(f"{words!r}: names that are not UTF-8 cannot be written into sessions; rename it") from None
    return words


def path_text(path):
    return text_of(os.fspath(path))


def value_text(value):
    """As it is typed after --set PATH=."""
    if value is None:
        return "auto"
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if isinstance(value, str):
        return text_of(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if hasattr(value, "__fspath__"):
        return path_text(value)
    if isinstance(value, dict):
        return json.dumps(value, default=_plain)
    try:
        parts = list(value)
    except TypeError:
        raise ValueError(f"a setting cannot be {value!r}") from None
    if any(isinstance(part, (list, tuple, dict, np.ndarray)) for part in parts):
        return json.dumps(parts, default=_plain)
    return ",".join(value_text(part) for part in parts)


def _environment(value):
    text = value_text(value)
    if text not in settings()["light.environment.builtin"].choices:
        return ["light.environment.file=" + text]
    return ["light.environment.file=", "light.environment.constant=auto", "light.environment.builtin=" + text]


def _camera(camera):
    names = ("eye", "target", "up", "fov")
    if isinstance(camera, dict):
        unknown = set(camera) - {*names, "projection"}
        if unknown:
            raise ValueError(f"camera: there is no {', '.join(sorted(map(str, unknown)))}; there are {', '.join(names)}, projection")
        pairs = camera.items()
    else:
        parts = camera.split() if isinstance(camera, str) else tuple(camera)
        if len(parts) != 4:
            raise ValueError("camera: eye, target, up and fov are needed, or a dictionary of some of them")
        pairs = zip(names, parts)
    return [f"camera.{name}={value_text(value)}" for name, value in pairs]


def scene_of(isovalue=None, look=None, environment=None, camera=None, settings=None, *, session="", preset="", shift=0.0,
             view="", azimuth=0.0, elevation=0.0, roll=0.0, zoom=1.0, fit=""):
    """The options of a scene. What is given as `settings` wins over the short forms."""
    words = []
    if isovalue is not None:
        words.append("isosurface.value=" + value_text(isovalue))
    if look is not None:
        words.append("look.mode=" + value_text(look))
    if environment is not None:
        words += _environment(environment)
    if camera is not None:
        words += _camera(camera)
    for path, value in dict(settings or {}).items():
        words.append(f"{path}={value_text(value)}")
    if fit not in ("", None, "surface", "volume"):
        raise ValueError(f'fit: {fit!r} is neither "surface" nor "volume"')
    scene = _isolux.Scene()
    scene.assignments = words
    scene.session = value_text(session or "")
    scene.preset = value_text(preset or "")
    scene.shift = float(shift)
    scene.view = view or ""
    scene.camera(float(azimuth), float(elevation), float(roll), float(zoom), fit or "")
    return scene
