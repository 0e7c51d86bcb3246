#!/usr/bin/env python3
"""Pictures of cameras between programs and files: `--camera`, `--frames`, traces, records: camera_command.py ARMLET."""

import json
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

COMMAND = Path(sys.argv[1]).resolve()
FAILED, USAGE, NO_FILE = 70, 64, 66
EYE = "camera eye { at: lookingAt(xyz(400mm, 0mm, 0mm), from: xyz(400mm, 0mm, 900mm)); size: [8, 6]; noise: 4.0 }\n"
ONE = EYE + "let img = eye.capture()\n"
THREE = EYE + "for (i in range(3)) { print(eye.capture()[2, 3]); wait(100ms) }\n"


def check(claim, found, wanted):
    if found != wanted:
        sys.exit(f"{claim}: {found!r} instead of {wanted!r}")


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(path, width, height, color):
    """A picture of one colour, by the specification of PNG: grey for a number, RGB for three of them."""
    grey = isinstance(color, int)
    rows = (b"\0" + bytes([color] if grey else color) * width) * height
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 0 if grey else 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def pixels(path):
    """The bytes of the pixels of a PNG of 8-bit RGB that uses any filters."""
    data, at, size, packed = path.read_bytes(), 8, None, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            size = struct.unpack(">II", body[:8])
        packed += body if kind == b"IDAT" else b""
        at += length + 12
    raw, out, stride = zlib.decompress(packed), [], 3 * size[0]
    before = bytearray(stride)
    for y in range(size[1]):
        how, row = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for x in range(stride):
            a, b, c = (row[x - 3] if x >= 3 else 0), before[x], (before[x - 3] if x >= 3 else 0)
            paeth = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            row[x] = (row[x] + (0, a, b, (a + b) // 2, paeth)[how]) % 256
        out.append(bytes(row))
        before = row
    return b"".join(out)


def fnv1a(data):
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return f"{value:016x}"


def run(folder, text, *options):
    (folder / "p.rbt").write_text(text)
    return subprocess.run([COMMAND, "run", "--quiet", "p.rbt", *options], cwd=folder, capture_output=True, text=True, timeout=60)


def check_recorded(folder):
    seen = folder / "seen"
    seen.mkdir()
    # In the order of the names, whatever their ending; other files do not count.
    png(seen / "b.PNG", 8, 6, (4, 5, 6))
    png(seen / "a.png", 8, 6, (1, 2, 3))
    png(seen / "c.png", 8, 6, (7, 8, 9))
    (seen / "readme.txt").write_text("not a picture")
    done = run(folder, THREE, "--camera", "eye=seen/")
    check("recorded pictures", (done.returncode, done.stdout),
          (0, "".join(f"Color(r: {r}, g: {r + 1}, b: {r + 2})\n" for r in (1, 4, 7))))
    done = run(folder, THREE + "eye.capture()\n", "--camera", "eye=seen")
    check("too few of them", done.returncode, FAILED)
    for part in ("R0686", "picture 4 for the camera `eye`", "there are 3 pictures in seen"):
        check(f"{part} in {done.stderr}", part in done.stderr, True)
    png(seen / "a.png", 6, 8, (1, 2, 3))
    done = run(folder, THREE, "--camera", "eye=seen")
    check("another size", (done.returncode, "the picture is 6 x 8, and the camera takes 8 x 6" in done.stderr), (FAILED, True))
    png(seen / "a.png", 8, 6, 9)
    done = run(folder, THREE, "--camera", "eye=seen")
    check("another number of channels", (done.returncode, "grey, with one channel" in done.stderr), (FAILED, True))
    (seen / "a.png").write_bytes((seen / "b.PNG").read_bytes()[:40])
    done = run(folder, THREE, "--camera", "eye=seen")
    check("a file that is cut off", (done.returncode, "R0686" in done.stderr), (FAILED, True))
    png(seen / "a.png", 8, 6, (1, 2, 3))


def check_options(folder):
    (folder / "empty").mkdir()
    for option, status, words in (("eye=none", NO_FILE, "the camera `eye` cannot be read from none: "),
                                  ("eye=empty", NO_FILE, "there is no PNG or JPEG file in it"),
                                  ("eyes=seen", USAGE, "the program has no camera `eyes`; did you mean `eye`?"),
                                  ("thing=seen", USAGE, "the program has no camera `thing`; it has eye"),
                                  ("seen", USAGE, "expected NAME=FOLDER")):
        done = run(folder, THREE, "--camera", option)
        check(f"--camera {option}: {done.stderr}", (done.returncode, words in done.stderr, done.stdout == "" or status == USAGE),
              (status, True, True))
    done = run(folder, THREE, "--camera", "eye=seen", "--camera", "eye=seen")
    check("one camera twice", (done.returncode, "twice" in done.stderr), (USAGE, True))
    done = run(folder, "print(1)\n", "--camera", "eye=seen")
    check("a program without cameras", (done.returncode, done.stderr), (USAGE, "armlet: the program has no camera `eye`\n"))


def check_frames(folder):
    done = run(folder, THREE, "--frames", "out/pictures", "--trace", "t.jsonl")
    check("pictures as files", (done.returncode, done.stderr), (0, ""))
    names = sorted(path.name for path in (folder / "out/pictures").iterdir())
    check("their names", names, [f"eye-00000{i}.png" for i in range(3)])
    lines = [json.loads(line) for line in (folder / "t.jsonl").read_text().splitlines()]
    frames = [line for line in lines if line["what"] == "frame"]
    check("how many lines", [(line["t"], line["number"], line["size"]) for line in frames],
          [(0.1 * i, i, [8, 6, 3]) for i in range(3)])
    for line in frames:
        check("the file of a line", line["file"], f"out/pictures/eye-00000{line['number']}.png")
        check("the hash of its pixels", line["hash"], fnv1a(pixels(folder / line["file"])))
    check("the camera at the beginning", [camera["name"] for camera in lines[0]["cameras"]], ["eye"])
    # The program runs on what it saw.
    again = run(folder, THREE, "--camera", "eye=out/pictures")
    check("once more on its own pictures", again.stdout, done.stdout)
    run(folder, THREE, "--trace", "t.csv")
    rows = [row for row in (folder / "t.csv").read_text().splitlines() if ",frame," in row]
    check("rows of a table", [row.split(",")[:3] for row in rows], [[f"0.{i}00000000", "frame", "eye"] for i in range(3)])
    check("without files", [row.endswith(",") for row in rows], [True] * 3)
    run(folder, THREE, "--trace", "t.csv", "--frames", "more")
    check("with files", (folder / "t.csv").read_text().count("more/eye-00000"), 3)
    done = run(folder, ONE, "--frames", "more", "--quiet")
    check("pictures of an earlier run", (done.returncode, done.stderr),
          (0, "armlet: more also holds 2 pictures of an earlier run: eye-000001.png to eye-000002.png\n"))
    (folder / "more/own-notes.png").write_text("")
    done = run(folder, THREE, "--frames", "more", "--quiet")
    check("other files are not counted", (done.returncode, done.stderr), (0, ""))
    for option in ("--frames", "--storyboard", "--video", "--trace", "--record"):
        done = run(folder, THREE, option, "")
        check(f"{option} without a name: {done.stderr}", (done.returncode, "expected the name of a" in done.stderr),
              (USAGE, True))
    for option, ending in (("--storyboard", ".png"), ("--trace", ".csv"), ("--video", ".mp4"), ("--record", "below/.arec")):
        done = run(folder, THREE, option, ending)
        check(f"{option} {ending}: {done.stderr}", (done.returncode, "expected a name before ." in done.stderr), (USAGE, True))
    (folder / "file").write_text("")
    done = run(folder, THREE, "--frames", "file/below")
    check("a folder that cannot be made", (done.returncode, "cannot be made" in done.stderr), (NO_FILE, True))
    run(folder, "print(nothing)", "--frames", "unused")
    check("a program that is refused leaves a folder", (folder / "unused").exists(), False)


def check_record(folder):
    for options in ([], ["--camera", "eye=seen"]):
        done = run(folder, THREE, "--record", "r.arec", "--hash", *options)
        check("a recorded run", done.returncode, 0)
        replayed = subprocess.run([COMMAND, "replay", "r.arec"], cwd=folder, capture_output=True, text=True, timeout=60)
        check("the same output", replayed.stdout, "".join(done.stdout.splitlines(True)[:-1]))
        verified = subprocess.run([COMMAND, "replay", "--verify", "r.arec"], cwd=folder, capture_output=True, text=True, timeout=60)
        check(f"the same run: {verified.stderr}", (verified.returncode, verified.stdout),
              (0, "the same run, " + done.stdout.splitlines(True)[-1]))
    # One pixel that the program does not look at is another one: the hash shows it.
    drawn = run(folder, THREE, "--hash").stdout.splitlines()[-1]
    other = run(folder, THREE.replace("noise: 4.0", "noise: 4.0; seed: 2"), "--hash").stdout.splitlines()[-1]
    check("other noise, another hash", drawn == other, False)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        check_recorded(folder)
        check_options(folder)
        check_frames(folder)
        check_record(folder)


if __name__ == "__main__":
    main()
