#!/usr/bin/env python3
"""Checks that the language knows no robots: no word of them stands in the interpreter's sources.

What programs of robots call things comes from the host (stdlib/). The exceptions are files, each with its reason.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("interpreter/src", "interpreter/include")
WORDS = re.compile(
    r"\b(?:robots?|arms?|joints?|grippers?|pos[JC]|move[JLC]|moveCirc|scara|puma\d*)\b", re.IGNORECASE)
ARM_A_CONDITION = re.compile(r"\barm\(")  # the verb

# The headlines are the language's; the pages of help below them are written for users of the library, with its programs.
MESSAGES = "interpreter/include/armlet/interpreter/messages/"

# Beginnings of paths, and why every word may stand there.
EXCEPTIONS = {
    "interpreter/src/habits/": "statements of other robot languages: patterns of whole lines, tried only where a text has mistakes",
}


def files():
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in (".hpp", ".cpp", ".def"):
                yield path


def problems():
    used = set()
    for path in files():
        name = str(path.relative_to(ROOT))
        found = [(number, match[0])
                 for number, line in enumerate(path.read_text().splitlines(), 1)
                 if not name.startswith(MESSAGES) or line.startswith("ARMLET_MESSAGE")
                 for match in WORDS.finditer(ARM_A_CONDITION.sub("", line))]
        exception = next((key for key in EXCEPTIONS if name.startswith(key)), None)
        if exception and found:
            used.add(exception)
        elif not exception:
            for number, word in found:
                yield f"{name}:{number}: the language knows no `{word}`: let the host say it"
    for key in EXCEPTIONS.keys() - used:
        yield f"{key} is an exception without need"


def main():
    found = list(problems())
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
