#!/usr/bin/env python3
"""Compares docs/stdlib.md with what the command says of its library.

usage: check_reference.py COMMAND [--write]

--write brings the document up to date.
"""
import difflib
import pathlib
import subprocess
import sys

DOCUMENT = pathlib.Path(__file__).resolve().parent.parent / "docs" / "stdlib.md"


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--write"]):
        sys.exit(__doc__)
    says = subprocess.run([sys.argv[1], "help", "--markdown"], capture_output=True, text=True, check=True).stdout
    if sys.argv[2:]:
        DOCUMENT.write_text(says)
        return
    written = DOCUMENT.read_text()
    if says != written:
        sys.stdout.writelines(list(difflib.unified_diff(written.splitlines(True), says.splitlines(True),
                                                        str(DOCUMENT), "armlet help --markdown", n=1))[:60])
        sys.exit(f"{DOCUMENT} is out of date: {sys.argv[0]} COMMAND --write")
    print("reference: up to date")


if __name__ == "__main__":
    main()
