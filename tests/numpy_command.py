#!/usr/bin/env python3
"""A trace .npy is read by NumPy and holds what the trace .csv of the same run holds: numpy_command.py ARMLET."""

import csv
import os
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77  # as SKIP_RETURN_CODE in cmake/ArmletTests.cmake
SYSTEM = "/usr/bin/python3"  # whose NumPy the package python3-numpy is, whatever python3 stands for

try:
    import numpy
except ImportError:
    if os.access(SYSTEM, os.X_OK) and "ARMLET_SYSTEM_PYTHON" not in os.environ:
        os.execve(SYSTEM, [SYSTEM, *sys.argv], {**os.environ, "ARMLET_SYSTEM_PYTHON": "1"})
    print("skipped: NumPy is missing (Debian: apt-get install python3-numpy)")
    sys.exit(SKIPPED)

COMMAND = Path(sys.argv[1]).resolve()
PROGRAMS = {
    "one": "robot arm = robots.kr6()\nmoveJ(arm.home() + posJ(10deg, 10deg, 0deg, 20deg, 0deg, 5deg))\nmoveJ(arm.home())\n",
    "two": "robot a = robots.scara()\nrobot b = robots.panda(base: xyz(2m, 0m, 0m))\n"
           "moveJ(a, a.home() + posJ(10deg, 0deg, 20mm, 0deg))\nmoveJ(b, b.home())\n",
    "none": "print(1 + 1)\n",
}


def run(folder, program, trace):
    (folder / "p.rbt").write_text(program)
    done = subprocess.run([COMMAND, "run", "--quiet", "p.rbt", "--trace", trace], cwd=folder, capture_output=True,
                          text=True, timeout=60)
    if done.returncode != 0:
        sys.exit(f"{program}: {done.stderr}")


def columns(row, symbol):
    """The cells q1, q2 ... of a row; those that do not apply are NaN."""
    found = []
    while f"{symbol}{len(found) + 1}" in row:
        cell = row[f"{symbol}{len(found) + 1}"]
        found.append(float(cell) if cell else numpy.nan)
    return found


def check(folder, name):
    run(folder, PROGRAMS[name], "run.csv")
    run(folder, PROGRAMS[name], "run.npy")
    array = numpy.load(folder / "run.npy")  # allow_pickle=False is the default
    with (folder / "run.csv").open(newline="") as file:
        # Without the units behind the names.
        rows = [{key.split(" ")[0]: cell for key, cell in row.items()} for row in csv.DictReader(file)]
    rows = [row for row in rows if row["what"] == "robot"]
    if array.dtype.names != ("t", "robot", "p", "r", "q", "qd", "qdd") or array.shape != (len(rows),):
        sys.exit(f"{name}: {array.dtype}, {array.shape} for {len(rows)} rows")
    names = list(dict.fromkeys(row["name"] for row in rows))
    for row, sample in zip(rows, array):
        wanted = {"t": [float(row["t"])], "robot": [names.index(row["name"])],
                  "p": [float(row[key]) for key in ("x", "y", "z")],
                  "r": [float(row[key]) for key in ("qw", "qx", "qy", "qz")],
                  **{symbol: columns(row, symbol) for symbol in ("q", "qd", "qdd")}}
        for key, values in wanted.items():  # the .csv has 9 significant digits
            found = numpy.atleast_1d(sample[key])
            if not numpy.allclose(found, values, rtol=1e-8, atol=0, equal_nan=True):
                sys.exit(f"{name}: {key} is {found} instead of {values} at t = {row['t']}")
    return len(rows)


with tempfile.TemporaryDirectory() as place:
    counts = [check(Path(place), name) for name in PROGRAMS]
print(f"{sum(counts)} rows of {len(counts)} runs, NumPy {numpy.__version__}")
if counts[0] < 10 or counts[1] < 10:
    sys.exit("too few rows to say anything")
