#!/usr/bin/env python3
"""Meshes in programs: mesh_command.py ARMLET. Bodies from GLB files made by the specification are placed, weighed, compared
and hit; broken files are refused with their name and the reason, in bounded time and memory."""

import json
import re
import resource
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from glb_files import box, document, file_of, glb, prism, sphere

MEGABYTE = 1 << 20

# Two legs, 100 mm long, 20 mm thick, 50 mm high.
ANGLE = prism([(0.02, 0.02), (0.02, 0.1), (0, 0.1), (0, 0), (0.1, 0), (0.1, 0.02)], 0.05)


def fail(what):
    sys.exit(what)


def check(what, holds):
    if not holds:
        fail(what)


class Folder:
    def __init__(self, path):
        self.path = Path(path)

    def write(self, name, data):
        (self.path / name).write_bytes(data)

    def run(self, program, *options, memory=None):
        file = self.path / "program.rbt"
        file.write_text(program)
        limit = (lambda: resource.setrlimit(resource.RLIMIT_AS, (memory, memory))) if memory else None
        return subprocess.run([sys.argv[1], "run", str(file), *options], capture_output=True, text=True, timeout=120,
                              preexec_fn=limit)

    def lines(self, program):
        done = self.run(program)
        check(f"{program}\n{done.stdout}{done.stderr}", done.returncode == 0)
        return done.stdout.splitlines(), done.stderr


def numbers(lines):
    return [float(re.match(r"-?[\d.e+-]+", line).group()) for line in lines if re.match(r"-?\d", line)]


def near(a, b, tolerance):
    return abs(a - b) <= tolerance


def check_bodies(folder):
    folder.write("box.glb", file_of(box(0.04, 0.06, 0.08, at=(3, -2, 1)), wide=False))
    folder.write("angle.glb", file_of(ANGLE))
    folder.write("ball.glb", file_of(sphere(0.05, 40)))
    lines, told = folder.lines("""robot arm = robots.scara()
object table { shape: box(1m, 1m, 20mm); at: xyz(0mm, 800mm, 90mm); fixed: true }
object one { shape: mesh("box.glb", density: 1000kg/m^3); at: xyz(0mm, 800mm, 140mm) }
object two { shape: box(40mm, 60mm, 80mm); at: xyz(100mm, 800mm, 140mm) }
print(f"{distance(one, two) / 1mm:.6f}")
print(f"{distance(one, table) / 1mm:.6f}")
print(touching(one, table))
object angle { shape: mesh("angle.glb"); at: xyz(-300mm, 900mm, 125mm); mass: 1kg }
object pea { shape: sphere(5mm); at: xyz(-290mm, 910mm, 125mm) }
print(f"{distance(angle, pea) / 1mm:.6f}")
object ball { shape: mesh("ball.glb"); at: xyz(300mm, 800mm, 300mm) }
print(f"{distance(ball, table) / 1mm:.6f}")
object cap { shape: plane(20mm, 20mm); at: xyz(0mm, 800mm, 180mm); mass: 5g }
one.setPose(xyz(0mm, 800mm, 240mm))
print(f"{poseOf(cap).z / 1mm:.3f}")
print(topGrasp(one).p[2] / 1mm)
""")
    found = numbers(lines)
    # 60 mm between the boxes; on the table; from the inner corner 40 mm to either leg, less the radius; the radius of the
    # ball above the table; the plane on the table; 10 mm above the middle, for the body is 20 mm longer than wide.
    wanted = [60, 0, 35, 150, 100, 250]
    check(f"distances {lines} {told}", len(found) == 6 and all(near(a, b, 2e-4) for a, b in zip(found, wanted)))
    check("touching", "true" in lines)
    check(f"what lay on it fell: {told}", "W0714" in told)


