#!/usr/bin/env python3
"""Corrupts whole files and feeds them to the program: ./dev corrupt [SECONDS].

Whatever a file holds, a command must end with a documented exit code, at most one line about it, within seconds,
leaving neither pieces of results nor changed inputs. Every mutant follows from the seed, the family and its number:
--seed S --only FAMILY:NUMBER makes it again. Failing files are kept. Exit code: 0 nothing failed, 1 something did,
2 the script itself could not run."""

import argparse
import collections
import concurrent.futures
import os
import pathlib
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import mutations
import seeds

SECONDS_OF_PROCESSOR = 5.0  # what an answer may take; the machine may be busy, so its own time is counted
SECONDS_OF_CLOCK = 60.0  # for one that sleeps instead
MEMORY = 8 << 30  # bytes of address space
FILE_SIZE = 1 << 30
SMALL = ["--size", "32x24"]
EXIT_CODES = {0, 2, 3, 4, 5}
# Half of the mutants are DICOM, which is decoded by the most code of others.
SHARES = {"dicom": 10, "vti": 2, "vtp": 2, "light": 2, "nifti": 1, "headers": 2, "tiff": 1, "mesh": 1, "array": 2, "probe": 1,
          "session": 1, "recording": 1}


class Outcome(Exception):
    """Why a run is a failure."""


def commands(family, path, folder, rng):
    """One command line that opens this file, and the results that it may leave."""
    draw = (["render", path, "--out", "o.png", *SMALL], {"o.png"})
    look = (["info", path, "--json"], set())
    if family == "light":
        sky = ["--environment", f"{folder}/sky.exr"] if os.path.exists(f"{folder}/sky.exr") else []
        transfer = ["--set", "gi.mode=transfer", "--set", "gi.sh_order=2", "--set", "lamp1.shown=true"] if sky else []
        words = ["--set", "gi.samples=1", "--set", "gi.lattice_scale=0.5"]
        lit = ["render", "phantom:ball:8", "--look", "gi", "--light", path, "--out", "o.png", *SMALL]
        return rng.choice((look, look, (lit + sky + transfer + words, {"o.png"})))
    if family == "probe":
        return (["reference", "phantom:ball:8", "--environment", path, "--spp", "1", "--size", "16x12", "--out", "o.exr"],
                {"o.exr"})
    if family == "recording":
        return ["replay", path, "--out", "d", "--fps", "0.5", *SMALL], None
    words, results = draw if rng.random() < (0.5 if family == "session" else 0.15) else look
    if family in ("vtp", "mesh"):
        words = words + ["--set", "source.mesh_voxels=16"]
    return words, results


def too_long_to_replay(data):
    """A recording whose times a mutation has stretched may rightly take hours."""
    times = re.findall(rb'"time"\s*:\s*([-+0-9.eE]+)', data)
    return any(len(t) > 4 for t in times)


def limits():
    os.setsid()
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (FILE_SIZE, FILE_SIZE))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def processor_seconds(pid):
    """Of a running process and of its children that have ended."""
    try:
        fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    except OSError:
        return 0.0
    return sum(map(int, fields[11:15])) / os.sysconf("SC_CLK_TCK")


def wait(process):
    """Exit code (negative: the signal that ended it) and seconds of processor time, of its children too."""
    begin = time.monotonic()
    while True:
        pid, status, usage = os.wait4(process.pid, os.WNOHANG)
        if pid:
            process.returncode = os.waitstatus_to_exitcode(status)
            return process.returncode, usage.ru_utime + usage.ru_stime
        used, seconds = processor_seconds(process.pid), time.monotonic() - begin
        if used > SECONDS_OF_PROCESSOR or seconds > SECONDS_OF_CLOCK:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
            raise Outcome(f"no answer after {used:.1f} s of the processor, {seconds:.0f} s of the clock")
        time.sleep(0.005 if seconds < 1 else 0.05)


