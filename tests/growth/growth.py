#!/usr/bin/env python3
"""Counts the instructions that each part of the work from text to bytecode takes for programs of size n and 4n.

usage: growth.py GROWTH [SHAPE...] [--all] [--scale S] [--show]

What grows in proportion to n log n takes 4 log 4n / log n times as many, 5.2 for n = 100 (2 % more are granted); what grows with the square of n,
sixteen. The instructions are counted by valgrind, so the result is the same on every machine and under any load.
Without --all and names only the shapes of QUICK are counted, which takes some twenty seconds.
"""
import argparse
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile

import mistakes  # noqa: F401, adds to SHAPES
import shapes

QUICK = """unset_variables breaks_between_first_values functions_called_forward guards variadic_arguments
nested_structs nested_defaults enum enum_names text_switch long_condition long_list poses formatted_text locals_of_one_function
captures classic tries objects paths record_columns tests one_line nested_calls nested_blocks else_if_ladders
wrong_names wrong_fields wrong_enum_values cases_twice structs_in_circles missing_cases syntax_errors
foreign_blocks foreign_ends foreign_values open_texts broken_cases wide_line_before_mistake function_types comments""".split()
PARTS = ["read", "check", "lower_all", "explain", "show", "lay_out"]
SKIPPED = 77
AT_ONCE = 60   # shapes; growth has a function for each of 256 files
FEW = 300_000  # instructions at 4n that say nothing: other things grow in steps
TINY = 2      # read twice, as the first program of its kind fills the tables of the parser
SIZE = 100    # n, at scale 1
# Nested as deep as a program may be, so many times; and what takes as much as it ever will only behind 300 instructions.
SIZES = {"member_chains": 270, "nested_calls": 300, "nested_lists": 300, "nested_blocks": 240, "else_if_ladders": 270,
         "conditional_ladders": 270, "nested_defaults": 45, "tries": 60, "robot_block": 15, "arguments": 1000,
         "parameters": 1000, "enums": 1000, "wide_struct": 1000, "matrix": 1000, "list_used_often": 1000, "long_list": 400, "wrong_names": 300}


def counted(program, files, folder):
    """Instructions by (part, number of the file)."""
    out = os.path.join(folder, "callgrind.out")
    run = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", "--compress-strings=no",
                          "--compress-pos=no", program, *files], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"growth: {run.stderr[-2000:]}")
    costs = {}
    callee = None
    name = re.compile(r"cfn=.*?\b(" + "|".join(PARTS) + r")<(\d+)u?l?>\(")
    with open(out, encoding="utf-8", errors="replace") as lines:
        for line in lines:
            if line.startswith("cfn="):
                match = name.match(line)
                callee = (match[1], int(match[2])) if match else None
            elif line.startswith("calls=") and callee is not None:
                costs[callee] = costs.get(callee, 0) + int(next(lines).split()[1])
    return costs


def compared(given, names):
    """Counts the work of some shapes; returns how many parts take too much."""
    sizes = {name: int(SIZES.get(name, SIZE) * given.scale) for name in names}
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for name in names:
            for i, size in enumerate((TINY, TINY, sizes[name], 4 * sizes[name])):
                lays_out = name in shapes.FORMATS and (given.all or given.names)
                files.append(os.path.join(folder, f"{name}_{i}.rbt"))
                with open(files[-1], "w", encoding="utf-8") as file:
                    file.write(("// fmt\n" if lays_out else "") + shapes.SHAPES[name](size))
        costs = counted(given.growth, files, folder)
    missing = [name for k, name in enumerate(names) if ("check", 4 * k + 4) not in costs]
    if missing:
        sys.exit(f"growth: nothing was counted for {', '.join(missing)}")
    failed = 0
    for k, name in enumerate(names):
        most = 4 * math.log(4 * sizes[name]) / math.log(sizes[name]) * 1.02
        shown = []
        for what in PARTS:
            base, small, large = (costs.get((what, 4 * k + i), 0) for i in (2, 3, 4))
            if large < FEW:
                continue
            # A reader that gives up at the tenth mistake takes longer for two lines than for a hundred: no base then.
            ratio = (large - base) / (small - base) if small > base else large / max(1, small)
            shown.append(f"{what} {large / 1e6:.1f} M ({ratio:.2f})")
            if ratio > most:
                failed += 1
                print(f"{name}: {what} takes {ratio:.2f} times as many instructions for a text 4 times as long; "
                      f"n log n would be {most:.2f}")
        if given.show:
            print(f"{name:30} " + ", ".join(shown))
    return failed


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("growth")
    parser.add_argument("names", nargs="*")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--scale", type=float, default=1.0)
    parser.add_argument("--show", action="store_true")
    given = parser.parse_intermixed_args()
    if shutil.which("valgrind") is None:
        print("growth: skipped, valgrind is not installed (./dev test installs it)")
        sys.exit(SKIPPED)
    names = given.names or (sorted(shapes.SHAPES) if given.all else QUICK)
    failed = 0
    for first in range(0, len(names), AT_ONCE):
        failed += compared(given, names[first:first + AT_ONCE])
    print(f"{failed} parts grow too fast" if failed else f"{len(names)} shapes grow as they should")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
