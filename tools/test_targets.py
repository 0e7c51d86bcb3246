#!/usr/bin/env python3
"""What has to be built for some of the tests: test_targets.py BUILD -R NAME, or test_targets.py BUILD -L LABEL

Prints the targets of the folder BUILD that the chosen tests run, one a line: those whose name matches the pattern NAME, or
that have the label LABEL. Prints `all` for tests that install everything. Exits with 1 if there is no such test.
"""
import pathlib
import re
import subprocess
import sys

QUOTED = re.compile(r'"((?:[^"\\]|\\.)*)"')


def tests(folder):
    """The name, command and label of every test of a folder and its subfolders; ctest does not show the commands of
    programs that are not built yet."""
    listed = "".join(path.read_text() for path in folder.glob("CTestTest*"))
    labels = dict(re.findall(r'^set_tests_properties\(\[=*\[(.*?)\]=*\] PROPERTIES .*?LABELS "(.*?)"', listed, re.M))
    for line in listed.splitlines():
        test = re.match(r"add_test\(\[=*\[(.*?)\]=*\](.*)\)$", line)
        if test:
            yield test[1], QUOTED.findall(test[2]), labels.get(test[1])
        below = re.match(r'subdirs\("(.*)"\)$', line)
        if below:
            yield from tests(folder / below[1])


def outputs(build):
    """The files that can be built, by their whole name."""
    listed = subprocess.run(["ninja", "-C", str(build), "-t", "targets", "all"], capture_output=True, text=True, check=True)
    rules = (line.rsplit(": ", 1) for line in listed.stdout.splitlines())
    return {str(build / output): output for output, rule in rules if rule != "phony"}


def main():
    build, choice, wanted = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], sys.argv[3]
    chosen = [command for name, command, label in tests(build)
              if (label == wanted if choice == "-L" else re.search(wanted, name))]
    if not chosen:
        sys.exit(f"there is no such test: {wanted}; `ctest --test-dir {sys.argv[1]} -N` lists them")
    known, needed = outputs(build), set()
    for command in chosen:
        if {"--install", "--build-and-test"} & set(command):
            needed = {"all"}
            break
        needed.update(known[word] for word in command if word in known)
    if any(pathlib.Path(target).name == "armlet" for target in needed):
        needed.add("commands")  # it starts other programs
    print("\n".join(sorted(needed)))


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main()
