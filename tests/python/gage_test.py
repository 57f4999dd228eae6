"""Values and derivatives against Teem's gage (Kindlmann), an independent implementation of the same B-spline."""

import ctypes
import ctypes.util
import unittest

import numpy as np

import isolux

# Numbers of Teem 1.12's headers: nrrd.h and gage.h.
NRRD_TYPE_DOUBLE, AXIS_INFO_SPACING, AXIS_INFO_CENTER, CENTER_NODE = 10, 2, 7, 1
KERNEL_00, KERNEL_11, KERNEL_22 = 1, 3, 6
VALUE, GRADIENT, HESSIAN = 1, 2, 7


class Gage:
    """A probe of the B-spline of the samples of an array [z, y, x]; voxel coordinates, derivatives per voxel.

    gage takes the volume for the cube from -1 to 1 along its longest axis, and derivatives by that.
    """

    def __init__(self, values):
        teem = ctypes.CDLL(ctypes.util.find_library("teem"))
        for name in ("nrrdNew", "gageContextNew", "gagePerVolumeNew", "gageAnswerPointer"):
            getattr(teem, name).restype = ctypes.c_void_p
        self._teem, self._values = teem, np.ascontiguousarray(values, np.float64)
        nrrd = ctypes.c_void_p(teem.nrrdNew())
        sizes = (ctypes.c_size_t * 3)(*values.shape[::-1])
        self._check(teem.nrrdWrap_nva(nrrd, self._values.ctypes.data_as(ctypes.c_void_p), NRRD_TYPE_DOUBLE, 3, sizes))
        teem.nrrdAxisInfoSet_nva(nrrd, AXIS_INFO_SPACING, (ctypes.c_double * 3)(1, 1, 1))
        teem.nrrdAxisInfoSet_nva(nrrd, AXIS_INFO_CENTER, (ctypes.c_int * 3)(*[CENTER_NODE] * 3))
        self._context = ctypes.c_void_p(teem.gageContextNew())
        kind = ctypes.c_void_p.in_dll(teem, "gageKindScl")
        volume = ctypes.c_void_p(teem.gagePerVolumeNew(self._context, nrrd, kind))
        self._check(teem.gagePerVolumeAttach(self._context, volume))
        for which, name in ((KERNEL_00, "nrrdKernelBSpline3"), (KERNEL_11, "nrrdKernelBSpline3D"),
                            (KERNEL_22, "nrrdKernelBSpline3DD")):
            kernel = ctypes.c_void_p.in_dll(teem, name)
            self._check(teem.gageKernelSet(self._context, which, kernel, (ctypes.c_double * 8)()))
        for item in (VALUE, GRADIENT, HESSIAN):
            self._check(teem.gageQueryItemOn(self._context, volume, item))
        self._check(teem.gageUpdate(self._context))
        self._answers = {}
        for item, count in ((VALUE, 1), (GRADIENT, 3), (HESSIAN, 9)):
            pointer = teem.gageAnswerPointer(self._context, volume, item)
            self._answers[item] = ctypes.cast(pointer, ctypes.POINTER(ctypes.c_double * count)).contents

    def _check(self, status):
        if status:
            raise RuntimeError("gage could not be set up")

    def at(self, voxel):
        self._check(self._teem.gageProbe(self._context, *map(ctypes.c_double, voxel)))
        step = 2 / (max(self._values.shape) - 1)
        return [np.array(self._answers[item]) * step**order for order, item in enumerate((VALUE, GRADIENT, HESSIAN))]


class AsGageHasIt(unittest.TestCase):
    def test_values_and_derivatives(self):
        values = np.random.default_rng(4).normal(size=(16, 17, 18)).astype(np.float32)
        gage = Gage(values)
        points = np.random.default_rng(5).uniform(2, 13, (300, 3))
        found = isolux.Volume(values).probe(
            points, settings={"hit.field": "cubic", "derivatives.field": "cubic", "derivatives.scale": 0})
        for i, point in enumerate(points):
            value, gradient, hessian = gage.at(point)
            np.testing.assert_allclose(found.value[i], value[0], rtol=0, atol=1e-13)
            np.testing.assert_allclose(found.gradient[i], gradient, rtol=0, atol=1e-13)
            np.testing.assert_allclose(found.hessian[i], hessian.reshape(3, 3), rtol=0, atol=1e-13)


if __name__ == "__main__":
    unittest.main()
