"""Any array gives a volume or an exception that says why not; none ends Python."""

import multiprocessing.shared_memory
import os
import unittest
import warnings

import numpy as np

import isolux
from support import ball, smooth_field


def values_of(volume, shape):
    """The voxels of a volume, by asking it at each of them."""
    index = np.stack(np.meshgrid(*(np.arange(n) for n in shape), indexing="ij"), axis=-1)
    return volume.probe(volume.world(index), settings={"hit.field": "trilinear", "derivatives.scale": 0}).value


class Refused(unittest.TestCase):
    def refuse(self, array, said, **words):
        with self.assertRaisesRegex(ValueError, said):
            isolux.Volume(array, **words)

    def test_what_has_no_three_axes(self):
        for shape in ((), (4,), (4, 4), (2, 2, 2, 2)):
            with self.subTest(shape):
                self.refuse(np.zeros(shape), "three axes")

    def test_what_is_empty(self):
        for shape in ((0, 4, 4), (4, 0, 4), (0, 0, 0)):
            with self.subTest(shape):
                self.refuse(np.zeros(shape), "no voxels")

    def test_what_has_no_numbers(self):
        for dtype in ("complex64", "complex128", "S3", "U2", "O", "M8[s]", "m8[s]", [("a", "f4"), ("b", "f4")], "V4"):
            with self.subTest(dtype):
                self.refuse(np.zeros((3, 3, 3), dtype=dtype), "voxels are real numbers")

    def test_what_is_no_array(self):
        class Liar:
            def __array__(self, *_):
                raise RuntimeError("no")

        for thing in (None, "text", object(), {1: 2}, Liar(), [[[1, 2], [3]], 4]):
            with self.subTest(repr(thing)), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                self.refuse(thing, "array")

    def test_what_is_too_long(self):
        long = np.lib.stride_tricks.as_strided(np.zeros(1, np.uint8), (70000, 1, 1), (0, 0, 0))
        self.refuse(long, "65535")

    def test_what_is_larger_than_memory(self):
        huge = np.lib.stride_tricks.as_strided(np.zeros(1, np.uint8), (60000, 60000, 1), (0, 0, 0))
        with self.assertRaises(MemoryError):  # of NumPy or of ours
            isolux.Volume(np.lib.stride_tricks.as_strided(huge, (60000, 60000, 60000), (0, 0, 0)))

    def test_geometry(self):
        array = ball(8)
        for words in ({"spacing": 0}, {"spacing": -1}, {"spacing": (1, 2)}, {"spacing": float("nan")}, {"spacing": "fine"},
                      {"origin": (0, 0)}, {"origin": (0, 0, float("inf"))}, {"axes": "xyy"}, {"axes": "xy"}, {"axes": None},
                      {"directions": np.zeros((3, 3))}, {"directions": np.ones((3, 3))}, {"directions": np.eye(2)},
                      {"directions": np.full((3, 3), np.nan)}, {"spacing": 1e-12}):
            with self.subTest(words), self.assertRaises(ValueError):
                isolux.Volume(array, **words)


