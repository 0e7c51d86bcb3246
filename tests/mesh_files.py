"""Meshes in many formats, made here from one box with a picture on it: mesh_files.textured(folder) writes them and gives
the name of each; the box is 0.04 x 0.06 x 0.08 m when z is up, its lower corner in the origin."""

import base64
import json
import struct
import zlib

from glb_files import box, glb

SIZES = (0.04, 0.06, 0.08)
VOLUME = SIZES[0] * SIZES[1] * SIZES[2]
# Colours of materials without a picture, as on a screen.
COLOR = (1.0, 0.5, 0.25)


def png(width=2, height=2, seed=0):
    rows = b"".join(b"\0" + bytes((seed + 40 * x + 90 * y + c) % 256 for x in range(width) for c in (0, 80, 160))
                    for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def jpeg(width, height):
    """What stands before and behind the picture itself, which nobody here looks at."""
    return (b"\xff\xd8\xff\xe0\0\x04ab\xff\xc0" + struct.pack(">HBHHB", 11, 8, height, width, 1) + b"\1\x11\0" +
            b"\xff\xda\0\x08\1\1\0\0\x3f\0" + b"x" + b"\xff\xd9")


# The corners and the six faces of the box, counterclockwise seen from outside.
POINTS = [(x * SIZES[0], y * SIZES[1], z * SIZES[2]) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
FACES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
ON_IMAGE = [(0, 0), (1, 0), (1, 1), (0, 1)]
TRIANGLES = [(f[0], f[k], f[k + 1]) for f in FACES for k in (1, 2)]


def numbers(values):
    return " ".join(f"{value:g}" for value in values)


def obj(texture=".\\Tex.png", library="box.mtl"):
    text = f"mtllib {library}\n" + "".join(f"v {numbers(p)}\n" for p in POINTS) + "".join(f"vt {numbers(t)}\n" for t in ON_IMAGE)
    text += "usemtl wood\n" + "".join("f " + " ".join(f"{i + 1}/{k + 1}" for k, i in enumerate(f)) + "\n" for f in FACES[:3])
    text += "usemtl paint\n" + "".join("f " + " ".join(f"{i + 1}/{k + 1}" for k, i in enumerate(f)) + "\n" for f in FACES[3:])
    mtl = f"newmtl wood\nKd 1 1 1\nmap_Kd {texture}\nnewmtl paint\nKd {numbers(COLOR)}\n"
    return text.encode(), mtl.encode()


def wrl(texture="tex.png", more="", points=None, index=None):
    # y up: (x, y, z) of the world is (x, z, -y) of the file.
    points = points or [(x, z, -y) for x, y, z in POINTS]
    index = index or ", ".join(", ".join(map(str, f)) + ", -1" for f in FACES)
    on_image = ", ".join("0, 1, 2, 3, -1" for _ in FACES)
    return f"""#VRML V2.0 utf8
# A box.
{more}
Transform {{ children [ Shape {{
  appearance Appearance {{ material Material {{ diffuseColor {numbers(COLOR)} }} texture ImageTexture {{ url "{texture}" }} }}
  geometry IndexedFaceSet {{
    coord Coordinate {{ point [ {", ".join(numbers(p) for p in points)} ] }}
    texCoord TextureCoordinate {{ point [ {", ".join(numbers(t) for t in ON_IMAGE)} ] }}
    coordIndex [ {index} ]
    texCoordIndex [ {on_image} ]
  }}
}} ] }}
""".encode()


def stl(binary=True):
    if not binary:
        facets = "".join("facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {numbers(POINTS[i])}\n" for i in t) +
                         "endloop\nendfacet\n" for t in TRIANGLES)
        return f"solid box\n{facets}endsolid box\n".encode()
    data = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for i in t for x in POINTS[i]), 0) for t in TRIANGLES)
    return b"binary".ljust(80, b" ") + struct.pack("<I", len(TRIANGLES)) + data


def ply(binary=True, texture="tex.png"):
    corners = [(POINTS[i], ON_IMAGE[k]) for f in FACES for k, i in enumerate(f)]
    head = "ply\nformat " + ("binary_little_endian" if binary else "ascii") + f" 1.0\ncomment TextureFile {texture}\n"
    head += f"element vertex {len(corners)}\n" + "".join(f"property float {c}\n" for c in "xyz")
    head += "property float s\nproperty float t\n" + "".join(f"property uchar {c}\n" for c in ("red", "green", "blue"))
    head += f"element face {len(FACES)}\nproperty list uchar int vertex_indices\nend_header\n"
    color = [round(255 * c) for c in COLOR]
    if binary:
        body = b"".join(struct.pack("<5f3B", *p, *t, *color) for p, t in corners)
        body += b"".join(struct.pack("<B4i", 4, *(4 * k + i for i in range(4))) for k in range(len(FACES)))
        return head.encode() + body
    body = "".join(f"{numbers(p)} {numbers(t)} {numbers(color)}\n" for p, t in corners)
    body += "".join("4 " + numbers(4 * k + i for i in range(4)) + "\n" for k in range(len(FACES)))
    return (head + body).encode()


