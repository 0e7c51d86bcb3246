"""GLB files for tests, made by the specification alone: whole ones and broken ones."""

import json
import math
import struct

BOX = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]


def box(x, y, z, at=(0, 0, 0)):
    """Vertices and triangles of a box, x, y, z its sides, `at` its middle."""
    corners = [(at[0] + x * (i & 1) - x / 2, at[1] + y * (i >> 1 & 1) - y / 2, at[2] + z * (i >> 2) - z / 2) for i in range(8)]
    return corners, list(BOX)


def prism(outline, height):
    """An outline in x and y, counterclockwise, that can be cut into triangles from its corner 0, from 0 to `height`."""
    n = len(outline)
    corners = [(x, y, z) for z in (0, height) for x, y in outline]
    faces = [(0, k + 1, k) for k in range(1, n - 1)] + [(n, n + k, n + k + 1) for k in range(1, n - 1)]
    for k in range(n):
        i = (k + 1) % n
        faces += [(k, i, n + i), (k, n + i, n + k)]
    return corners, faces


def sphere(radius, rounds):
    """`rounds` bands of 2 `rounds` faces."""
    corners = [(0, 0, -radius)]
    for i in range(1, rounds):
        z, r = -radius * math.cos(math.pi * i / rounds), radius * math.sin(math.pi * i / rounds)
        corners += [(r * math.cos(math.pi * k / rounds), r * math.sin(math.pi * k / rounds), z) for k in range(2 * rounds)]
    corners.append((0, 0, radius))
    n, top = 2 * rounds, len(corners) - 1
    faces = [(0, 1 + (k + 1) % n, 1 + k) for k in range(n)]
    for i in range(rounds - 2):
        for k in range(n):
            a, b = 1 + i * n + k, 1 + i * n + (k + 1) % n
            faces += [(a, b, b + n), (a, b + n, a + n)]
    faces += [(top - n + k, top - n + (k + 1) % n, top) for k in range(n)]
    return corners, faces


def document(corners, faces, wide=True):
    """The JSON part and the binary part, y up."""
    flat = [c for x, y, z in corners for c in (x, z, -y)]
    letter = "I" if wide else "H"
    indices = struct.pack(f"<{3 * len(faces)}{letter}", *[k for face in faces for k in face])
    positions = struct.pack(f"<{len(flat)}f", *flat)
    binary = positions + indices + b"\0" * (-len(indices) % 4)
    return {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(corners), "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5125 if wide else 5123, "count": 3 * len(faces), "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": len(positions)},
                        {"buffer": 0, "byteOffset": len(positions), "byteLength": len(indices)}],
        "buffers": [{"byteLength": len(binary)}]}, binary


def glb(description, binary):
    text = description if isinstance(description, bytes) else json.dumps(description).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(binary), 0x004E4942) + binary
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def file_of(mesh, wide=True):
    return glb(*document(*mesh, wide))
