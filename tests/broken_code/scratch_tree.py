"""A copy of the source tree in which code may be broken: build/broken_code/tree.

It holds what git would add (tracked files and new ones that are not ignored), has a build folder of its own (preset dev; ccache
brings what is already compiled), and is brought up to date with the tree whenever it is opened. The tree itself is never written to.

Two things make a change cheap. The copy's render/gl/shader_library.cpp looks for shaders in a folder first, so that a broken one
costs a run of the tests and no build. And code that is compiled is judged by programs of the wanted tests alone (*focused*): a header
that half of the tests include would else compile them all.
"""

import fcntl
import fnmatch
import hashlib
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "build" / "broken_code"
FOCUSED = """
function(focused name program)
  get_target_property(sources ${program} SOURCES)
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
  add_executable(${name} EXCLUDE_FROM_ALL ${sources} ${ARGN})
  foreach(property IN ITEMS LINK_LIBRARIES COMPILE_DEFINITIONS)
    get_target_property(value ${program} ${property})
    if(value)
      set_target_properties(${name} PROPERTIES ${property} "${value}")
    endif()
  endforeach()
endfunction()
"""
TEST = re.compile(r"^(?:TYPED_)?TEST(?:_F|_P)?\((\w+),\s*(\w+)\)", re.M)
FOLDER_OF = {"property_tests": "properties", "gi_bake_tests": "gi"}  # of tests, where its name is another
MEMORY = 8 << 30  # bytes of address space: broken loops may ask for any amount
SHADERS = "resources/shaders/"
TOO_LONG = "it takes too long"
LIBRARY = "render/gl/shader_library.cpp"
LOOKUP = "std::string_view textOf(std::string_view name) {\n"
FROM_FOLDER = """#include <cstdlib>
#include <fstream>
#include <map>
"""
LOOKUP_IN_FOLDER = """  static std::map<std::string, std::string> changed;
  if (const char* const folder = std::getenv("ISOLUX_BROKEN_SHADERS")) {
    const std::string key(name);
    const auto known = changed.find(key);
    if (known != changed.end()) return known->second;
    std::ifstream file(std::string(folder) + "/" + key);
    std::ostringstream text;
    if (file && text << file.rdbuf()) return changed[key] = text.str();
  }
"""


class Trouble(Exception):
    """What keeps the script itself from going on; one line."""


class TestRun:
    """What one run of tests came to."""

    def __init__(self, passed, words, seconds, count):
        self.passed, self.words = passed, words  # words: the first that failed, or why
        self.seconds, self.count = seconds, count  # of a processor; of tests that passed


