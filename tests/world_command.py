#!/usr/bin/env python3
"""Worlds in files: world_command.py ARMLET. Scenes as .rbt, GLB and URDF are taken by `run`, `check` and the prompt; what is wrong in them is
refused with file, line and cause; textures and their broken files."""

import math
import struct
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path

import mesh_files
from glb_files import box, document, glb, prism


def check(what, holds):
    if not holds:
        sys.exit(what)


class Folder:
    def __init__(self, path):
        self.path = Path(path)
        (self.path / "worlds").mkdir()

    def write(self, name, data):
        (self.path / name).write_bytes(data if isinstance(data, bytes) else data.encode())

    def run(self, world, program, command="run"):
        self.write("program.rbt", program)
        words = [sys.argv[1], command, str(self.path / "program.rbt")] + (["--world", str(self.path / "worlds" / world)] if world else [])
        return subprocess.run(words, capture_output=True, text=True, timeout=120)

    def lines(self, world, program):
        done = self.run(world, program)
        check(f"{world}: {program}\n{done.stdout}{done.stderr}", done.returncode == 0)
        return done.stdout.splitlines()

    def refuses(self, world, *texts, program="print(1)\n"):
        done = self.run(world, program)
        check(f"{world} was taken", done.returncode != 0)
        check(f"{world}: no crash", done.returncode > 0)
        for text in texts:
            check(f"{world}: {text!r} is not in\n{done.stderr}", text in done.stderr)


def scene(nodes, meshes, materials=()):
    """nodes: dicts whose "mesh" is an index of meshes: (corners, faces), each with the material of the same index if there is one."""
    description, binary = None, b""
    for index, mesh in enumerate(meshes):
        one, part = document(*mesh)
        if description is None:
            description = {**one, "meshes": [], "accessors": [], "bufferViews": []}
        first = len(description["accessors"])
        for accessor in one["accessors"]:
            description["accessors"].append({**accessor, "bufferView": accessor["bufferView"] + first})
        for view in one["bufferViews"]:
            description["bufferViews"].append({**view, "byteOffset": view.get("byteOffset", 0) + len(binary)})
        primitive = {"attributes": {"POSITION": first}, "indices": first + 1}
        if index < len(materials):
            primitive["material"] = index
        description["meshes"].append({"primitives": [primitive]})
        binary += part
    description["buffers"] = [{"byteLength": len(binary)}]
    description["nodes"] = nodes
    below = {child for node in nodes for child in node.get("children", [])}
    description["scenes"] = [{"nodes": [k for k in range(len(nodes)) if k not in below]}]
    if materials:
        description["materials"] = [{"pbrMetallicRoughness": {"baseColorFactor": list(color)}} for color in materials]
    return glb(description, binary)


def check_programs(folder):
    folder.write("worlds/bench.rbt", 'let height = 90mm\nobject bench { shape: box(600mm, 400mm, 20mm); at: xyz(500mm, 0mm, height); fixed: true }\n'
                                     'object cube { shape: box(40mm, 40mm, 40mm); at: xyz(450mm, 100mm, height + 30mm); density: 1000kg/m^3 }\n'
                                     'frame corner { at: xyz(-300mm, -200mm, 10mm); on: bench }\n')
    lines = folder.lines("bench.rbt", 'insertObj("cube")\nprint(getNumberObj(), poseOf(object("cube")), poseOf(frame("corner")))\n')
    check(f"{lines}", lines == ["1 (450, 100, 120) mm, 0 deg about z (200, -200, 100) mm, 0 deg about z"])
    check("check knows the names", "cub" in folder.run("bench.rbt", 'insertObj("cub")\n', "check").stderr)
    check("check takes a world", folder.run("bench.rbt", 'insertObj("cube")\n', "check").returncode == 0)
    for refused in ["print(1)", "robot arm = robots.scara()", "moveJ(xyz(300mm, 0mm, 100mm))", "for (i in range(3)) { wait(1s) }", "var x = 1"]:
        folder.write("worlds/acts.rbt", f"object ball {{ shape: sphere(15mm); at: xyz(300mm, 0mm, 300mm) }}\n{refused}\n")
        folder.refuses("acts.rbt", "R0670", "acts.rbt:2:1")
    folder.write("worlds/wrong.rbt", "object ball { shape: sphere(15); at: xyz(300mm, 0mm, 300mm) }\n")
    folder.refuses("wrong.rbt", "E0401", "wrong.rbt:1:29")
    folder.refuses("none.rbt", "none.rbt", "there is no such file")


