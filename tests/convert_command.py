#!/usr/bin/env python3
"""Meshes of other formats: convert_command.py ARMLET CONVERTER. Textured boxes in every format become GLB with the picture and
the colour inside; programs, joints and robot descriptions take them, with a cache; broken files are refused with their name and
the reason, in bounded time, without a foreign file being opened. Without a converter (CONVERTER is empty), the message about that."""

import json
import os
import re
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import mesh_files as meshes
from broken_meshes import hostile
from glb_files import box as box_of, file_of, sphere
from stl_files import check_forms as check_stl_forms

ARMLET = sys.argv[1]
BY_SPECIFICATION = ("box.gltf", "data.gltf", "out.glb")  # kept as they are, y up
WITHOUT_PICTURE = ("box.stl", "text.stl")


def check(what, holds):
    if not holds:
        sys.exit(what)


class Folder:
    """A folder of files, and one for the cache."""

    def __init__(self, path, armlet=ARMLET):
        self.path = Path(path)
        self.armlet = armlet
        self.cache = self.path / "cache"
        self.environment = dict(os.environ, XDG_CACHE_HOME=str(self.cache))

    def write(self, name, data):
        (self.path / name).write_bytes(data)

    def call(self, *words):
        return subprocess.run([self.armlet, *words], capture_output=True, text=True, timeout=300, cwd=self.path, env=self.environment)

    def convert(self, name, *options, to="made.glb"):
        return self.call("mesh", "convert", name, to, *options)

    def run(self, program, *options):
        self.write("program.rbt", program.encode())
        return self.call("run", "program.rbt", *options)


# ---- what a GLB says

def parts(data):
    """Description, binary part, notes."""
    at, out = 12, {}
    while at < len(data):
        length, kind = struct.unpack_from("<I4s", data, at)
        out[kind.rstrip(b"\0")] = data[at + 8:at + 8 + length]
        at += 8 + length
    return json.loads(out[b"JSON"]), out[b"BIN"], out.get(b"NOTE", b"").decode()


def numbers_of(document, binary, index):
    accessor = document["accessors"][index]
    width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[accessor["type"]]
    letter = {5126: "f", 5125: "I", 5123: "H"}[accessor["componentType"]]
    offset = document["bufferViews"][accessor["bufferView"]].get("byteOffset", 0)
    flat = struct.unpack_from(f"<{accessor['count'] * width}{letter}", binary, offset)
    return [flat[k:k + width] for k in range(0, len(flat), width)]


def triangles_of(name, document, binary):
    """(positions with z up, positions on the picture or None, primitive) of each triangle."""
    for mesh in document["meshes"]:
        for each in mesh["primitives"]:
            positions = numbers_of(document, binary, each["attributes"]["POSITION"])
            if name in BY_SPECIFICATION:
                positions = [(x, -z, y) for x, y, z in positions]
            on_image = each["attributes"].get("TEXCOORD_0")
            on_image = numbers_of(document, binary, on_image) if on_image is not None else None
            flat = [k for (k,) in numbers_of(document, binary, each["indices"])]
            for k in range(0, len(flat), 3):
                corners = flat[k:k + 3]
                yield [positions[i] for i in corners], on_image and [on_image[i] for i in corners], each


def volume_of(triangles):
    def det(a, b, c):
        return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]))
    return sum(det(*positions) for positions, _, _ in triangles) / 6


def linear(x):
    return x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4


def rounded(values):
    return tuple(round(float(v), 5) + 0.0 for v in values)