class ScratchTree:
    def __init__(self, jobs, wanted):
        """wanted: (target, tests)..., what compiled code will be judged by."""
        self.jobs = jobs
        self.path = FOLDER / "tree"
        self.build_folder = self.path / "build" / "dev"
        self.shaders = FOLDER / "shaders"  # broken ones
        self.broken = {}  # path -> what the file holds in the tree; None: it is not there
        FOLDER.mkdir(parents=True, exist_ok=True)
        self.lock = open(FOLDER / "lock", "w")
        try:
            fcntl.flock(self.lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise Trouble(f"another run is at work in {FOLDER}") from None
        shutil.rmtree(self.shaders, ignore_errors=True)
        self.focused = {}  # (target, tests) -> target
        self.sync(self.focus(wanted))
        self.configure()

    def focus(self, wanted):
        """CMake's words for a program of each target's files that hold wanted tests."""
        tests_of = {path: [".".join(test) for test in TEST.findall(path.read_text())] for path in (ROOT / "tests").rglob("*_test.cpp")}
        words = {}
        for target, tests in wanted:
            plain = [re.sub(r"^\*/|/gpu$", "", one) for one in tests.split(":")]
            files = sorted(str(path.relative_to(ROOT)) for path, names in tests_of.items() if path.relative_to(ROOT / "tests").parts[0]
                           == FOLDER_OF.get(target, target.removesuffix("_tests")) and any(fnmatch.fnmatchcase(name, one) for name in names for one in plain))
            name = "focused_" + hashlib.sha256(" ".join([target, *files]).encode()).hexdigest()[:12]
            self.focused[target, tests] = name
            sources = "".join(f" ${{PROJECT_SOURCE_DIR}}/{file}" for file in files)
            words[name] = f"focused({name} {target}{sources})\n"
        return FOCUSED + "".join(words[name] for name in sorted(words))

    def sync(self, focus):
        """Files that differ are written anew, so that only they are compiled."""
        listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                                capture_output=True, check=True).stdout.decode().split("\0")
        wanted = {name for name in listed if name and (ROOT / name).is_file()}
        for name in wanted:
            source, target = ROOT / name, self.path / name
            content = self.content(name, source) + (focus.encode() if name == "tests/CMakeLists.txt" else b"")
            if target.is_file() and target.read_bytes() == content:
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)
            shutil.copymode(source, target)
        for folder, folders, files in os.walk(self.path):
            if pathlib.Path(folder) == self.path:
                folders[:] = [name for name in folders if name != "build"]
            for name in files:
                path = pathlib.Path(folder, name)
                if str(path.relative_to(self.path)) not in wanted:
                    path.unlink()

    @staticmethod
    def content(name, source):
        if name != LIBRARY:
            return source.read_bytes()
        text = source.read_text()
        if text.count(LOOKUP) != 1:
            raise Trouble(f"{LIBRARY} has no longer the function that shaders are found by: {LOOKUP.strip()}")
        text = text.replace(LOOKUP, LOOKUP + LOOKUP_IN_FOLDER)
        return text.replace("\n\n#include <set>", "\n\n" + FROM_FOLDER + "#include <set>").encode()

    def environment(self):
        env = dict(os.environ, CCACHE_NOHASHDIR="1")
        if not subprocess.run(["ccache", "--get-config", "base_dir"], capture_output=True, text=True).stdout.strip():
            env["CCACHE_BASEDIR"] = str(self.path)
        env.setdefault("ISOLUX_DATA", str(ROOT.parent / "shared" / "data"))
        return env

    def configure(self):
        if (self.build_folder / "build.ninja").is_file():
            return
        options = ["-DISOLUX_UNITY=ON", "-DISOLUX_UNITY_FILES=1"]  # folder by folder: little is compiled again
        if shutil.which("ld.gold"):  # a third of the time
            options.append("-DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=gold")
        made = subprocess.run(["cmake", "--preset", "dev", *options], cwd=self.path, capture_output=True, text=True, env=self.environment())
        if made.returncode != 0:
            raise Trouble("cmake failed:\n" + made.stdout + made.stderr)

    def break_code(self, file, text):
        """Gives the copy's file another text. restore() takes it back."""
        if file.startswith(SHADERS):
            path = self.shaders / pathlib.Path(file).name
            self.broken[path] = None
            path.parent.mkdir(exist_ok=True)
        else:
            path = self.path / file
            self.broken.setdefault(path, path.read_text())
        path.write_text(text)

    def restore(self):
        for path, text in self.broken.items():
            if text is None:
                path.unlink()
            else:
                path.write_text(text)
        self.broken.clear()

    def build(self, target):
        """None, or the compiler's words."""
        made = subprocess.run(["ninja", "-C", self.build_folder, "-j", str(self.jobs), target],
                              capture_output=True, text=True, env=self.environment())
        return None if made.returncode == 0 else made.stdout[-4000:]

    def run(self, target, tests, seconds, broken=True):
        """Runs the tests that a GoogleTest filter names, until one fails; more than `seconds` of a processor are a failure.

        A busy machine stretches time by any factor, but not what a processor does. `broken`: with the shaders that are broken.
        """
        started = time.monotonic()
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        parts = [self.start(target, tests, part, seconds, broken) for part in range(self.jobs)]
        words = passed = None
        waiting = dict(enumerate(parts))
        while waiting and passed is not False:
            for part, (process, log) in list(waiting.items()):
                try:
                    code = process.wait(0.02)
                except subprocess.TimeoutExpired:
                    if time.monotonic() - started > 600 + 20 * seconds:  # it waits for what never comes
                        passed, words = False, TOO_LONG
                        break
                    continue
                del waiting[part]
                if code != 0:
                    passed, words = False, reason(code, pathlib.Path(log.name).read_text(errors="replace"))
                    break
        for process, log in parts:
            if process.poll() is None:
                process.kill()
                process.wait()
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        output = "".join(pathlib.Path(log.name).read_text(errors="replace") for _, log in parts)
        return TestRun(passed is not False, words, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
                       len(re.findall(r"^\[       OK \] ", output, re.M)))

    def start(self, target, tests, part, seconds, broken):
        log = open(FOLDER / f"tests_{part}.log", "w")
        env = dict(self.environment(), GTEST_TOTAL_SHARDS=str(self.jobs), GTEST_SHARD_INDEX=str(part))
        if broken:
            env["ISOLUX_BROKEN_SHADERS"] = str(self.shaders)
        command = [self.build_folder / "bin" / target, f"--gtest_filter={tests}", "--gtest_fail_fast"]
        return subprocess.Popen(command, stdout=log, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, env=env,
                                cwd=self.build_folder, preexec_fn=lambda: limit(int(seconds) + 1)), log