def check_mass(folder):
    # 0.04 x 0.06 x 0.08 m of 2700 kg/m^3: the arm carries its weight.
    lines, _ = folder.lines("""robot arm = robots.puma560(tool: parallelGripper(stroke: 80mm, force: 200N))
let from = posJ(0deg, -30deg, -60deg, 0deg, -60deg, 0deg)
arm.moveJ(from)
let here = arm.here()
object part { shape: mesh("box.glb", density: 2700kg/m^3); at: here }
object same { shape: box(40mm, 60mm, 80mm); at: here * xyz(z: 500mm); mass: 518.4g }
let q = [0.0, -0.5, -1.0, 0.0, -1.0, 0.0]
print(arm.gravity(q))
arm.grasp(part)
let with_mesh = arm.gravity(q)
arm.release()
remove(part)
same.setPose(arm.here())
arm.grasp(same)
let with_box = arm.gravity(q)
print(with_mesh)
print(with_box)
""")
    empty, mesh, same = [json.loads(line) for line in lines]
    # Coordinates at 3 m in single precision: 2e-7 m.
    check(f"the same weight: {lines}", all(near(a, b, 2e-5) for a, b in zip(mesh, same)) and abs(mesh[1] - empty[1]) > 1)


def check_motion(folder):
    program = """robot arm = robots.scara(tool: parallelGripper(stroke: 40mm, length: 100mm))
object thing { shape: SHAPE; at: xyz(606mm, 350mm, 140mm); fixed: true }
arm.moveJ(posJ(60deg, 0deg, 100mm, 0deg))
arm.moveJ(posJ(0deg, 0deg, 100mm, 0deg))
"""
    texts = []
    for shape in ('mesh("box.glb")', "box(40mm, 60mm, 80mm)"):
        done = folder.run(program.replace("SHAPE", shape))
        check(f"{shape}: {done.stderr}", done.returncode == 0)
        told = re.search(r"(?s)W0711([^\n]*).*?why:([^\n]*)", done.stderr)
        check(f"{shape} is not met: {done.stderr}", told)
        texts.append(told.groups())
    check(f"the same collision: {texts}", texts[0] == texts[1])


TOUCH = """robot arm = robots.scara(tool: tcp(xyz(z: 100mm)))
BODIES
object base { shape: box(200mm, 200mm, 20mm); at: xyz(300mm, 200mm, 70mm); fixed: true; stiffness: 20N/mm }
fn height(x: length, y: length) -> length {
    arm.moveJ(xyz(x, y, 150mm))
    let down = arm.moveL(xyz(x, y, 60mm), speed: 20mm/s) until arm.force().z > 2N
    if (!down.stopped) throw error("nothing is there")
    let z = arm.here().z
    arm.moveL(xyz(x, y, 150mm), speed: 100mm/s)
    return z
}
print(f"{height(300mm, 160mm) / 1mm:.3f}")
print(f"{height(260mm, 230mm) / 1mm:.3f}")
print(f"{height(320mm, 220mm) / 1mm:.3f}")
"""
FIXED = "fixed: true; stiffness: 20N/mm }"


def check_touch(folder):
    """A probe comes down onto both legs of the angle iron and into the corner between them, as onto two boxes."""
    mesh = f'object angle {{ shape: mesh("angle.glb"); at: xyz(300mm, 200mm, 105mm); {FIXED}'
    boxes = (f"object one {{ shape: box(100mm, 20mm, 50mm); at: xyz(300mm, 160mm, 105mm); {FIXED}\n"
             f"object two {{ shape: box(20mm, 100mm, 50mm); at: xyz(260mm, 200mm, 105mm); {FIXED}")
    found = numbers(folder.lines(TOUCH.replace("BODIES", mesh))[0])
    wanted = numbers(folder.lines(TOUCH.replace("BODIES", boxes))[0])
    check(f"heights {found} {wanted}", len(found) == 3 and all(near(a, b, 2e-3) for a, b in zip(found, wanted)))
    check(f"into the corner {found}", near(found[0] - found[2], 50, 0.1) and near(found[0], 130, 1))


def refused(folder, data, reason, seconds=20.0, memory=None):
    folder.write("bad.glb", data)
    begin = time.monotonic()
    done = folder.run('let part = mesh("bad.glb")\n', memory=memory)
    check(f"{reason}: {done.stdout} {done.stderr[:500]}",
          done.returncode == 70 and 'R0656: the mesh "bad.glb" cannot be used' in done.stderr and reason in done.stderr)
    check(f"{reason}: took {time.monotonic() - begin} s", time.monotonic() - begin < seconds)


