"""How the module behaves: errors, interrupts, threads, progress, memory, references."""

import ctypes
import gc
import io
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
import unittest
import warnings
import weakref

import numpy as np

import isolux
from isolux import _progress
from support import ball, failure, temporary_folder


def resident_bytes():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE")


class HeapFigures(ctypes.Structure):
    """glibc's struct mallinfo2."""
    _fields_ = [(name, ctypes.c_size_t) for name in (
        "arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks", "fordblks", "keepcost")]


def allocated_bytes():
    """What was asked for and not given back: pages that the heaps of threads keep for later do not count."""
    mallinfo2 = ctypes.CDLL(None).mallinfo2
    mallinfo2.restype = HeapFigures
    figures = mallinfo2()
    return figures.uordblks + figures.hblkhd


class Errors(unittest.TestCase):
    def test_a_size_is_whole_pixels(self):
        volume = isolux.Volume(ball(8, 3))
        for size in ((64.5, 64), (64,), "64x64", (0, 64)):
            with self.subTest(size), self.assertRaises(ValueError):
                volume.render(0, size=size)
        self.assertEqual(volume.render(0, size=np.array([16, 12])).image.shape[:2], (12, 16))

    def test_they_say_what_the_command_says(self):
        volume = isolux.open("phantom:ball:16")
        for kind, call, words in (
                (OSError, lambda: isolux.open("/nowhere.nii"), ["info", "/nowhere.nii"]),
                (ValueError, lambda: isolux.open("phantom:bal:16"), ["info", "phantom:bal:16"]),
                (ValueError, lambda: volume.render(settings={"look.mod": "gi"}),
                 ["render", "phantom:ball:16", "--out", "/tmp/x.png", "--set", "look.mod=gi"]),
                (ValueError, lambda: volume.render(look="shiny"),
                 ["render", "phantom:ball:16", "--out", "/tmp/x.png", "--look", "shiny"]),
                (ValueError, lambda: volume.render(aovs="dept"),
                 ["render", "phantom:ball:16", "--out", "/tmp/x.exr", "--aov", "dept"]),
                (OSError, lambda: volume.render(look="gi", environment="/nowhere.hdr"),
                 ["render", "phantom:ball:16", "--out", "/tmp/x.png", "--look", "gi", "--environment", "/nowhere.hdr"]),
                (ValueError, lambda: volume.render(preset="ct_bone"),
                 ["render", "phantom:ball:16", "--out", "/tmp/x.png", "--preset", "ct_bone"]),
                (OSError, lambda: volume.render(session="/nowhere.isolux"),
                 ["render", "phantom:ball:16", "--out", "/tmp/x.png", "--session", "/nowhere.isolux"])):
            with self.subTest(words):
                line = failure(*words)
                with self.assertRaises((OSError, ValueError)) as caught:
                    call()
                self.assertEqual(str(caught.exception), line)
                self.assertIsInstance(caught.exception, (kind, ValueError))
                self.assertNotIn("\n", line)

    def test_arguments(self):
        volume = isolux.Volume(ball(12))
        for words in ({"size": 12}, {"size": (0, 4)}, {"size": (99999, 4)}, {"size": "big"}, {"image": False},
                      {"camera": (1, 2)}, {"camera": {"eyes": 1}}, {"context": "vulkan"}, {"fit": "all"}, {"view": "below"},
                      {"settings": {"source.path": "x"}}, {"settings": {"isosurface.value": object()}}):
            with self.subTest(words), self.assertRaises(ValueError):
                volume.render(**words)
        with self.assertRaises(TypeError):
            volume.render(progress=5)
        with self.assertRaises(TypeError):
            volume.render(no_such_word=5)

    def test_names_that_are_no_unicode(self):
        with isolux.open(b"phantom:ball:16") as volume:
            for ask in (lambda: isolux.open("/tmp/\udcff.nii"), lambda: isolux.open(b"/tmp/\xff.nii"),
                        lambda: volume.bake("/tmp/\udcff.vti"), lambda: volume.render(light="/tmp/\udcff.vti"),
                        lambda: volume.render(size=(8, 8)).save("/tmp/\udcff.png")):
                with self.assertRaisesRegex(ValueError, "UTF-8"):
                    ask()

    def test_a_closed_volume(self):
        volume = isolux.Volume(ball(12))
        volume.close()
        for call in (lambda: volume.render(), lambda: volume.hits((0, 0, 0), (0, 0, 1)), lambda: volume.measure()):
            with self.assertRaisesRegex(ValueError, "closed"):
                call()
        self.assertIn("closed", repr(volume))


