#!/usr/bin/env python3
"""Checks that bindings of the library name parameters that signatures have: at("speed"), check_word<"axis", ...>.

A name in a file with rows of the library has to be a parameter in one of these rows, a name in another file a parameter anywhere.
Which function runs is known only in the run: then a message with a wrong name says so (docs/decisions/0277-parameters-by-name.md).
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SOURCES = ROOT / "stdlib" / "src"

LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
PARAMETER = re.compile(r"(?:^|[(,;]\s*|\s)([A-Za-z_]\w*):(?:\s|$)")
NAMED = re.compile(r'\bat\("(\w+)"\)|\b\w+<"(\w+)"[,>]')
ROW = re.compile(r"\bdef<")


def parameters_of(text: str) -> set[str]:
    """The words before a colon in the literals of a source, which contain all parameters of its rows."""
    joined = (match.group(1) for match in LITERAL.finditer(text))
    return {name for literal in joined for name in PARAMETER.findall(literal)}


def main() -> int:
    texts = {path: path.read_text() for path in sorted(SOURCES.rglob("*.?pp"))}
    known = {path: parameters_of(text) for path, text in texts.items()}
    anywhere = set().union(*known.values())
    bad = []
    for path, text in texts.items():
        allowed = known[path] if ROW.search(text) else anywhere
        for number, line in enumerate(text.splitlines(), 1):
            for match in NAMED.finditer(line):
                name = match.group(1) or match.group(2)
                if name not in allowed:
                    bad.append(f"{path.relative_to(ROOT)}:{number}: no signature here has the parameter `{name}`")
    print("\n".join(bad) if bad else f"parameters: {sum(len(NAMED.findall(t)) for t in texts.values())} names, all known")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
