#!/usr/bin/env python3
"""Paths around obstacles: their library is loaded when the first one is searched, and not before; without it programs say
so; two processes find the same bits: planning_command.py ARMLET."""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

COMMAND = Path(sys.argv[1]).resolve()
ROOT = Path(__file__).resolve().parent.parent
POST = """robot arm = robots.scara()
object post { shape: box(60mm, 60mm, 2000mm); at: xyz(520mm, 0mm, 300mm); fixed: true }
arm.setJoints(posJ(-60deg, 20deg, 0mm, 0deg))
"""
AROUND = POST + "with (avoid: true) { arm.moveJ(posJ(60deg, 20deg, 0mm, 0deg)) }\n"
ENDLESS = POST.replace("60mm, 60mm, 2000mm", "760mm, 20mm, 2000mm") + \
    "arm.plan(to: posJ(60deg, 20deg, 0mm, 0deg), iterations: 1000000)\n"
BESIDE = POST + "with (avoid: true) { arm.moveJ(posJ(-50deg, 20deg, 0mm, 0deg)) }\n"


def run(command, text, *options, **environment):
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "program.rbt"
        program.write_text(text)
        return subprocess.run([command, "run", program, *options], capture_output=True, text=True, timeout=120,
                              env=os.environ | environment)


def check(claim, holds, *shown):
    if not holds:
        sys.exit("\n".join([f"not so: {claim}", *map(str, shown)]))


def main():
    library = COMMAND.parent.parent / "lib" / "libarmlet_planning.so"
    if not library.exists():
        print("this build has no OMPL")
        sys.exit(77)
    loaded = run(COMMAND, AROUND, LD_DEBUG="files")
    check("a path around is found", loaded.returncode == 0, loaded.stdout, loaded.stderr[-2000:])
    check("its library is loaded for that", "libompl" in loaded.stderr)
    beside = run(COMMAND, BESIDE, LD_DEBUG="files")
    check("a move that meets nothing does not need it",
          beside.returncode == 0 and "libompl" not in beside.stderr, beside.stderr[-2000:])

    hashes = [run(COMMAND, AROUND, "--hash") for _ in range(2)]
    check("two processes make the same motion",
          hashes[0].returncode == 0 and hashes[0].stdout == hashes[1].stdout and hashes[0].stdout.strip(),
          *[each.stdout + each.stderr for each in hashes])

    limited = run(COMMAND, ENDLESS, "--steps", "500000")
    check("a search counts as steps, and ends with them",
          limited.returncode != 0 and "steps" in limited.stderr, limited.stdout, limited.stderr)

    with tempfile.TemporaryDirectory() as folder:
        alone = Path(folder) / "bin" / "armlet"
        alone.parent.mkdir()
        shutil.copy(COMMAND, alone)
        without = run(alone, AROUND)
        check("without the library programs say so",
              without.returncode != 0 and "R0646" in without.stderr + without.stdout
              and '"post"' in without.stderr + without.stdout, without.stdout, without.stderr)
        check("and moves that meet nothing are made", run(alone, BESIDE).returncode == 0)
    print("paths around obstacles: in order")


if __name__ == "__main__":
    main()
