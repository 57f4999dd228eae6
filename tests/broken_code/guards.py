#!/usr/bin/env python3
"""Takes guards of the arithmetic out, one at a time, and asks whether a test notices: ./dev guards [--help].

guards.toml lists them; --table writes them as tables. Everything happens in a copy of the tree
(scratch_tree.py). Exit code: 0 each guard is as the list says, 1 one is not, 2 the script itself could not run."""

import argparse
import fnmatch
import os
import pathlib
import re
import sys
import tomllib

import tables as files
import results
import scratch_tree

LIST = pathlib.Path(__file__).with_name("guards.toml")
RESULTS = scratch_tree.FOLDER / "guards.json"


class Removal:
    """One place of a guard: file, old text, new text, and the tests that are to fail (program, GoogleTest filter)."""

    def __init__(self, guard, number, entry):
        self.guard = guard
        self.name = guard["name"] + (f"/{number}" if number > 1 else "")
        self.file, self.old, self.new = entry["file"], entry["old"].strip("\n"), entry["new"].strip("\n")
        self.program, self.tests = entry["tests"].split()
        self.kept = entry.get("kept", "")  # why it stays although no test fails without it
        self.open = entry.get("open", False)  # whether one does is not known yet
        self.entry = entry

    def broken(self, text):
        found = text.count(self.old)
        if found != 1:
            raise scratch_tree.Trouble(f"guard {self.name}: its text is {found} times in {self.file}, not once:\n{self.old}")
        return text.replace(self.old, self.new)

    def digest(self):
        return results.digest(self.file, self.old, self.new, self.program, self.tests)


def read_list():
    with open(LIST, "rb") as file:
        guards = tomllib.load(file)["guard"]
    listed = [Removal(guard, i + 1, entry) for guard in guards for i, entry in enumerate(guard["without"])]
    names = [removal.name for removal in listed]
    twice = {name for name in names if names.count(name) > 1}
    if twice:
        raise scratch_tree.Trouble(f"two guards have the name {sorted(twice)[0]}")
    return listed


def write_list(listed):
    def value(of):
        if of is True:
            return "true"
        if "\n" in of:
            return f"'''\n{of.strip(chr(10))}\n'''"
        return f"'{of}'" if "'" not in of else f"'''{of}'''"

    head = "".join(re.match(r"(#[^\n]*\n|\n)*", LIST.read_text()).group())
    parts = []
    for places in by_guard(listed):
        guard = places[0].guard
        parts.append("[[guard]]\n" + "".join(f"{key} = {value(guard[key])}\n" for key in ("name", "wrong", "guard")))
        for place in places:
            keys = [key for key in ("file", "old", "new", "tests", "kept", "open") if place.entry.get(key)  or key == "new"]
            parts.append("[[guard.without]]\n" + "".join(f"{key} = {value(place.entry[key])}\n" for key in keys))
    LIST.write_text(head + "\n".join(parts))


def settle(listed):
    """Open entries that results know: the test that noticed is named; those that none noticed are marked."""
    kept = results.Results(RESULTS)
    for removal in listed:
        found = kept.of.get(removal.name)
        if not removal.open or not found or found["digest"] != removal.digest():
            continue
        if found["state"] != "noticed":
            removal.entry["open"] = "no test" if found["state"] == "unnoticed" else found["state"]
            continue
        name = re.search(r"\S+\.\S+$", found["words"])
        if name:
            removal.entry["tests"] = f"{removal.program} {re.sub('^[A-Z][a-z]+/', '*/', name.group())}"
        del removal.entry["open"]
        new = Removal(removal.guard, 1, removal.entry)
        kept.put(removal.name, "noticed", found["words"], found["seconds"], digest=new.digest())
    write_list(listed)


def by_guard(listed):
    guards = {}
    for removal in listed:
        guards.setdefault(removal.guard["name"], []).append(removal)
    return guards.values()


def tables(listed):
    """The sections of the page: counts; guards with tests as a table; as lists those that stay without, and those not tried yet."""
    once = lambda words: ", ".join(f"`{word}`" for word in dict.fromkeys(words))
    where = lambda place: place.file.replace("resources/shaders/", "")
    count = lambda holds: sum(map(bool, map(holds, listed)))
    figures = (f"Of {len(listed)} places in the list {count(lambda p: not p.kept and not p.open)} have a test that fails without the "
               f"guard, {count(lambda p: p.kept)} stay with a reason, {count(lambda p: p.open == 'no test')} have been taken out "
               f"without a test noticing, and {count(lambda p: p.open and p.open != 'no test')} have not been taken out yet.")
    table = ["| what goes wrong | guard | where | test that fails without it |", "|---|---|---|---|"]
    kept, untried = [], []
    for places in by_guard(listed):
        guard = places[0].guard
        tested = [place for place in places if not place.kept and not place.open]
        if tested:
            tests = once(shown(name) for place in tested for name in place.tests.split(":"))
            table.append(f"| {guard['wrong']} | {guard['guard']} | {once(map(where, tested))} | {tests} |")
        kept += [f"- `{where(place)}`: {guard['wrong']}; {guard['guard']}. {sentence(place.kept)}" for place in places if place.kept]
        for words in dict.fromkeys(place.open for place in places if place.open):
            waiting = [place for place in places if place.open == words]
            missed = " **Taken out: no test noticed.**" if words == "no test" else ""
            untried.append(f"- {once(map(where, waiting))}: {guard['wrong']}; {guard['guard']}.{missed}")
    return {"figures of guards": figures, "guards": "\n".join(table), "kept guards": "\n".join(kept), "open guards": "\n".join(untried) or "- none"}