def dae(texture="tex.png", up="Z_UP", unit=1.0, more="", extra_node=""):
    positions = numbers(x / unit for p in POINTS for x in p)
    index = " ".join(f"{i} {k}" for f in FACES for k, i in enumerate(f))
    return f"""<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="u" meter="{unit}"/><up_axis>{up}</up_axis></asset>{more}
<library_images><image id="img"><init_from>{texture}</init_from></image></library_images>
<library_effects><effect id="fx"><profile_COMMON>
<newparam sid="s"><surface type="2D"><init_from>img</init_from></surface></newparam>
<newparam sid="t"><sampler2D><source>s</source></sampler2D></newparam>
<technique sid="c"><lambert><diffuse><texture texture="t" texcoord="UV"/></diffuse></lambert></technique>
</profile_COMMON></effect></library_effects>
<library_materials><material id="mat"><instance_effect url="#fx"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="24">{positions}</float_array><technique_common>
<accessor source="#pa" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
</technique_common></source>
<source id="uv"><float_array id="uva" count="8">{numbers(x for t in ON_IMAGE for x in t)}</float_array><technique_common>
<accessor source="#uva" count="4" stride="2"><param name="S" type="float"/><param name="T" type="float"/></accessor>
</technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<polylist material="m" count="6"><input semantic="VERTEX" source="#v" offset="0"/>
<input semantic="TEXCOORD" source="#uv" offset="1" set="0"/>
<vcount>4 4 4 4 4 4</vcount><p>{index}</p></polylist>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="scene"><node id="n">{extra_node}
<instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="m" target="#mat">
<bind_vertex_input semantic="UV" input_semantic="TEXCOORD" input_set="0"/></instance_material></technique_common></bind_material>
</instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
""".encode()


def chunk_3ds(kind, *parts):
    data = b"".join(parts)
    return struct.pack("<HI", kind, 6 + len(data)) + data


def three_ds(texture="TEX.PNG"):
    corners = [(POINTS[i], ON_IMAGE[k]) for f in FACES for k, i in enumerate(f)]
    points = chunk_3ds(0x4110, struct.pack("<H", len(corners)), *(struct.pack("<3f", *p) for p, _ in corners))
    on_image = chunk_3ds(0x4140, struct.pack("<H", len(corners)), *(struct.pack("<2f", *t) for _, t in corners))
    faces = [(4 * k, 4 * k + a, 4 * k + a + 1) for k in range(6) for a in (1, 2)]
    use = chunk_3ds(0x4130, b"wood\0", struct.pack("<H", len(faces)), *(struct.pack("<H", k) for k in range(len(faces))))
    triangles = chunk_3ds(0x4120, struct.pack("<H", len(faces)), *(struct.pack("<4H", *t, 7) for t in faces), use)
    body = chunk_3ds(0x4000, b"box\0", chunk_3ds(0x4100, points, on_image, triangles))
    white = chunk_3ds(0x0011, bytes([255, 255, 255]))
    material = chunk_3ds(0xAFFF, chunk_3ds(0xA000, b"wood\0"), chunk_3ds(0xA020, white),
                         chunk_3ds(0xA200, chunk_3ds(0xA300, texture.encode() + b"\0")))
    return chunk_3ds(0x4D4D, chunk_3ds(0x0002, struct.pack("<I", 3)), chunk_3ds(0x3D3D, material, body))


def gltf(texture="Tex%201.png", buffer="box.bin"):
    """The description and the bytes of its buffer."""
    corners = [((p[0], p[2], -p[1]), (t[0], 1 - t[1])) for p, t in ((POINTS[i], ON_IMAGE[k]) for f in FACES for k, i in enumerate(f))]
    faces = [4 * k + i for k in range(6) for i in (0, 1, 2, 0, 2, 3)]
    positions = b"".join(struct.pack("<3f", *p) for p, _ in corners)
    on_image = b"".join(struct.pack("<2f", *t) for _, t in corners)
    binary = positions + on_image + struct.pack(f"<{len(faces)}H", *faces)
    n = len(corners)
    views = [(0, len(positions)), (len(positions), len(on_image)), (len(positions) + len(on_image), 2 * len(faces))]
    return {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
            "materials": [{"name": "wood", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
            "textures": [{"source": 0}], "images": [{"uri": texture}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": n, "type": "VEC3",
                           "min": [min(p[k] for p, _ in corners) for k in range(3)],
                           "max": [max(p[k] for p, _ in corners) for k in range(3)]},
                          {"bufferView": 1, "componentType": 5126, "count": n, "type": "VEC2"},
                          {"bufferView": 2, "componentType": 5123, "count": len(faces), "type": "SCALAR"}],
            "bufferViews": [{"buffer": 0, "byteOffset": o, "byteLength": l} for o, l in views],
            "buffers": [{"uri": buffer, "byteLength": len(binary)}]}, binary


def embedded(document, binary):
    """The same with its buffer as a data: address."""
    copy = json.loads(json.dumps(document))
    copy["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(binary).decode()
    return copy


def textured(folder):
    """Writes a textured box in every format; {name: (has a picture, has the colour)}."""
    (folder / "tex.png").write_bytes(png())
    (folder / "Tex 1.png").write_bytes(png())
    text, mtl = obj()
    document, binary = gltf()
    packed = json.loads(json.dumps(document))
    del packed["buffers"][0]["uri"]
    files = {"box.obj": text, "box.wrl": wrl(), "box.stl": stl(), "text.stl": stl(False), "box.ply": ply(), "text.ply": ply(False),
             "box.dae": dae(), "box.3ds": three_ds(), "box.gltf": json.dumps(document).encode(),
             "data.gltf": json.dumps(embedded(document, binary)).encode(), "out.glb": glb(packed, binary)}
    for name, data in files.items():
        (folder / name).write_bytes(data)
    (folder / "BOX.MTL").write_bytes(mtl)
    (folder / "box.bin").write_bytes(binary)
    return list(files)
