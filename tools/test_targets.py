#!/usr/bin/env python3
"""What has to be built for some of the tests: test_targets.py BUILD NAME

Prints the targets of the folder BUILD that the tests whose name contains NAME run, one a line; `all` for tests that install
everything. Exits with 1 if there is no such test.
"""
import pathlib
import re
import subprocess
import sys

QUOTED = re.compile(r'"((?:[^"\\]|\\.)*)"')


def tests(folder):
    """Of a folder and those in it: the name and the command of every test."""
    listed = "".join(path.read_text() for path in folder.glob("CTestTest*"))
    for line in listed.splitlines():
        test = re.match(r"add_test\(\[=*\[(.*?)\]=*\](.*)\)$", line)
        if test:
            yield test[1], QUOTED.findall(test[2])
        below = re.match(r'subdirs\("(.*)"\)$', line)
        if below:
            yield from tests(folder / below[1])


def outputs(build):
    """The files that can be built, by their whole name."""
    listed = subprocess.run(["ninja", "-C", str(build), "-t", "targets", "all"], capture_output=True, text=True, check=True)
    rules = (line.rsplit(": ", 1) for line in listed.stdout.splitlines())
    return {str(build / output): output for output, rule in rules if rule != "phony"}


def main():
    build, name = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    chosen = [command for test, command in tests(build) if name in test]
    if not chosen:
        sys.exit(f"no test has a name with {name} in it; `ctest --test-dir {sys.argv[1]} -N` lists them")
    known, needed = outputs(build), set()
    for command in chosen:
        if {"--install", "--build-and-test"} & set(command):
            needed = {"all"}
            break
        needed.update(known[word] for word in command if word in known)
    print("\n".join(sorted(needed)))


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main()
