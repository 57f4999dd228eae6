#!/usr/bin/env python3
"""Prints a hash of the pixels of many pictures: equal lines of two programs on one machine mean equal pictures.

hashes.py PROGRAM [--only TEXT] [--size WxH] [--data DIR]: draws the sessions of docs/gallery, pictures_0_1_0 and sessions,
the frames of recordings, and the built-in presets on phantoms, by both executors. Compare two programs with `diff`. Few
samples of light keep it short.
"""
import argparse
import hashlib
import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PRESETS = ("ct_bone", "ct_skin", "ct_skin_bone", "mr_skin", "mr_brain", "simulation", "distance", "microscopy")
SHORT = ("--set", "gi.samples=8", "--set", "gi.bounces=1", "--set", "picture.supersampling=1", "--context", "software")


def subjects():
    """Yields (name, arguments) of each picture."""
    for folder in (ROOT / "docs/gallery", HERE / "pictures_0_1_0", HERE / "sessions"):
        for file in sorted(folder.glob("*.*")):
            if file.suffix in (".png", ".isolux"):
                yield file.stem, [str(file)]
    for preset in PRESETS:
        for phantom in ("phantom:head:64", "phantom:torus:48"):
            yield f"{preset} {phantom}", [phantom, "--preset", preset]


def pixels(file):
    """Returns the decompressed image data of a PNG, without its session."""
    import zlib
    bytes_, at, data = file.read_bytes(), 8, b""
    while at < len(bytes_):
        length, kind = int.from_bytes(bytes_[at:at + 4], "big"), bytes_[at + 4:at + 8]
        if kind == b"IDAT":
            data += bytes_[at + 8:at + 8 + length]
        at += 12 + length
    return zlib.decompress(data)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--only", default="")
    parser.add_argument("--size", default="160x128")
    parser.add_argument("--data", type=pathlib.Path,
                        default=pathlib.Path(os.environ.get("ISOLUX_DATA", ROOT / "../shared/data")))
    options = parser.parse_args()
    program = options.program.resolve()
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(options.data.resolve(), pathlib.Path(folder, "data"))
        out = pathlib.Path(folder, "out.png")
        for name, arguments in subjects():
            if options.only not in name:
                continue
            if arguments[0].endswith(".png"):  # a copy beside a link to the data, as the gallery's images were drawn
                copy = pathlib.Path(folder, "in.png")
                copy.write_bytes(pathlib.Path(arguments[0]).read_bytes())
                arguments = [str(copy), *arguments[1:]]
            for executor in ("cpu", "gpu"):
                out.unlink(missing_ok=True)
                run = subprocess.run([program, "render", *arguments, *SHORT, "--size", options.size, "--executor",
                                      executor, "--out", out], capture_output=True, text=True, cwd=folder, check=False)
                result = hashlib.sha256(pixels(out)).hexdigest()[:16] if run.returncode == 0 else run.stderr.strip()
                print(f"{name} {executor}: {result}", flush=True)
        for recording in sorted((HERE / "recordings").glob("*.jsonl")):
            if options.only not in recording.stem:
                continue
            frames = pathlib.Path(folder, recording.stem)
            run = subprocess.run([program, "replay", recording, "--fps", "10", "--size", options.size, "--context",
                                  "software", "--out", frames], capture_output=True, text=True, check=False)
            for frame in sorted(frames.glob("*.png")):
                print(f"{recording.stem} {frame.stem}: {hashlib.sha256(pixels(frame)).hexdigest()[:16]}", flush=True)
            if run.returncode != 0:
                print(f"{recording.stem}: {run.stderr.strip()}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
