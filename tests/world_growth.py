#!/usr/bin/env python3
"""Worlds grow like n log n: world_growth.py ARMLET. Programs with n and 4n bodies, frames or signals; the instructions that a run takes, less
those of the same program with none, are counted with valgrind. n log n gives 5.0 times as many for n = 250; the square of n sixteen."""

import math
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SIZE = 250
SLACK = 1.1  # what grows in steps, such as tables that double
FEW = 2_000_000  # instructions that say nothing


def spread(n):
    return (f'for (i in range({n})) {{ sphere(4mm).spawn(f"ball{{i}}", at: xyz(300mm + (i % 20) * 20mm, (i / 20) * 20mm, '
            '300mm + (i % 7) * 15mm)) }\n')


def in_one_place(n):
    return f'for (i in range({n})) {{ sphere(40mm).spawn(f"ball{{i}}", at: xyz(300mm + i * 0.01mm, 0mm, 300mm)) }}\n'


def in_one_place_removed(n):
    """What lies on each one is looked for as it goes."""
    return in_one_place(n) + f'for (i in range({n})) {{ remove(object(f"ball{{i}}")) }}\n'


def in_one_place_moved(n):
    return in_one_place(n) + f'for (i in range({n})) {{ object(f"ball{{i}}").setPose(xyz(300mm + (i % 20) * 100mm, (i / 20) * 100mm, 500mm)) }}\n'


def boxes_in_each_other(n):
    return (f'for (i in range({n})) {{ box(60mm, 40mm, 50mm).spawn(f"box{{i}}", at: xyz(300mm + (i % 10) * 0.1mm, 0mm, '
            '300mm + (i / 10) * 0.01mm)) }\n')


def removed(n):
    return spread(n) + f'for (i in range({n})) {{ remove(object(f"ball{{i}}")) }}\n'


def moved(n):
    return spread(n) + f'for (i in range({n})) {{ object(f"ball{{i}}").setPose(xyz(300mm + (i % 20) * 20mm, (i / 20) * 20mm, 500mm)) }}\n'


def stacks(n):
    """Five boxes on one another, the lowest of which is taken away."""
    return (f'for (i in range({n // 5})) {{\n  for (k in range(5)) {{ box(20mm, 20mm, 20mm).spawn(f"box{{i}}_{{k}}", at: '
            'xyz(300mm + (i % 15) * 30mm, (i / 15) * 30mm, 10mm + k * 20mm)) }\n}\n'
            f'for (i in range({n // 5})) {{ remove(object(f"box{{i}}_0")) }}\n')


def on_a_tray(n):
    return ('object tray { shape: box(2m, 2m, 20mm); at: xyz(0m, 0m, 100mm); fixed: true }\n' +
            "".join(f"object knob{i} {{ shape: sphere(5mm); at: xyz({i % 30} * 20mm, {i // 30} * 20mm, 20mm); on: tray; fixed: true }}\n"
                    for i in range(n)) + ('tray.setPose(xyz(0m, 0m, 200mm))\n' if n else ""))


def frames(n):
    return "".join(f"frame corner{i} {{ at: xyz({i}mm, 0mm, 0mm) }}\n" for i in range(n))


def signals(n):
    return f'for (i in range({n})) {{ setSignal(f"line{{i}}", true) }}\nfor (i in range({n})) {{ if (!signal(f"line{{i}}")) {{ print(i) }} }}\n'


def moves(n):
    """The arm passes some bodies closely, and most not at all."""
    return spread(n) + ('robot arm = robots.ur5()\nfor (i in range(4)) {\n'
                        '  arm.moveJ(posJ([i % 2 == 0 ? 0.5rad : -0.5rad, -1.2rad, 1.2rad, 0rad, 0.3rad, 0rad]), 2s)\n}\n')


SHAPES = [spread, in_one_place, in_one_place_removed, in_one_place_moved, boxes_in_each_other, removed, moved, stacks, on_a_tray, frames, signals, moves]


def instructions(folder, program):
    (folder / "program.rbt").write_text(program)
    done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", sys.argv[1], "run", "program.rbt"],
                          cwd=folder, capture_output=True, text=True, timeout=600)
    if done.returncode != 0:
        sys.exit(f"{program[:500]}\n{done.stderr[-2000:]}")
    return int(re.search(r"Collected : (\d+)", done.stderr).group(1))


def main():
    if not shutil.which("valgrind"):
        print("skipped: valgrind is not installed")
        sys.exit(77)
    most = 4 * math.log(4 * SIZE) / math.log(SIZE) * SLACK
    too_much = []
    with tempfile.TemporaryDirectory() as path:
        folder = Path(path)
        for shape in SHAPES:
            none, one, four = (instructions(folder, shape(n)) for n in (0, SIZE, 4 * SIZE))
            times = (four - none) / max(one - none, 1)
            print(f"{shape.__name__:14} {one - none:12} {four - none:12} {times:6.2f}")
            if times > most and four - none > FEW:
                too_much.append(shape.__name__)
    if too_much:
        sys.exit(f"more than {most:.2f} times as many instructions for 4 times as much: {', '.join(too_much)}")


if __name__ == "__main__":
    main()
