"""Pictures and deferred images are those of `isolux render`, bit for bit."""

import os
import unittest
import warnings

import numpy as np

import isolux
from support import ball, bytes_of, command, temporary_folder

# Of each scene: the volume, what Python is asked for, and the same on the command line.
SCENES = {
    "as it comes": ("phantom:head:48", {}, []),
    "isovalue and camera": (
        "phantom:gyroid:40",
        {"isovalue": 0.2, "camera": ((30, -90, 40), (0, 0, 0), (0, 0, 1), 35)},
        ["--isovalue", "0.2", "--camera", "30,-90,40 0,0,0 0,0,1 35"]),
    "normals of a side": ("phantom:torus:40", {"look": "normal", "view": "left", "fit": "surface"},
                          ["--look", "normal", "--view", "left", "--fit", "surface"]),
    "curvature": ("phantom:torus:40", {"look": "kappa1", "settings": {"derivatives.scale": 1.5}},
                  ["--look", "kappa1", "--set", "derivatives.scale=1.5"]),
    "stored light": ("phantom:torus:32", {"look": "gi", "environment": "studio", "settings": {"gi.samples": 16}},
                     ["--look", "gi", "--environment", "studio", "--set", "gi.samples=16"]),
    "a transparent picture": ("phantom:ball:32", {"look": "lambert", "settings": {"picture.transparent": True}},
                              ["--look", "lambert", "--set", "picture.transparent=true"]),
    "several rays per pixel": ("phantom:head:40", {"look": "blinn_phong", "settings": {"picture.supersampling": 3}},
                               ["--look", "blinn_phong", "--set", "picture.supersampling=3"]),
    "another field": ("phantom:head:40", {"look": "tone", "settings": {"hit.field": "cubic", "look.ridges": 1.0}},
                      ["--look", "tone", "--set", "hit.field=cubic", "--set", "look.ridges=1"]),
    "sampled hits of a cut": (
        "phantom:gyroid:40",
        {"look": "lambert", "settings": {"hit.method": "sampled", "clip.planes": [[0, 0, 0, 1, 0, 0]]}},
        ["--look", "lambert", "--set", "hit.method=sampled", "--set", "clip.planes=[[0,0,0,1,0,0]]"]),
    "a nearer view with letters": (
        "phantom:head:40",
        {"azimuth": 30, "elevation": 10, "zoom": 1.5, "look": "lambert",
         "settings": {"picture.letters": True, "picture.scale_bar": True, "picture.isovalue": True}},
        ["--azimuth", "30", "--elevation", "10", "--zoom", "1.5", "--look", "lambert", "--set", "picture.letters=true", "--set",
         "picture.scale_bar=true", "--set", "picture.isovalue=true"]),
}
IMAGES = ["position", "voxel", "depth", "value_error", "normal", "gradient", "hessian", "kappa", "direction1", "direction2",
          "flowline_curvature", "curvature_confidence", "scale", "piece", "hit"]


