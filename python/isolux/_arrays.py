"""Any array as what the compiled part takes: three axes (z, y, x), C-ordered, numbers of this machine."""

import warnings

import numpy as np


class IsoluxWarning(UserWarning):
    """What was done to get an answer: values that changed, a picture in which nothing is to be seen, ..."""


def warn(text, level=3):
    warnings.warn(text, IsoluxWarning, stacklevel=level)


def voxels_of(array):
    """Numbers of the same values in a type that volumes know; ValueError where there are none."""
    if isinstance(array, np.ma.MaskedArray):
        if array.dtype.kind not in "fiub":
            raise _no_numbers(array.dtype)
        if array.mask.any():
            kept = array.dtype if array.dtype.kind == "f" else np.dtype(np.float64)
            warn("masked voxels count as missing", 4)
            array = array.astype(kept).filled(np.nan)
        else:
            array = array.filled()
    try:
        array = np.asarray(array)
    except Exception as error:  # whatever a stranger's __array__ raises
        raise ValueError(f"array: this is no array: {error}") from error
    if array.dtype.kind not in "fiub":
        raise _no_numbers(array.dtype)
    if array.ndim != 3:
        raise ValueError(f"array: a volume has three axes, this array has {array.ndim} (shape {array.shape})")
    if array.size == 0:
        raise ValueError(f"array: there are no voxels (shape {array.shape})")
    if array.dtype.kind == "b":
        return array.astype(np.uint8)
    if not array.dtype.isnative:
        array = array.astype(array.dtype.newbyteorder("="))
    if array.dtype == np.float16:
        return array.astype(np.float32)
    if array.dtype.kind == "f" and array.dtype.itemsize > 8:
        with np.errstate(over="ignore"):
            narrow = array.astype(np.float64)
        if not np.array_equal(narrow, array, equal_nan=True):
            warn(f"{array.dtype} values were rounded to float64", 4)
        array = narrow
    if array.dtype.itemsize > 2 and array.dtype != np.float32 and _changes(array):
        warn(f"{array.dtype} values are kept as float32: they change by up to one part in 2^23 of their range", 4)
    return array


def _changes(array):
    """Whether values of a wide type are neither whole numbers close together nor those of float32."""
    with np.errstate(all="ignore"):
        if np.array_equal(array.astype(np.float32).astype(array.dtype), array, equal_nan=array.dtype.kind == "f"):
            return False
        if array.dtype.kind in "iu":
            return int(array.max()) - int(array.min()) > 65535
        whole = array[np.isfinite(array)]
        return not (whole.size == array.size and (whole == np.rint(whole)).all() and np.ptp(whole) <= 65535)


def _no_numbers(dtype):
    return ValueError(f"array: voxels are real numbers, these are {dtype}")


def order_of(axes):
    """Of "zyx" or any other order of the three, checked."""
    if not isinstance(axes, str) or sorted(axes) != ["x", "y", "z"]:
        raise ValueError(f'axes: {axes!r} is no order of "x", "y" and "z"')
    return axes


def three_numbers(value, name):
    """Three finite numbers as a tuple; one number stands for three."""
    numbers = np.asarray(value, dtype=np.float64) if not isinstance(value, str) else np.empty(0)
    if numbers.ndim == 0:
        numbers = np.repeat(numbers, 3)
    if numbers.shape != (3,) or not np.isfinite(numbers).all():
        raise ValueError(f"{name}: three numbers are needed, not {value!r}")
    return tuple(float(number) for number in numbers)


def rows_of(points, name):
    """Points as float64 rows (n, 3), and the shape of the answers."""
    try:
        rows = np.asarray(points, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name}: rows of x, y, z are needed: {error}") from error
    if rows.ndim == 0 or rows.shape[-1] != 3:
        raise ValueError(f"{name}: the last axis has x, y, z; this one has the shape {rows.shape}")
    return rows
