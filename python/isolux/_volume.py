"""Volumes, and what can be asked of them."""

import json
import operator
import os
import weakref

import numpy as np

from . import _isolux
from ._arrays import order_of, rows_of, three_numbers, voxels_of, warn
from ._picture import Picture
from ._progress import told
from ._records import Record
from ._scene import path_text, scene_of, value_text
from ._settings import settings as _settings

_open_volumes = weakref.WeakSet()
_WORLD = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}


class Volume:
    """Voxels in the world, ready to be drawn and asked.

    array       three axes of real numbers, NaN where nothing is known. It is copied. int8, uint8, int16, uint16 and float32
                are kept as they are; others become one of them, with an IsoluxWarning where values change
    spacing     mm between voxels, in the order of the array's axes; one number for all three
    origin      world position (x, y, z) of the voxel [0, 0, 0], mm
    directions  three rows, in the order of the array's axes: where each points in the world; by default along the
                world's axis of its letter
    axes        what the array's axes are: "zyx" (the last one is x), or any other order
    name, unit  for texts and legends; unit "HU" says that the values are Hounsfield units
    anatomical  the world is LPS: x to the patient's left, y to the back, z up
    progress    True for a bar, or a function of (fraction, stage)
    """

    def __init__(self, array, spacing=1.0, origin=(0.0, 0.0, 0.0), directions=None, axes="zyx", *, name="array", unit="",
                 anatomical=False, progress=None):
        self._axes = order_of(axes)
        voxels = voxels_of(array)
        spacing = dict(zip(axes, three_numbers(spacing, "spacing")))
        if min(spacing.values()) <= 0:
            raise ValueError("spacing: distances of voxels are greater than 0")
        rows = [_WORLD[letter] for letter in axes] if directions is None else _directions(directions)
        columns = dict(zip(axes, rows))
        voxels = np.ascontiguousarray(voxels.transpose([axes.index(letter) for letter in "zyx"]))
        with told(progress) as tell:
            core = _isolux.Core.of_array(voxels, [spacing[a] for a in "xyz"], three_numbers(origin, "origin"),
                                         [columns[a] for a in "xyz"], str(name), str(unit), bool(anatomical), tell)
        self._take(core)
        for text in self.warnings:
            warn(text, 3)

    def _take(self, core):
        self._core = core
        self._facts = Record(core.facts())
        _open_volumes.add(self)

    def _own(self):
        if self._core is None:
            raise ValueError("this volume is closed")
        return self._core

    # --- what it is

    @property
    def axes(self):
        """What the axes of `shape`, `spacing` and `directions` are, "zyx" unless told otherwise."""
        return self._axes

    def _ordered(self, values):
        return tuple(values["xyz".index(letter)] for letter in self._axes)

    @property
    def shape(self):
        return self._ordered(self._facts.dims)

    @property
    def spacing(self):
        """mm between voxels, in the order of `axes`."""
        return self._ordered(self._facts.spacing_mm)

    @property
    def directions(self):
        return np.array(self._ordered(self._facts.directions))

    @property
    def origin(self):
        """World position (x, y, z) of the voxel [0, 0, 0], mm."""
        return self._facts.origin_mm

    @property
    def name(self):
        return self._facts.name

    @property
    def unit(self):
        return self._facts.unit

    @property
    def kind(self):
        """What kind of data this is: "ct_hu", "ct", "mr", "microscopy", "simulation", "distance", "labels" or "other"."""
        return self._facts.kind

    @property
    def range(self):
        """The smallest and the largest value."""
        return self._facts.range

    @property
    def suggested_isovalue(self):
        """What is drawn unless an isovalue is given."""
        return self._facts.suggested_isovalue

    @property
    def warnings(self):
        """What had to be done to read it, a line each."""
        return list(self._facts.warnings)

    @property
    def facts(self):
        """All that is known of it (x, y, z order): dims, type, spacing_mm, origin_mm, directions, missing, data_hash, ..."""
        return self._facts

    def world(self, index):
        """World positions (x, y, z) of voxel indices, in the order of `axes`; fractions lie between voxels."""
        rows = rows_of(index, "index")
        return np.asarray(self.origin) + (rows * np.asarray(self.spacing)) @ self.directions

    def __repr__(self):
        order = ", ".join(self._axes)
        size = " x ".join(str(n) for n in self.shape)
        steps = " x ".join(f"{step:g}" for step in self.spacing)
        low, high = self.range
        unit = f" {self.unit}" if self.unit else ""
        closed = ", closed" if self._core is None else ""
        return (f"<isolux.Volume {self.name!r}: {size} voxels ({order}) of {self._facts.type}, spacing {steps} mm ({order}), "
                f"values {low:g} to {high:g}{unit}{closed}>")

    def close(self):
        """Gives memory and graphics context back now; the volume cannot be asked any more."""
        self._core = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    # --- pictures

    def render(self, isovalue=None, look=None, size=None, camera=None, aovs=(), settings=None, *, environment=None,
               image=True, linear=False, light="", light_around=False, accuracy=False, explain=False, context="auto",
               progress=None, **view):
        """Draws a picture, the one that `isolux render` draws of the same scene. A second one costs a frame.

        isovalue      data units; None: the suggested one
        look          "gi", "normal", "kappa1", ...: settings()["look.mode"].choices
        size          (width, height) in pixels; (1024, 768) unless the volume is a picture's session
        camera        (eye, target, up, fov): world mm, vertical field of view in degrees; or a dictionary of some of them
        aovs          deferred images by name: "position", "depth", "normal", "gradient", "hessian", "kappa",
                      "irradiance", "hit", ..., and "error_depth", "error_normal", "error_kappa", "error_light",
                      "error_noise", "error_normal_noise", "error_kappa_noise"
        settings      {path: value}: any of settings(); they win over the arguments before
        environment   "studio", "window", "overcast", "sunset", or a light probe's file
        image         False: only what aovs asks for
        linear        also linear float32
        light         stored light from this file of `bake`
        light_around  stores light around what is seen, too
        accuracy      bounds the errors of the picture: in `stats`
        explain       says in `stats` why scales of derivatives were chosen (draws again)
        context       "auto", "software", "egl" or "osmesa", for all pictures of this volume until another one is asked for
        view, azimuth, elevation, roll, zoom, fit, session, preset, shift: as the options of `isolux render`

        Light that is stored stays for the next picture: `forget_light` drops it.
        """
        wish = _isolux.Wish()
        wish.scene = scene_of(isovalue, look, environment, camera, settings, **view)
        if size is not None:
            wish.size = _size(size)
        wish.images = aovs if isinstance(aovs, str) else ",".join(aovs)
        wish.color, wish.linear = bool(image), bool(linear)
        if not (image or linear or wish.images):
            raise ValueError("nothing to draw: image=False, and no aovs")
        wish.light = value_text(light or "")
        wish.light_around, wish.accuracy, wish.explain = bool(light_around), bool(accuracy), bool(explain)
        if context not in ("auto", "software", "egl", "osmesa"):
            raise ValueError(f'context: unknown value {context!r}; choose "auto", "software", "egl" or "osmesa"')
        wish.context = context
        with told(progress) as tell:
            drawn = self._own().render(wish, tell)
        for note in drawn.notes:
            warn(note, 3)
        return Picture(drawn)

    def forget_light(self):
        """Drops stored light, so that the next picture has that of a program that starts."""
        self._own().forget_light(None)

    # --- numbers

    def hits(self, origins, directions, isovalue=None, *, settings=None, progress=None):
        """Where rays first meet the isosurface, in double precision: the exact crossing of the trilinear field.

        `origins` and `directions` end in an axis of x, y, z (world mm) and are broadcast against each other. Of the record
        `t` is the distance from the origin in mm, `position` the point, `normal` the outward unit normal of the smoothing
        spline there, `error` how far the object's own surface may lie from it along the ray (sampling, and two deviations
        of the noise; mm), `value_error` |f - isovalue| at the hit (data units; what arithmetic leaves), and `entering`
        whether the ray goes into the inside. NaN (and False) where nothing is hit.
        """
        origins, directions = rows_of(origins, "origins"), rows_of(directions, "directions")
        try:
            origins, directions = np.broadcast_arrays(origins, directions)
        except ValueError:
            raise ValueError(f"origins and directions do not fit: shapes {origins.shape} and {directions.shape}") from None
        shape = origins.shape[:-1]
        with told(progress) as tell:
            found = self._own().hits(scene_of(isovalue, settings=settings), np.ascontiguousarray(origins.reshape(-1, 3)),
                                     np.ascontiguousarray(directions.reshape(-1, 3)), tell)
        record = Record({name: values.reshape(shape + values.shape[1:]) for name, values in found.items()})
        record["entering"] = record["entering"].astype(bool)
        return record

    def probe(self, points, isovalue=None, *, settings=None, progress=None):
        """What the field says at points (..., 3) of the world, in double precision.

        `value` is of hit.field; `gradient` (per mm), `hessian` (..., 3, 3), `normal` (outward), `kappa` (..., 2; k1 >= k2,
        1/mm) and `confidence` are of derivatives.field at `scale_mm`. NaN outside, and beside missing voxels.
        """
        rows = rows_of(points, "points")
        with told(progress) as tell:
            found = self._own().probe(scene_of(isovalue, settings=settings), np.ascontiguousarray(rows.reshape(-1, 3)), tell)
        shape = rows.shape[:-1]
        return Record({name: values if np.isscalar(values) else values.reshape(shape + values.shape[1:])
                       for name, values in found.items()})

    def measure(self, isovalue=None, *, anyway=False, settings=None, progress=None):
        """Area, enclosed volume and pieces of the isosurface, each with its error: the keys of `isolux measure --json`.

        `anyway`: also where lengths are doubtful (no spacing in the file).
        """
        with told(progress) as tell:
            return Record(json.loads(self._own().measure(scene_of(isovalue, settings=settings), bool(anyway), tell)))

    def measure_labels(self, smoothing=1.0, *, anyway=False, progress=None):
        """Counted volume of each label, and volume and area of its smoothed surface: the keys of `isolux measure --labels --json`.

        `smoothing`: 0 to 2 voxels. `anyway`: also where lengths are doubtful (no spacing in the file).
        """
        with told(progress) as tell:
            return Record(json.loads(self._own().measure_labels(float(smoothing), bool(anyway), tell)))

    def bake(self, path, isovalue=None, *, environment=None, overwrite=False, mix_arithmetic=False, settings=None, progress=None):
        """Stores the light of all isosurfaces as a .vti: `render(light=path)`, ParaView. A bake of the same light goes on.

        `mix_arithmetic`: also where another kind of processor began it. Returns what it cost: the keys of `isolux bake --stats`.
        """
        with told(progress) as tell:
            scene = scene_of(isovalue, environment=environment, settings=settings)
            text, notes = self._own().bake(scene, path_text(path), bool(overwrite), bool(mix_arithmetic), tell)
        for note in notes:
            warn(note, 3)
        return Record(json.loads(text))

    def study(self, knobs="", isovalue=None, *, size=(256, 256), repeat=7, settings=None, progress=None):
        """Measures error against time of each quality setting (docs/explanation/accuracy.md).

        `knobs`: names, or "rate,method"; all unless told. Returns the record of `isolux study`'s study.json.
        """
        names = knobs if isinstance(knobs, str) else ",".join(knobs)
        if int(repeat) < 1:
            raise ValueError("repeat: at least 1")
        with told(progress) as tell:
            text = self._own().study(scene_of(isovalue, settings=settings), names, _size(size), int(repeat), tell)
        return Record(json.loads(text))