class Interrupts(unittest.TestCase):
    def interrupt(self, call, after):
        """Makes calls until a signal stops one, which comes once this processor time was spent in them. What is spent between
        the signal and KeyboardInterrupt, in seconds of the processor."""
        begin, sent = time.process_time(), []

        def send():
            while time.process_time() - begin < after:
                time.sleep(0.001)
            sent.extend((time.process_time(), time.monotonic()))
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=send)
        thread.start()
        with self.assertRaises(KeyboardInterrupt):
            while True:
                call()
        spent = time.process_time() - sent[0]
        print(f"ended {1000 * (time.monotonic() - sent[1]):.0f} ms after the signal", file=sys.stderr)
        thread.join()
        return spent

    def test_long_work_stops_and_the_volume_goes_on(self):
        volume = isolux.Volume(ball(48, 16))
        words = {"look": "gi", "settings": {"gi.samples": 65536, "gi.extent": "full"}, "size": (64, 48)}
        self.interrupt(lambda: volume.render(0, **words), 0.4)  # the whole takes many minutes
        self.assertTrue(np.isfinite(volume.render(0, "lambert", size=(32, 24), aovs="depth").aov.depth).any())

    def test_rays_stop(self):
        volume = isolux.Volume(np.random.default_rng(1).normal(size=(64, 64, 64)).astype(np.float32))
        origins = np.random.default_rng(2).uniform(0, 63, (2_000_000, 3))
        directions = np.random.default_rng(3).normal(size=3)
        begin = time.process_time()
        volume.hits(origins, directions, 9.0)
        whole = time.process_time() - begin
        spent = self.interrupt(lambda: volume.hits(origins, directions, 9.0), 0.1 * whole)
        self.assertLess(spent, 0.5 * whole, "the rest was computed")

    def test_a_function_that_raises_stops_the_work(self):
        volume = isolux.Volume(ball(48, 16))

        def tell(fraction, stage):
            raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            volume.render(0, "gi", settings={"gi.samples": 65536, "gi.extent": "full"}, size=(64, 48), progress=tell)


class Threads(unittest.TestCase):
    def test_python_runs_meanwhile(self):
        volume = isolux.Volume(ball(32, 11))
        counted, done = [0], threading.Event()

        def count():
            while not done.is_set():
                counted[0] += 1
                time.sleep(0)

        thread = threading.Thread(target=count)
        thread.start()
        during = []  # a call that held Python's lock would let nothing through, whatever else the machine does
        while len(during) < 20 and max(during, default=0) <= 20:
            before = counted[0]
            volume.render(0, "gi", settings={"gi.samples": 256, "gi.extent": "full"}, size=(64, 48))
            during.append(counted[0] - before)
        done.set()
        thread.join()
        self.assertGreater(max(during), 20)

    def test_two_threads_draw_two_volumes(self):
        sizes = (20, 28)
        alone = [isolux.Volume(ball(n, n / 3)).render(0, "lambert", size=(60, 40)).image for n in sizes]
        drawn = [[], []]

        def draw(i):
            with isolux.Volume(ball(sizes[i], sizes[i] / 3)) as volume:
                for _ in range(8):
                    drawn[i].append(volume.render(0, "lambert", size=(60, 40)).image)
                    volume.render(0, "normal", size=(60, 40))

        threads = [threading.Thread(target=draw, args=(i,)) for i in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for i in range(2):
            self.assertEqual(len(drawn[i]), 8)
            for image in drawn[i]:
                np.testing.assert_array_equal(image, alone[i])

    def test_two_threads_ask_one_volume(self):
        volume = isolux.Volume(ball(24, 8))
        alone = {look: volume.render(0, look, size=(40, 30)).image for look in ("lambert", "normal")}
        wrong = []

        def draw(look):
            for _ in range(10):
                if not np.array_equal(volume.render(0, look, size=(40, 30)).image, alone[look]):
                    wrong.append(look)

        threads = [threading.Thread(target=draw, args=(look,)) for look in alone]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])

    def test_a_forked_process_is_told(self):
        volume = isolux.Volume(ball(12))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            child = os.fork()
        if child == 0:
            try:
                volume.render(0, size=(8, 8))
            except RuntimeError:
                os._exit(7)
            os._exit(0)
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 7)

    def test_a_forked_process_with_a_volume_of_its_own_draws_or_is_told(self):
        with isolux.Volume(ball(24, 8)) as volume:
            volume.render(0, "lambert", size=(8, 8))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            child = os.fork()
        if child == 0:
            try:
                signal.alarm(60)  # it hung
                own = isolux.Volume(ball(24, 8))
                own.measure(0)
                own.render(0, "lambert", size=(8, 8))
            except RuntimeError as error:
                os._exit(7 if "spawn" in str(error) else 8)
            finally:
                os._exit(0)
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), 7)

    def test_python_ends_with_volumes_open(self):
        for text in ("import isolux; v = isolux.open('phantom:ball:16'); v.render(look='lambert', size=(20, 20))",
                     "import isolux, threading; v = isolux.open('phantom:ball:32')\n"
                     "threading.Thread(target=lambda: v.render(look='gi', settings={'gi.samples': 4096}), daemon=True).start()"):
            several = [subprocess.Popen([sys.executable, "-c", text], stderr=subprocess.PIPE, text=True) for _ in range(4)]
            for one in several:
                _, errors = one.communicate(timeout=60)
                with self.subTest(text):
                    self.assertEqual((one.returncode, errors), (0, ""))


