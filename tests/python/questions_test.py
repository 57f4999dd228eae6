"""First hits, fields and measures against closed forms, an intersector of our own and scipy's splines."""

import os
import unittest

import numpy as np
from scipy import ndimage

import isolux
from support import ball, command, smooth_field, temporary_folder


def trilinear(array, voxel):
    """Value at (x, y, z) of an array [z, y, x]."""
    return ndimage.map_coordinates(array.astype(np.float64), np.asarray(voxel)[::-1].reshape(3, -1), order=1, mode="nearest")[0]


def first_crossing(array, isovalue, origin, direction):
    """Of the trilinear field, by walking from grid plane to grid plane and solving the cubic between: voxels are mm."""
    planes = [0.0]
    for a in range(3):
        if direction[a] != 0:
            planes += [(k - origin[a]) / direction[a] for k in range(array.shape[2 - a])]
    planes = sorted(t for t in planes if t >= 0)
    for near, far in zip(planes, planes[1:]):
        middle = origin + direction * (near + far) / 2
        if far - near < 1e-12 or (middle < 0).any() or (middle > np.array(array.shape[::-1]) - 1).any():
            continue
        nodes = np.linspace(near, far, 4)
        values = [trilinear(array, origin + direction * t) - isovalue for t in nodes]
        cubic = np.polynomial.Polynomial.fit(nodes, values, 3)
        roots = [r.real for r in cubic.roots() if abs(r.imag) < 1e-9 and near - 1e-12 <= r.real <= far + 1e-12]
        for root in sorted(roots):
            if cubic(root - 1e-6) * cubic(root + 1e-6) < 0:
                return root
    return np.nan


class Hits(unittest.TestCase):
    def test_they_are_those_of_another_intersector(self):
        array = smooth_field((9, 10, 11))
        array = array.astype(np.float32)
        volume = isolux.Volume(array)
        rng = np.random.default_rng(7)
        count = 150
        inside = rng.uniform(0, 1, (count, 3)) * [10, 9, 8]
        directions = rng.normal(size=(count, 3))
        directions /= np.linalg.norm(directions, axis=1)[:, None]
        origins = inside - 30 * directions
        found = volume.hits(origins, directions, 0.6)
        ours = np.array([first_crossing(array, 0.6, *ray) for ray in zip(origins, directions)])
        self.assertGreater(np.isfinite(ours).sum(), 50)
        np.testing.assert_array_equal(np.isfinite(found.t), np.isfinite(ours))
        np.testing.assert_allclose(found.t, ours, rtol=0, atol=1e-7)
        np.testing.assert_allclose(found.position, origins + directions * found.t[:, None], atol=1e-12)
        self.assertLess(np.nanmax(found.value_error), 1e-12)

    def test_they_are_those_of_the_command_to_the_last_bit(self):
        rng = np.random.default_rng(3)
        origins, directions = rng.uniform(-40, 40, (40, 3)), rng.normal(size=(40, 3))
        with temporary_folder() as folder:
            file = os.path.join(folder, "rays.csv")
            np.savetxt(file, np.hstack([origins, directions]), "%.17g", ",")
            import json
            rows = json.loads(command("probe", "phantom:head:40", "--isovalue", "300", "--rays", file, "--json"))
        found = isolux.open("phantom:head:40").hits(origins, directions, 300)
        for i, row in enumerate(rows):
            hit = row["hit"]
            self.assertEqual(hit is None, bool(np.isnan(found.t[i])))
            if hit is not None:
                self.assertEqual((hit["t_mm"], hit["position_mm"], hit["entering"], hit["t_error_mm"]),
                                 (found.t[i], list(found.position[i]), found.entering[i], found.error[i]))
        self.assertGreater(np.isfinite(found.t).sum(), 5)

    def test_a_ball_within_the_bound(self):
        volume = isolux.Volume(ball(40, 12.0))
        rng = np.random.default_rng(5)
        directions = rng.normal(size=(500, 3))
        directions /= np.linalg.norm(directions, axis=1)[:, None]
        found = volume.hits(19.5 - 40 * directions, directions, 0)
        miss = np.abs(found.t - (40 - 12.0))
        self.assertTrue((miss <= found.error).all())
        self.assertLess(np.median(found.error), 0.2)
        self.assertTrue(found.entering.all())
        np.testing.assert_allclose(found.normal, -directions, atol=0.02)

    def test_shapes(self):
        volume = isolux.Volume(ball(16, 5))
        found = volume.hits(np.full((2, 3, 3), 7.5) + [0, 0, -20], (0, 0, 2), 0)
        self.assertEqual((found.t.shape, found.position.shape, found.entering.dtype), ((2, 3), (2, 3, 3), np.bool_))
        np.testing.assert_allclose(found.t, 15, atol=0.1)  # mm, whatever the length of the direction
        self.assertEqual(volume.hits((7.5, 7.5, -20), (0, 0, 1), 0).t.shape, ())
        self.assertEqual(volume.hits(np.zeros((0, 3)), (0, 0, 1), 0).t.shape, (0,))
        for origins, directions in (((1, 2), (1, 2)), (np.zeros((2, 3)), np.zeros((3, 3))), ("a", "b"), (5, (0, 0, 1))):
            with self.subTest(str(origins)), self.assertRaises(ValueError):
                volume.hits(origins, directions, 0)

    def test_what_is_no_ray_hits_nothing(self):
        volume = isolux.Volume(ball(16, 5))
        for direction in ((0, 0, 0), (np.nan, 0, 1), (np.inf, 0, 0), (1e300, 1e300, 1e300), (1e-320, 0, 0)):
            with self.subTest(direction):
                volume.hits((7.5, 7.5, -20), direction, 0)
        self.assertTrue(np.isnan(volume.hits((np.nan, 0, 0), (0, 0, 1), 0).t))
        self.assertTrue(np.isnan(volume.hits((7.5, 7.5, -20), (0, 0, -1), 0).t))


