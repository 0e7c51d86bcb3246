#!/usr/bin/env python3
"""What `armlet robot` shows: robot_command.py ARMLET."""

import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

HANDS = ["barrett_hand", "parallel_gripper", "suction_cup"]

GRIPPER = """<robot name="grabber"><link name="base"/><link name="a"/><link name="b"/><link name="c"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="a"/><origin xyz="0 0 0.2" rpy="1.5708 0 0"/>
<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="5" velocity="2"/></joint>
<joint name="left" type="prismatic"><parent link="a"/><child link="b"/><axis xyz="0 1 0"/>
<limit lower="0" upper="0.04" effort="5" velocity="1"/></joint>
<joint name="right" type="prismatic"><parent link="a"/><child link="c"/><axis xyz="0 -1 0"/>
<limit lower="0" upper="0.04" effort="5" velocity="1"/><mimic joint="left"/></joint></robot>"""


def robot(*arguments):
    return subprocess.run([sys.argv[1], "robot", *arguments], capture_output=True, text=True, timeout=60)


def arm_names():
    """The arms that `armlet robot` lists."""
    entries = [json.loads(line) for line in robot("--json").stdout.splitlines()]
    return [entry["name"] for entry in entries if entry["joints"] != "hand"]


def check(what, found, wanted):
    if found != wanted:
        sys.exit(f"{what}: {found!r} instead of {wanted!r}")


def check_list():
    done = robot()
    check("status of the list", (done.returncode, done.stderr), (0, ""))
    check("names", [line.split()[0] for line in done.stdout.splitlines()], NAMES + HANDS)
    check("kinds of the joints", done.stdout.splitlines()[3].split()[1], "RRPR")
    check("the same as JSON", [json.loads(line)["name"] for line in robot("--json").stdout.splitlines()],
          NAMES + HANDS)


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


def check_hands():
    table = robot("barrett_hand").stdout
    check("a joint that follows another", "0.3333 f1" in table, True)
    check("the spread", "finger2_spread" in table and "spread" in table, True)
    check("a suction cup", "suction cup of radius 15 mm" in robot("suction_cup").stdout, True)
    check("no block of a hand", robot("barrett_hand", "--rbt").returncode, 64)
    check("no joints to describe", robot("suction_cup", "--urdf").returncode, 64)
    for form in ("--urdf", "--rbt"):
        check(f"{form} of no robot", robot(form).returncode, 64)


def check_packages(folder):
    """A mesh that is not there is advice; --package and ROS_PACKAGE_PATH say where it is."""
    mesh = '<link name="a"><visual><geometry><mesh filename="package://arm/a.xyz"/></geometry></visual></link>'
    path = folder / "meshes.urdf"
    path.write_text(GRIPPER.replace('<link name="a"/>', mesh))
    (folder / "elsewhere").mkdir()
    (folder / "elsewhere" / "a.xyz").write_text("")
    done = robot(str(path), "--tip", "a")
    check("a mesh that is not there", (done.returncode, "`a` is not there" in done.stderr), (0, True))
    done = robot(str(path), "--tip", "a", "--package", f"arm={folder / 'elsewhere'}")
    check("a mesh of a package", (done.returncode, "is not there" in done.stderr), (0, False))
    check("no package", robot(str(path), "--tip", "a", "--package", "arm").returncode, 64)


def check_files(folder):
    for name in NAMES:
        # The arm as a description, read back: same reach, same limits, and again the same description.
        text = robot(name, "--urdf").stdout
        path = folder / f"{name}.urdf"
        path.write_text(text)
        before, after = json.loads(robot(name, "--json").stdout), robot(str(path), "--json", "--published")
        check(f"status of {name}.urdf", (after.returncode, after.stderr), (0, ""))
        after = json.loads(after.stdout)
        check("limits", [j["upper"] for j in after["joints"]], [j["upper"] for j in before["joints"]])
        check("mass", math.isclose(after["movingMass"], before["movingMass"], abs_tol=1e-12), True)
        check("reach", math.isclose(after["reach"]["fromBase"], before["reach"]["fromBase"], rel_tol=1e-6), True)
        check("same kind of arm", after["closedForm"], before["closedForm"])
    check("a hand as a description", robot("barrett_hand", "--urdf").stdout.count("<mimic"), 4)
    # A block is laid out as `armlet fmt` would, and is a program.
    program = folder / "puma.rbt"
    program.write_text(robot("puma560", "--rbt").stdout + "assert(puma560.dof == 6)\n")
    for command in (["fmt", "--check"], ["run"]):
        done = subprocess.run([sys.argv[1], *command, str(program)], capture_output=True, text=True, timeout=60)
        check(f"{command} of a block", done.returncode, 0)
    gripper = folder / "grabber.urdf"
    gripper.write_text(GRIPPER)
    done = robot(str(gripper))
    check("fingers that divide", (done.returncode, "`a` (1 joint: turn), where they meet" in done.stderr), (65, True))
    check("an arm that ends at its palm", robot(str(gripper), "--tip", "a").stdout.startswith("grabber: 1 joints, R"),
          True)
    capital = folder / "GRABBER.URDF"
    capital.write_text(GRIPPER)
    check("an ending in capitals", robot(str(capital), "--tip", "a").returncode, 0)
    done = robot(str(folder / "arm.urdf.xacro"))
    check("a xacro file", (done.returncode, "xacro file" in done.stderr), (65, True))
    check_packages(folder)
    check("a finger", "RP" in robot(str(gripper), "--tip", "b").stdout, True)
    gripper.write_text(GRIPPER.replace('<mimic joint="left"/>', '<mimic joint="left" multiplier="0.5"/>'))
    done = robot(str(gripper), "--tip", "c")
    check("a finger that copies a joint beside it has the joint itself", (done.returncode, "RP" in done.stdout), (0, True))
    gripper.write_text(GRIPPER.replace('upper="1"', 'upper="-2"'))
    done = robot(str(gripper))
    check("broken", (done.returncode, "limits swapped" in done.stderr), (65, True))
    check("no such file", robot(str(folder / "none.urdf")).returncode, 66)


NAMES = arm_names()
check_list()
check_hands()
with tempfile.TemporaryDirectory() as name:
    check_files(Path(name))
check_table()
check_json()
check_names()