def limit(seconds):
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def reason(code, output):
    if code in (-signal.SIGXCPU, -signal.SIGKILL):
        return TOO_LONG
    failed = re.search(r"^\[  FAILED  \] (\S+?),? ", output, re.M)
    if re.search(r"shader .+ does not compile", output):
        return "the shader does not compile"
    if failed:
        return failed.group(1)
    running = re.findall(r"^\[ RUN      \] (\S+)", output, re.M)
    where = f" in {running[-1]}" if running else ""
    return f"it ends by signal {-code}{where}" if code < 0 else f"it ends with {code}{where}"


class Judge:
    """Whether tests notice a change. A test that fails must pass where nothing is changed, which is asked when it first fails."""

    def __init__(self, tree, wanted):
        """wanted: (target, tests)..."""
        self.tree = tree
        self.times_file = FOLDER / "unchanged.json"  # of each target: its digest, and the seconds that tests of it took
        self.times = json.loads(self.times_file.read_text()) if self.times_file.is_file() else {}
        for target in dict.fromkeys(target for target, _ in wanted):
            trouble = tree.build(target)
            if trouble:
                raise Trouble(f"{target} does not build unchanged:\n{trouble}")
            digest = hashlib.sha256((tree.build_folder / "bin" / target).read_bytes()).hexdigest()
            if self.times.get(target, {}).get("digest") != digest:
                self.times[target] = {"digest": digest, "seconds": {}}

    def seconds(self, target, tests):
        """Of a processor, that tests take unchanged."""
        known = self.times[target]["seconds"]
        if tests not in known:
            run = self.tree.run(target, tests, 3600, broken=False)
            if not run.passed:
                raise Trouble(f"{target} fails unchanged: {run.words}")
            if run.count == 0:
                raise Trouble(f"{target} has no tests '{tests}'")
            known[tests] = run.seconds
            self.times_file.write_text(json.dumps(self.times, indent=1))
        return known[tests]

    def allowed(self, target, tests):
        return 60 + 5 * self.times[target]["seconds"].get(tests, 0.0)

    def judge(self, changed, target, tests):
        """changed: file -> text. ("noticed" | "unnoticed" | "does not compile", words, seconds)."""
        started = time.monotonic()
        compiled = not all(file.startswith(SHADERS) for file in changed)
        program = self.tree.focused[target, tests] if compiled else target
        try:
            for file, text in changed.items():
                self.tree.break_code(file, text)
            trouble = self.tree.build(program) if compiled else None
            if trouble:
                found = re.search(r"(error: .*|undefined reference.*)", trouble)
                return "does not compile", found.group(1) if found else trouble[-200:], time.monotonic() - started
            allowed = self.allowed(target, tests)
            run = self.tree.run(program, tests, allowed)
            if run.words == TOO_LONG:
                self.seconds(target, tests)
                if self.allowed(target, tests) > allowed:
                    run = self.tree.run(program, tests, self.allowed(target, tests))
        finally:
            self.tree.restore()
        seconds = time.monotonic() - started
        if run.words == "the shader does not compile":
            return "does not compile", run.words, seconds
        if run.passed:
            if run.count == 0:
                raise Trouble(f"{target} has no tests '{tests}'")
            return "unnoticed", "", seconds
        if run.words != TOO_LONG:
            self.seconds(target, run.words if re.fullmatch(r"[\w/]+\.[\w/]+", run.words) else tests)
        return "noticed", run.words, seconds