class Probe(unittest.TestCase):
    def test_values_are_those_of_scipy(self):
        array = np.random.default_rng(11).normal(size=(40, 41, 42))
        volume = isolux.Volume(array.astype(np.float32))
        points = np.random.default_rng(12).uniform(18, 22, (200, 3))  # the border's own rule fades by 0.27 each voxel
        spline = array.astype(np.float32).astype(np.float64)
        for field, prefilter, order in (("cubic_interpolating", True, 3), ("cubic", False, 3), ("trilinear", False, 1)):
            found = volume.probe(points, settings={"hit.field": field, "derivatives.scale": 0}).value
            theirs = ndimage.map_coordinates(spline, points[:, ::-1].T, order=order, prefilter=prefilter, mode="mirror")
            with self.subTest(field):
                # Coefficients are kept as float32.
                np.testing.assert_allclose(found, theirs, rtol=0, atol=2e-6 if prefilter else 1e-13)

    def test_derivatives_are_those_of_the_spline(self):
        array = np.random.default_rng(11).normal(size=(12, 13, 14)).astype(np.float32)
        spacing = np.array([3.0, 2.0, 0.5])
        volume = isolux.Volume(array, spacing)
        points = np.random.default_rng(12).uniform(3, 8, (60, 3)) * spacing[::-1]
        found = volume.probe(points, settings={"derivatives.field": "cubic", "derivatives.scale": 0})

        def value(at):
            return ndimage.map_coordinates(array.astype(np.float64), (at / spacing[::-1])[:, ::-1].T, order=3, prefilter=False)

        step = 1e-4
        for a in range(3):
            e = np.zeros(3)
            e[a] = step
            slope = (value(points + e) - value(points - e)) / (2 * step)
            np.testing.assert_allclose(found.gradient[:, a], slope, rtol=1e-5, atol=1e-6)
            bend = (value(points + e) - 2 * value(points) + value(points - e)) / step**2
            np.testing.assert_allclose(found.hessian[:, a, a], bend, rtol=1e-4, atol=1e-5)
        np.testing.assert_array_equal(found.hessian, found.hessian.transpose(0, 2, 1))
        self.assertEqual(found.scale_mm, 0)

    def test_curvature_of_a_ball(self):
        volume = isolux.Volume(ball(40, 12.0))
        found = volume.probe([[19.5 + 12, 19.5, 19.5], [19.5, 19.5 - 12, 19.5]], settings={"derivatives.scale": 0})
        np.testing.assert_allclose(found.kappa, 1 / 12, rtol=0.02)
        np.testing.assert_allclose(found.normal, [[1, 0, 0], [0, -1, 0]], atol=1e-3)

    def test_outside_there_is_nothing(self):
        found = isolux.Volume(ball(12)).probe([[-1, 0, 0], [np.nan, 1, 1], [5, 5, 5]])
        np.testing.assert_array_equal(np.isnan(found.value), [True, True, False])
        self.assertTrue(np.isnan(found.hessian[0]).all())


class Measure(unittest.TestCase):
    def test_a_ball(self):
        found = isolux.Volume(ball(64, 24.0, spacing=0.5), 0.5).measure(0)  # radius 24 mm is beyond; see below
        self.assertTrue(found.open)
        found = isolux.Volume(ball(64, 12.0, spacing=0.5), 0.5).measure(0)
        self.assertFalse(found.open)
        self.assertLess(abs(found.area_mm2.value - 4 * np.pi * 144), found.area_mm2.error)
        self.assertLess(abs(found.volume_mm3.value - 4 / 3 * np.pi * 12**3), found.volume_mm3.error)
        self.assertEqual([piece.id for piece in found.pieces], [0])

    def test_it_is_that_of_the_command(self):
        import json
        theirs = json.loads(command("measure", "phantom:head:48", "--isovalue", "300", "--json"))
        ours = isolux.open("phantom:head:48").measure(300)
        self.assertEqual(ours, theirs)

    def test_no_surface_is_an_error(self):
        with self.assertRaisesRegex(ValueError, "no surface; the data range is"):
            isolux.Volume(ball(12)).measure(1e6)

    def test_doubtful_lengths(self):
        with temporary_folder() as folder:
            raw = os.path.join(folder, "ball.raw")
            ball(16, 5).tofile(raw)
            volume = isolux.open(raw, raw="16x16x16 float32")
            try:
                volume.measure(0)
            except OSError as error:
                self.assertIn("lengths are doubtful", str(error))
                self.assertIn("doubt", volume.measure(0, anyway=True))


