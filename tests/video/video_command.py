#!/usr/bin/env python3
"""armlet run --video: video_command.py ARMLET [LIBRARY READ_VIDEO]. Pictures as PNG files need no OpenCV; videos are tried where
the library that writes them was built, READ_VIDEO being tests/video/read_video.cpp."""

import hashlib
import os
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import zlib
from pathlib import Path

ARMLET = Path(sys.argv[1]).resolve()
LIBRARY, READER = (Path(word).resolve() for word in sys.argv[2:4]) if len(sys.argv) > 3 else (None, None)
ROOT = Path(__file__).resolve().parent.parent.parent
WIDTH, HEIGHT, RATE = 768, 576, 25  # as apps/armlet/video has them

MOVES = "robot arm = robots.scara()\narm.moveJ(posJ(60deg, 40deg, 20mm, 0deg), time: 1.3s)\narm.moveJ(home(), time: 0.91s)\n"
COUNT, SECONDS = 57, "2.28"  # of the video: at 0, 0.04 ... 2.20 s, and the end at 2.21 s
# Of the pixels of three pictures of MOVES, at 0 s, 0.8 s and the end: the same on every machine and by every compiler.
PIXELS = {0: "e779638dca2da71f", 20: "9b643f525931e242", 56: "7c48ee294c6bdb05"}


def check(what, holds, *shown):
    if not holds:
        sys.exit("\n".join([f"video_command.py: {what}", *map(str, shown)]))


class Folder:
    def __init__(self, path):
        self.path = Path(path)

    def run(self, program, *options, exit=0, command=ARMLET, **more):
        (self.path / "program.rbt").write_text(program)
        done = subprocess.run([command, "run", "program.rbt", *options], cwd=self.path, capture_output=True, text=True, timeout=300, **more)
        check(f"{program}\n{options} ended with {done.returncode}", done.returncode == exit, done.stdout, done.stderr)
        return done

    def left(self):
        return sorted(p.name for p in self.path.iterdir() if p.name != "program.rbt")