def check_glb(folder):
    nodes = [{"name": "root", "translation": [0.4, 0.1, 0], "children": [1, 2]},
             {"name": "the cup", "mesh": 0, "translation": [0, 0.05, 0], "rotation": [0, math.sin(math.pi / 8), 0, math.cos(math.pi / 8)],
              "extras": {"mass": 0.25}},
             {"name": "tile", "mesh": 1, "scale": [2, 1, 1], "translation": [0, -0.1, 0], "extras": {"fixed": True}},
             {"name": "tile", "mesh": 1, "translation": [1, 0, 0]},
             {"mesh": 1, "translation": [2, 0, 0]}, {"name": "sphere", "mesh": 1, "translation": [3, 0, 0]}]
    iron = prism([(0.02, 0.02), (0.02, 0.1), (0, 0.1), (0, 0), (0.1, 0), (0.1, 0.02)], 0.05)
    folder.write("worlds/kitchen.glb", scene(nodes, [box(0.04, 0.06, 0.1), iron], [(1, 0, 0, 1), (0, 0.2122, 1, 1)]))
    lines = folder.lines("kitchen.glb", 'print(objects())\nprint(poseOf(object("the_cup")))\nprint(poseOf(object("tile")))\n'
                                        'print(distance(object("the_cup"), object("tile")))\ninsertObj("the_cup")\nprint(getNumberObj())\n')
    check(f"{lines}", lines[0] == '[object "the_cup", object "tile", object "tile_2", object "node_4", object "sphere_"]')
    check(f"{lines}", lines[1] == "(400, 0, 150) mm, 45 deg about z")
    check(f"{lines}", lines[2].startswith("(500, 50, 25) mm"))
    check(f"{lines}", abs(float(lines[3].split()[0]) - 50) < 1e-4)
    record = str(folder.path / "run.arec")
    words = [sys.argv[1], "run", str(folder.path / "program.rbt"), "--world", str(folder.path / "worlds/kitchen.glb"), "--record", record]
    subprocess.run(words, capture_output=True, check=True, timeout=120)
    (folder.path / "worlds/kitchen.glb").rename(folder.path / "worlds/kept.glb")
    again = subprocess.run([sys.argv[1], "replay", record, "--verify"], capture_output=True, text=True, timeout=120)
    check(f"a run is taken again without the files of its world: {again.stderr}", again.returncode == 0)
    (folder.path / "worlds/kept.glb").rename(folder.path / "worlds/kitchen.glb")
    folder.refuses("no.glb", "no.glb")
    whole = (folder.path / "worlds/kitchen.glb").read_bytes()
    for size in range(0, len(whole), 97):
        folder.write("worlds/cut.glb", whole[:size])
        folder.refuses("cut.glb", "cut.glb")
        if size > 600:
            break
    open_box = (iron[0], iron[1][1:])
    folder.write("worlds/open.glb", scene([{"name": "lid", "mesh": 0}], [open_box]))
    folder.refuses("open.glb", "open.glb", 'node "lid"')
    folder.write("worlds/rest.glb", scene([{"name": "lid", "mesh": 0}, {"name": "iron", "mesh": 1}], [open_box, iron]))
    done = folder.run("rest.glb", "print(objects())\n")
    check(f"one open thing of two: {done.stdout}{done.stderr}", done.stdout == '[object "iron"]\n')
    check(f"it is told: {done.stderr}", "W0743" in done.stderr and 'node "lid": its surface is open' in done.stderr)
    folder.write("worlds/loop.glb", scene([{"name": "a", "mesh": 0, "children": [1]}, {"name": "b", "mesh": 0, "children": [0]}], [iron]))
    folder.refuses("loop.glb", "loop.glb")
    folder.write("worlds/mass.glb", scene([{"name": "lid", "mesh": 0, "extras": {"mass": -1}}], [iron]))
    folder.refuses("mass.glb", 'node "lid"', "mass")
    folder.write("worlds/many.glb", scene([{"name": f"n{k}", "mesh": 0} for k in range(10001)], [iron]))
    begin = time.monotonic()
    folder.refuses("many.glb", "more than 10000 nodes")
    check("many nodes take long", time.monotonic() - begin < 10)


URDF = """<robot name="shop"><link name="world"/>
<material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
<link name="bench"><visual><origin xyz="0 0 0.05"/><geometry><box size="0.6 0.4 0.1"/></geometry><material name="grey"/></visual></link>
<joint name="a" type="fixed"><parent link="world"/><child link="bench"/><origin xyz="0.5 0 0"/></joint>
<link name="mug"><inertial><origin xyz="0 0 0.01"/><mass value="0.3"/><inertia ixx="3e-4" iyy="3e-4" izz="2e-4" ixy="0" ixz="0" iyz="0"/></inertial>
<collision><geometry><cylinder radius="0.03" length="0.08"/></geometry></collision>
<collision><origin xyz="0.04 0 0"/><geometry><sphere radius="0.01"/></geometry></collision></link>
<joint name="b" type="floating"><parent link="bench"/><child link="mug"/><origin xyz="0 0.1 0.14" rpy="0 0 1.5707963267948966"/></joint>
</robot>"""


