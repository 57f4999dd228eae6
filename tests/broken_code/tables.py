"""Writes the tables of the scripts here, build/broken_code/NAME.md."""

import scratch_tree


def write(name, sections):
    """sections: title -> words."""
    file = scratch_tree.FOLDER / f"{name}.md"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text("\n\n".join(f"## {title}\n\n{words}" for title, words in sections.items()) + "\n")
    print(file)