def check_format(folder, name):
    done = folder.convert(name)
    check(f"{name}: {done.stderr}", done.returncode == 0 and "12 triangles, 0.04 x 0.06 x 0.08 m, closed" in done.stderr)
    document, binary, notes = parts((folder.path / "made.glb").read_bytes())
    triangles = list(triangles_of(name, document, binary))
    check(f"{name}: {len(triangles)} triangles", len(triangles) == 12)
    check(f"{name}: volume {volume_of(triangles)}", abs(volume_of(triangles) - meshes.VOLUME) < 1e-9)
    check(f"{name}: no notes {notes}", notes == "")
    wanted = {(rounded(meshes.POINTS[i]), rounded((meshes.ON_IMAGE[k][0], 1 - meshes.ON_IMAGE[k][1])))
              for f in meshes.FACES for k, i in enumerate(f)}
    found = {(rounded(p), rounded(t)) for positions, on_image, _ in triangles if on_image for p, t in zip(positions, on_image)}
    check(f"{name}: places on the picture {found ^ wanted}", found == (set() if name in WITHOUT_PICTURE else wanted))
    check_look(name, document, binary)
    check_glb_is_sound(name, document, binary)


def check_look(name, document, binary):
    """The picture inside, byte for byte, on the material of the faces that have it; the colour on those that have none."""
    if name in WITHOUT_PICTURE:
        check(f"{name}: no picture", "images" not in document)
        return
    (image,) = document["images"]
    view = document["bufferViews"][image["bufferView"]]
    data = binary[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]
    check(f"{name}: the picture", data == meshes.png() and image["mimeType"] == "image/png" and "uri" not in image)
    pictured = [m for m in document["materials"] if "baseColorTexture" in m["pbrMetallicRoughness"]]
    check(f"{name}: materials {document['materials']}", len(pictured) == 1)
    wanted = rounded([linear(c) for c in meshes.COLOR] + [1])
    if name == "box.obj":
        (paint,) = [m for m in document["materials"] if m["name"] == "paint"]
        check(f"{name}: {paint}", rounded(paint["pbrMetallicRoughness"]["baseColorFactor"]) == wanted)
    if name.endswith(".ply"):
        colors = {rounded(c) for mesh in document["meshes"] for p in mesh["primitives"]
                  for c in numbers_of(document, binary, p["attributes"]["COLOR_0"])}
        check(f"{name}: colours {colors}", len(colors) == 1 and all(abs(a - b) < 0.01 for a, b in zip(colors.pop(), wanted)))


def check_glb_is_sound(name, document, binary):
    """What the specification asks of views: inside of the buffer, aligned, none over another."""
    views = sorted((v.get("byteOffset", 0), v["byteLength"]) for v in document["bufferViews"])
    check(f"{name}: buffers", len(document["buffers"]) == 1 and "uri" not in document["buffers"][0])
    check(f"{name}: views {views}", all(a % 4 == 0 and a + b <= len(binary) for a, b in views))
    check(f"{name}: views apart {views}", all(a + b <= c for (a, b), (c, _) in zip(views, views[1:])))


SHAPES = b"""#VRML V2.0 utf8
PROTO Part [ field SFVec3f size 1 1 1 field SFColor paint 0 0 1 ] {
  Shape { appearance Appearance { material Material { diffuseColor IS paint transparency 0.5 } } geometry Box { size IS size } } }
Transform { scale 1 -1 1 children Shape { geometry Cylinder { } } }
Transform { translation 5 0 0 rotation 1 2 3 0.7 children Shape { geometry Sphere { } } }
Transform { translation 10 0 0 children Shape { geometry Cone { } } }
Transform { translation 15 0 0 children Shape { geometry Extrusion { ccw FALSE crossSection [ 1 1, -1 1, -1 -1, 1 -1, 1 1 ] } } }
Transform { translation 20 0 0 children DEF P Part { size 2 2 2 } }
Transform { translation 25 0 0 children USE P }
Shape { geometry IndexedLineSet { coord Coordinate { point [ 0 0 0, 99 99 99 ] } coordIndex [ 0 1 -1 ] } }
Transform { translation 30 0 0 children Shape { geometry IndexedFaceSet {
  coord Coordinate { point [ 0 0 0, 1 0 0, 0 1 0, 0 0 1 ] } coordIndex [ 0 2 1 -1 0 1 3 -1 0 3 2 -1 1 2 3 -1 ]
  color Color { color [ 1 0 0, 0 1 0, 0 0 1, 1 1 1 ] } } } }
DEF T TimeSensor { } ROUTE T.fraction_changed TO nowhere.set_fraction
"""


