"""STL files of a tetrahedron as programs of all kinds write them: forms() gives (name, bytes, triangles, a note or None),
refused() gives (name, bytes, reason). Called, it prints both as JSON for the tests of the page."""

import base64
import json
import struct

POINTS = [(0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.1)]
FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]


def text(name="part", shift=0.0, normal="0 0 0", end="endsolid part"):
    facets = "".join(f"  facet normal {normal}\n    outer loop\n" +
                     "".join("      vertex %g %g %g\n" % (POINTS[i][0] + shift, *POINTS[i][1:]) for i in face) +
                     "    endloop\n  endfacet\n" for face in FACES)
    return f"solid {name}\n{facets}{end}\n"


def binary(head=b"binary", count=4, behind=b""):
    data = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for i in face for x in POINTS[i]), 0) for face in FACES)
    return head.ljust(80, b" ") + struct.pack("<I", count) + data + behind


def forms():
    plain = text()
    missing = "`endsolid` is missing"
    yield "upper", plain.upper().encode(), 4, None
    yield "mixed", plain.title().encode(), 4, None
    yield "blanks", b" \t\r\n " + plain.replace("  ", "\t").encode(), 4, None
    yield "mark", b"\xef\xbb\xbf" + plain.encode(), 4, None
    yield "two_words", plain.replace("endsolid", "end solid").replace("endloop", "end loop").replace("endfacet", "end facet").encode(), 4, None
    yield "no_name", text("", end="endsolid").encode(), 4, None
    yield "long_name", text("facet normal of loop 7 \xe4 end", end="endsolid of loop 7").encode("latin-1"), 4, None
    yield "no_number", text(normal="nan -nan nan").encode(), 4, None
    yield "endless", text(normal="inf 0 0").encode(), 4, None
    yield "no_end", text(end="").encode(), 4, missing
    yield "two", (plain + text("other", 0.5)).encode(), 8, None
    yield "two_open", (text(end="") + text("other", 0.5)).encode(), 8, missing
    yield "dos", plain.replace("\n", "\r\n").encode() + b"\x1a", 4, None
    yield "old_mac", plain.replace("\n", "\r").encode(), 4, None
    yield "padded", plain.encode() + b"\0" * 100, 4, None
    yield "words", plain.replace("endsolid", "color 0.1 0.2 0.3\nendsolid").encode(), 4, 'line 30 begins with "color"'
    yield "one_line", plain.replace("\n", " ").replace("solid part  ", "solid part\n", 1).encode(), 4, None
    yield "numbers", plain.replace("0.1", "+1.0E-01").encode(), 4, None
    yield "solid_binary", binary(b"solid facet normal"), 4, None
    yield "zeros_binary", binary(b"solid".ljust(80, b"\0")), 4, None
    yield "three_more", binary(behind=b"\1\2\3"), 4, "3 bytes behind its 4 triangles are not read"
    yield "one_more_solid", binary(b"solid x", behind=b"\0"), 4, "1 byte behind its 4 triangles is not read"


def refused():
    yield "zero", binary(count=0), "its header says 0 triangles, but there are bytes for 4"
    yield "too_few", binary(count=2), "its header says 2 triangles, but there are bytes for 4"
    yield "too_many", binary(count=9), "its header says 9 triangles, but there are bytes for 4"
    yield "one_triangle_more", binary(behind=b"\0" * 50), "its header says 4 triangles, but there are bytes for 5"
    yield "solid_too_many", binary(b"solid box", count=9), "its header says 9 triangles, but there are bytes for 4"
    yield "in_a_facet", text()[:400].encode(), "it is cut off: `endfacet` is missing"
    yield "word", text().replace("0.1 0 0", "0.1 zero 0", 1).encode(), 'line 6 has "zero" where a number should be'
    yield "comma", text().replace("0.1", "0,1", 1).encode(), 'has "0,1" where a number should be'
    yield "short", text().replace("0.1 0 0", "0.1 0", 1).encode(), 'has "endloop" where a number should be'
    yield "four", text().replace("    endloop", "      vertex 1 1 1\n    endloop", 1).encode(), "has 4 corners; expected 3"
    yield "foreign", text().replace("endloop", "endlop", 1).encode(), 'line 7 has "endlop" in a facet'
    yield "empty", b"solid x\nendsolid x\n", "there are no triangles in it"
    yield "page", b"<!DOCTYPE html>\n<html>" + b" " * 100, 'it is no STL file: it begins with "<!DOCTYPE"'
    yield "byte", text().replace("facet", "fa\0et", 3).encode().replace(b"solid part", b"solid part" + b" " * 80), "it is no text: it has a byte of 0"


def check_forms(folder, check, parts, refuse):
    """The same tetrahedron of 100 mm, whose volume is 1/6000 m^3, once or twice; what is wrong, with its numbers."""
    for name, data, count, note in forms():
        folder.write(f"{name}.stl", data)
        done = folder.convert(f"{name}.stl")
        check(f"{name}.stl: {done.stderr}", done.returncode == 0 and f"{count} triangles" in done.stderr)
        notes = parts((folder.path / "made.glb").read_bytes())[2]
        check(f"{name}.stl: notes {notes}", note in notes if note else not notes)
        program = ('robot arm { joint revolute(limits: [-1rad, 1rad]) }\n'
                   f'object o {{ shape: mesh("{name}.stl", density: 6000kg/m^3); at: xyz(0m, 0m, 0m); on: arm; fixed: true }}\n'
                   'print(arm.dynamicParameters()[0])\n')
        done = folder.run(program)
        check(f"{name}.stl: {done.stderr}", done.returncode == 0 and ("W0742" in done.stderr) == (note is not None))
        check(f"{name}.stl weighs {done.stdout}", abs(float(done.stdout.split()[0]) - count / 4) < 1e-6)
    for name, data, why in refused():
        refuse(folder, f"{name}.stl", data, why)


if __name__ == "__main__":
    print(json.dumps({"forms": [(name, base64.b64encode(data).decode(), count, note) for name, data, count, note in forms()],
                      "refused": [(name, base64.b64encode(data).decode(), why) for name, data, why in refused()]}))
