#!/usr/bin/env python3
"""Compares docs/stdlib.md with what the command says of its library, and the list of what is not available yet at the
top of docs/language.md with the tables that refuse it.

usage: check_reference.py COMMAND [--write]

--write brings the documents up to date.
"""
import difflib
import pathlib
import subprocess
import sys
import textwrap

DOCS = pathlib.Path(__file__).resolve().parent.parent / "docs"
BEGIN, END = "<!-- later -->\n", "<!-- end of later -->\n"


def output(command, *arguments):
    return subprocess.run([command, "help", *arguments], capture_output=True, text=True, check=True).stdout


def with_later(language, features):
    """The language reference with the list as it has to be."""
    begin, end = language.index(BEGIN) + len(BEGIN), language.index(END)
    listed = textwrap.fill(", ".join(features) + ".", 118, break_long_words=False, break_on_hyphens=False)
    return language[:begin] + listed + "\n" + language[end:]


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--write"]):
        sys.exit(__doc__)
    language = (DOCS / "language.md").read_text()
    features = output(sys.argv[1], "--later").splitlines()
    wanted = {"stdlib.md": output(sys.argv[1], "--markdown"), "language.md": with_later(language, features)}
    stale = []
    for name, says in wanted.items():
        document = DOCS / name
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