def check_shapes(folder):
    """VRML's own shapes are closed and have the inside inside, mirrored ones and those that say clockwise too."""
    folder.write("shapes.wrl", SHAPES)
    done = folder.convert("shapes.wrl")
    check(f"shapes: {done.stderr}", done.returncode == 0 and "closed" in done.stderr)
    document, binary, _ = parts((folder.path / "made.glb").read_bytes())
    triangles = list(triangles_of("shapes.wrl", document, binary))

    def volume(x):
        return volume_of([t for t in triangles if all(abs(p[0] - x) < 2.4 for p in t[0])])
    for x, low, high in ((0, 5.8, 6.2832), (5, 3.6, 4.189), (10, 1.9, 2.0944), (15, 3.99, 4.01), (20, 7.99, 8.01), (25, 7.99, 8.01),
                         (30, 0.166, 0.1667)):
        check(f"volume at {x}: {volume(x)}", low < volume(x) < high)
    factors = {rounded(m["pbrMetallicRoughness"]["baseColorFactor"]) for m in document["materials"]}
    check(f"colours {factors}", (0, 0, 1, 0.5) in factors)
    colors = {rounded(c) for mesh in document["meshes"] for p in mesh["primitives"] if "COLOR_0" in p["attributes"]
              for c in numbers_of(document, binary, p["attributes"]["COLOR_0"])}
    check(f"colours of corners {colors}", colors == {(1, 0, 0, 1), (0, 1, 0, 1), (0, 0, 1, 1), (1, 1, 1, 1)})


def check_jpeg(folder):
    folder.write("photo.JPG", meshes.jpeg(3, 5))
    folder.write("photo.wrl", meshes.wrl("photo.jpg"))
    check("a JPEG", folder.convert("photo.wrl").returncode == 0)
    document, binary, notes = parts((folder.path / "made.glb").read_bytes())
    check(f"a JPEG: {notes}", document["images"][0]["mimeType"] == "image/jpeg" and meshes.jpeg(3, 5) in binary)
    folder.write("photo.JPG", meshes.jpeg(3, 50000))
    check("a large JPEG", "3 x 50000 pixels" in folder.convert("photo.wrl").stderr)
    folder.write("photo.JPG", meshes.jpeg(3, 5)[:8])
    check("a JPEG cut off", "is damaged or cut off" in folder.convert("photo.wrl").stderr)


def check_units_and_axes(folder):
    for name in ("box.obj", "box.stl", "box.ply", "box.3ds", "box.wrl"):
        done = folder.convert(name, "--unit", "25.4mm")
        check(f"{name} in inches: {done.stderr}", "0.001016 x 0.001524 x 0.002032 m" in done.stderr)
    for name, sizes in (("box.obj", "0.04 x 0.08 x 0.06"), ("box.3ds", "0.04 x 0.08 x 0.06")):
        check(f"{name} with y up", sizes in folder.convert(name, "--up", "y").stderr)
    check("VRML as it is", "0.04 x 0.08 x 0.06" in folder.convert("box.wrl", "--up", "z").stderr)
    # DAE says both: millimetres and y up.
    folder.write("mm.dae", meshes.dae(unit=0.001))
    done = folder.convert("mm.dae")
    check(f"DAE in mm: {done.stderr}", "0.04 x 0.06 x 0.08 m" in done.stderr)
    folder.write("y.dae", meshes.dae(up="Y_UP"))
    done = folder.convert("y.dae")
    check(f"DAE with y up: {done.stderr}", "0.04 x 0.08 x 0.06 m" in done.stderr)
    for unit in ("0mm", "-1mm", "1kg", "nan", ""):
        done = folder.convert("box.obj", "--unit", unit)
        check(f"unit {unit}: {done.stderr}", done.returncode == (64 if unit else 0))
    check("glTF is in metres", "glTF is in metres" in folder.convert("box.gltf", "--unit", "1mm").stderr)


