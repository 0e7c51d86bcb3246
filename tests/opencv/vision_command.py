#!/usr/bin/env python3
"""Functions of pictures by OpenCV: its library is loaded when the first of them is called, and not before; without it
programs say so; two processes find the same: vision_command.py ARMLET LIBRARY."""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

COMMAND, LIBRARY = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
PICTURE = """camera eye { at: lookingAt(xyz(400mm, 0mm, 0mm), from: xyz(400mm, -300mm, 700mm)); size: [320, 240] }
object card { shape: box(100mm, 60mm, 10mm); at: xyz(400mm, 0mm, 5mm); color: "white"; fixed: true }
let img = gray(eye.capture())
"""
OURS = PICTURE + "print(corners(img).rows > 0)\n"
OPENCV = PICTURE + "print(lines(edges(img)))\nprint(corners(img, method: \"fast\"))\n"


def run(command, text, **environment):
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "program.rbt"
        program.write_text(text)
        return subprocess.run([command, "run", program], capture_output=True, text=True, timeout=120,
                              env=os.environ | environment)


def check(claim, holds, *shown):
    if not holds:
        sys.exit("\n".join([f"not so: {claim}", *map(str, shown)]))


def main():
    check("the library is beside the command", (COMMAND.parent.parent / "lib" / LIBRARY.name).exists())
    found = [run(COMMAND, OPENCV, LD_DEBUG="files") for _ in range(2)]
    check("functions of OpenCV are called", found[0].returncode == 0, found[0].stdout, found[0].stderr[-2000:])
    check("its libraries are loaded for that", "libopencv_core" in found[0].stderr)
    check("two processes find the same", found[0].stdout == found[1].stdout, found[0].stdout, found[1].stdout)
    for never in ("highgui", "imgcodecs", "videoio", "viz"):
        check(f"{never} is never loaded", f"libopencv_{never}" not in found[0].stderr)
    ours = run(COMMAND, OURS, LD_DEBUG="files")
    check("other functions of pictures do not load it",
          ours.returncode == 0 and "opencv" not in ours.stderr, ours.stdout, ours.stderr[-2000:])

    with tempfile.TemporaryDirectory() as folder:
        alone = Path(folder) / "bin" / "armlet"
        alone.parent.mkdir()
        shutil.copy(COMMAND, alone)
        for text, name in ((OPENCV, "edges"), (PICTURE + 'print(corners(img, method: "fast"))\n', "corners")):
            without = run(alone, text)
            said = without.stderr + without.stdout
            check("without the library programs say so, and which command makes it",
                  without.returncode != 0 and "R0691" in said and name in said and "./dev build vision" in said, said)
        check("and all others run", run(alone, OURS).returncode == 0)
    print("vision: in order")


if __name__ == "__main__":
    main()
