"""Broken meshes for convert_command.py, and such as would do harm: hostile(folder) gives (name, bytes, reason)."""

import json
import struct

import mesh_files as meshes


def hostile(folder):
    """(name, bytes, what the message says); None: it may be read as well."""
    obj, wrl, dae, ply, tds = meshes.obj("t.png")[0], meshes.wrl(), meshes.dae(), meshes.ply(False), meshes.three_ds()
    document, binary = meshes.gltf()

    def gltf(**changes):
        return json.dumps({**document, **changes}).encode()
    triangle = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n"
    yield "index.obj", triangle + b"f 1 2 9\n", "a face names v 9, but there are 3"
    yield "below.obj", triangle + b"f -1 -2 -9\n", "a face names v -9"
    yield "zero.obj", triangle + b"f 0 1 2\n", "a face names v 0"
    yield "picture.obj", triangle + b"f 1/7 2/1 3/1\n", "a face names vt 7, but there are 1"
    yield "nan.obj", triangle.replace(b"v 1", b"v nan") + b"f 1 2 3\n", "is no number"
    yield "far.obj", triangle.replace(b"v 1", b"v 1e30") + b"f 1 2 3\n", "10 km"
    yield "self.obj", b"mtllib self.obj\n" + triangle + b"f 1 2 3\n", None
    yield "bytes.obj", b"v 0 0 0\0", "is no text"
    yield "empty.obj", b"", "too small"
    yield "long.obj", b"v 0 0 0 \\\n" * 100000, "cannot be read"
    yield "polygon.obj", triangle + b"f" + b" 1 2 3" * 100000 + b"\n", "but the limit is"
    yield "index.wrl", meshes.wrl(index="0, 1, 99, -1"), "`coordIndex` 2 is 99, but there are 8 points"
    yield "below.wrl", meshes.wrl(index="0, 1, -7, -1"), "`coordIndex` 2 is -7"
    yield "picture.wrl", wrl.replace(b"texCoordIndex [ 0, 1, 2", b"texCoordIndex [ 0, 1, 77"), "`texCoordIndex` 2 is 77"
    for word in ("Inline", "EXTERNPROTO X [ ]", "Script", "MovieTexture"):
        more = f'{word} {"" if " " in word else "{ url"} "canary.wrl" {"" if " " in word else "}"}'
        yield f"{word[:4]}.wrl", meshes.wrl(more=more), f"line 3: `{word.split()[0]}` would open another file"
    yield "loop.wrl", b"#VRML V2.0 utf8\nDEF A Group { children [ DEF B Group { children USE A } ] }\n", "the node A contains itself"
    yield "proto.wrl", b"#VRML V2.0 utf8\nPROTO P [ ] { Group { children P { } } }\nP { }\n", "PROTO P contains itself"
    bomb = b"".join(b"DEF G%d Group { children [ USE G%d USE G%d ] }\n" % (k + 1, k, k) for k in range(40))
    yield "bomb.wrl", b"#VRML V2.0 utf8\nDEF G0 Shape { geometry Box { } }\n" + bomb, "used again and again"
    protos = b"".join(b"PROTO P%d [ ] { Group { children [ P%d { } P%d { } ] } }\n" % (k + 1, k, k) for k in range(30))
    yield "protos.wrl", b"#VRML V2.0 utf8\nPROTO P0 [ ] { Group { } }\n" + protos + b"P30 { }\n", "its prototypes make more than"
    yield "deep.wrl", b"#VRML V2.0 utf8\n" + b"Group { children [ " * 100000, "more than 200 nodes in one another"
    yield "nan.wrl", meshes.wrl(points=[(float("nan"), 0, 0)] * 8), "cannot be read"
    yield "old.wrl", b"#VRML V1.0 ascii\nCube { }\n", "it is VRML 1.0"
    yield "packed.wrl", b"\x1f\x8b" + wrl, "it is compressed"
    grid = b"#VRML V2.0 utf8\nShape { geometry ElevationGrid { xDimension 20000 zDimension 20000 height [ 0 1 ] } }\n"
    yield "grid.wrl", grid, "an ElevationGrid of 20000 x 20000 has 2 heights"
    yield "count.stl", b" " * 80 + struct.pack("<I", 0x7fffffff) + b"\0" * 50, "its header says 2147483647 triangles"
    yield "nan.stl", b" " * 80 + struct.pack("<I", 1) + struct.pack("<12fH", *[float("nan")] * 12, 0), "is no number"
    yield "count.ply", ply.replace(b"element vertex 24", b"element vertex 2000000000"), "it is cut off in element 24"
    yield "index.ply", ply.replace(b"4 0 1 2 3\n", b"4 0 1 2 99\n"), "names vertex 99, but there are 24"
    list_head = (b"ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                 b"element face 1\nproperty list uint int vertex_indices\nend_header\n" + b"\0" * 36)
    yield "line.ply", ply.replace(b"0 0 0.08 0 0 255 128 64", b"0 0 0.08 0 0 255 128", 1), "it is cut off in element"
    yield "word.ply", ply.replace(b"0.08", b"0.0x", 1), "where a number should be"
    yield "list.ply", list_head + struct.pack("<I", 0xffffffff) + b"\0" * 12, "has a list of 4294967295"
    laughs = "".join(f'<!ENTITY l{k + 1} "{f"&l{k};" * 10}">' for k in range(10))
    yield "laughs.dae", dae.replace(b"<COLLADA", f'<!DOCTYPE x [<!ENTITY l0 "ha">{laughs}]><COLLADA'.encode()), "it declares entities"
    yield "include.dae", meshes.dae(more='<xi:include href="canary.wrl"/>'), "it includes another file"
    yield "self.dae", meshes.dae(extra_node='<instance_node url="#n"/>'), "a node contains itself"
    nodes = "".join(f'<node id="b{k + 1}"><instance_node url="#b{k}"/><instance_node url="#b{k}"/></node>' for k in range(40))
    bomb = meshes.dae(more=f"<library_nodes>{nodes}</library_nodes>", extra_node='<instance_node url="#b40"/>')
    yield "bomb.dae", bomb, "its nodes show more than a million parts"
    yield "sampler.dae", dae.replace(b"<source>s<", b"<source>t<"), "a parameter contains itself"
    yield "index.dae", dae.replace(b"<p>0 0", b"<p>77 0"), "Invalid data index (77/8)"
    yield "below.dae", dae.replace(b"<p>0 0", b"<p>-7 0"), "has one below 0"
    yield "word.dae", dae.replace(b"<p>0 0", b"<p>0 x"), "has something else in it"
    yield "tag.dae", dae.replace(b" count=", b" \xffount=", 1), "has no `count`"
    yield "count.dae", dae.replace(b'count="24"', b'count="2000000000"'), "a size in it is false"
    yield "deep.dae", meshes.dae(extra_node="<node>" * 50000 + "</node>" * 50000), "more than 64 elements in one another"
    yield "packed.dae", b"PK\3\4" + b"\0" * 100, "it is a packed archive"
    yield "count.3ds", struct.pack("<HI", 0x4D4D, 0x7fffffff) + tds[6:], "its main chunk says 2147483647 bytes"
    yield "inner.3ds", tds[:18] + struct.pack("<I", 0x7fffffff) + tds[22:], "cannot be read"
    yield "loop.gltf", gltf(nodes=[{"mesh": 0, "children": [0]}]), "is below itself"
    yield "count.gltf", gltf(buffers=[{"uri": "box.bin", "byteLength": 1 << 31}]), "buffer 0 says 2147483648 bytes"
    yield "outside.gltf", gltf(buffers=[{"uri": "../../../etc/passwd", "byteLength": 10}]), "leads out of the folder"
    yield "root.gltf", gltf(buffers=[{"uri": "/etc/passwd", "byteLength": 10}]), "begins at a root"
    yield "net.gltf", gltf(buffers=[{"uri": "http://localhost/x", "byteLength": 10}]), "on a drive or in a network"
    yield "deep.gltf", b"[" * 1000000, "more than 64 values in one another"
    yield "digits.gltf", gltf(buffers=[{"uri": "data:;base64,!!!!", "byteLength": 3}]), "base64"
    # Pictures: what is there and cannot be used is refused, what is not there is reported.
    for picture, why in (("fifo.png", "it is a pipe"), ("wide.png", "20000 x 20000 pixels"), ("long.png", "is damaged or cut off"),
                         ("link.png", "it is a link")):
        for name, data in pictured(picture, folder, document):
            yield name, data, why
    for picture in ("/etc/passwd", "../../etc/passwd", "http://localhost/x.png", "C:\\a\\tex.png", "nowhere.png", "tex.bmp"):
        for name, data in pictured(picture, folder, document):
            yield name, data, None


def pictured(picture, folder, document):
    text, library = meshes.obj(picture, "hostile.mtl")
    folder.write("hostile.mtl", library)
    yield "picture.obj", text
    yield "picture.wrl", meshes.wrl(picture.replace("\\", "\\\\"))
    yield "picture.dae", meshes.dae(picture)
    yield "picture.3ds", meshes.three_ds(picture)
    yield "picture.ply", meshes.ply(True, picture)
    yield "picture.gltf", json.dumps({**document, "images": [{"uri": picture}]}).encode()