def check_command(folder):
    check("help", all(word in folder.call("mesh", "convert", "--help").stdout for word in ("IN", "OUT", "--unit", "--up")))
    folder.write("notes.txt", b"mine")
    done = folder.convert("box.obj", to="notes.txt")
    check(f"no .glb: {done.stderr}", done.returncode == 64 and "has to end in .glb" in done.stderr)
    check("kept", (folder.path / "notes.txt").read_bytes() == b"mine")
    done = folder.convert("out.glb", to="out.glb")
    check(f"itself: {done.stderr}", done.returncode == 64 and "would take the place of" in done.stderr)
    done = folder.convert("nothing.obj")
    check(f"missing: {done.stderr}", done.returncode == 66 and "nothing.obj: there is no such file" in done.stderr)
    done = folder.convert("notes.txt")
    check(f"no format: {done.stderr}", done.returncode == 64 and "ends in no format that is read: OBJ, 3DS" in done.stderr)
    # What was there stays where the conversion fails.
    before = (folder.path / "made.glb").read_bytes()
    folder.write("bad.obj", b"f 1 2 3\n")
    check("refused", folder.convert("bad.obj").returncode == 65 and (folder.path / "made.glb").read_bytes() == before)
    # Through a link, as people name files; the same bytes each time.
    os.symlink("box.obj", folder.path / "link.obj")
    check("a link", folder.convert("link.obj").returncode == 0)
    folder.convert("box.dae", to="one.glb")
    folder.convert("box.dae", to="two.glb")
    check("the same bytes", (folder.path / "one.glb").read_bytes() == (folder.path / "two.glb").read_bytes())


# ---- in programs

PROGRAM = """robot arm = robots.scara()
object table { shape: box(1m, 1m, 20mm); at: xyz(0mm, 800mm, 90mm); fixed: true }
object one { shape: mesh("NAME", density: 1000kg/m^3); at: xyz(0mm, 800mm, 140mm) }
object two { shape: box(40mm, 60mm, 80mm); at: xyz(100mm, 800mm, 140mm) }
print(f"{distance(one, two) / 1mm:.6f}")
print(f"{distance(one, table) / 1mm:.6f}")
"""


def distances(done):
    """In mm; the file has single precision."""
    return [round(float(line), 3) for line in done.stdout.split()]


def entries(folder):
    return sorted(p for p in (folder.cache / "armlet" / "meshes").glob("*.glb"))


def check_programs(folder, names):
    for name in names:
        done = folder.run(PROGRAM.replace("NAME", name))
        check(f"{name}: {done.stdout}{done.stderr}", done.returncode == 0 and distances(done) == [60, 0])
    check("a cache", len(entries(folder)) == len([n for n in names if not n.endswith(".glb")]))
    done = folder.run('let part = mesh("box.stl", density: 1000kg/m^3, unit: 1mm)\nprint(part)\n')
    check(f"unit: {done.stderr}", done.returncode == 0)
    done = folder.run('let part = mesh("out.glb", unit: 1mm)\n')
    check(f"unit of GLB: {done.stderr}", done.returncode == 70 and "GLB is in metres" in done.stderr)
    done = folder.run('let part = mesh("box.stl", unit: 0mm)\n')
    check(f"no unit: {done.stderr}", done.returncode == 70 and "expected more than 0" in done.stderr)


