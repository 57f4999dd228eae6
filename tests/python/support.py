"""What the tests share: the module, the program, small volumes of closed form."""

import os
import subprocess
import tempfile

import numpy as np

# The module's cache is the tests'; the driver's shaders stay where other processes have them.
CACHE = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
os.environ.setdefault("MESA_SHADER_CACHE_DIR", os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache"))
os.environ["XDG_CACHE_HOME"] = CACHE.name

import isolux  # noqa: E402,F401

BINARY = os.environ.get("ISOLUX_BINARY", "")
SOURCE = os.environ.get("ISOLUX_SOURCE", os.path.join(os.path.dirname(__file__), "..", ".."))


def ball(n=32, radius=10.0, dtype=np.float32, spacing=1.0):
    """Signed distance to a ball in the middle, positive inside: the isosurface of 0 has this radius in mm."""
    axis = (np.arange(n) - (n - 1) / 2) * spacing
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    return (radius - np.sqrt(x * x + y * y + z * z)).astype(dtype)


def smooth_field(shape=(20, 22, 24)):
    """A field without symmetry, so that no order of axes is mistaken for another one."""
    z, y, x = np.meshgrid(*(np.arange(n, dtype=np.float64) for n in shape), indexing="ij")
    return np.sin(0.31 * x) + 0.7 * np.cos(0.23 * y + 0.4) + 0.5 * np.sin(0.17 * z + 0.11 * x)


def command(*words, folder=None):
    """Runs the program; its standard output."""
    done = subprocess.run([BINARY, *words], capture_output=True, text=True, cwd=folder, check=False)
    if done.returncode != 0:
        raise AssertionError(f"isolux {' '.join(words)} ended with {done.returncode}: {done.stderr}")
    return done.stdout


def failure(*words):
    """The line that the program prints when it fails, without its name."""
    done = subprocess.run([BINARY, *words], capture_output=True, text=True, check=False)
    return done.stderr.strip().removeprefix("isolux: ")


def temporary_folder():
    return tempfile.TemporaryDirectory(prefix="isolux_python_")


def bytes_of(path):
    with open(path, "rb") as file:
        return file.read()