def check_broken(folder):
    whole = file_of(ANGLE)
    for size in range(0, len(whole), 100):
        refused(folder, whole[:size], "")
    open_box = box(0.1, 0.1, 0.1)
    open_box[1].pop()
    refused(folder, file_of(open_box), "its surface is open: 3 edges belong to one triangle alone")
    twisted = box(0.1, 0.1, 0.1)
    twisted[1][3] = twisted[1][3][::-1]
    refused(folder, file_of(twisted), "do not agree which side is outside")
    far = box(0.1, 0.1, 0.1)
    far[1][0] = (0, 2, 9)
    refused(folder, file_of(far), "but there are 8 vertices")
    nothing = box(0.1, 0.1, 0.1)
    nothing[0][0] = (float("nan"), 0, 0)
    refused(folder, file_of(nothing), "a coordinate that is no number")
    huge = bytearray(whole)
    huge[8:12] = struct.pack("<I", 0x7fffffff)
    refused(folder, bytes(huge), "its header says 2147483647 bytes")
    huge = bytearray(whole)
    huge[12:16] = struct.pack("<I", 0x7ffffff0)
    refused(folder, bytes(huge), "does not fit into it")
    description, binary = document(*box(0.1, 0.1, 0.1))
    description["accessors"][0]["count"] = 1 << 31
    refused(folder, glb(description, binary), "of its view hold", memory=1024 * MEGABYTE)
    description["accessors"][0]["count"] = 8
    description["nodes"] = [{"mesh": 0, "children": [1]}, {"children": [0]}]
    refused(folder, glb(description, binary), "is below itself")
    description["nodes"] = [{"mesh": 0}]
    description["buffers"].append({"byteLength": 4, "uri": "program.rbt"})
    description["bufferViews"][0]["buffer"] = 1
    refused(folder, glb(description, binary), "its geometry lies in another file")
    refused(folder, glb(b'{"extras":' + b"[" * (4 * MEGABYTE) + b"}", b"1234"), "values in one another",
            memory=1024 * MEGABYTE)
    refused(folder, b"solid cube\n", "does not begin with")
    done = folder.run('let part = mesh("../../etc/passwd")\n')
    check(f"outside: {done.stderr}", done.returncode == 70 and "only below their own folder" in done.stderr)
    done = folder.run('let part = mesh("nowhere.glb")\n')
    check(f"missing: {done.stderr}", done.returncode == 70 and "there is no such file" in done.stderr)
    lines, _ = folder.lines('try { let part = mesh("nowhere.glb") } catch (e) { print(e.kind) }\n')
    check("a kind to catch", lines[0] == "BadMesh")


def check_many(folder):
    """A million triangles: too many by a few are refused, somewhat fewer are read, in less than 1.5 GB."""
    too_many = sphere(0.05, 501)  # 1,002,000
    refused(folder, file_of(too_many), "1000000 triangles", memory=1536 * MEGABYTE)
    folder.write("fine.glb", file_of(sphere(0.05, 499)))
    begin = time.monotonic()
    done = folder.run("""robot arm = robots.scara()
object ball { shape: mesh("fine.glb", density: 1000kg/m^3); at: xyz(300mm, 800mm, 50mm) }
object other { shape: box(20mm, 20mm, 20mm); at: xyz(300mm, 800mm, 130mm) }
print(f"{distance(ball, other) / 1mm:.4f}")
""", memory=1536 * MEGABYTE)
    check(f"a million triangles: {done.stdout}{done.stderr}", done.returncode == 0)
    check(f"its distance: {done.stdout}", near(numbers(done.stdout.splitlines())[0], 20, 2e-3))
    return time.monotonic() - begin