def open(path, *, settings=None, raw="", progress=None):  # noqa: A001
    """A volume of a file: any that the program reads, a DICOM folder, "phantom:NAME[:SIZE]", a session, a picture with one.

    `settings` of `source.` say what of it; `raw` how to read a file without header.
    """
    words = dict(settings or {})
    if raw:
        words.setdefault("source.raw", raw)
    volume = Volume.__new__(Volume)
    volume._axes = "zyx"
    name = path_text(path)
    if not name:
        raise ValueError("path: the name of a file is needed")
    with told(progress) as tell:
        core = _isolux.Core.open(name, scene_of(settings=words), tell)
    volume._take(core)
    return volume


def from_nibabel(image, *, progress=None):
    """A volume of an image of nibabel, in its place in the patient (RAS becomes LPS)."""
    affine = np.array(image.affine, dtype=np.float64)
    units = getattr(image.header, "get_xyzt_units", lambda: ("mm", ""))()[0]
    affine[:3] *= {"meter": 1000.0, "micron": 0.001}.get(units, 1.0)
    to_lps = np.diag([-1.0, -1.0, 1.0])
    columns = to_lps @ affine[:3, :3]
    spacing = np.linalg.norm(columns, axis=0)
    return Volume(np.asanyarray(image.dataobj), spacing, to_lps @ affine[:3, 3], (columns / spacing).T, axes="xyz",
                  name=os.path.basename(image.get_filename() or "nibabel"), anatomical=True, progress=progress)


