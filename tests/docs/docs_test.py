"""The documentation: links, generated pages, commands, length, words, pictures."""

import os
import re
import subprocess
import tempfile
import unittest

SOURCE = os.environ["ISOLUX_SOURCE"]
BINARIES = os.environ["ISOLUX_BINARIES"]  # the folder of isolux and isolux_keys
DOCS = os.path.join(SOURCE, "docs")

# Words a page may have (a word has a letter or a digit); a tenth more is allowed. What is generated does not count.
BUDGETS = {
    "README.md": 750, "CONTRIBUTING.md": 60, "docs/index.md": 120, "docs/gallery.md": 1100, "docs/howto/index.md": 1400,
    "docs/start/clinician.md": 550, "docs/start/engineer.md": 550, "docs/start/simulation.md": 550, "docs/start/python.md": 550,
    "docs/guide/open.md": 750, "docs/guide/surfaces.md": 750, "docs/guide/labels.md": 560, "docs/guide/looks.md": 750, "docs/guide/slices.md": 450,
    "docs/guide/clip.md": 450, "docs/guide/measure.md": 750, "docs/guide/light.md": 600, "docs/guide/compare.md": 350,
    "docs/guide/export.md": 800, "docs/guide/accuracy.md": 600, "docs/guide/sessions.md": 550, "docs/guide/large-data.md": 450,
    "docs/guide/window.md": 350, "docs/reference/settings.md": 4600, "docs/reference/commands.md": 2800,
    "docs/reference/outputs.md": 1400, "docs/reference/formats.md": 780, "docs/reference/keys.md": 400,
    "docs/reference/file-formats-isolux.md": 700, "docs/reference/python.md": 800, "docs/reference/glossary.md": 800,
    "docs/reference/troubleshooting.md": 800, "docs/reference/cite.md": 80, "docs/explanation/trust.md": 500,
    "docs/explanation/hits.md": 800, "docs/explanation/curvature.md": 1000, "docs/explanation/looks.md": 800,
    "docs/explanation/global-illumination.md": 1100, "docs/explanation/surfaces-in-baked-light.md": 450, "docs/explanation/measurement.md": 850, "docs/explanation/accuracy.md": 750,
    "docs/explanation/components.md": 350, "docs/explanation/labels.md": 710, "docs/explanation/large-volumes.md": 500, "docs/explanation/numerics.md": 680,
    "docs/explanation/papers.md": 500, "docs/developers/architecture.md": 1500, "docs/developers/frame-graph.md": 1100,
    "docs/developers/graphics.md": 500,
    "docs/developers/processes.md": 800, "docs/developers/extending.md": 450, "docs/developers/contributing.md": 450,
    "docs/developers/dependencies.md": 300, "docs/records/2026-11-benchmarks.md": 2400,
    "docs/records/2026-11-accuracy-surfaces.md": 1300, "docs/records/2026-11-accuracy-light.md": 1500,
    "docs/records/2026-11-derivative-scales.md": 500, "docs/records/2026-11-paper-tables.md": 900,
    "docs/records/tried-and-not-kept.md": 400, "docs/records/2026-11-build-time.md": 200,
}
MOST_WORDS = 46850  # of all pages together

# Words that the writing guide replaces, in text for users.
REPLACED = [r"\bas ever\b", r"\bheeds?\b", r"\bof its own\b", r"\bof one's own\b", r"\bfor want of\b", r"\bwhich one is taken\b",
            r"\banew\b", r"\byardstick\b", r"\ba mistake of ours\b", r"\bwhat there is so far\b", r"\bgoes by itself\b",
            r"\bin parts of\b", r"\bnobody\b"]


def pages():
    found = ["README.md", "CONTRIBUTING.md"]
    for folder, folders, files in os.walk(DOCS):
        folders[:] = [f for f in folders if f not in ("images", "gallery", "data")]
        found += [os.path.relpath(os.path.join(folder, f), SOURCE) for f in files if f.endswith(".md")]
    return sorted(found)


def text_of(page):
    with open(os.path.join(SOURCE, page), encoding="utf-8") as file:
        return file.read()


def run(*command, folder=None, **environment):
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False, env=os.environ | environment)
    if done.returncode != 0:
        raise AssertionError(f"{command}: {done.returncode}: {done.stderr}")
    return done.stdout


def without_code(text):
    return re.sub(r"```.*?```", "", text, flags=re.S)


def anchors_of(page):
    anchors = set()
    for heading in re.findall(r"^#+ (.*)$", without_code(text_of(page)), re.M):
        plain = re.sub(r"\[(.*?)\]\(.*?\)", r"\1", heading).replace("`", "").lower()
        slug = re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")
        number, unique = 0, slug
        while unique in anchors:
            number += 1
            unique = f"{slug}-{number}"
        anchors.add(unique)
    return anchors


def words_of(text):
    text = re.sub(r"<!-- generated: (\w+) -->.*?<!-- end of \1 -->", "", text, flags=re.S)
    return sum(1 for word in text.split() if re.search(r"\w", word))


