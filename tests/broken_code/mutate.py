#!/usr/bin/env python3
"""Changes constants and comparisons of the arithmetic, one at a time, and asks whether a test notices: ./dev mutate [--help].

mutate.toml says which files, which tests are closest to each, and which are asked next; survivors.toml lists changes that no test can notice, with the
reason. Everything happens in a copy of the tree (scratch_tree.py). Which changes are tried follows from the seed alone.
Exit code: 0 at least 95 % of those tried were noticed (accepted ones aside), 1 fewer, 2 the script itself could not run."""

import argparse
import collections
import fnmatch
import math
import os
import re
import sys
import tomllib

import tables as files
import results
import scratch_tree

HERE = os.path.dirname(os.path.abspath(__file__))
WANTED = 0.95  # of those tried that are neither accepted nor refused by the compiler
# Code of which nothing is changed: comments, texts, directives, what only the compiler reads.
PASSED_OVER = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])\'|^[ \t]*#(?:\\\n|[^\n])*|'
                         r"\b(?:static_assert|assert)\([^;]*;|\bstd::array<[^;{}()]*>|\blayout\([^)]*\)|template <[^{;]*?>\n", re.S | re.M)
NUMBER = re.compile(r"(?<![\w.])(0x[0-9a-fA-F.]+(?:p[-+]?\d+)?|\d+\.?\d*(?:[eE][-+]?\d+)?)([uUfFlL]*)(?![\w.])")
COMPARISON = re.compile(r"(?<= )(<=|>=|==|!=|<|>)(?= )")
OTHERS = {"<": ("<=", ">="), "<=": ("<", ">"), ">": (">=", "<="), ">=": (">", "<"), "==": ("!=",), "!=": ("==",)}


class Mutant:
    def __init__(self, file, text, begin, end, new, stages, ordinals):
        self.file, self.begin, self.end, self.new = file, begin, end, new
        self.stages = stages  # (program, tests)...
        self.line = text.count("\n", 0, begin) + 1
        first, last = text.rfind("\n", 0, begin) + 1, text.find("\n", end)
        self.before = text[first:last].strip()
        self.after = (text[first:begin] + new + text[end:last]).strip()
        # Lines move; what they say stays.
        same = (file, self.before, self.after)
        ordinals[same] = ordinals.get(same, 0) + 1
        self.key = results.digest(*same, str(ordinals[same]))

    def broken(self, text):
        return text[:self.begin] + self.new + text[self.end:]


def changed_number(number, suffix):
    """Zero becomes one, a whole number the next, others twice themselves."""
    if suffix.lower() in ("u", "") and re.fullmatch(r"\d+", number):
        return str(int(number) + 1) + suffix
    if number.startswith("0x"):
        return f"2 * {number}{suffix}" if "p" not in number else f"2.0 * {number}{suffix}"
    value = float(number)
    return ("1.0" if value == 0.0 else repr(2.0 * value)) + suffix


def mutants_of(file, text, stages):
    code = PASSED_OVER.sub(lambda found: re.sub(r"[^\n]", " ", found.group()), text)
    ordinals = {}
    for found in NUMBER.finditer(code):
        yield Mutant(file, text, found.start(), found.end(), changed_number(*found.groups()), stages, ordinals)
    for found in COMPARISON.finditer(code):
        for other in OTHERS[found.group()]:
            yield Mutant(file, text, found.start(), found.end(), other, stages, ordinals)


def all_mutants():
    with open(os.path.join(HERE, "mutate.toml"), "rb") as file:
        content = tomllib.load(file)
    seen, listed = set(), []
    for scope in content["scope"]:  # the first that names a file
        stages = [tuple(content["named"].get(stage, stage).split()) for stage in scope["tests"]]
        for pattern in scope["files"]:
            paths = sorted(path for path in scratch_tree.ROOT.glob(pattern) if path not in seen)
            if not paths and not list(scratch_tree.ROOT.glob(pattern)):
                raise scratch_tree.Trouble(f"mutate.toml: there is no file {pattern}")
            for path in paths:
                seen.add(path)
                listed += mutants_of(str(path.relative_to(scratch_tree.ROOT)), path.read_text(), stages)
    return listed


def accepted_survivors():
    with open(os.path.join(HERE, "survivors.toml"), "rb") as file:
        entries = tomllib.load(file).get("survivor", [])
    return {(entry["file"], entry["before"], entry["after"]): entry["reason"] for entry in entries}


def check(listed):
    """Of the list of survivors alone: what they change is still there."""
    there = {(mutant.file, mutant.before, mutant.after) for mutant in listed}
    gone = [entry for entry in accepted_survivors() if entry not in there]
    for file, before, _ in gone:
        print(f"survivors.toml: {file} has no longer the line: {before}")
    return 1 if gone else 0


def try_all(chosen, arguments):
    kept = results.Results(scratch_tree.FOLDER / "mutants.json")
    if not arguments.resume:
        kept.forget(mutant.key for mutant in chosen)
    todo = [mutant for mutant in chosen if mutant.key not in kept.of]
    if todo:
        wanted = list(dict.fromkeys(stage for mutant in todo for stage in mutant.stages))
        judge = scratch_tree.Judge(scratch_tree.ScratchTree(arguments.jobs, wanted), wanted)
    for mutant in todo:
        changed = {mutant.file: mutant.broken((judge.tree.path / mutant.file).read_text())}
        seconds = 0.0
        for program, tests in mutant.stages:
            state, words, more = judge.judge(changed, program, tests)
            seconds += more
            if state != "unnoticed":
                break
        kept.put(mutant.key, state, words, seconds, file=mutant.file, line=mutant.line, before=mutant.before, after=mutant.after)
        print(f"{state:16} {mutant.file}:{mutant.line} {mutant.after} ({seconds:.0f} s)", flush=True)
    return report(chosen, kept)


