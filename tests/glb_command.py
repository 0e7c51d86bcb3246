#!/usr/bin/env python3
"""The shapes of arms as GLB: glb_command.py ARMLET. The file is read by its specification alone, moved as its nodes say,
and compared with the forward kinematics of programs."""

import json
import math
import random
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

MOST_BYTES = {5121: 1, 5123: 2, 5125: 4, 5126: 4}


def armlet(*arguments):
    return subprocess.run([sys.argv[1], *arguments], capture_output=True, timeout=120)


def fail(what):
    sys.exit(what)


def check(what, holds):
    if not holds:
        fail(what)


def product(A, B):
    return [[sum(A[i][k] * B[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def inverse(T):
    R = [[T[j][i] for j in range(3)] for i in range(3)]
    p = [-sum(R[i][k] * T[k][3] for k in range(3)) for i in range(3)]
    return [R[i] + [p[i]] for i in range(3)] + [[0, 0, 0, 1]]


def moved(T, v):
    return [sum(T[i][k] * v[k] for k in range(3)) + T[i][3] for i in range(3)]


def pose_of(node):
    x, y, z, w = node.get("rotation", [0, 0, 0, 1])
    p = node.get("translation", [0, 0, 0])
    check("a unit quaternion", abs(x * x + y * y + z * z + w * w - 1) < 1e-12)
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), p[0]],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), p[1]],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), p[2]], [0, 0, 0, 1]]