class Docs(unittest.TestCase):
    def test_links_lead_somewhere(self):
        links = 0
        for page in pages():
            for target in re.findall(r"\]\(([^)\s]+)\)", without_code(text_of(page))):
                if re.match(r"[a-z]+:", target):
                    continue
                links += 1
                path, _, anchor = target.partition("#")
                file = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
                with self.subTest(page=page, target=target):
                    self.assertTrue(os.path.exists(os.path.join(SOURCE, file)))
                    if anchor and file.endswith(".md"):
                        self.assertIn(anchor, anchors_of(file))
        self.assertGreater(links, 200)

    def test_every_page_is_reached_from_the_index(self):
        reached, todo = set(), ["docs/index.md"]
        while todo:
            page = todo.pop()
            if page in reached:
                continue
            reached.add(page)
            for target in re.findall(r"\]\(([^)\s#]+\.md)[^)]*\)", text_of(page)):
                file = os.path.normpath(os.path.join(os.path.dirname(page), target))
                if os.path.exists(os.path.join(SOURCE, file)):
                    todo.append(file)
        self.assertEqual({page for page in pages() if page.startswith("docs/")} - reached, set())

    def test_generated_pages_are_what_the_program_says(self):
        isolux = os.path.join(BINARIES, "isolux")
        for page, command in {"settings": (isolux, "settings", "--markdown"), "commands": (isolux, "--made-page", "commands"),
                              "keys": (os.path.join(BINARIES, "isolux_keys"),)}.items():
            with self.subTest(page):
                self.assertEqual(text_of(f"docs/reference/{page}.md"), run(*command), " ".join(command))
        table = re.search(r"<!-- generated: aovs -->\n(.*?)<!-- end of aovs -->", text_of("docs/reference/outputs.md"), re.S)
        self.assertEqual(table.group(1).strip(), run(isolux, "--made-page", "aovs").strip())

    def test_commands_of_the_pages_run(self):
        blocks = 0
        for page in pages():
            with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as home:
                for block in re.findall(r"```sh run\n(.*?)```", text_of(page), re.S):
                    blocks += 1
                    with self.subTest(page=page, block=block):
                        run("bash", "-euc", block, folder=folder, HOME=home, XDG_CONFIG_HOME=home, XDG_STATE_HOME=home,
                            XDG_CACHE_HOME=home, PATH=BINARIES + os.pathsep + os.environ["PATH"])
        self.assertGreater(blocks, 20)

    def test_pages_are_short(self):
        self.assertEqual(set(pages()), set(BUDGETS))
        for page, budget in BUDGETS.items():
            with self.subTest(page):
                self.assertLessEqual(words_of(text_of(page)), 1.1 * budget)
        self.assertLessEqual(sum(words_of(text_of(page)) for page in BUDGETS), MOST_WORDS)

    def test_words_are_those_of_the_field(self):
        texts = {page: without_code(text_of(page)) for page in pages()}
        for name in ("scene/settings/settings.cpp", "scene/settings/host_settings.cpp"):
            texts[name] = "\n".join(re.findall(r'"((?:[^"\\]|\\.)*)"', text_of(name)))
        for folder, _, files in os.walk(os.path.join(SOURCE, "ui")):
            for file in files:
                if file.endswith(".cpp"):
                    name = os.path.relpath(os.path.join(folder, file), SOURCE)
                    calls = re.findall(r'\btr\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)', text_of(name))
                    texts[name] = "\n".join(re.sub(r'"\s*"', "", call) for call in calls)
        for name, text in texts.items():
            for pattern in REPLACED:
                found = re.search(pattern, text, re.I)
                with self.subTest(name, pattern=pattern):
                    self.assertIsNone(found, found and text[max(0, found.start() - 40):found.end() + 40])

    def test_each_page_of_the_guide_has_its_picture(self):
        script = text_of("docs/make_pictures.sh")
        for part in ("guide", "start"):
            for file in sorted(os.listdir(os.path.join(DOCS, part))):
                name = file.removesuffix(".md")
                with self.subTest(part, page=name):
                    self.assertIn(f"../images/{part}/{name}.png", text_of(f"docs/{part}/{file}"))
                    self.assertTrue(os.path.exists(os.path.join(DOCS, "images", part, name + ".png")))
                    self.assertRegex(script, rf"{part}/{name}\b|{part} {name}\b")

    def test_help_prints_pages(self):
        isolux = os.path.join(BINARIES, "isolux")
        self.assertIn("guide/slices", run(isolux, "help"))
        self.assertEqual(run(isolux, "help", "slices"), text_of("docs/guide/slices.md"))
        done = subprocess.run([isolux, "help", "slice"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("did you mean slices?", done.stderr)

    def test_shells_complete(self):
        script = run(os.path.join(BINARIES, "isolux"), "--made-page", "bash")
        for words, expected in ((["ren"], "render"), (["render", "--isov"], "--isovalue"),
                                (["render", "--set", "look.mo"], "look.mode=")):
            line = " ".join(["isolux", *words])
            code = (f"{script}\ncompopt() {{ :; }}\nCOMP_WORDS=({line}); COMP_CWORD={len(words)}; _isolux; "
                    "printf '%s\\n' \"${COMPREPLY[@]}\"")
            with self.subTest(line):
                self.assertIn(expected, run("bash", "-c", code).split())


if __name__ == "__main__":
    unittest.main()