def pixels(file):
    """Of a PNG file of RGB, 8 bits, not interlaced: width, height, rows without gaps."""
    data, at, packed = file.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            width, height = struct.unpack(">II", data[at + 8:at + 16])
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    raw, before, rows = zlib.decompress(packed), bytearray(3 * width), []
    for y in range(height):
        start = y * (3 * width + 1)
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + 3 * width])
        if kind == 2:
            row = bytearray((a + b) & 255 for a, b in zip(row, before))
        elif kind:
            for i in range(3 * width):
                left, up, corner = row[i - 3] if i >= 3 else 0, before[i], before[i - 3] if i >= 3 else 0
                if kind == 4:
                    p = left + up - corner
                    near = min((abs(p - left), 0, left), (abs(p - up), 1, up), (abs(p - corner), 2, corner))[2]
                row[i] = (row[i] + (left if kind == 1 else (left + up) // 2 if kind == 3 else near)) & 255
        rows.append(row)
        before = row
    return width, height, b"".join(rows)


def boxes(data):
    """Of an MP4 file or a part of one: kind and content of each box."""
    at = 0
    while at + 8 <= len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        head = 8
        if size == 1:
            size, head = struct.unpack(">Q", data[at + 8:at + 16])[0], 16
        check(f"a box of {size} bytes", size >= head)
        yield kind.decode("latin-1"), data[at + head:at + size]
        at += size


def box(data, *path):
    for kind in path:
        found = [content for name, content in boxes(data) if name == kind]
        check(f"no box {kind}", found)
        data = found[0]
    return data


def seconds_of(file):
    head = box(file.read_bytes(), "moov", "mvhd")
    scale, duration = struct.unpack(">II", head[12:20])
    return duration / scale


def codec_of(file):
    return box(file.read_bytes(), "moov", "trak", "mdia", "minf", "stbl", "stsd")[12:16].decode("latin-1")


def check_pictures():
    with tempfile.TemporaryDirectory() as name:
        folder = Folder(name)
        done = folder.run(MOVES, "--video", "made/frames/")
        files = sorted((folder.path / "made" / "frames").iterdir())
        check("one picture for each 40 ms and one of the end", [f.name for f in files] == [f"frame-{i:06}.png" for i in range(COUNT)], files)
        check("the summary says so", f"video in made/frames/: {COUNT} pictures, {SECONDS} s" in done.stderr, done.stderr)
        found = {}
        for number in PIXELS:
            width, height, rows = pixels(files[number])
            check("the size of pictures", (width, height) == (WIDTH, HEIGHT))
            found[number] = hashlib.sha256(rows).hexdigest()[:16]
        check("the pixels of pictures are the recorded ones", found == PIXELS, found)
        check("the arm is elsewhere in the middle than at the start", files[20].read_bytes() != files[0].read_bytes())
        # Again, into a folder that is there and has no slash; without a word.
        again = folder.run(MOVES, "--video", "made", "--quiet")
        check("the same pictures again", all((folder.path / "made" / f.name).read_bytes() == f.read_bytes() for f in files))
        check("--quiet says nothing", not again.stderr, again.stderr)
        # A shorter video in the same folder.
        done = folder.run("print(1)\n", "--video", "made/")
        check("pictures of another video are named", "made/frame-000001.png and later ones belong to another video" in done.stderr, done.stderr)
        check("a run that takes no time is one picture", "1 picture, 0.04 s" in done.stderr, done.stderr)
        # A run that fails is filmed up to there.
        failing = MOVES.replace("arm.moveJ(home", "var none: int[] = []\nprint(none[2])\narm.moveJ(home")
        folder.run(failing, "--video", "failed/", exit=70)
        check("a run that failed", len(list((folder.path / "failed").iterdir())) == 34)  # 1.3 s
        check("nothing else is left", folder.left() == ["failed", "made"], folder.left())


def check_same_runs():
    """A run that is filmed is the same run, to the bit."""
    with tempfile.TemporaryDirectory() as name:
        for example in ("02_table1_classic.rbt", "03_pick_place_modern.rbt"):
            file = ROOT / "examples" / example
            found = [subprocess.run([ARMLET, "run", file, "--hash", "--quiet", *more], cwd=name, capture_output=True, text=True, timeout=300)
                     for more in ([], ["--video", f"{name}/frames/"])]
            check(f"{example} is another run when it is filmed", found[0].returncode == 0 and found[0].stdout == found[1].stdout,
                  found[0].stdout[-200:], found[1].stdout[-200:], found[1].stderr)


def check_refusals():
    with tempfile.TemporaryDirectory() as name:
        folder = Folder(name)
        said = folder.run(MOVES, "--video", "out.gif", exit=64).stderr
        check("a GIF is refused, with what to do instead", all(w in said for w in ("256 colours", "--video out.mp4", "ffmpeg -i out.mp4 out.gif")), said)
        for wrong in ("out.avi", "out.webm", "out", "out.MP4"):
            said = folder.run(MOVES, "--video", wrong, exit=64).stderr
            check(f"{wrong} is refused", f'not "{wrong}"' in said and ".mp4 or .mkv" in said and "frames/" in said, said)
        said = folder.run("print(1) print(", "--video", "out.mp4", exit=65)
        (folder.path / "file").write_text("")
        said = folder.run("print(1)", "--video", "file/frames/", exit=66)
        check("a folder that cannot be made is known before the run", "file/frames/" in said.stderr and not said.stdout, said.stdout, said.stderr)
        check("nothing is left", folder.left() == ["file"], folder.left())
        # The command without its libraries.
        alone = folder.path / "bin" / "armlet"
        alone.parent.mkdir()
        shutil.copy(ARMLET, alone)
        done = folder.run("print(1)", "--video", "out.mp4", command=alone, exit=66)
        check("without the library the command says so before the run",
              all(w in done.stderr for w in ("libarmlet_video.so", "./dev build video", "libopencv-videoio-dev", "--video frames/")) and not done.stdout,
              done.stdout, done.stderr)
        folder.run("print(1)", "--video", "frames/", command=alone)
        check("and pictures are written all the same", folder.left() == ["bin", "file", "frames"], folder.left())


def check_video():
    check("the library is beside the command", (ARMLET.parent.parent / "lib" / LIBRARY.name).exists())
    with tempfile.TemporaryDirectory() as name:
        folder = Folder(name)
        folder.run(MOVES, "--video", "frames/")
        done = folder.run(MOVES, "--video", "run.mp4")
        check("the summary names the video", f"video in run.mp4: {COUNT} pictures, {SECONDS} s" in done.stderr, done.stderr)
        video = folder.path / "run.mp4"
        check("it is H.264", codec_of(video) == "avc1", codec_of(video))
        check("its duration", abs(seconds_of(video) - float(SECONDS)) < 0.041, seconds_of(video))
        folder.run(MOVES, "--video", "run.mkv", "--quiet")
        for file in ("run.mp4", "run.mkv"):
            read = subprocess.run([READER, folder.path / file, folder.path / "frames"], capture_output=True, text=True)
            check(f"{file} is read back", read.returncode == 0, read.stdout, read.stderr)
            pictures, width, height, rate, worst, moved = (float(word) for word in read.stdout.split())
            check(f"pictures, size and rate of {file}", (pictures, width, height, rate) == (COUNT, WIDTH, HEIGHT, RATE), read.stdout)
            check(f"each picture of {file} shows what the PNG of that number shows", worst < 12, worst)
            check("the arm is elsewhere in the middle than at the start", moved > 40, moved)
        # What was there before stays as it was: a disk that is full, a program that is rejected, a folder that is not there.
        before = video.read_bytes()
        def little_room():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))
        done = folder.run(MOVES, "--video", "run.mp4", exit=70, preexec_fn=little_room)
        check("a disk that is full", "the video run.mp4 cannot be written" in done.stderr and "kB are free" in done.stderr, done.stderr)
        folder.run("print(", "--video", "run.mp4", exit=65)
        done = folder.run("print(1)", "--video", "no/run.mp4", exit=66)
        check("a folder that is not there is known before the run", 'there is no folder "no/"' in done.stderr and not done.stdout, done.stderr)
        done = folder.run("print(1)", "--video", "run.mp4", exit=66, env=os.environ | {"OPENCV_VIDEOIO_PRIORITY_FFMPEG": "0"})
        check("an OpenCV without FFmpeg is known before the run", "FFmpeg" in done.stderr and not done.stdout, done.stderr)
        check("the video before is as it was", video.read_bytes() == before)
        folder.run("print(1)", "--video", "program.rbt.mp4", "--quiet")
        check("nothing else is left", folder.left() == ["frames", "program.rbt.mp4", "run.mkv", "run.mp4"], folder.left())


