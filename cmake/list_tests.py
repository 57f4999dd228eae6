#!/usr/bin/env python3
"""Writes the CTest entries of a GoogleTest program.

    list_tests.py --program FILE --out FILE.cmake --prefix app. [--suites all] [--filter FILTER] [--launcher FILE]
                  [--reports FOLDER] [--property NAME VALUE]...

An entry is a test, or a whole suite where its tests share what is slow to make: suites of files named *_gl_test.cpp, which
share a context, and with `--suites all` every suite. What a suite's tests were is in the reports, FOLDER/ENTRY.xml.
Labels come from the folder of the source: tests/volume/read/reader_nrrd_test.cpp has `volume` and `volume.read`; sources beside the
folders have `volume.root`. ./dev test PATH... selects by them.
"""
import argparse
import json
import os
import pathlib
import subprocess
import tempfile


def listed(arguments):
    """(suite, test, source) of each test that is not disabled, in the program's order."""
    command = [arguments.program, "--gtest_list_tests"]
    if arguments.filter:
        command.append(f"--gtest_filter={arguments.filter}")
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder, "tests.json")
        run = subprocess.run(command + [f"--gtest_output=json:{out}"], capture_output=True, text=True, timeout=120)
        if run.returncode != 0 or not out.exists():
            raise SystemExit(f"list_tests.py: {' '.join(command)}: {run.stdout}{run.stderr}")
        report = json.loads(out.read_text())
    for suite in report["testsuites"]:
        for test in suite["testsuite"]:
            if "DISABLED_" not in suite["name"] + test["name"]:
                yield suite["name"], test["name"], test["file"]


def labels_of(source, prefix):
    parts = pathlib.PurePath(source).parts
    parts = parts[len(parts) - parts[::-1].index("tests"):]  # below tests/
    layer = "property" if parts[0] == "properties" else parts[0]
    own = prefix.split(".")[0]
    room = parts[1] if len(parts) > 2 else "root"
    return [own, f"{layer}.{room}"] if own == layer else [own, layer, f"{layer}.{room}"]


def main():
    parser = argparse.ArgumentParser()
    for name in ("--program", "--out", "--prefix"):
        parser.add_argument(name, required=True)
    for name in ("--suites", "--filter", "--launcher", "--reports"):
        parser.add_argument(name, default="")
    parser.add_argument("--property", nargs=2, action="append", default=[])
    arguments = parser.parse_args()

    entries = {}  # name -> [filter, labels, whole suite, tests]
    tests = list(listed(arguments))
    for suite, test, source in tests:
        whole = arguments.suites == "all" or source.endswith("_gl_test.cpp")
        name = f"{arguments.prefix}{suite}.{'all' if whole else test}"
        entry = entries.setdefault(name, [f"{suite}.{'*' if whole else test}", [], whole, 0])
        entry[1] += [label for label in labels_of(source, arguments.prefix) if label not in entry[1]]
        entry[3] += 1

    lines = []
    for name, (chosen, labels, whole, count) in entries.items():
        if whole and arguments.filter:  # of a filtered program, the suite's tests that it leaves
            chosen = ":".join(f"{s}.{t}" for s, t, _ in tests if f"{s}.*" == chosen)
        command = ([arguments.launcher] if arguments.launcher else []) + [arguments.program, f"--gtest_filter={chosen}"]
        if arguments.reports:
            command.append(f"--gtest_output=xml:{os.path.join(arguments.reports, name.replace('/', '-'))}.xml")
        # Until CTest has times of its own, long suites come first: none is left over at the end.
        properties = [("LABELS", ";".join(labels)), ("COST", count), ("SKIP_REGULAR_EXPRESSION", r"\[  SKIPPED \]")] + arguments.property
        words = " ".join(f"[==[{word}]==]" for word in command)
        settings = " ".join(f"{key} [==[{value}]==]" for key, value in properties)
        lines.append(f"add_test([==[{name}]==] {words})\nset_tests_properties([==[{name}]==] PROPERTIES {settings})\n")
    out = pathlib.Path(arguments.out)
    text = "".join(lines)
    if not out.exists() or out.read_text() != text:
        out.write_text(text)


if __name__ == "__main__":
    main()