def check_cache(folder):
    """A change of the mesh or of what it names makes a new entry; an entry that is not as it was is not trusted."""
    program = PROGRAM.replace("NAME", "box.obj")
    for entry in (folder.cache / "armlet" / "meshes").iterdir():
        entry.unlink()
    check("made", folder.run(program).returncode == 0 and len(entries(folder)) == 1)
    (entry,) = entries(folder)
    whole, first = entry.read_bytes(), entry.stat()
    check("taken again", folder.run(program).returncode == 0 and entry.stat().st_ino == first.st_ino)
    check("and known as used now", entry.stat().st_mtime_ns > first.st_mtime_ns)
    for broken in (whole[:-5], whole[:100] + b"\xff" + whole[101:], b"", file_of(box_of(1, 1, 1))):
        entry.write_bytes(broken)
        done = folder.run(program)
        check(f"a broken entry: {done.stderr}", done.returncode == 0 and distances(done) == [60, 0])
        check("is made anew", entry.read_bytes() == whole)
    (names,) = (folder.cache / "armlet" / "meshes").glob("*.names")
    for broken in (b"", b"armlet mesh names 1\n", b"armlet mesh names 1\nx\n../../../etc/passwd\n", names.read_bytes()[:-3]):
        names.write_bytes(broken)
        check("broken names", folder.run(program).returncode == 0)
    folder.write("tex.png", meshes.png(seed=7))
    check("another picture", folder.run(program).returncode == 0 and len(entries(folder)) == 2)
    folder.write("tex.png", meshes.png())
    check("the first one", folder.run(program).returncode == 0 and len(entries(folder)) == 2)
    blocked = Folder(folder.path)
    folder.write("file", b"")
    blocked.environment["XDG_CACHE_HOME"] = str(folder.path / "file")
    check("no cache can be made", blocked.run(program).returncode == 0)


def check_missing_picture(folder):
    """It is reported each time, also when the mesh comes from the cache or from a record."""
    text, library = meshes.obj("nowhere.png", "plain.mtl")
    folder.write("plain.obj", text)
    folder.write("plain.mtl", library)
    program = PROGRAM.replace("NAME", "plain.obj")
    for _ in range(2):
        done = folder.run(program, "--record", "run.arec")
        check(f"W0740: {done.stderr}", done.returncode == 0 and "W0740" in done.stderr and '"nowhere.png" is left out' in done.stderr)
    (folder.path / "plain.obj").unlink()
    done = folder.call("replay", "run.arec")
    check(f"replayed: {done.stderr}", done.returncode == 0 and distances(done) == [60, 0] and "W0740" in done.stderr)
    done = folder.run(program)
    check(f"gone: {done.stderr}", done.returncode == 70 and "there is no such file" in done.stderr)
    lines = folder.run('try { let part = mesh("bad.obj") } catch (e) { print(e.kind) }\n').stdout.split()
    check("a kind to catch", lines == ["BadMesh"])
    done = folder.run('let part = mesh("../box.obj")\n')
    check(f"outside: {done.stderr}", "only below their own folder" in done.stderr)


ROBOT = """robot arm {
    joint revolute(d: 400mm, a: 250mm, limits: [-170deg, 170deg], maxSpeed: 180deg/s MESH)
    joint revolute(a: 150mm, alpha: 180deg, limits: [-145deg, 145deg], maxSpeed: 240deg/s)
    tool: tcp(xyz(z: 50mm))
}
object post { shape: box(20mm, 20mm, 300mm); at: xyz(0mm, 150mm, 450mm); fixed: true }
moveJ(posJ(40deg, 0deg))
moveJ(posJ(-40deg, 0deg))
moveJ(posJ(60deg, 0deg))
"""

URDF = """<robot name="stick"><link name="base"/><link name="arm"><visual>
<origin xyz="0.2 0 0" rpy="0 0 0"/><geometry><mesh filename="MESH" scale="10 10 10"/></geometry></visual></link><link name="tip"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="arm"/><origin xyz="0 0 0.5"/>
<axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="5" velocity="2"/></joint>
<joint name="end" type="revolute"><parent link="arm"/><child link="tip"/><origin xyz="0.4 0 0"/>
<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="5" velocity="2"/></joint></robot>"""


