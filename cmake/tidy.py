#!/usr/bin/env python3
"""Runs clang-tidy on sources of a build folder and remembers which are clean.

    tidy.py BUILD SOURCE...

A source is looked at again where it, a header of ours that it includes (as ninja knows from its last build), its compile
command, .clang-tidy or clang-tidy's version has changed: a check of everything takes half an hour on two cores, one after an
edit seconds. Findings are printed; the exit code is 1 where there are any, 2 where the build folder does not know a source.
"""
import concurrent.futures
import hashlib
import json
import os
import pathlib
import shlex
import subprocess
import sys


def dependencies(build, root):
    """Object -> the files below root it was made of, as ninja has recorded them."""
    text = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout
    result, files = {}, []
    for line in text.splitlines():
        if line.startswith("    "):
            path = os.path.normpath(os.path.join(build, line.strip()))
            if path.startswith(root + os.sep):
                files.append(path)
        elif line:
            files = result.setdefault(os.path.normpath(os.path.join(build, line.split(":")[0])), [])
    return result


def main(build, sources):
    root = os.getcwd()
    build = os.path.abspath(build)
    version = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True).stdout
    settings = version + pathlib.Path(".clang-tidy").read_text()
    commands = {}
    for entry in json.loads(pathlib.Path(build, "compile_commands.json").read_text()):
        commands.setdefault(os.path.normpath(os.path.join(entry["directory"], entry["file"])), entry)
    made_of = dependencies(build, root)
    contents = {}

    def content(path):
        if path not in contents:
            contents[path] = hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()
        return contents[path]

    stamps = pathlib.Path(build, "tidy")
    stamps.mkdir(exist_ok=True)

    def check(source):
        path = os.path.join(root, source)
        entry = commands[path]
        arguments = shlex.split(entry["command"])
        output = os.path.normpath(os.path.join(entry["directory"], arguments[arguments.index("-o") + 1]))
        files = sorted({path, *made_of.get(output, [])})
        state = settings + entry["command"] + "".join(f"{f}\0{content(f)}\0" for f in files if os.path.exists(f))
        stamp = stamps / hashlib.sha256(state.encode()).hexdigest()
        if stamp.exists():
            return True, ""
        run = subprocess.run(["clang-tidy", "-p", build, "--quiet", "--extra-arg=-Wno-unknown-warning-option", source],
                             capture_output=True, text=True)
        if run.returncode == 0:
            stamp.touch()
            return True, ""
        return False, run.stdout or run.stderr

    unknown = [s for s in sources if os.path.join(root, s) not in commands]
    if unknown:
        print("tidy.py: not built in " + build + ": " + ", ".join(unknown), file=sys.stderr)
        return 2
    found = 0
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        for clean, text in pool.map(check, sources):
            if not clean:
                found += 1
                print(text, flush=True)
    print(f"tidy.py: {found} of {len(sources)} sources with findings", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