class Progress(unittest.TestCase):
    def test_a_function_hears_how_far_it_is(self):
        heard = []
        isolux.Volume(ball(40, 13)).render(0, "gi", settings={"gi.samples": 256, "gi.extent": "full"}, size=(64, 48),
                                           progress=lambda fraction, stage: heard.append((fraction, stage)))
        self.assertTrue(heard)
        self.assertTrue(all(0 <= fraction <= 1 and isinstance(stage, str) for fraction, stage in heard))

    def test_the_bar(self):
        out = io.StringIO()
        bar = _progress.Bar(out)
        bar(0.0, "reading")
        bar(0.5, "reading")
        bar.close()
        self.assertIn("reading:  50%|##########          |", out.getvalue())
        self.assertTrue(out.getvalue().endswith("\r"))


def comma_locale(folder):
    """Makes a locale with a decimal comma, needing no package of locales; its name, for LOCPATH=folder."""
    with open(os.path.join(folder, "comma.src"), "w", encoding="ascii") as file:
        file.write('comment_char %\nescape_char /\nLC_NUMERIC\ndecimal_point ","\nthousands_sep "."\ngrouping 3\n'
                   "END LC_NUMERIC\n")
    with open(os.path.join(folder, "ascii.map"), "w", encoding="ascii") as file:
        file.write("<code_set_name> ANSI_X3.4-1968\n<comment_char> %\n<escape_char> /\nCHARMAP\n")
        file.writelines(f"<U{code:04X}> /x{code:02x} X\n" for code in range(128))
        file.write("END CHARMAP\n")
    subprocess.run(["localedef", "-c", "-i", os.path.join(folder, "comma.src"), "-f", os.path.join(folder, "ascii.map"),
                    os.path.join(folder, "comma")], capture_output=True, check=False)
    return "comma"


@unittest.skipUnless(shutil.which("localedef"), "no localedef")
class Locale(unittest.TestCase):
    def answers(self, environment):
        text = """if True:
            import locale, re, isolux
            locale.setlocale(locale.LC_NUMERIC, "")
            print(locale.localeconv()["decimal_point"])
            volume = isolux.open("phantom:torus:16")
            study = volume.study("derivatives_scale,near_threshold", size=(24, 24), repeat=1)
            rows = [[value for key, value in row.items() if "milliseconds" not in key]
                    for knob in study.knobs for row in knob["settings"]]
            print(re.sub("'build_seconds': [^,]*,", "", str(rows)))
            picture = volume.render(look="kappa1", size=(120, 90), settings={"look.range_low": 0.05, "look.range_high": 0.25})
            print(picture.image.tobytes().hex())
        """
        done = subprocess.run([sys.executable, "-c", text], env={**os.environ, **environment}, capture_output=True,
                              text=True, check=True)
        point, rest = done.stdout.split("\n", 1)
        return point, rest

    def test_a_decimal_comma_changes_nothing(self):
        with temporary_folder() as folder:
            comma = self.answers({"LOCPATH": folder, "LC_ALL": comma_locale(folder)})
        plain = self.answers({"LC_ALL": "C"})
        self.assertEqual((comma[0], plain[0]), (",", "."))
        self.assertEqual(comma[1], plain[1])


class Memory(unittest.TestCase):
    def test_pictures_leave_nothing(self):
        volume = isolux.Volume(ball(24, 8))

        def draw(count):
            for i in range(count):
                volume.render(0, ("lambert", "normal", "kappa1")[i % 3], size=(96, 64), aovs=["depth"] if i % 2 else ())

        draw(60)
        gc.collect()
        before = resident_bytes()
        draw(int(os.environ.get("ISOLUX_PYTHON_RENDERS", "150")))
        gc.collect()
        self.assertLess(resident_bytes(), 1.05 * before)

    def test_volumes_leave_nothing(self):
        array = ball(40, 8)

        def turns(count):
            for _ in range(count):
                with isolux.Volume(array) as volume:
                    volume.render(0, "lambert", size=(40, 30))
            isolux._isolux.await_ends(5)
            return allocated_bytes()

        before = turns(8)
        self.assertLess(turns(24) - before, 24 * array.nbytes / 8)

    def test_references(self):
        array = ball(16, 5)
        before = sys.getrefcount(array)
        volume = isolux.Volume(array)
        self.assertEqual(sys.getrefcount(array), before)
        picture = volume.render(0, "lambert", size=(20, 16), aovs="depth")
        drawn = picture._drawn
        held = sys.getrefcount(drawn)
        depth = picture.aov.depth
        self.assertGreater(sys.getrefcount(drawn), held)
        picture._aov = None
        del depth
        gc.collect()
        self.assertEqual(sys.getrefcount(drawn), held)
        for thing in (volume, picture):
            self.assertEqual(sys.getrefcount(thing), 4)  # two names, the tuple, the argument
        gone = weakref.ref(volume)
        del volume, thing
        gc.collect()
        self.assertIsNone(gone())

        def tell(fraction, stage):
            pass

        own = sys.getrefcount(tell)
        with isolux.Volume(array, progress=tell) as other:
            other.render(0, "lambert", size=(20, 16), progress=tell)
        self.assertEqual(sys.getrefcount(tell), own)


if __name__ == "__main__":
    unittest.main()
