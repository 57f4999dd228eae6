"""The sections of docs/numerics.md that the scripts here write, each between <!-- NAME --> and <!-- end of NAME -->."""

import re

import scratch_tree

PAGE = scratch_tree.ROOT / "docs" / "numerics.md"


def between(section):
    return re.compile(rf"(?<=<!-- {section} -->\n).*?(?=\n<!-- end of {section} -->)", re.S)


def write(sections):
    """sections: name -> words."""
    text = PAGE.read_text()
    for section, words in sections.items():
        text, count = between(section).subn(lambda _: words, text)
        if count != 1:
            raise scratch_tree.Trouble(f"docs/numerics.md has {count} sections '{section}', not one")
    PAGE.write_text(text)


def outdated(sections):
    """Names of those that say something else, or are missing."""
    text = PAGE.read_text()
    found = {section: between(section).search(text) for section in sections}
    return [section for section, words in sections.items() if not found[section] or found[section].group() != words]
