#!/usr/bin/env python3
"""Compares what documents repeat of the tables in the sources with those tables: docs/stdlib.md, and the blocks between
"begin of NAME" and "end of NAME" in other files.

usage: check_reference.py COMMAND [--write]

--write brings the documents up to date.
"""
import difflib
import json
import pathlib
import re
import subprocess
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent


def output(command, *arguments):
    return subprocess.run([command, "help", *arguments], capture_output=True, text=True, check=True).stdout


def filled(text):
    return textwrap.fill(text, 118, break_long_words=False, break_on_hyphens=False) + "\n"


def traces(lists):
    """The endings of trace files, for the manual page, in which a dot must not begin a line."""
    formats = [f"\\&{entry['ending']} ({entry['holds']})" for entry in lists["traces"]]
    return filled("; ".join(formats) + ".")


# Of each file the blocks in it, and what they have to hold.
BLOCKS = {"docs/armlet.1": {"traces": traces},
          "docs/language.md": {"later": lambda lists: filled(", ".join(lists["later"]) + ".")}}


def with_block(text, name, content):
    """The text with what has to be between the lines that begin and end the block."""
    begin = re.search(rf"^.*\bbegin of {name}\b.*\n", text, re.M)
    end = re.search(rf"^.*\bend of {name}\b.*\n", text, re.M)
    if not begin or not end:
        sys.exit(f"there is no block {name}")
    return text[:begin.end()] + content + text[end.start():]


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--write"]):
        sys.exit(__doc__)
    lists = json.loads(output(sys.argv[1], "--lists"))
    lists["later"] = output(sys.argv[1], "--later").splitlines()
    wanted = {"docs/stdlib.md": output(sys.argv[1], "--markdown")}
    for name, blocks in BLOCKS.items():
        wanted[name] = (ROOT / name).read_text()
        for block, content in blocks.items():
            wanted[name] = with_block(wanted[name], block, content(lists))
    stale = []
    for name, says in wanted.items():
        document = ROOT / name
        written = document.read_text()
        if sys.argv[2:]:
            document.write_text(says)
        elif says != written:
            sys.stdout.writelines(list(difflib.unified_diff(written.splitlines(True), says.splitlines(True),
                                                            str(document), "armlet help", n=1))[:60])
            stale.append(str(document))
    if stale:
        sys.exit(f"{' and '.join(stale)}: out of date: {sys.argv[0]} COMMAND --write")
    print("reference: up to date")


if __name__ == "__main__":
    main()
