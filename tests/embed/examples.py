#!/usr/bin/env python3
"""Runs the hosts of examples/embed: examples.py SOURCES BUILD. Each ends with what it prints."""
import pathlib
import subprocess
import sys


def expected_of(source):
    begin, words, end = source.read_text().rpartition("// Prints:\n")
    if not words:
        sys.exit(f"{source.name} does not say what it prints")
    return "".join(line.removeprefix("//").removeprefix(" ") for line in end.splitlines(keepends=True))


def main():
    sources, build = (pathlib.Path(folder) for folder in sys.argv[1:])
    hosts = sorted(sources.glob("*.cpp"))
    failed = 0
    for source in hosts:
        run = subprocess.run([build / source.stem], capture_output=True, text=True, timeout=120)
        if run.returncode != 0 or run.stdout != expected_of(source):
            print(f"{source.name}: exit status {run.returncode}, prints\n{run.stdout}{run.stderr}")
            failed += 1
    print(f"{len(hosts)} hosts, {failed} failed")
    sys.exit(1 if failed or not hosts else 0)


if __name__ == "__main__":
    main()