def joint_motion(joint, q):
    if joint["joint"] == "prismatic":
        return [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, q], [0, 0, 0, 1]]
    c, s = math.cos(q), math.sin(q)
    return [[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]


class Scene:
    def __init__(self, data):
        magic, version, length, size, kind = struct.unpack_from("<4sIIII", data)
        check("a GLB of version 2", (magic, version, length, kind) == (b"glTF", 2, len(data), 0x4E4F534A))
        self.json = json.loads(data[20:20 + size])
        binary, kind = struct.unpack_from("<II", data, 20 + size)
        check("one binary chunk", kind == 0x004E4942 and 28 + size + binary == len(data) and size % 4 == binary % 4 == 0)
        self.binary = data[28 + size:]
        check("its size", self.json["buffers"] == [{"byteLength": binary}])
        self.parents = {child: i for i, node in enumerate(self.nodes()) for child in node.get("children", [])}

    def nodes(self):
        return self.json["nodes"]

    def index(self, name):
        found = [i for i, node in enumerate(self.nodes()) if node["name"] == name]
        check(f"one node {name}", len(found) == 1)
        return found[0]

    def world(self, i, q=None):
        """Of a node, with y up as in the file, its joints at q instead of where the file has them."""
        T = [[float(a == b) for b in range(4)] for a in range(4)]
        while i is not None:
            node = self.nodes()[i]
            local = pose_of(node)
            joint = node.get("extras")
            if joint and q is not None:
                number = int(node["name"].split()[1])
                local = product(product(local, inverse(joint_motion(joint, joint["q"]))), joint_motion(joint, q[number - 1]))
            T = product(local, T)
            i = self.parents.get(i)
        return T

    def values(self, accessor):
        accessor = self.json["accessors"][accessor]
        view = self.json["bufferViews"][accessor["bufferView"]]
        width = 3 if accessor["type"] == "VEC3" else 1
        letter = "f" if accessor["componentType"] == 5126 else "I"
        check("room in its view", accessor["count"] * width * MOST_BYTES[accessor["componentType"]] == view["byteLength"])
        numbers = struct.unpack_from(f"<{accessor['count'] * width}{letter}", self.binary, view["byteOffset"])
        found = [numbers[i:i + 3] for i in range(0, len(numbers), 3)] if width == 3 else list(numbers)
        if "min" in accessor:
            check("bounds", accessor["min"] == [min(c) for c in zip(*found)] and accessor["max"] == [max(c) for c in zip(*found)])
        return found

    def parts(self, node):
        """Positions, normals, indices of each part of a node."""
        mesh = self.nodes()[node].get("mesh")
        if mesh is None:
            return []
        return [(self.values(part["attributes"]["POSITION"]), self.values(part["attributes"]["NORMAL"]),
                 self.values(part["indices"])) for part in self.json["meshes"][mesh]["primitives"]]


def z_up(v):
    """glTF's y up as z up."""
    return [v[0], -v[2], v[1]]


def far(a, b):
    return math.dist(a, b)


def kinematics(name, positions):
    """The frames of all links and of the tool point at these positions, as a program sees them."""
    lists = ", ".join("[" + ", ".join(repr(x) for x in q) + "]" for q in positions)
    number = '{T[i, j]:.17g}'
    program = (f"robot arm = robots.{name}()\nlet qs = [{lists}]\n"
               "fn tell(T: matrix) { for (i in range(0, 3)) { for (j in range(0, 4)) { print(f\"" + number + "\") } } }\n"
               "for (q in qs) {\n for (f in arm.linkFrames(q)) { tell(f.T) }\n tell(arm.fkine(q).T)\n}\n")
    with tempfile.NamedTemporaryFile("w", suffix=".rbt") as file:
        file.write(program)
        file.flush()
        done = armlet("run", file.name)
    check(f"program of {name}: {done.stdout.decode()} {done.stderr.decode()}", done.returncode == 0)
    numbers = [float(line) for line in done.stdout.decode().splitlines() if line.strip() and line[0] in "-0123456789"]
    poses = [[numbers[k + 4 * i:k + 4 * i + 4] for i in range(3)] + [[0, 0, 0, 1]] for k in range(0, len(numbers), 12)]
    each = len(poses) // len(positions)
    return [poses[k * each:(k + 1) * each] for k in range(len(positions))]


def check_surface(name, part):
    """Closed, each edge once in each direction, with the outside outside, corners with unit normals on their side."""
    positions, normals, indices = part
    edges, volume = {}, 0.0
    for a, b, c in zip(*[iter(indices)] * 3):
        p, q, r = positions[a], positions[b], positions[c]
        for edge in ((p, q), (q, r), (r, p)):
            edges[edge] = edges.get(edge, 0) + 1
        u, v = [q[k] - p[k] for k in range(3)], [r[k] - p[k] for k in range(3)]
        n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        volume += sum(n[k] * p[k] for k in range(3)) / 6
        for corner in (a, b, c):
            check(f"{name}: a normal on the side of its triangle",
                  sum(n[k] * normals[corner][k] for k in range(3)) > 0.8 * math.hypot(*n))
    check(f"{name}: a closed surface", all(count == edges.get((q, p), 0) for (p, q), count in edges.items()))
    check(f"{name}: volume {volume}", volume > 0)
    check(f"{name}: normals", all(abs(math.hypot(*n) - 1) < 1e-6 for n in normals))


def check_arm(name, chance):
    done = armlet("robot", name, "--glb")
    check(f"status of {name}: {done.stderr}", done.returncode == 0 and not done.stderr)
    scene = Scene(done.stdout)
    n = sum("extras" in node for node in scene.nodes())
    joints = [scene.nodes()[scene.index(f"link {k + 1}")]["extras"] for k in range(n)]
    home = [joint["q"] for joint in joints]
    positions = [home] + [[chance.uniform(joint.get("lower", -3.0), joint.get("upper", 3.0)) for joint in joints]
                          for _ in range(4)]
    frames = kinematics(name, positions)
    worst = 0.0
    for q, poses in zip(positions, frames):
        for what, pose in (("flange", poses[n - 1]), ("tool point", poses[n])):
            T = scene.world(scene.index(what), q)
            worst = max(worst, far(z_up([row[3] for row in T[:3]]), [row[3] for row in pose[:3]]))
            for axis in range(3):
                worst = max(worst, far(z_up([row[axis] for row in T[:3]]), [row[axis] for row in pose[:3]]))
        for k in range(n):
            i = scene.index(f"link {k + 1}")
            carried = product(poses[k], inverse(frames[0][k]))  # from where the link is at home to where it is now
            at_home, now = scene.world(i), scene.world(i, q)
            for positions_of_part, _, _ in scene.parts(i):
                for v in positions_of_part[::97]:
                    wanted = moved(carried, z_up(moved(at_home, v)))
                    worst = max(worst, far(z_up(moved(now, v)), wanted))
    check(f"{name}: {worst} m from its forward kinematics", worst < 1e-12)
    for i in range(len(scene.nodes())):
        for part in scene.parts(i):
            check_surface(f"{name}, {scene.nodes()[i]['name']}", part)
    check("materials", {part["material"] for mesh in scene.json["meshes"] for part in mesh["primitives"]}
          <= set(range(len(scene.json["materials"]))))
    check(f"{name}: the same bytes again", armlet("robot", name, "--glb").stdout == done.stdout)
    return done.stdout


def check_refusals(folder, scara):
    path = folder / "scara.glb"
    done = armlet("robot", "scara", "--glb", str(path))
    check("a file", done.returncode == 0 and path.read_bytes() == scara)
    for arguments, status, text in (
            (("puma650", "--glb"), 64, 'did you mean "puma560"?'), (("suction_cup", "--glb"), 64, "is a hand"),
            (("--glb", "scara"), 64, "before the file"), (("scara", "--glb", "--urdf"), 64, "excludes"),
            (("scara", "--glb", str(folder / "no" / "x.glb")), 66, "there is no folder")):
        done = armlet("robot", *arguments)
        check(f"{arguments}: {done}", done.returncode == status and text in done.stderr.decode() and not done.stdout)
    description = folder / "arm.urdf"
    description.write_bytes(armlet("robot", "ur5", "--urdf").stdout)
    done = armlet("robot", str(description), "--published", "--glb", str(description))
    check("no file takes the place of what was read", done.returncode == 64 and description.stat().st_size > 100)
    check("an arm of a file", armlet("robot", str(description), "--published", "--glb").stdout[:4] == b"glTF")


def main():
    chance = random.Random(7)
    entries = [json.loads(line) for line in armlet("robot", "--json").stdout.splitlines()]
    written = {entry["name"]: check_arm(entry["name"], chance) for entry in entries if entry["joints"] != "hand"}
    with tempfile.TemporaryDirectory() as folder:
        check_refusals(Path(folder), written["scara"])


if __name__ == "__main__":
    main()
