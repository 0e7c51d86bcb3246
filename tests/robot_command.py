#!/usr/bin/env python3
"""What `armlet robot` shows: robot_command.py ARMLET."""

import json
import math
import subprocess
import sys

NAMES = ["planar2", "planar3", "rrr3", "scara", "scorbot", "puma560", "stanford", "pa10_6", "pa10", "irb120", "ur3",
         "ur5", "ur10", "panda", "iiwa14", "arm7"]


def robot(*arguments):
    return subprocess.run([sys.argv[1], "robot", *arguments], capture_output=True, text=True, timeout=60)


def check(what, found, wanted):
    if found != wanted:
        sys.exit(f"{what}: {found!r} instead of {wanted!r}")


def check_list():
    done = robot()
    check("status of the list", (done.returncode, done.stderr), (0, ""))
    check("names", [line.split()[0] for line in done.stdout.splitlines()], NAMES)
    check("kinds of the joints", done.stdout.splitlines()[3].split()[1], "RRPR")
    check("the same as JSON", [json.loads(line)["name"] for line in robot("--json").stdout.splitlines()], NAMES)


def check_table():
    done = robot("puma560")
    check("status of a table", (done.returncode, done.stderr), (0, ""))
    for text in ("puma560: 6 joints, RRRRRR", "Corke and Armstrong-Helouvry 1994", "standard convention",
                 "671.83", "-266", "97.6", "spherical wrist, axes 2 and 3 parallel", "23.45 kg"):
        check(f"{text} in the table", text in done.stdout, True)
    check("an offset beside the joint", "q4 + 90" in robot("scorbot").stdout, True)
    check("the modified convention", "modified convention" in robot("panda").stdout, True)
    check("an arm that slides", "q3" in robot("stanford").stdout, True)


def check_json():
    for name in NAMES:
        done = robot(name, "--json")
        check(f"status of {name}", done.returncode, 0)
        table = json.loads(done.stdout)
        check("name", table["name"], name)
        check("home fits", len(table["home"]), len(table["joints"]))
        for joint, q in zip(table["joints"], table["home"]):
            check("home within the limits", joint["lower"] <= q <= joint["upper"], True)
            check("rates above zero", min(joint[f"max{rate}"] for rate in ("Speed", "Accel", "Jerk")) > 0, True)
    puma = json.loads(robot("puma560", "--json").stdout)
    check("rad, not deg", math.isclose(puma["joints"][0]["upper"], math.radians(160)), True)
    check("an effort of the source", puma["joints"][1]["maxEffort"], 186.4)
    scara = json.loads(robot("scara", "--json").stdout)
    check("reach of the SCARA", math.isclose(scara["reach"]["fromAxis1"], 0.7, rel_tol=1e-9), True)


def check_names():
    check("a second name", robot("iiwa").stdout.startswith("iiwa14:"), True)
    done = robot("puma650")
    check("status of an unknown name", (done.returncode, done.stdout), (64, ""))
    check("what was meant", 'did you mean "puma560"?' in done.stderr, True)
    check("all names", all(name in done.stderr for name in NAMES), True)
    check("two names", robot("scara", "ur5").returncode, 64)


check_list()
check_table()
check_json()
check_names()