def check_links(folder):
    # A wing of 50 x 600 x 50 mm to the left of the first link, as an STL: it meets the post.
    corners, faces = box_of(0.05, 0.6, 0.05, at=(-0.125, 0, 0.08))
    data = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for i in t for x in corners[i]), 0) for t in faces)
    folder.write("wing.stl", b" " * 80 + struct.pack("<I", len(faces)) + data)
    plain = folder.run(ROBOT.replace("MESH", ""))
    winged = folder.run(ROBOT.replace("MESH", ', mesh: "wing.stl"'))
    check(f"without: {plain.stderr}", plain.returncode == 0 and "W0711" not in plain.stderr)
    check(f"with: {winged.stderr}", winged.returncode == 0 and "W0711" in winged.stderr and "post" in winged.stderr)
    # The same in millimetres, and at half the size.
    data = b"".join(struct.pack("<12fH", 0, 0, 0, *(500 * x for i in t for x in corners[i]), 0) for t in faces)
    folder.write("half.stl", b" " * 80 + struct.pack("<I", len(faces)) + data)
    for size, hits in (("meshUnit: 1mm, meshScale: 2", True), ("meshUnit: 2mm", True), ("meshUnit: 1mm", False)):
        done = folder.run(ROBOT.replace("MESH", f', mesh: "half.stl", {size}'))
        check(f"{size}: {done.stderr}", done.returncode == 0 and ("W0711" in done.stderr) == hits)
    for size, why in (("meshUnit: 0mm", "its unit is 0 m"), ("meshScale: -1", "its scale is -1")):
        done = folder.run(ROBOT.replace("MESH", f', mesh: "half.stl", {size}'))
        check(f"{size}: {done.stderr}", done.returncode == 70 and "R0656" in done.stderr and why in done.stderr)
    broken = folder.run(ROBOT.replace("MESH", ', mesh: "bad.obj"'))
    check(f"broken: {broken.stderr}", broken.returncode == 70 and "bad.obj" in broken.stderr and "a face names v 1" in broken.stderr)
    for name in ("box.dae", "box.stl", "BOX.STL"):
        shutil.copy(folder.path / "box.stl", folder.path / "BOX.STL")
        folder.write("stick.urdf", URDF.replace("MESH", name).encode())
        done = folder.call("robot", "stick.urdf", "--glb", "stick.glb")
        check(f"{name} of a URDF: {done.stderr}", done.returncode == 0)
        document, binary, _ = parts((folder.path / "stick.glb").read_bytes())
        counts = sorted(document["accessors"][p["indices"]]["count"] for m in document["meshes"] for p in m["primitives"])
        check(f"{name} of a URDF: {counts}", 36 in counts)
        done = folder.run('robot stick = urdf("stick.urdf", tip: "tip")\nprint(stick.here())\n')
        check(f"{name} in a program: {done.stderr}", done.returncode == 0)


# ---- what is stopped

