"""A picture that was drawn."""

import json

import numpy as np

from ._records import Record
from ._scene import path_text


class Picture:
    """What `Volume.render` gives. A notebook shows it.

    image    uint8 (height, width, 3), sRGB, row 0 at the top; (height, width, 4) with straight alpha where
             `picture.transparent` is set; None with image=False
    linear   float32 (height, width, 4), linear RGBA before it is clamped and encoded; None unless asked for
    aov      the deferred images that were asked for, by name: float32 (height, width) or (height, width, channels); NaN
             where there is no surface, 0 in "hit"
    stats    what was computed and what it cost: the keys of `isolux render --stats`
    session  the scene as JSON, camera and isovalues filled in: `isolux.open` and the window take it
    """

    def __init__(self, drawn):
        self._drawn = drawn
        self._image = self._aov = self._stats = None

    @property
    def size(self):
        """(width, height) in pixels."""
        return self._drawn.size

    @property
    def image(self):
        if self._image is None:
            rgba = self._drawn.rgba()
            if rgba is not None:
                self._image = rgba if self._drawn.transparent else np.ascontiguousarray(rgba[..., :3])
        return self._image

    @property
    def linear(self):
        return self._drawn.linear()

    @property
    def aov(self):
        if self._aov is None:
            self._aov = Record(self._drawn.images())
        return self._aov

    @property
    def stats(self):
        if self._stats is None:
            self._stats = Record(json.loads(self._drawn.stats))
        return self._stats

    @property
    def session(self):
        return self._drawn.session()

    def save(self, path):
        """Writes a .png (the image, with its session inside) or an .exr (the deferred images; else `linear`)."""
        self._drawn.save(path_text(path))

    def _repr_png_(self):
        return None if self.image is None else self._drawn.png()

    def __array__(self, dtype=None):
        if self.image is None:
            raise ValueError("there is no image: image=False")
        return np.asarray(self.image, dtype=dtype)

    def __repr__(self):
        width, height = self.size
        images = f", aov {', '.join(self.aov)}" if self.aov else ""
        return f"<isolux.Picture {width} x {height}, image (row, column, channel){images}>"