class TheSamePictures(unittest.TestCase):
    def test_files_are_the_same_bytes(self):
        for name, (source, asked, words) in SCENES.items():
            with self.subTest(name), temporary_folder() as folder:
                ours, theirs = os.path.join(folder, "a.png"), os.path.join(folder, "b.png")
                command("render", source, "--out", theirs, "--size", "200x160", *words)
                with isolux.open(source) as volume:
                    volume.render(size=(200, 160), **asked).save(ours)
                self.assertEqual(bytes_of(ours), bytes_of(theirs))

    def test_deferred_images_are_the_same_bytes(self):
        for name, (source, asked, words) in SCENES.items():
            if asked.get("look") == "gi":
                continue  # below
            with self.subTest(name), temporary_folder() as folder:
                ours, theirs = os.path.join(folder, "a.exr"), os.path.join(folder, "b.exr")
                command("render", source, "--out", theirs, "--size", "120x90", "--aov", ",".join(IMAGES), *words)
                with isolux.open(source) as volume:
                    volume.render(size=(120, 90), aovs=IMAGES, **asked).save(ours)
                self.assertEqual(bytes_of(ours), bytes_of(theirs))

    def test_irradiance_beside_a_picture_is_that_without_one(self):
        source, asked, words = SCENES["stored light"]
        with temporary_folder() as folder, isolux.open(source) as volume:
            ours, theirs = os.path.join(folder, "a.exr"), os.path.join(folder, "b.exr")
            command("render", source, "--out", theirs, "--size", "120x90", "--aov", "irradiance", *words)
            volume.render(size=(120, 90), aovs="irradiance", **asked).save(ours)
            self.assertEqual(bytes_of(ours), bytes_of(theirs))

    def test_linear_pictures_are_the_same_bytes(self):
        with temporary_folder() as folder, isolux.open("phantom:ball:32") as volume:
            ours, theirs = os.path.join(folder, "a.exr"), os.path.join(folder, "b.exr")
            command("render", "phantom:ball:32", "--out", theirs, "--size", "120x90", "--look", "lambert")
            picture = volume.render(size=(120, 90), look="lambert", linear=True)
            picture.save(ours)
            self.assertEqual(bytes_of(ours), bytes_of(theirs))
            self.assertEqual(picture.linear.shape, (90, 120, 4))

    def test_a_second_picture_is_that_of_a_new_volume(self):
        with isolux.open("phantom:head:40") as volume, isolux.open("phantom:head:40") as other:
            volume.render(size=(100, 80), look="lambert")
            volume.render(size=(60, 90), look="kappa1", isovalue=100, aovs="kappa")
            again = volume.render(size=(100, 80), look="normal", isovalue=200)
            np.testing.assert_array_equal(again.image, other.render(size=(100, 80), look="normal", isovalue=200).image)

    def test_an_array_is_the_file_that_holds_it(self):
        values = ball(24)
        with temporary_folder() as folder:
            raw = os.path.join(folder, "ball.raw")
            values.tofile(raw)
            words = "24x24x24 float32 little spacing 0.5,0.7,0.9"
            with isolux.open(raw, raw=words) as volume, isolux.Volume(values, (0.9, 0.7, 0.5)) as array:
                one = volume.render(isovalue=1.5, size=(80, 60), look="lambert", aovs=["position"])
                two = array.render(isovalue=1.5, size=(80, 60), look="lambert", aovs=["position"])
                np.testing.assert_array_equal(one.image, two.image)
                np.testing.assert_array_equal(one.aov.position, two.aov.position)