def check_stopped(folder):
    """Ctrl-C ends a conversion at once, and the program says that it was stopped."""
    corners, faces = sphere(0.05, 499)
    data = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for i in t for x in corners[i]), 0) for t in faces)
    folder.write("fine.stl", b" " * 80 + struct.pack("<I", len(faces)) + data)
    folder.write("program.rbt", b'print("begin")\nlet part = mesh("fine.stl")\nprint(part)\n')
    running = subprocess.Popen([folder.armlet, "run", "program.rbt"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               cwd=folder.path, env=folder.environment)
    time.sleep(1.0)  # it is converted for several seconds
    running.send_signal(signal.SIGINT)
    begin = time.monotonic()
    out, told = running.communicate(timeout=60)
    took = time.monotonic() - begin
    check(f"stopped: {running.returncode} {out} {told}", running.returncode == 130 and "Shape" not in out)
    check(f"stopping took {took} s", took < 1.0)


# ---- what is broken

def refused(folder, name, data, why, seconds=20.0):
    folder.write(name, data)
    begin = time.monotonic()
    done = folder.convert(name)
    took = time.monotonic() - begin
    told = f"{name} ({why}): {done.returncode} {done.stderr[:500]}"
    check(told, done.returncode == 65 or why is None and done.returncode == 0)
    check(told, "broke down" not in done.stderr and "took more than" not in done.stderr and "exit status" not in done.stderr)
    check(told, done.returncode == 0 or f"armlet: {name}: " in done.stderr)
    check(told, why is None or why in done.stderr)
    check(f"{told}: took {took} s", took < seconds)


def check_broken(folder):
    os.mkfifo(folder.path / "fifo.png")
    os.mkfifo(folder.path / "canary.wrl")  # whoever opened it would wait for a writer
    os.symlink("/etc/passwd", folder.path / "link.png")
    picture = meshes.png()
    folder.write("wide.png", picture[:16] + struct.pack(">II", 20000, 20000) + picture[24:])
    folder.write("long.png", picture[:8] + struct.pack(">I", 1 << 30) + picture[12:])
    folder.write("tex.bmp", b"BM" + b"\0" * 100)
    for name, data, why in hostile(folder):
        refused(folder, name, data, why)


def check_cut(folder, names, every):
    for name in names:
        whole = (folder.path / name).read_bytes()
        for size in range(0, len(whole), every):
            refused(folder, "cut" + name[name.index("."):], whole[:size], None)


def check_confined(folder):
    """The converter opens nothing once it reads the mesh, as the kernel sees it."""
    tracer = shutil.which("strace")
    if not tracer:
        return
    for name in ("box.obj", "box.wrl", "box.dae", "box.3ds"):
        done = subprocess.run([tracer, "-f", "-e", "trace=%file,%network,prctl,execve", ARMLET, "mesh", "convert", name, "made.glb"],
                              capture_output=True, text=True, timeout=300, cwd=folder.path, env=folder.environment)
        lines = done.stderr.splitlines()
        confined = [k for k, line in enumerate(lines) if "PR_SET_SECCOMP" in line]
        if not confined:  # tracing is not allowed here
            return
        child = re.match(r"\[pid +(\d+)\]", lines[confined[0]]).group(1)
        after = [line for line in lines[confined[0] + 1:] if re.match(rf"\[pid +{child}\] (open|exec|connect|socket|stat|readlink|access)", line)]
        check(f"{name}: {after}", not after)


# ---- without a converter

def check_without(folder):
    alone = Folder(folder.path, str(folder.path / "alone" / "armlet"))
    (folder.path / "alone").mkdir()
    shutil.copy(ARMLET, alone.armlet)
    done = alone.convert("box.obj")
    check(f"convert: {done.stderr}", done.returncode == 70 and "libassimp-dev" in done.stderr and "armlet-mesh" in done.stderr)
    done = alone.run(PROGRAM.replace("NAME", "box.obj"))
    check(f"R0660: {done.stderr}", done.returncode == 70 and "R0660" in done.stderr and "libassimp-dev" in done.stderr)
    check("GLB all the same", alone.run(PROGRAM.replace("NAME", "out.glb")).returncode == 0)
    done = alone.run(ROBOT.replace("MESH", ', mesh: "box.stl"'))
    check(f"W0741: {done.stderr}", done.returncode == 0 and "W0741" in done.stderr)


def main():
    with tempfile.TemporaryDirectory() as path:
        folder = Folder(path)
        names = meshes.textured(folder.path)
        check_without(folder)
        if not sys.argv[2]:
            print("the converter is not built; the message about that is right")
            return
        for name in names:
            check_format(folder, name)
        check_shapes(folder)
        check_jpeg(folder)
        check_units_and_axes(folder)
        check_command(folder)
        check_programs(folder, names)
        check_cache(folder)
        check_missing_picture(folder)
        check_links(folder)
        check_stopped(folder)
        check_broken(folder)
        check_stl_forms(folder, check, parts, refused)
        check_cut(folder, names, int(sys.argv[3]) if len(sys.argv) > 3 else 100)
        check_confined(folder)
        print("meshes of other formats: in order")


if __name__ == "__main__":
    main()