class MeasureLabels(unittest.TestCase):
    def labels(self):
        z, y, x = np.mgrid[:30, :34, :52]
        labels = np.zeros(x.shape, np.uint16)
        for label, (cx, cy, cz, radius) in {3: (13, 17, 15, 9.5), 700: (33, 12, 14, 7.2), 12: (41, 25, 16, 6.1)}.items():
            labels[(x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2 <= radius**2] = label
        return labels

    def test_counts_are_those_of_numpy(self):
        labels = self.labels()
        counts = np.bincount(labels.ravel())
        found = isolux.Volume(labels, (2.0, 0.5, 0.75)).measure_labels().labels
        self.assertEqual([label.label for label in found], [3, 12, 700])
        pieces = {label: ndimage.label(labels == label)[1] for label in (3, 12, 700)}
        for label in found:
            self.assertEqual(label.voxels, counts[label.label])
            self.assertEqual(label.counted_mm3, counts[label.label] * 0.75)
            self.assertEqual(label.pieces, pieces[label.label])
            self.assertEqual((label.name, label.open, label.thin_share < 0.01), ("", False, True))
            self.assertLess(abs(label.volume_mm3.value / label.counted_mm3 - 1), 0.04)
            self.assertGreater(label.area_mm2.error, 0)
            inside = np.argwhere(labels == label.label)[:, ::-1] * (0.75, 0.5, 2.0)  # x, y, z in mm
            beyond = np.subtract(label.bounds_mm, [inside.min(0), inside.max(0)]) * [[-1], [1]]
            self.assertTrue(((beyond > 0) & (beyond < (0.75, 0.5, 2.0))).all(), beyond)  # half a voxel from a face at most

    def test_they_are_those_of_the_command(self):
        import json
        with temporary_folder() as folder:
            raw = os.path.join(folder, "labels.raw")
            self.labels().tofile(raw)
            words = ("measure", raw, "--raw", "52x34x30 uint16 spacing 0.75,0.5,2", "--labels", "--smoothing", "1.5")
            table = os.path.join(folder, "labels.csv")
            theirs = json.loads(command(*words, "--json", "--out", table))
            ours = isolux.open(raw, raw="52x34x30 uint16 spacing 0.75,0.5,2").measure_labels(1.5)
            self.assertEqual(ours, theirs)
            rows = np.genfromtxt(table, delimiter=",", names=True)
            np.testing.assert_array_equal(rows["voxels"], [label.voxels for label in ours.labels])
            np.testing.assert_array_equal(rows["area_error_mm2"], [label.area_mm2.error for label in ours.labels])
            np.testing.assert_array_equal(rows["high_z_mm"], [label.bounds_mm[1][2] for label in ours.labels])

    def test_what_is_no_label_map_is_refused(self):
        with self.assertRaisesRegex(ValueError, "is not a whole number"):
            isolux.Volume(ball(12)).measure_labels()
        with self.assertRaisesRegex(OSError, "do not look like labels"):
            isolux.open("phantom:head:32").measure_labels()
        with self.assertRaisesRegex(ValueError, "smoothing: must be from 0 to 2 voxels"):
            isolux.Volume(self.labels()).measure_labels(2.5)
        with self.assertRaisesRegex(ValueError, "no label but 0"):
            isolux.Volume(np.zeros((4, 4, 4), np.uint8)).measure_labels()


class LightAndStudies(unittest.TestCase):
    def test_a_bake_is_read_again(self):
        with temporary_folder() as folder:
            file = os.path.join(folder, "light.vti")
            words = {"settings": {"gi.samples": 8, "gi.texels": "own"}, "environment": "studio"}
            with isolux.Volume(ball(16, 5)) as volume:
                stats = volume.bake(file, 0, **words)
                self.assertGreater(stats.bake.texels, 0)
                picture = volume.render(0, "gi", size=(40, 30), light=file, **words)
                self.assertEqual(picture.stats.bake.mode, stats.bake.mode)
                with self.assertWarnsRegex(isolux.IsoluxWarning, "held other light and was replaced"):
                    volume.bake(file, 0, **dict(words, environment="overcast"))
                with self.assertRaises(ValueError):
                    volume.bake(os.path.join(folder, "light.png"), 0)
                with open(os.path.join(folder, "other.vti"), "w", encoding="utf-8") as other:
                    other.write("mine")
                with self.assertRaisesRegex(OSError, "overwrite=True"):
                    volume.bake(other.name, 0)

    def test_a_study(self):
        with isolux.Volume(ball(16, 5)) as volume:
            study = volume.study("rate", 0, size=(32, 32), repeat=1)
            self.assertIn("rate", json_names(study))
            with self.assertRaisesRegex(ValueError, "rate"):
                volume.study("raet", 0)


def json_names(study):
    return [knob["knob"] if "knob" in knob else knob["name"] for knob in study.knobs]


if __name__ == "__main__":
    unittest.main()