def check_interrupts():
    with tempfile.TemporaryDirectory() as name:
        folder = Folder(name)
        (folder.path / "program.rbt").write_text(MOVES.replace("0.91s", "900s") + "for (i in range(100000)) wait(1s)\n")
        # During the run: what was filmed until then is a whole video; during the drawing: nothing.
        for wait_for_drawing in (False, True):
            process = subprocess.Popen([ARMLET, "run", "program.rbt", "--video", "run.mp4", "--steps", "100000000", *([] if wait_for_drawing else ["--realtime"])],
                                       cwd=folder.path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            if wait_for_drawing:
                said = ""
                while "finished at" not in said:  # drawing comes after the summary
                    line = process.stderr.readline()
                    check("the drawing begins", line, said)
                    said += line
                time.sleep(0.5)
            else:
                time.sleep(2.5)
            process.send_signal(signal.SIGINT)
            out, said = process.communicate(timeout=120)
            check("Ctrl-C ends it with 130", process.returncode == 130, process.returncode, out, said)
            if wait_for_drawing:
                check("Ctrl-C while it is drawn leaves nothing", folder.left() == [], folder.left())
            else:
                check("Ctrl-C during the run leaves the video until there", folder.left() == ["run.mp4"], folder.left(), said)
                check("which is whole", 0.5 < seconds_of(folder.path / "run.mp4") < 10.0, seconds_of(folder.path / "run.mp4"))
                (folder.path / "run.mp4").unlink()


check_pictures()
check_same_runs()
check_refusals()
if LIBRARY is not None and LIBRARY.exists():
    check_video()
    check_interrupts()
    print("videos are as asked")
else:
    print("pictures of videos are as asked; videos themselves were not tried: libarmlet_video.so was not built (libopencv-videoio-dev)")