def check_text(code, error):
    lines = error.splitlines()
    if code == 0:
        bad = [line for line in lines if not line.startswith("isolux: note: ")]
        if bad:
            raise Outcome(f"success with something else on stderr: {bad[0][:200]}")
    elif len(lines) != 1 or not lines[0].startswith("isolux: "):
        raise Outcome(f"not one line on stderr: {error[:300]!r}")
    if any(ord(c) < 32 and c != "\n" or 127 <= ord(c) < 160 for c in error):
        raise Outcome(f"control characters on stderr: {error[:200]!r}")


def contents(folder):
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def write_files(folder, files):
    for name, data in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)


def run(program, words, results, inputs, work):
    """Runs the program in an empty folder; raises Outcome."""
    work.mkdir()
    (work / "tmp").mkdir()
    before = contents(inputs)
    environment = dict(os.environ, TMPDIR=str(work / "tmp"), LP_NUM_THREADS="1", LC_ALL="C.UTF-8")
    with open(work.parent / "err", "w+b") as error, open(work.parent / "out", "w+b") as out:
        process = subprocess.Popen([program, *words, "--threads", "1"], cwd=work, stdin=subprocess.DEVNULL, stdout=out,
                                   stderr=error, env=environment, preexec_fn=limits)
        code, seconds = wait(process)
        error.seek(0)
        text = error.read().decode("utf-8", "surrogateescape")
    if code < 0:
        raise Outcome(f"ended by {signal.Signals(-code).name}: {text[:300]!r}")
    if code not in EXIT_CODES:
        raise Outcome(f"exit code {code}: {text[:300]!r}")
    check_text(code, text)
    if seconds > SECONDS_OF_PROCESSOR:
        raise Outcome(f"took {seconds:.1f} s of the processor")
    left = {name for name in contents(work)}
    if left and (code != 0 or results is not None and left != results):
        raise Outcome(f"left behind with exit code {code}: {sorted(left)[:5]}")
    if code != 0 and any(p.name != "tmp" for p in work.iterdir()):
        raise Outcome(f"left behind: {[p.name for p in work.iterdir()]}")
    if contents(inputs) != before:
        raise Outcome("the input was changed")
    return code, seconds


class Family:
    def __init__(self, name, made):
        self.name, self.seeds = name, made

    def mutant(self, seed, number):
        """The files of a mutant, what was done to which, and the generator for the rest."""
        rng = random.Random(f"{seed}/{self.name}/{number}")
        chosen = self.seeds[number % len(self.seeds)]
        name = rng.choice(sorted(chosen.damaged or chosen.files))
        other = rng.choice(self.seeds).files
        way, data = mutations.mutate(chosen.files[name], rng, other[sorted(other)[0]])
        return chosen, dict(chosen.files, **{name: data}), f"{chosen.family}: {way} of {name}", rng


def try_one(options, family, number):
    """One mutant: (family, number, failure or None, exit code, seconds of processor)."""
    chosen, files, what, rng = family.mutant(options.seed, number)
    folder = pathlib.Path(tempfile.mkdtemp(prefix="isolux-mutant-"))
    try:
        inputs = folder / "in"
        inputs.mkdir()
        write_files(inputs, files)
        if family.name == "recording" and too_long_to_replay(files[chosen.name]):
            return family.name, number, None, 0, 0.0
        path = str(inputs) if chosen.open_folder else str(inputs / chosen.name)
        words, results = commands(family.name, path, inputs, rng)
        try:
            code, seconds = run(options.isolux, words, results, inputs, folder / "work")
            return family.name, number, None, code, seconds
        except Outcome as outcome:
            kept = options.keep / f"{family.name}-{options.seed}-{number}"
            shutil.rmtree(kept, ignore_errors=True)
            shutil.copytree(inputs, kept)
            shown = " ".join(word.replace(str(inputs), str(kept)) for word in words)
            return family.name, number, f"{outcome}\n    {what}\n    isolux {shown}", -1, 0.0
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def make_families(options):
    """Seeds of the chosen families; each must be read without complaint before it is damaged."""
    families = {}
    for name in options.families:
        folder = tempfile.mkdtemp(prefix="isolux-seeds-")
        try:
            maker = seeds.Maker(options.isolux, options.data, folder)
            families[name] = Family(name, seeds.FAMILIES[name](maker))
            for note in maker.notes:
                print(f"mutants: {name}: {note}")
        finally:
            shutil.rmtree(folder, ignore_errors=True)
    return families