def counted(chosen, kept):
    """Of those tried: how many by state, and what survives without a reason."""
    accepted = accepted_survivors()
    counts, survivors = collections.Counter(), []
    for mutant in chosen:
        state = kept.of[mutant.key]["state"]
        if state == "unnoticed" and (mutant.file, mutant.before, mutant.after) in accepted:
            state = "accepted"
        counts[state] += 1
        if state == "unnoticed":
            survivors.append(mutant)
    return counts, survivors


def interval(noticed, tried):
    """Wilson's 95 % interval of a share."""
    z, share = 1.96, noticed / tried
    middle, half = share + z * z / (2 * tried), z * math.sqrt(share * (1 - share) / tried + (z / (2 * tried)) ** 2)
    return [max(0.0, (middle - half) / (1 + z * z / tried)), min(1.0, (middle + half) / (1 + z * z / tried))]


def tables(chosen, listed):
    """The sections of the page: figures of those chosen, as far as they have been tried; survivors with their reasons."""
    kept = results.Results(scratch_tree.FOLDER / "mutants.json")
    tried = [mutant for mutant in chosen if mutant.key in kept.of]
    lines = ["| code | changes | tried | noticed | not, with a reason | not | do not compile |", "|---|---|---|---|---|---|---|"]
    room = lambda mutant: mutant.file.removeprefix("resources/").rsplit("/", 1)[0]
    for name in [*sorted(set(map(room, listed))), None]:
        of = lambda mutants: [mutant for mutant in mutants if name in (None, room(mutant))]
        counts, left = counted(of(tried), kept)
        lines.append(f"| {f'`{name}`' if name else 'all'} | {len(of(listed))} | {len(of(tried))} | {counts['noticed']} | "
                     f"{counts['accepted']} | {len(left)} | {counts['does not compile']} |")
    counts, left = counted(tried, kept)
    judged = counts["noticed"] + len(left)
    if judged:
        low, high = (100 * share for share in interval(counts["noticed"], judged))
        lines.append(f"\nOf the {judged} that compile and are not accepted {counts['noticed']} were noticed: "
                     f"{100 * counts['noticed'] / judged:.1f} %, of all such changes {low:.1f} to {high:.1f} % with a confidence of 95 %.")
    for mutant in left:
        lines.append(f"\n- `{mutant.file.removeprefix('resources/shaders/')}`: `{mutant.before}` → `{mutant.after}`: no test notices.")
    return {"mutants": "\n".join(lines), **accepted_table()}


def accepted_table():
    lines = [f"- `{file.removeprefix('resources/shaders/')}`: `{before}` → `{after}`: {reason}."
             for (file, before, after), reason in accepted_survivors().items()]
    return {"accepted mutants": "\n".join(lines)}


def report(chosen, kept):
    counts, survivors = counted(chosen, kept)
    noticed, tried = counts["noticed"], counts["noticed"] + len(survivors)
    for mutant in survivors:
        print(f"survives: {mutant.file}:{mutant.line}\n  - {mutant.before}\n  + {mutant.after}")
    print(f"of {len(chosen)} changes {counts['does not compile']} do not compile, {counts['accepted']} are accepted; "
          f"of the other {tried} {noticed} were noticed" + (f" ({100 * noticed / tried:.1f} %)" if tried else ""))
    return 0 if noticed >= WANTED * tried else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", default="isolux", help="which are chosen, and their order")
    parser.add_argument("--sample", type=int, metavar="N", help="this many (all)")
    parser.add_argument("--only", metavar="PATTERN", help="files whose path matches (shell pattern)")
    parser.add_argument("--list", action="store_true", help="name the changes, try none")
    parser.add_argument("--check", action="store_true", help="whether survivors.toml and code agree; builds nothing")
    parser.add_argument("--table", action="store_true", help="write build/broken_code/mutants.md: of those chosen, as far as they have been tried")
    parser.add_argument("--jobs", type=int, default=max((os.cpu_count() or 2) // 2, 1), help="processes at a time (half of the cores)")
    parser.add_argument("--resume", action="store_true", help="leave out what build/broken_code/mutants.json holds")
    arguments = parser.parse_args()
    listed = all_mutants()
    if arguments.check:
        return check(listed)
    if arguments.only:
        listed = [mutant for mutant in listed if fnmatch.fnmatch(mutant.file, arguments.only)]
    chosen = sorted(listed, key=lambda mutant: results.digest(arguments.seed, mutant.key))[:arguments.sample]
    if arguments.table:
        files.write("mutants", tables(chosen, listed))
        return 0
    if arguments.list:
        for mutant in chosen:
            print(f"{mutant.file}:{mutant.line}\n  - {mutant.before}\n  + {mutant.after}")
        print(f"{len(chosen)} of {len(listed)}")
        return 0
    os.nice(max(0, 5 - os.nice(0)))
    return try_all(chosen, arguments)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except scratch_tree.Trouble as trouble:
        print(trouble, file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        sys.exit(130)