class _Text(str):
    """Shown as it is printed."""

    def __repr__(self):
        return str(self)


def doctor(progress=None):
    """What this machine offers, and what Isolux would use of it: text."""
    with told(progress) as tell:
        return _Text(_isolux.doctor(tell))


def _directions(value):
    rows = np.asarray(value, dtype=np.float64)
    lengths = np.linalg.norm(rows, axis=1) if rows.shape == (3, 3) else np.zeros(1)
    if not (np.isfinite(lengths).all() and (lengths > 0).all() and abs(np.linalg.det(rows / lengths[:, None])) > 1e-6):
        raise ValueError("directions: three rows are needed that point in three directions")
    return [tuple(map(float, row)) for row in rows / lengths[:, None]]


def _size(size):
    try:
        width, height = (operator.index(one) for one in size)
    except (TypeError, ValueError):
        raise ValueError(f"size: (width, height) is needed, not {size!r}") from None
    if not (1 <= width <= 16384 and 1 <= height <= 16384):
        raise ValueError("size: 1 to 16384 pixels each")
    return width, height


def _close_all():
    _isolux.end()
    for volume in list(_open_volumes):
        volume.close()
    _isolux.await_ends(5.0)


def _list_settings():
    lines = [f"    {path}  {setting.meaning}" for path, setting in _settings().items()]
    return "\n        Settings (settings() says more):\n\n    " + "\n    ".join(lines) + "\n"


Volume.render.__doc__ += _list_settings()