def check_seeds(options, families):
    for family in families.values():
        for seed in family.seeds:
            with tempfile.TemporaryDirectory() as folder:
                inputs = pathlib.Path(folder) / "in"
                inputs.mkdir()
                write_files(inputs, seed.files)
                path = str(inputs) if seed.open_folder else str(inputs / seed.name)
                words, results = commands(family.name, path, inputs, random.Random(1))
                code, _ = run(options.isolux, words, results, inputs, pathlib.Path(folder) / "work")
                if code != 0:
                    error = (pathlib.Path(folder) / "err").read_text(errors="replace")
                    raise Outcome(f"the undamaged file {family.name}, {seed.family} is refused: {error}")


def numbers(options, families):
    """(family, number) in the order of the run: by shares, for as long or as many as asked."""
    if options.only:
        for one in options.only:
            name, number = one.split(":")
            yield families[name], int(number)
        return
    turn = [name for name in families for _ in range(SHARES[name])]
    random.Random(options.seed).shuffle(turn)
    count, end = collections.Counter(), time.monotonic() + options.seconds
    while sum(count.values()) < options.count if options.count else time.monotonic() < end:
        name = turn[sum(count.values()) % len(turn)]
        yield families[name], options.first + count[name]
        count[name] += 1


def print_table(rows, failures):
    print(f"\n{'family':10} {'mutants':>8} {'read':>7} {'refused':>8} {'failed':>7} {'slowest s':>10}")
    for name, runs in rows.items():
        read = sum(1 for code, _ in runs if code == 0)
        refused = sum(1 for code, _ in runs if code > 0)
        failed = sum(1 for code, _ in runs if code < 0)
        print(f"{name:10} {len(runs):8} {read:7} {refused:8} {failed:7} {max(s for _, s in runs):10.2f}")
    total = sum(map(len, rows.values()))
    print(f"{total} mutants, {len(failures)} failures" + (f": {1000 * len(failures) / total:.1f} per thousand"
                                                          if failures else ""))


def parse():
    root = pathlib.Path(__file__).resolve().parents[2]
    data = pathlib.Path(os.environ.get("ISOLUX_DATA") or root.parent / "shared" / "data")
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--isolux", required=True, type=os.path.abspath, help="the program")
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--count", type=int, default=0, help="this many instead of --seconds")
    parser.add_argument("--seed", default=str(int(time.time())), help="of all random choices")
    parser.add_argument("--first", type=int, default=0, help="number of the first mutant of each family")
    parser.add_argument("--only", nargs="*", metavar="FAMILY:NUMBER", help="these mutants of the seed again")
    parser.add_argument("--families", type=lambda t: t.split(","), default=list(seeds.FAMILIES))
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--keep", type=pathlib.Path, default=root / "build" / "mutants", help="for failing files")
    options = parser.parse_args()
    options.data = data if (data / "volumes").is_dir() else None
    options.keep.mkdir(parents=True, exist_ok=True)
    return options


def main():
    options = parse()
    print(f"mutants: seed {options.seed}, {options.jobs} at a time", flush=True)
    try:
        families = make_families(options)
        check_seeds(options, families)
    except (Outcome, ImportError, subprocess.CalledProcessError) as error:
        print(f"mutants: {error}\n{getattr(error, 'stderr', b'') or ''}", file=sys.stderr)
        return 2
    rows, failures = collections.defaultdict(list), []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        running = set()
        work = numbers(options, families)
        while True:
            for family, number in work:
                running.add(pool.submit(try_one, options, family, number))
                if len(running) >= 2 * options.jobs:
                    break
            if not running:
                break
            done, running = concurrent.futures.wait(running, return_when=concurrent.futures.FIRST_COMPLETED)
            for job in done:
                name, number, failure, code, seconds = job.result()
                rows[name].append((code, seconds))
                if failure:
                    failures.append(failure)
                    print(f"FAILED {name}:{number}  {failure}", flush=True)
    print_table(rows, failures)
    if failures:
        print(f"mutants: the failing files are in {options.keep}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
