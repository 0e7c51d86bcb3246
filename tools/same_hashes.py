#!/usr/bin/env python3
"""Compares the hashes of all examples, of scripts with tasks and of sixty pictures between two builds: same_hashes.py ARMLET OTHER_ARMLET."""

import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LATE = {"end_of_time.rbt"}  # three years of virtual time, reported every 10 ms


def last_line(command, program):
    done = subprocess.run([command, "run", "--quiet", "--hash", "--steps", "2000000", program.name], cwd=program.parent,
                          capture_output=True, text=True, timeout=600)
    return done.returncode, done.stdout.splitlines()[-1:]


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    commands = [str(Path(word).resolve()) for word in sys.argv[1:]]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        programs = []
        for source in ("examples", "tests/scripts/tasks", "tests/cameras/pictures"):
            shutil.copytree(ROOT / source, folder / source)
            programs += [p for p in sorted((folder / source).rglob("*.rbt")) if p.name not in LATE]
        with ThreadPoolExecutor(2) as pool:
            both = [list(pool.map(lambda p, c=command: last_line(c, p), programs)) for command in commands]
        other = [p for p, one, two in zip(programs, *both) if one != two]
        for program in other:
            print(f"{program.relative_to(folder)}: the hashes differ")
        ran = sum(1 for status, line in both[0] if line and line[0].startswith("hash "))
        print(f"{ran} runs, {len(other)} with different hashes")
        sys.exit(1 if other or ran < 40 else 0)


if __name__ == "__main__":
    main()
