#!/usr/bin/env python3
"""What `armlet fmt` does to files: fmt_command.py ARMLET."""

import os
import stat
import subprocess
import sys
import tempfile
from pathlib import Path

UGLY = "let  a=1 // one\nif(a>0){print( a )}\n"
NEAT = "let a = 1  // one\nif (a > 0) { print(a) }\n"
BROKEN = "let = 3\n"


def fmt(*arguments, text=""):
    return subprocess.run([sys.argv[1], "fmt", *arguments], input=text, capture_output=True, text=True, timeout=60)


def check(what, found, wanted):
    if found != wanted:
        sys.exit(f"{what}: {found!r} instead of {wanted!r}")


def check_input():
    done = fmt("-", text=UGLY)
    check("laid out from standard input", (done.returncode, done.stdout, done.stderr), (0, NEAT, ""))
    done = fmt("-", text=BROKEN)
    check("status of broken input", (done.returncode, done.stdout), (65, ""))
    check("message about broken input", "error E" in done.stderr, True)


def check_files(folder):
    ugly, neat, broken = (folder / name for name in ("ugly.rbt", "neat.rbt", "broken.rbt"))
    ugly.write_text(UGLY)
    neat.write_text(NEAT)
    broken.write_text(BROKEN)
    ugly.chmod(0o640)
    link = folder / "link.rbt"
    link.symlink_to(ugly)
    done = fmt("--check", str(ugly), str(neat))
    check("--check names what would change", (done.returncode, done.stdout), (1, f"{ugly}\n"))
    check("--check changes nothing", ugly.read_text(), UGLY)
    before = neat.stat()
    done = fmt(str(link), str(neat), str(broken), str(folder / "missing.rbt"))
    check("status of the worst file", done.returncode, 66)
    check("file behind a link", (ugly.read_text(), link.is_symlink()), (NEAT, True))
    check("permissions", stat.S_IMODE(ugly.stat().st_mode), 0o640)
    check("a neat file is not written", (neat.stat().st_ino, neat.stat().st_mtime_ns),
          (before.st_ino, before.st_mtime_ns))
    check("a broken file stays", broken.read_text(), BROKEN)
    check("only broken", fmt(str(broken)).returncode, 65)
    check("nothing is left behind", sorted(os.listdir(folder)), ["broken.rbt", "link.rbt", "neat.rbt", "ugly.rbt"])
    check("all neat", fmt("--check", str(ugly), str(neat)).returncode, 0)
    check("no file named", fmt().returncode, 64)


check_input()
with tempfile.TemporaryDirectory() as name:
    check_files(Path(name))
