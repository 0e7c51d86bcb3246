#!/usr/bin/env python3
"""Checks that every message of the catalogue is shown by a script, word for word where the reference has a sample."""

import functools
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SCRIPTS = ROOT / "tests" / "scripts" / "errors"
SAMPLES = ROOT / "tests" / "reference" / "messages"
SOURCES = ("interpreter/src", "stdlib/src", "apps")

# Codes that no script can show, and the test that shows them instead (None: nothing can yet).
ELSEWHERE = {
    "E0123": "tests/hostile.py",  # a script with an expectation in it is text
    "E0124": "tests/unit/interpreter/syntax/syntax_limits_test.cpp",  # too long for a script
    "E0126": "tests/hostile.py",  # there is no file
    "E0198": None,  # a defect of Armlet, or no memory left
    "E0220": "tests/unit/interpreter/check/host_vocabulary_test.cpp",  # the command always supplies a robot
    "E0319": "tests/unit/interpreter/check/host_vocabulary_test.cpp",  # functions of the library are never ambiguous
    "R0628": "tests/hostile.py",  # fills a gigabyte
    "R0629": "tests/hostile.py",  # needs a signal
    "R0646": "tests/planning_command.py",  # a build that has lost its library
    "R0660": "tests/convert_command.py",  # a build without the converter
    "R0670": "tests/world_command.py",  # a world in a file
    "R0691": "tests/opencv/vision_command.py",  # a build without OpenCV
    "W0740": "tests/convert_command.py",  # needs the converter
    "W0741": "tests/convert_command.py",
    "W0743": "tests/world_command.py",  # it has no line in the program
    "W0719": "tests/unit/interpreter/vm/entries_test.cpp",  # a script is one entry
    "W0712": "tests/unit/stdlib/session_test.cpp",  # the command always supplies a world
}

# Samples that list a table, and the test that compares them with it.
LISTS = {"E0202": "tests/unit/stdlib/reference_test.cpp"}  # the planners

# Messages whose text in scripts differs from the sample (docs/notes/messages.md).
CHANGED = {
    "R0604": {"163 deg": "130 deg"},
    "R0607": {"since t = 0.00 s": "since t = 3.00 s"},
    "E0504": {"cell.rbt:14:1": "modules/grip.rbt:14:1", "cell.rbt": "E0504_import_moves.rbt"},
}

HEADLINE = re.compile(r"^(?:error|advice) ([ERW]\d{4}): ")


def catalogue():
    files = sorted(p for folder in ("interpreter", "stdlib") for p in (ROOT / folder).rglob("messages/*.def"))
    rows = "".join(p.read_text() for p in files)
    return sorted(re.findall(r"^ARMLET_MESSAGE\(([ERW]\d{4}),", rows, re.M))


@functools.cache
def raised():
    """The codes that occur in the sources."""
    texts = [p.read_text() for folder in SOURCES for p in (ROOT / folder).rglob("*.[chi]*") if p.is_file()]
    return set(re.findall(r'"([ERW]\d{4})"', "".join(texts)))


def shown_block(script):
    return [line[5:] for line in script.splitlines() if line.startswith("// | ")]


def expected(script):
    """The codes that a script expects."""
    codes = re.findall(r"// expect (?:error|advice) ([ERW]\d{4})", script)
    return set(codes) | {m[1] for line in shown_block(script) if (m := HEADLINE.match(line))}


def sample(code):
    lines = [line for line in (SAMPLES / f"{code}.txt").read_text().splitlines() if line]
    start = next(i for i, line in enumerate(lines) if HEADLINE.match(line))
    for old, new in CHANGED.get(code, {}).items():
        lines = [line.replace(old, new) for line in lines]
    return lines[start:]


def contains(shown, wanted):
    """Whether all wanted lines are shown in their order; a script may mark more than the sample."""
    rest = iter(shown)
    return all(line in rest for line in wanted)


def problems():
    scripts = {path: path.read_text() for path in sorted(SCRIPTS.rglob("*.rbt"))}
    by_code = {}
    for path, text in scripts.items():
        for code in expected(text):
            by_code.setdefault(code, []).append(path)
        named = path.name.split("_")[0]
        if "modules" not in path.parts and named not in expected(text):
            yield f"{path.relative_to(ROOT)} does not expect {named}"
    for code in catalogue():
        if code in raised() and code not in by_code and code not in ELSEWHERE:
            yield f"{code} is shown by no script"
        if code in by_code and code in ELSEWHERE:
            yield f"{code} is shown by a script: remove the exception"
        if code not in raised():
            yield f"{code} is never raised"
    for code, test in ELSEWHERE.items():
        if test and code not in (ROOT / test).read_text():
            yield f"{code} is not tested in {test}"
    for path in sorted(SAMPLES.glob("*.txt")):
        code = path.stem
        shown = [shown_block(scripts[p]) for p in by_code.get(code, [])]
        if code not in LISTS and not any(contains(block, sample(code)) for block in shown):
            yield f"no script shows the sample of {code} word for word"


def main():
    found = list(problems())
    for problem in found:
        print(problem)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