class Taken(unittest.TestCase):
    def test_types_keep_their_values(self):
        base = (10 * smooth_field((4, 5, 6))).round()
        for dtype in ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f2", "f4", "f8", "g", ">i2", ">f2", ">f4", ">f8", ">u8", "?"):
            array = (base - base.min()).astype(dtype)
            with self.subTest(dtype), warnings.catch_warnings():
                warnings.simplefilter("error")
                volume = isolux.Volume(array)
                np.testing.assert_array_equal(values_of(volume, array.shape), array.astype(np.float64))

    def test_values_that_change_warn(self):
        wide = np.array([0.1, 1e6 + 0.01, 3.3, 7.7, 1e6, 2e6, 5.5, 0.0]).reshape(2, 2, 2)
        with self.assertWarns(isolux.IsoluxWarning):
            isolux.Volume(wide)
        with self.assertWarnsRegex(isolux.IsoluxWarning, "kept as float32"):
            isolux.Volume(wide.astype(np.longdouble))
        with self.assertWarnsRegex(isolux.IsoluxWarning, "rounded to float64"):
            isolux.Volume((np.arange(27, dtype=np.longdouble) / 3).reshape(3, 3, 3))

    def test_memory_that_is_not_in_order(self):
        base = smooth_field((6, 7, 8)).astype(np.float32)
        for name, array in {"reversed": base[::-1, :, ::-1], "strided": np.repeat(base, 2, axis=1)[:, ::2],
                            "fortran": np.asfortranarray(base), "transposed": base.T.copy().T,
                            "broadcast": np.broadcast_to(base[:1], base.shape)}.items():
            with self.subTest(name), warnings.catch_warnings():
                warnings.simplefilter("error")
                np.testing.assert_array_equal(values_of(isolux.Volume(array), array.shape), array)

    def test_memory_of_others(self):
        base = smooth_field((4, 5, 6)).astype(np.float32)
        locked = base.copy()
        locked.flags.writeable = False
        np.testing.assert_array_equal(values_of(isolux.Volume(locked), base.shape), base)
        shared = multiprocessing.shared_memory.SharedMemory(create=True, size=base.nbytes)
        try:
            array = np.ndarray(base.shape, base.dtype, buffer=shared.buf)
            array[:] = base
            volume = isolux.Volume(array)
            array[:] = 0  # a copy was taken
            np.testing.assert_array_equal(values_of(volume, base.shape), base)
            del array
        finally:
            shared.close()
            shared.unlink()
        unaligned = np.frombuffer(b"\0" + base.tobytes(), np.uint8)[1:].view(base.dtype).reshape(base.shape)
        np.testing.assert_array_equal(values_of(isolux.Volume(unaligned), base.shape), base)
        mapped = np.memmap("/dev/zero", np.uint8, "r", shape=(2, 3, 4)) if os.path.exists("/dev/zero") else np.zeros((2, 3, 4))
        isolux.Volume(np.array(mapped))

    def test_missing_voxels(self):
        array = ball(12)
        array[3, 4, 5], array[0, 0, 0] = np.nan, np.inf
        with self.assertWarnsRegex(isolux.IsoluxWarning, "2 of 1728 voxels are NaN or infinite"):
            volume = isolux.Volume(array)
        self.assertEqual(volume.facts.missing, 2)
        masked = np.ma.masked_less(ball(12, 4), -2)
        with self.assertWarnsRegex(isolux.IsoluxWarning, "masked"):
            self.assertEqual(isolux.Volume(masked).facts.missing, int(masked.mask.sum()))
        with self.assertWarns(isolux.IsoluxWarning):
            nothing = isolux.Volume(np.full((4, 4, 4), np.nan))
            self.assertTrue(np.isnan(nothing.hits((0, 0, -9), (0, 0, 1), 0.0).t))

    def test_few_voxels(self):
        for shape in ((1, 1, 1), (1, 1, 9), (2, 1, 2), (2, 2, 2), (1, 8, 8)):
            with self.subTest(shape), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                volume = isolux.Volume(np.arange(np.prod(shape), dtype=np.float32).reshape(shape))
                volume.render(isovalue=0.5, size=(16, 12), look="lambert", aovs=["depth"])
                volume.probe([[0, 0, 0]])

    def test_any_values(self):
        for array in (np.zeros((5, 5, 5)), np.full((5, 5, 5), 1e300), np.full((5, 5, 5), -1e-300),
                      np.array([np.finfo(float).max, np.finfo(float).min] * 4).reshape(2, 2, 2),
                      np.array([2**63, 2**64 - 1] * 4, np.uint64).reshape(2, 2, 2),
                      np.random.default_rng(1).integers(0, 256, 8 * 125, np.uint8).view(np.float64).reshape(5, 5, 5)):
            with self.subTest(str(array.flat[0])), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                volume = isolux.Volume(array)
                volume.render(size=(16, 12), look="lambert")


class Axes(unittest.TestCase):
    def test_any_order_is_the_same_volume(self):
        base = smooth_field((6, 7, 8)).astype(np.float32)
        one = isolux.Volume(base, (3, 2, 1), origin=(10, 20, 30))
        for axes in ("xyz", "yxz", "zxy", "xzy", "yzx"):
            order = ["zyx".index(letter) for letter in axes]
            other = isolux.Volume(base.transpose(order), [(3, 2, 1)[i] for i in order], origin=(10, 20, 30), axes=axes)
            with self.subTest(axes):
                self.assertEqual(one.facts.data_hash, other.facts.data_hash)
                self.assertEqual(other.shape, base.transpose(order).shape)
                self.assertIn(f"({', '.join(axes)})", repr(other))

    def test_the_last_axis_is_x(self):
        volume = isolux.Volume(smooth_field((6, 7, 8)).astype(np.float32), (3, 2, 1), origin=(10, 20, 30))
        self.assertEqual(volume.facts.dims, (8, 7, 6))
        self.assertEqual((volume.shape, volume.spacing), ((6, 7, 8), (3, 2, 1)))
        self.assertIn("6 x 7 x 8 voxels (z, y, x)", repr(volume))
        np.testing.assert_array_equal(volume.world([1, 2, 3]), [13, 24, 33])

    def test_directions(self):
        array = smooth_field((5, 6, 7)).astype(np.float32)
        turned = [[0, 0, -1], [1, 0, 0], [0, 2, 0]]  # of z, y, x
        volume = isolux.Volume(array, (3, 2, 1), directions=turned, origin=(1, 1, 1))
        np.testing.assert_allclose(volume.directions, [[0, 0, -1], [1, 0, 0], [0, 1, 0]])
        np.testing.assert_allclose(volume.world([1, 2, 3]), [1 + 4, 1 + 3, 1 - 3])
        np.testing.assert_allclose(values_of(volume, array.shape), array, rtol=0, atol=1e-6)

    def test_nibabel(self):
        import nibabel

        array = smooth_field((5, 6, 7)).astype(np.float32)
        affine = np.array([[0, -2.0, 0, 5], [1.5, 0, 0, -7], [0, 0, 3, 11], [0, 0, 0, 1]])
        volume = isolux.from_nibabel(nibabel.Nifti1Image(array, affine))
        self.assertEqual(volume.axes, "xyz")
        ras = affine @ [1, 2, 3, 1]
        np.testing.assert_allclose(volume.world([1, 2, 3]), [-ras[0], -ras[1], ras[2]])
        np.testing.assert_allclose(values_of(volume, array.shape), array, rtol=1e-12)
        image = nibabel.Nifti1Image(array, affine)
        image.header.set_xyzt_units("micron")
        np.testing.assert_allclose(isolux.from_nibabel(image).world([1, 2, 3]), volume.world([1, 2, 3]) / 1000)


if __name__ == "__main__":
    unittest.main()