class WhatAPictureHas(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.volume = isolux.Volume(ball(32))

    def test_images_have_their_shapes(self):
        picture = self.volume.render(isovalue=0, size=(64, 48), look="lambert", aovs=["depth", "normal", "kappa", "hit"])
        self.assertEqual(picture.image.shape, (48, 64, 3))
        self.assertEqual(picture.image.dtype, np.uint8)
        self.assertEqual({name: image.shape for name, image in picture.aov.items()},
                         {"depth": (48, 64), "normal": (48, 64, 3), "kappa": (48, 64, 2), "hit": (48, 64)})
        self.assertEqual(picture.aov.depth.dtype, np.float32)

    def test_row_0_is_the_top(self):
        with isolux.Volume(ball(32), origin=(0, 0, 0)) as volume:
            picture = volume.render(isovalue=0, size=(64, 48), view="anterior", aovs=["position"], image=False)
            z = picture.aov.position[..., 2]
            self.assertGreater(np.nanmean(z[:24]), np.nanmean(z[24:]))
            self.assertIsNone(picture.image)

    def test_points_of_a_ball_lie_on_it(self):
        position = self.volume.render(isovalue=0, size=(64, 48), aovs="position", image=False).aov["position"]
        distance = np.linalg.norm(position - 15.5, axis=-1)
        self.assertGreater(np.isfinite(distance).sum(), 300)
        np.testing.assert_allclose(distance[np.isfinite(distance)], 10.0, atol=0.06)

    def test_images_stay_when_the_volume_goes(self):
        with isolux.Volume(ball(16)) as volume:
            picture = volume.render(isovalue=0, size=(32, 24), look="lambert", aovs=["depth"])
        depth = picture.aov.depth
        image = picture.image
        del picture, volume
        self.assertTrue(np.isfinite(depth).any())
        self.assertGreater(image.max(), 0)
        self.assertFalse(depth.flags.writeable)

    def test_a_notebook_shows_it(self):
        picture = self.volume.render(isovalue=0, size=(32, 24), look="lambert")
        self.assertTrue(picture._repr_png_().startswith(b"\x89PNG"))
        self.assertIn("32 x 24", repr(picture))

    def test_its_session_draws_it_again(self):
        with temporary_folder() as folder, isolux.open("phantom:ball:24") as volume:
            file = os.path.join(folder, "ball.png")
            picture = volume.render(isovalue=1, size=(50, 40), look="normal", azimuth=20)
            picture.save(file)
            self.assertIn('"normal"', picture.session)
            with isolux.open(file) as again:
                np.testing.assert_array_equal(again.render().image, picture.image)

    def test_stats_are_those_of_the_command(self):
        stats = self.volume.render(isovalue=0, size=(32, 24), look="lambert").stats
        self.assertEqual(stats.size, [32, 24])
        self.assertEqual(stats["isovalue"], 0)
        self.assertIn("cast", [one.name for one in stats.passes])

    def test_an_empty_picture_warns(self):
        with self.assertWarnsRegex(isolux.IsoluxWarning, "the image is empty"):
            self.volume.render(isovalue=1e6, size=(16, 12))

    def test_bounds_of_errors(self):
        picture = self.volume.render(isovalue=0, size=(32, 24), aovs=["error_depth", "depth"], image=False)
        seen = np.isfinite(picture.aov.depth)
        self.assertTrue((picture.aov.error_depth[seen] > 0).all())

    def test_bounds_of_errors_are_in_the_file(self):
        with temporary_folder() as folder, isolux.open("phantom:ball:24") as volume:
            ours, theirs = os.path.join(folder, "a.exr"), os.path.join(folder, "b.exr")
            command("render", "phantom:ball:24", "--out", theirs, "--size", "60x45", "--aov", "depth,error_depth", "--look", "lambert")
            volume.render(size=(60, 45), look="lambert", aovs=["depth", "error_depth"], image=False).save(ours)
            self.assertEqual(bytes_of(ours), bytes_of(theirs))

    def test_a_session_stays_what_it_was_when_it_was_opened(self):
        before = os.getcwd()
        with temporary_folder() as folder, temporary_folder() as other, isolux.open("phantom:ball:16") as volume:
            volume.render(isovalue=2, size=(20, 16), look="normal", azimuth=50).save(os.path.join(folder, "a.png"))
            try:
                os.chdir(folder)
                with isolux.open("a.png") as reopened:
                    picture = reopened.render(size=(20, 16))
                    os.chdir(other)
                    np.testing.assert_array_equal(reopened.render(size=(20, 16)).image, picture.image)
                    with self.assertRaises(ValueError):
                        picture.save(os.path.join(folder, "a.png"))
            finally:
                os.chdir(before)

    def test_numbers_of_numpy_are_numbers(self):
        plane = np.array([0, 0, 4, 0, 0, 1], dtype=np.float32)
        for one in ([list(plane)], plane[None], [plane]):
            self.volume.render(isovalue=0, size=(20, 16), settings={"clip.planes": one})
        with self.assertRaises(ValueError):
            self.volume.render(settings={"clip.planes": [[object()]]})

    def test_another_light_is_not_taken_for_that_of_the_file(self):
        with temporary_folder() as folder, isolux.open("phantom:ball:16") as volume:
            file = os.path.join(folder, "light.vti")
            few = {"gi.samples": 4}
            volume.bake(file, environment="studio", settings=few)
            words = {"look": "gi", "size": (20, 16), "light": file}
            first = volume.render(environment="studio", settings=few, **words)
            with self.assertRaises(OSError):
                volume.render(environment="sunset", settings=few, **words)
            with self.assertRaises(OSError):
                volume.render(environment="sunset", settings=few, **words)
            again = volume.render(environment="studio", settings=few, **words)
            np.testing.assert_array_equal(first.image, again.image)

    def test_nothing_is_written_over_what_is_read(self):
        with temporary_folder() as folder:
            file = os.path.join(folder, "ball.png")
            with isolux.open("phantom:ball:16") as volume:
                volume.render(size=(20, 20), look="lambert").save(file)
            raw = os.path.join(folder, "ball.raw")
            ball(16).tofile(raw)
            with isolux.open(raw, raw="16x16x16 float32") as volume, warnings.catch_warnings():
                warnings.simplefilter("ignore")
                picture = volume.render(size=(20, 20), look="lambert")
                os.symlink(raw, os.path.join(folder, "link.png"))
                with self.assertRaises(ValueError):
                    picture.save(os.path.join(folder, "link.png"))
                with self.assertRaises(ValueError):
                    picture.save(os.path.join(folder, "picture.jpg"))


class Films(unittest.TestCase):
    def test_a_film(self):
        with temporary_folder() as folder, isolux.Volume(ball(16)) as volume:
            file = os.path.join(folder, "turn.mp4")
            isolux.film((volume.render(isovalue=0, size=(64, 48), look="lambert", azimuth=a) for a in range(0, 90, 30)), file)
            self.assertEqual(os.listdir(folder), ["turn.mp4"])
            with self.assertRaises(ValueError):
                isolux.film([], file)
            with self.assertRaises(ValueError):
                isolux.film([np.zeros((8, 8, 3), np.uint8), np.zeros((8, 9, 3), np.uint8)], os.path.join(folder, "b.mp4"))
            self.assertEqual(os.listdir(folder), ["turn.mp4"])


if __name__ == "__main__":
    unittest.main()
