#!/usr/bin/env python3
"""Checks the form of CHANGELOG.md: releases, groups, kinds of changes, and one line for each change.

usage: check_changelog.py

Each release has groups (Language, Library, Page, C++, Tools), each group kinds (Added, Changed, Fixed, Removed), all in this order and none
empty. A change is one line of at most 180 characters. The version of CMakeLists.txt has a release with its date.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
GROUPS = ["Language", "Library", "Page", "C++", "Tools"]
KINDS = ["Added", "Changed", "Fixed", "Removed"]
COLUMNS = 180
RELEASE = re.compile(r"\[(Unreleased|\d+\.\d+\.\d+)\](?: - (\d{4}-\d\d-\d\d))?")


class Checker:
    def __init__(self):
        self.faults, self.releases, self.groups, self.kinds, self.kind_line = [], {}, [], [], 0

    def fault(self, number, what):
        self.faults.append(f"CHANGELOG.md:{number}: {what}")

    def close_kind(self):
        if self.kind_line:
            self.fault(self.kind_line, "there is nothing below this heading")
        self.kind_line = 0

    def heading(self, number, allowed, seen, name):
        if name not in allowed:
            self.fault(number, f"`{name}` is none of {', '.join(allowed)}")
        elif seen and allowed.index(name) <= allowed.index(seen[-1]):
            self.fault(number, f"`{name}` comes before `{seen[-1]}`, once: {', '.join(allowed)}")
        else:
            seen.append(name)

    def line(self, number, line):
        if line.startswith("## "):
            self.close_kind()
            match = RELEASE.fullmatch(line[3:])
            if not match or (match[1] == "Unreleased") != (match[2] is None):
                self.fault(number, "a release is `## [0.1.0] - 2026-11-29` or `## [Unreleased]`")
            else:
                self.releases[match[1]] = match[2]
            self.groups, self.kinds = [], []
        elif line.startswith("### "):
            self.close_kind()
            self.heading(number, GROUPS, self.groups, line[4:])
            self.kinds = []
        elif line.startswith("#### "):
            self.close_kind()
            self.heading(number, KINDS, self.kinds, line[5:])
            self.kind_line = number
        elif line.startswith("- "):
            self.kind_line = 0
            if not self.kinds:
                self.fault(number, f"a change is below a group ({', '.join(GROUPS)}) and a kind ({', '.join(KINDS)})")
            if len(line) > COLUMNS:
                self.fault(number, f"{len(line)} characters; at most {COLUMNS}")
        elif line and self.groups:
            self.fault(number, "a change is one line that starts with `- `")

    def check(self, text, version):
        for number, line in enumerate(text.splitlines(), 1):
            self.line(number, line)
        self.close_kind()
        if "Unreleased" not in self.releases:
            self.fault(1, "there is no heading `## [Unreleased]` for the next changes")
        if version not in self.releases:
            self.fault(1, f"there is no release {version}, the version of CMakeLists.txt")


def main():
    checker = Checker()
    version = re.search(r"project\(armlet VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
    checker.check((ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), version)
    print("\n".join(checker.faults) or "changelog: in order")
    return 1 if checker.faults else 0


if __name__ == "__main__":
    sys.exit(main())
