#!/usr/bin/env python3
"""Line coverage by layer, from what gcov says of a build folder: ./dev coverage.

    coverage.py BUILD LEAST LAYER...

A line counts once, however many objects hold it (headers, templates), and is covered where any of them ran it. Lines that no object
has code for do not count; so the build must not be optimised. Prints a table and the files with the most lines that nothing ran; the
exit code is 1 where a layer has less than LEAST per cent, 2 where there is nothing to read.
"""
import collections
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys


def lines_of(data, root):
    """Of one .gcda file: {source below root: {line: runs}}."""
    made = subprocess.run(["gcov", "--json-format", "--stdout", data.name], cwd=data.parent, capture_output=True, text=True)
    result = {}
    for text in made.stdout.splitlines():
        if not text.startswith("{"):
            continue
        report = json.loads(text)
        for source in report["files"]:
            path = os.path.normpath(os.path.join(report["current_working_directory"], source["file"]))
            if not path.startswith(root + os.sep):
                continue
            lines = result.setdefault(os.path.relpath(path, root), collections.Counter())
            for line in source["lines"]:
                lines[line["line_number"]] += line["count"]
    return result


def main(build, least, layers):
    root, build = os.getcwd(), pathlib.Path(build).resolve()
    data = sorted(build.rglob("*.gcda"))
    if not data:
        print(f"{build} holds no .gcda files: nothing that was built for coverage has run")
        return 2
    files = {}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for lines in pool.map(lambda path: lines_of(path, root), data):
            for name, counts in lines.items():
                files.setdefault(name, collections.Counter()).update(counts)
    failed = False
    missed = []
    print("| layer | files | lines | covered |\n|---|---|---|---|")
    for layer in layers:
        own = {name: counts for name, counts in files.items() if name.split(os.sep)[0] == layer}
        total = sum(map(len, own.values()))
        ran = sum(count > 0 for counts in own.values() for count in counts.values())
        percent = 100 * ran / total if total else 0.0
        failed = failed or percent < least
        print(f"| {layer} | {len(own)} | {total} | {percent:.1f} % |")
        missed += [(sum(count == 0 for count in counts.values()), name, counts) for name, counts in own.items()]
    print("\nmost lines that nothing ran:")
    for count, name, counts in sorted(missed, reverse=True, key=lambda entry: entry[:2])[:15]:
        if count == 0:
            break
        where = sorted(line for line, runs in counts.items() if runs == 0)
        print(f"  {name}: {count} of {len(counts)} (first: {', '.join(map(str, where[:6]))})")
    if failed:
        print(f"a layer has less than {least:g} %")
    return 1 if failed else 0


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], float(sys.argv[2]), sys.argv[3:]))
