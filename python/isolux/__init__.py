"""Exact isosurfaces of voxel volumes: pictures, first hits, curvature, measures.

    >>> import isolux
    >>> v = isolux.open("phantom:head")
    >>> p = v.render(isovalue=300, look="gi", size=(1024, 768))
    >>> p.save("head.png")

Lengths are millimetres, positions (x, y, z) of the world; arrays are indexed (z, y, x) unless a Volume is told otherwise.
docs/reference/python.md shows what can be done.
"""

import atexit as _atexit
import os as _os

from . import _isolux

__version__ = _isolux.version()


def _find_readers():
    """The programs that parse DICOM, VTK and TIFF: in the build tree, or installed."""
    here = _os.path.dirname(_os.path.abspath(__file__))
    for way in ("../../bin", "../../../../libexec/isolux"):
        folder = _os.path.normpath(_os.path.join(here, way))
        if _os.access(_os.path.join(folder, "isolux-reader-vtk"), _os.X_OK):
            _isolux.set_reader_folder(folder)
            return


_find_readers()

from ._arrays import IsoluxWarning  # noqa: E402
from ._film import film  # noqa: E402
from ._picture import Picture  # noqa: E402
from ._records import Record  # noqa: E402
from ._settings import Setting, Settings, settings  # noqa: E402
from ._volume import Volume, doctor, from_nibabel, open  # noqa: E402,A004
from ._volume import _close_all  # noqa: E402

__all__ = ["IsoluxWarning", "Picture", "Record", "Setting", "Settings", "Volume", "doctor", "film", "from_nibabel", "open",
           "settings"]

_atexit.register(_close_all)