def check_urdf(folder):
    folder.write("worlds/shop.urdf", URDF)
    lines = folder.lines("shop.urdf", 'print(objects())\nprint(poseOf(object("bench")), poseOf(object("mug")), poseOf(object("mug_2")))\n'
                                      'object("mug").setPose(xyz(500mm, -100mm, 140mm))\nprint(poseOf(object("mug_2")))\n'
                                      'print(touching(object("mug"), object("bench")))\n')
    check(f"{lines}", "(500, 0, 50) mm" in lines[1] and "(500, 100, 140) mm" in lines[1] and "(500, 140, 140) mm" in lines[1])
    check(f"{lines}", "(500, -60, 140) mm" in lines[2] and lines[3] == "true")
    for old, new, text in [('type="fixed"', 'type="continuous"', "joint `a` moves"), ("</robot>", "", "bot"), ("0.6 0.4 0.1", "0.6 nan 0.1", "nan"),
                           ('<box size="0.6 0.4 0.1"/>', '<mesh filename="no.glb"/>', "no such file"),
                           ('<mass value="0.3"/>', '<mass value="-0.3"/>', "mug")]:
        folder.write("worlds/wrong.urdf", URDF.replace(old, new, 1))
        folder.refuses("wrong.urdf", text)
    folder.write("worlds/block.stl", mesh_files.stl())
    folder.write("worlds/meshes.urdf", URDF.replace('<box size="0.6 0.4 0.1"/>', '<mesh filename="block.stl" scale="0.001 0.001 0.001"/>', 1))
    if (Path(sys.argv[1]).parent / "armlet-mesh").exists():
        check("a mesh of another format", folder.lines("meshes.urdf", 'print(object("bench").name)\n') == ["bench"])
    folder.write("worlds/bomb.urdf", '<!DOCTYPE x [<!ENTITY a "aaaa">]>' + URDF)
    folder.refuses("bomb.urdf", "bomb.urdf")


def png(width, height):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    rows = b"".join(b"\0" + b"\x80\x40\x20" * width for _ in range(height))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def check_no_worlds(folder):
    """Meshes and other files that are no worlds are refused with what a world is, and what to write."""
    for name, data in (("cup.obj", b"v 0 0 0\n"), ("cup.STL", mesh_files.stl()), ("cup.dae", mesh_files.dae()), ("cup.wrl", mesh_files.wrl())):
        folder.write(f"worlds/{name}", data)
        folder.refuses(name, "it is a mesh; a world is a .rbt file that declares objects, or a scene as GLB or URDF",
                       f'mesh("{name}")', f"armlet mesh convert {name} cup.glb")
    folder.write("worlds/shop.gltf", "{}")
    folder.refuses("shop.gltf", "a world is a .rbt file", "armlet mesh convert shop.gltf shop.glb")
    folder.write("worlds/photo.png", png(2, 2))
    folder.refuses("photo.png", "it is no text; a world is a .rbt file")
    folder.write("worlds/part.rbt", 'object part { shape: mesh("cup.glb"); at: xyz(400mm, 0mm, 200mm) }\n')
    folder.write("worlds/cup.glb", glb(*document(*box(0.1, 0.1, 0.1))))
    check("what is proposed works", folder.lines("part.rbt", "print(objects())\n") == ['[object "part"]'])


def check_textures(folder):
    program = 'object crate {{ shape: box(40mm, 40mm, 40mm); at: xyz(300mm, 0mm, 300mm); texture: "{}" }}\nprint("there")\n'
    folder.write("wood.png", png(8, 4))
    check("a texture is taken", folder.lines(None, program.format("wood.png")) == ["there"])
    folder.write("cut.png", png(8, 4)[:20])
    folder.write("text.png", b"hello")
    for name, text in [("none.png", "no such file"), ("cut.png", "cut off"), ("text.png", "neither a PNG nor a JPEG"), ("../wood.png", "folder")]:
        folder.refuses(None, "R0671", name, text, program=program.format(name))
    folder.write("worlds/wood.png", png(2, 2))
    folder.write("worlds/crate.rbt", program.format("wood.png").splitlines()[0] + "\n")
    (folder.path / "wood.png").unlink()
    check("a world's files are its own", folder.lines("crate.rbt", 'print(poseOf(object("crate")).x)\n') == ["300 mm"])


with tempfile.TemporaryDirectory() as path:
    here = Folder(path)
    check_programs(here)
    check_glb(here)
    check_urdf(here)
    check_no_worlds(here)
    check_textures(here)
