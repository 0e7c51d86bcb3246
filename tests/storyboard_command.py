#!/usr/bin/env python3
"""Pictures of the cell in files: storyboard_command.py ARMLET. `snapshot` and `armlet run --storyboard`."""

import subprocess
import sys
import tempfile
from pathlib import Path

ARMLET = Path(sys.argv[1]).resolve()
WIDTH, HEIGHT, GAP, LABEL = 480, 360, 12, 34  # as apps/armlet/storyboard has them


def check(what, holds):
    if not holds:
        sys.exit(f"storyboard_command.py: {what}")


class Folder:
    def __init__(self, path):
        self.path = Path(path)

    def run(self, program, *options, exit=0):
        (self.path / "program.rbt").write_text(program)
        done = subprocess.run([ARMLET, "run", "program.rbt", *options], cwd=self.path, capture_output=True, text=True, timeout=300)
        check(f"{program}\nended with {done.returncode}\n{done.stdout}{done.stderr}", done.returncode == exit)
        return done

    def size(self, name):
        """Width and height, read by the language itself."""
        out = self.run(f'let img = loadImage("{name}"); print(img.width, img.height)', "--quiet").stdout
        return tuple(int(word) for word in out.split())

    def look(self, program):
        return self.run(program, "--quiet").stdout.split()


MOVES = 'robot arm = robots.scara()\n' + "".join(f"arm.moveJ(posJ({10 * k}deg, {15 * k}deg, 20mm, 0deg))\n" for k in range(1, 8))

with tempfile.TemporaryDirectory() as name:
    folder = Folder(name)

    # One picture for each of seven moves, in four columns and two rows.
    folder.run(MOVES, "--storyboard", "sheet.png")
    check("the size of a sheet of seven", folder.size("sheet.png") == (GAP + 4 * (WIDTH + GAP), GAP + 2 * (HEIGHT + LABEL + GAP)))
    first = (folder.path / "sheet.png").read_bytes()
    folder.run(MOVES, "--storyboard", "sheet.png", "--quiet")
    check("the same sheet again", (folder.path / "sheet.png").read_bytes() == first)
    # Pictures differ where the arm does; below each is a label; the last fields are white.
    cut = f'let img = loadImage("sheet.png")\nfn tile(i: int) -> image {{ let x = {GAP} + i % 4 * {WIDTH + GAP}; let y = {GAP} + i / 4 * {HEIGHT + LABEL + GAP}; ' \
          f'return img[x:x + {WIDTH}, y:y + {HEIGHT + LABEL}] }}\n'
    out = folder.look(cut + f'print(tile(0) == tile(1), tile(1) == tile(2), min(matrix(gray(tile(0)[0:{WIDTH}, {HEIGHT}:{HEIGHT + LABEL}]))) < 100, min(matrix(gray(tile(7)))))')
    check(f"pictures and labels: {out}", out[:3] == ["false", "false", "true"] and float(out[3]) == 255)

    # A program without moves, one that fails behind its second move, more moves than a sheet has room for.
    folder.run("print(1)", "--storyboard", "none.png")
    check("a sheet without moves", folder.size("none.png")[0] == GAP + WIDTH + GAP)
    folder.run(MOVES.replace("arm.moveJ(posJ(30deg", "var none: int[] = []\nprint(none[2])\narm.moveJ(posJ(30deg", 1), "--storyboard", "failed.png", exit=70)
    check("a sheet of a run that failed", folder.size("failed.png") == (GAP + 2 * (WIDTH + GAP), GAP + HEIGHT + LABEL + GAP))
    done = folder.run("robot arm = robots.scara()\nfor (i in range(150)) arm.moveJ(posJ(1deg * (i % 7), 0deg, 0mm, 0deg))", "--storyboard", "many.png")
    check(f"some of many moves: {done.stderr}", "38 of 150 moves, every 4th" in done.stdout + done.stderr)
    done = folder.run("print(1)", "--storyboard", "sheet.jpg", exit=64)
    check(f"another ending: {done.stderr}", 'a storyboard is a .png file, not "sheet.jpg"' in done.stdout + done.stderr)

    # Pictures that the program takes.
    folder.run('robot arm = robots.puma560()\nsnapshot("cell")\nsnapshot("small.jpg", width: 64, height: 48)\n'
               'camera eye { at: lookingAt(xyz(400mm, 0mm, 0mm), from: xyz(400mm, -300mm, 900mm)); size: [120, 90]; noise: 20.0 }\nsnapshot("seen.png", from: eye)')
    check("the sizes of snapshots", [folder.size(f) for f in ("cell.png", "small.jpg", "seen.png")] == [(960, 720), (64, 48), (120, 90)])
    out = folder.look('camera eye { at: lookingAt(xyz(400mm, 0mm, 0mm), from: xyz(400mm, -300mm, 900mm)); size: [120, 90]; noise: 20.0 }\n'
                      'let before = eye.capture()\nsnapshot("seen.png", from: eye)\nlet seen = loadImage("seen.png")\n'
                      'camera same { at: lookingAt(xyz(400mm, 0mm, 0mm), from: xyz(400mm, -300mm, 900mm)); size: [120, 90] }\nprint(seen == same.capture(), seen == before)')
    check(f"a snapshot is without noise: {out}", out == ["true", "false"])
    for program, words in (('snapshot("cell.gif")', ".png"), ('snapshot("cell", width: 5000)', "16 to 2048"), ('snapshot("/nowhere/cell.png")', "nowhere")):
        done = subprocess.run([ARMLET, "run", "-"], input=program, cwd=folder.path, capture_output=True, text=True, timeout=60)
        check(f"{program}: {done.stdout}{done.stderr}", done.returncode != 0 and words in done.stdout + done.stderr)
print("storyboards and snapshots are as asked")