ROBOT = """robot arm {
    joint revolute(d: 400mm, a: 250mm, limits: [-170deg, 170deg], maxSpeed: 180deg/s MESH)
    joint revolute(a: 150mm, alpha: 180deg, limits: [-145deg, 145deg], maxSpeed: 240deg/s)
    joint prismatic(limits: [0mm, 150mm], maxSpeed: 400mm/s)
    joint revolute(limits: [-360deg, 360deg], maxSpeed: 360deg/s)
    tool: parallelGripper(stroke: 60mm)
}
object post { shape: box(20mm, 20mm, 200mm); at: xyz(0mm, 150mm, 480mm); fixed: true }
moveJ(posJ(40deg, 0deg, 0mm, 0deg))
moveJ(posJ(-40deg, 0deg, 0mm, 0deg))
moveJ(posJ(60deg, 0deg, 0mm, 0deg))
"""

URDF = """<robot name="stick"><link name="base"/><link name="arm">KIND
<origin xyz="0.2 0 0" rpy="0 0 0"/><geometry><mesh filename="long.glb" scale="SCALE"/></geometry>END</link><link name="tip"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="arm"/><origin xyz="0 0 0.5"/>
<axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="5" velocity="2"/></joint>
<joint name="end" type="revolute"><parent link="arm"/><child link="tip"/><origin xyz="0.4 0 0"/>
<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="5" velocity="2"/></joint></robot>"""


def collisions(text):
    return len(re.findall(r"W0711", text))


def check_links(folder):
    # A wing on the first link, 300 mm to its left: it reaches the post long before the link would.
    folder.write("wing.glb", file_of(box(0.05, 0.6, 0.05, at=(-0.125, 0, 0.08))))
    plain = folder.run(ROBOT.replace("MESH", ""))
    winged = folder.run(ROBOT.replace("MESH", ', mesh: "wing.glb"'))
    check(f"without: {plain.stderr}", plain.returncode == 0 and collisions(plain.stderr) == 0)
    check(f"with: {winged.stderr}", winged.returncode == 0 and 'link 1 of `arm`' in winged.stderr and "post" in winged.stderr)
    broken = folder.run(ROBOT.replace("MESH", ', mesh: "bad.glb"'))
    check(f"broken: {broken.stderr}", broken.returncode == 70 and 'R0656: the mesh "bad.glb"' in broken.stderr)
    # An arm of a description, whose link is 40 mm thick in the file, or 400 mm by its scale.
    folder.write("long.glb", file_of(box(0.4, 0.04, 0.04)))
    for kind in ("visual", "collision"):
        for scale, hits in (("1 1 1", False), ("1 10 1", True)):
            text = URDF.replace("KIND", f"<{kind}>").replace("END", f"</{kind}>").replace("SCALE", scale)
            (folder.path / "stick.urdf").write_text(text)
            done = folder.run("""let arm = urdf("stick.urdf", tip: "tip", tool: parallelGripper(stroke: 40mm))
object post { shape: box(20mm, 20mm, 200mm); at: xyz(150mm, 150mm, 500mm); fixed: true }
arm.moveJ(posJ(5deg, 0deg))
arm.moveJ(posJ(-5deg, 0deg))
""")
            check(f"{kind} {scale}: {done.stderr}", done.returncode == 0 and ("link 1" in done.stderr and "W0711" in done.stderr) == hits)
    done = subprocess.run([sys.argv[1], "robot", str(folder.path / "stick.urdf"), "--tip", "tip", "--glb"], capture_output=True, timeout=60)
    check(f"--glb of it: {done.stderr}", done.returncode == 0)
    size, = struct.unpack_from("<I", done.stdout, 12)
    scene = json.loads(done.stdout[20:20 + size])
    bounds = [a for a in scene["accessors"] if "min" in a and a["count"] == 36]
    check(f"its link is the mesh: {bounds}", len(bounds) == 1 and near(bounds[0]["max"][1] - bounds[0]["min"][1], 0.4, 1e-6))


def main():
    with tempfile.TemporaryDirectory() as path:
        folder = Folder(path)
        check_bodies(folder)
        check_mass(folder)
        check_motion(folder)
        check_touch(folder)
        check_broken(folder)
        check_links(folder)
        print(f"a million triangles: {check_many(folder):.1f} s")


if __name__ == "__main__":
    main()
