#!/usr/bin/env python3
"""Checks the decisions of docs/decisions: their form, and the index docs/decisions/README.md.

usage: check_decisions.py [--write]

Each is `# NNNN: Title` with the sections Context, Decision and Consequences, none of them empty, in at most 60 lines of at most 120
characters (tables excepted). The index lists every file with its title. --write makes the index again.
"""
import difflib
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "docs" / "decisions"
INDEX = FOLDER / "README.md"
LINES, COLUMNS = 60, 120
SECTIONS = ["Context", "Decision", "Consequences"]
TITLE = re.compile(r"# (\d{4}): (\S.*)")
NAME = re.compile(r"(\d{4})-[a-z0-9-]+\.md")

HEAD = """# Decisions

A decision is a choice that could have been made otherwise and that later changes have to respect. Each page has a number, a noun
phrase as its title, and the sections Context (what made a choice necessary), Decision (what was chosen, and what was rejected) and
Consequences (what follows, limits included). A decision that is replaced is removed, or merged into the one that replaces it; its number is
not used again. Measurements and observations are in [notes](../notes/).

`tools/check_decisions.py --write` makes the list below; `./dev check texts` compares it.

"""


def decisions():
    return sorted(path for path in FOLDER.glob("*.md") if path != INDEX)


def title_of(path):
    """The title on the first line, without its number, or None."""
    match = TITLE.fullmatch(path.read_text(encoding="utf-8").partition("\n")[0])
    return match[2] if match else None


def faults_of(path):
    name, text = path.name, path.read_text(encoding="utf-8")
    shown = f"docs/decisions/{name}"
    lines = text.splitlines()
    title = TITLE.fullmatch(lines[0]) if lines else None
    number = NAME.fullmatch(name)
    if not number:
        yield f"{shown}: the name of a decision is a number and its title, 0007-start-and-end-of-tasks.md"
    elif not title or title[1] != number[1]:
        yield f"{shown}:1: the first line is `# {number[1]}: Title`"
    elif not title[2][0].isupper() or title[2].endswith("."):
        yield f"{shown}:1: a title starts with a capital letter and has no full stop"
    found = [line[3:] for line in lines if line.startswith("## ")]
    if found != SECTIONS:
        yield f"{shown}: the sections are {', '.join(SECTIONS)}; found: {', '.join(found) or 'none'}"
    for section in re.split(r"(?m)^## ", text)[1:]:
        heading, _, body = section.partition("\n")
        if not body.strip():
            yield f"{shown}: the section {heading} is empty"
    if len(lines) > LINES:
        yield f"{shown}: {len(lines)} lines; at most {LINES}"
    for at, line in enumerate(lines, 1):
        if len(line) > COLUMNS and not line.startswith("|"):
            yield f"{shown}:{at}: {len(line)} characters; at most {COLUMNS}"


def repeated(paths):
    """Numbers that two decisions have."""
    seen = {}
    for path in paths:
        first = seen.setdefault(path.name[:4], path.name)
        if first != path.name:
            yield f"docs/decisions/{path.name}: {first} has the same number"


def index(paths):
    return HEAD + "".join(f"* [{path.name[:4]}]({path.name}): {title_of(path)}\n" for path in paths)


def main():
    paths = decisions()
    faults = [fault for path in paths for fault in faults_of(path)] + list(repeated(paths))
    wanted = index(paths)
    if "--write" in sys.argv[1:]:
        INDEX.write_text(wanted, encoding="utf-8")
    present = INDEX.read_text(encoding="utf-8") if INDEX.exists() else ""
    if present != wanted:
        faults.append("docs/decisions/README.md is old; make it by tools/check_decisions.py --write:")
        faults += [line for line in difflib.unified_diff(present.splitlines(), wanted.splitlines(), lineterm="", n=0) if line[:3] not in ("---", "+++")]
    print("".join(f"{fault}\n" for fault in faults), end="")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