def sentence(words):
    return words[:1].upper() + words[1:].rstrip(".") + "."


def shown(name):
    return re.sub(r"^\*/|/gpu$", "", name).replace("*", "…")


def check(listed):
    """Of the list alone, without a build: each text is where it should be, tests have the names given, the page agrees."""
    suites = set()
    for path in (scratch_tree.ROOT / "tests").rglob("*.cpp"):
        suites.update(re.findall(r"^(?:TYPED_)?TEST(?:_F|_P)?\((\w+), (\w+)\)", path.read_text(), re.M))
    names = [f"{suite}.{test}" for suite, test in suites]
    wrong = []
    for removal in listed:
        try:
            removal.broken((scratch_tree.ROOT / removal.file).read_text())
        except (scratch_tree.Trouble, OSError) as error:
            wrong.append(str(error))
        if removal.old == removal.new:
            wrong.append(f"guard {removal.name}: nothing replaces it but itself")
        for pattern in removal.tests.split(":"):
            plain = pattern.removeprefix("*/").split("/")[0]
            if not any(fnmatch.fnmatch(name, plain) for name in names):
                wrong.append(f"guard {removal.name}: there is no test {pattern}")
    for line in wrong:
        print(line)
    return 1 if wrong else 0


def take_out(listed, arguments):
    kept = results.Results(RESULTS)
    if not arguments.resume:
        kept.forget(removal.name for removal in listed)
    todo = [r for r in listed if kept.of.get(r.name, {}).get("digest") != r.digest()]
    if todo:
        wanted = list(dict.fromkeys((removal.program, removal.tests) for removal in todo))
        judge = scratch_tree.Judge(scratch_tree.ScratchTree(arguments.jobs, wanted), wanted)
    for removal in todo:
        changed = {removal.file: removal.broken((judge.tree.path / removal.file).read_text())}
        state, words, seconds = judge.judge(changed, removal.program, removal.tests)
        kept.put(removal.name, state, words, seconds, digest=removal.digest())
        print(f"{state:16} {removal.name}{': ' + words if words else ''} ({seconds:.0f} s)", flush=True)
    return report(listed, kept)


def report(listed, kept):
    states = {removal.name: kept.of[removal.name] for removal in listed}
    count = lambda state: sum(entry["state"] == state for entry in states.values())
    print(f"of {len(listed)} tried {count('noticed')} noticed, {count('unnoticed')} not, {count('does not compile')} do not compile")
    wrong = []
    for removal in listed:
        entry = states[removal.name]
        if entry["state"] == "does not compile":
            wrong.append(f"{removal.name} does not compile: {entry['words']}")
        elif entry["state"] == "unnoticed" and not removal.kept:  # open ones, too
            wrong.append(f"{removal.name} ({removal.file}) is noticed by none of {removal.tests}")
        elif entry["state"] == "noticed" and removal.kept:
            wrong.append(f"{removal.name} is noticed now, by {entry['words']}: name it in guards.toml instead of a reason")
    for line in wrong:
        print("wrong:", line)
    if any(removal.open and states[removal.name]["state"] == "noticed" for removal in listed):
        print("./dev guards --settle names the tests that noticed open guards")
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", action="store_true", help="name the guards, try none")
    parser.add_argument("--only", metavar="PATTERN", help="those whose name or file matches (shell pattern)")
    parser.add_argument("--open", action="store_true", help="those that no test is named for yet")
    parser.add_argument("--jobs", type=int, default=max((os.cpu_count() or 2) // 2, 1), help="processes at a time (half of the cores)")
    parser.add_argument("--resume", action="store_true", help="leave out what build/broken_code/guards.json holds")
    parser.add_argument("--check", action="store_true", help="whether list and code agree; builds nothing")
    parser.add_argument("--settle", action="store_true", help="name in guards.toml what noticed guards that were open; --table afterwards")
    parser.add_argument("--table", action="store_true", help="write them as tables, build/broken_code/guards.md")
    arguments = parser.parse_args()
    listed = read_list()
    if arguments.settle:
        settle(listed)
        return 0
    if arguments.table:
        files.write("guards", tables(listed))
        return 0
    if arguments.check:
        return check(listed)
    if arguments.only:
        listed = [r for r in listed if fnmatch.fnmatch(r.name, arguments.only) or fnmatch.fnmatch(r.file, arguments.only)]
    if arguments.open:
        listed = [r for r in listed if r.open]
    if arguments.list:
        for removal in listed:
            print(f"{removal.name:32} {removal.file}: {removal.guard['guard']}")
        return 0
    os.nice(max(0, 5 - os.nice(0)))
    return take_out(listed, arguments)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except scratch_tree.Trouble as trouble:
        print(trouble, file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        sys.exit(130)
