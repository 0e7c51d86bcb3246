#!/usr/bin/env python3
"""Compares the pictures of laboratories and the storyboard in docs/images with what their programs draw.

usage: check_pictures.py COMMAND [--write]

Each program runs with one line more, which saves the picture, or with --storyboard. A number after the file name, as in #3, means a program of a document.
--write puts the pictures into docs/images.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs" / "images"
FIGURES, STORYBOARD = "savePlot(FILE)", None  # the line that saves the picture
SCENE = "snapshot(FILE, width: 640, height: 480)"
CLOSE = (
    "camera shot { at: lookingAt(xyz(300mm, 20mm, 210mm), from: xyz(1800mm, -750mm, 1000mm)); size: [960, 480]; fov: 50deg }"
    " snapshot(FILE, from: shot)"
)
PICTURES = {
    "laboratories/laboratory_03.svg": ("examples/labs/03_workspace.rbt", FIGURES),
    "laboratories/laboratory_07.svg": ("examples/labs/07_singularity.rbt", FIGURES),
    "laboratories/laboratory_08.svg": ("docs/labs/08-trajectory-zoo.md#3", FIGURES),
    "laboratories/laboratory_09.svg": ("examples/labs/09_integration.rbt", FIGURES),
    "laboratories/laboratory_12.svg": ("examples/labs/12_straight_line.rbt", FIGURES),
    "laboratories/laboratory_13.svg": ("examples/figures/fig10_inverse_dynamics_payload.rbt", FIGURES),
    "laboratories/laboratory_14.svg": ("examples/figures/fig11_M_C_G_live.rbt", FIGURES),
    "laboratories/laboratory_15.svg": ("examples/labs/15_falling_arm.rbt", FIGURES),
    "laboratories/laboratory_16.svg": ("examples/labs/16_controllers.rbt", FIGURES),
    "laboratories/laboratory_17.svg": ("examples/labs/17_stick_slip.rbt", FIGURES),
    "laboratories/laboratory_18.png": ("examples/labs/18_see_the_cube.rbt", "eye.capture().save(FILE)"),
    "laboratories/laboratory_19.svg": ("examples/labs/19_visual_servoing.rbt", FIGURES),
    "cameras/sorting.png": ("examples/cameras/sort_by_sight.rbt", "snapshot(FILE)"),
    "../../examples/cameras/photograph.jpg": ("tests/cameras/photograph.rbt", "photo.save(FILE)"),
    "tutorial/move_an_arm.jpg": ("docs/tutorial/01-move-an-arm.md#1", SCENE),
    "tutorial/positions.jpg": ("docs/tutorial/02-positions.md#5", SCENE),
    "tutorial/grasping.jpg": ("docs/tutorial/03-objects-and-grasping.md#1", SCENE),
    "tutorial/around.jpg": ("docs/tutorial/04-why-it-refuses.md#9", SCENE),
    "tutorial/arc_and_line.svg": ("docs/tutorial/05-lines-and-paths.md#1", FIGURES),
    "tutorial/planners.svg": ("docs/tutorial/05-lines-and-paths.md#2", FIGURES),
    "tutorial/tray.jpg": ("docs/tutorial/06-functions-and-tests.md#1", SCENE),
    "tutorial/picture.png": ("docs/tutorial/08-the-eye.md#1", "picture.save(FILE)"),
    "tutorial/servo.svg": ("docs/tutorial/08-the-eye.md#2", FIGURES),
    "storyboard.png": ("examples/06_handover.rbt", STORYBOARD),
    "pick_and_place.jpg": ("README.md#1", CLOSE),
}


def text_of(program):
    """The text of a program in a file, or in a document."""
    file, _, number = program.partition("#")
    text = (ROOT / file).read_text(encoding="utf-8")
    return re.findall(r"```rbt\n(.*?)```", text, re.DOTALL)[int(number) - 1] if number else text


def drawn(command, picture, program, line):
    """The picture as its program draws it now."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / pathlib.Path(program.partition("#")[0]).with_suffix(".rbt").name
        saved = copy.parent / pathlib.Path(picture).name
        more = f'\n{line.replace("FILE", chr(34) + saved.name + chr(34))}\n' if line else ""
        copy.write_text(text_of(program) + more, encoding="utf-8")
        words = [] if line else ["--storyboard", str(saved)]
        run = subprocess.run([command, "run", str(copy), *words], capture_output=True, text=True)
        if run.returncode != 0 or not saved.exists():
            sys.exit(f"{program} drew nothing:\n{run.stdout}{run.stderr}")
        return saved.read_bytes()


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    stale = []
    for picture, (program, line) in PICTURES.items():
        drawing = drawn(str(pathlib.Path(sys.argv[1]).resolve()), picture, program, line)
        place = IMAGES / picture
        if sys.argv[2:] == ["--write"]:
            place.write_bytes(drawing)
        elif not place.exists() or place.read_bytes() != drawing:
            stale.append(f"docs/images/{picture} is not what {program} draws")
    if stale:
        sys.exit("\n".join(stale) + "\nrun ./dev generate docs")
    print(f"pictures: {len(PICTURES)} as their programs draw them")


if __name__ == "__main__":
    main()
