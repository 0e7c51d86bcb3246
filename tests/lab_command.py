#!/usr/bin/env python3
"""armlet lab --inputs: laboratories are played without a page, identically each time, and bad scripts are refused:
lab_command.py ARMLET."""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

COMMAND = Path(sys.argv[1]).resolve()
ROOT = Path(__file__).resolve().parent.parent
FIGURES = ROOT / "examples" / "figures"
LABORATORIES = ROOT / "examples" / "labs"
MOST_LINES = 70

LAB = """robot arm = robots.scara()
lab cell {
    sliders hand(of: arm, as: "x y z")
    field height(50mm, range: [0mm, 150mm])
    field pieces(3)
    button lift("Lift", fn() { arm.moveJ(posJ(0deg, 60deg, cell.height, 0deg), time: 1s) })
    button far("Far", fn() { arm.moveL(xyz(2m, 0m, 0m)) })
    plot high(fn() => cell.height)
}
"""

# A script, the exit status, and what is said on standard error.
REFUSED = [
    ('{"t": 1, "press": "lift"', 65, ":1: this is no JSON object"),
    ("[1]", 65, ":1: an input is an object"),
    ('{"press": "lift"}', 65, ":1: `t` is missing"),
    ('{"t": "soon", "press": "lift"}', 65, ":1: `t` takes numbers, not \"soon\""),
    ('{"t": -1, "press": "lift"}', 65, ":1: `t` lies between 0 s and 100 years, not at -1 s"),
    ('{"t": 1e300, "press": "lift"}', 65, ":1: `t` lies between"),
    ('{"t": 2, "press": "lift"}\n\n{"t": 1, "press": "lift"}', 65, ":3: time goes back from 2 s to 1 s"),
    ('{"t": 1}', 65, ":1: an input has one of"),
    ('{"t": 1, "press": 3}', 65, ":1: `press` is a text, not 3"),
    ('{"t": 1, "press": "lift", "vlaue": 3}', 65, ":1: there is no `vlaue` here; such an input has `t`, `press`"),
    ('{"t": 1, "set": "height"}', 65, ":1: `value` is missing"),
    ('{"t": 1, "set": "height", "value": null}', 65, ":1: `value` is a number, a text, true or false, not null"),
    ('{"t": 1, "joints": "arm", "values": [1, "x"]}', 65, ":1: `values` takes numbers, not \"x\""),
    ('{"t": 1, "joints": "arm", "values": 1}', 65, ":1: `values` is a list, not 1"),
    ('{"t": 1, "press": "lfit"}', 70, ":1: `cell` has no button `lfit`; it has `lift`, `far`"),
    ('{"t": 1, "set": "height", "value": 0.2}', 70, ":1: The field `height` goes from 0 mm to 150 mm; 200 mm lies"),
    ('{"t": 1, "set": "height", "value": true}', 70, ":1: The field `height` takes a length, not true"),
    ('{"t": 1, "set": "pieces", "value": 2.5}', 70, ":1: The field `pieces` takes a whole number, not 2.5"),
    ('{"t": 1, "joints": "left", "values": [0, 0, 0, 0]}', 70, ":1: There is no robot `left`; the cell has `arm`"),
    ('{"t": 1, "joints": "arm", "values": [0, 0, 0]}', 70, ":1: `arm` has 4 joints; 3 values were given"),
    ('{"t": 1, "joints": "arm", "values": [0, 0, 5, 0]}', 70, ":1: `arm`: joint 3 would slide to 5000 mm"),
    ('{"t": 1, "hand": "hand", "values": [5, 0, 0.3]}', 70, ":1: "),
    ('{"t": 1, "show": "height"}', 70, ":1: `cell` has no plot, table or changing text `height`"),
    ('{"t": 1, "press": "lift"}\n{"t": 1.5, "joints": "arm", "values": [0, 0, 0, 0]}', 70, ":2: `arm` is moving"),
    ('{"t": 1, "press": "far"}', 70, "error R0601: out of reach"),
]


def lab(folder, program, script, *words):
    (folder / "cell.rbt").write_text(program)
    (folder / "inputs.jsonl").write_text(script)
    return armlet(folder, "lab", "cell.rbt", "--inputs", "inputs.jsonl", *words)


def armlet(folder, *words):
    return subprocess.run([COMMAND, *words], cwd=folder, capture_output=True, text=True, timeout=120)


def check(is_so, message):
    if not is_so:
        sys.exit(f"lab_command.py: {message}")


def check_refused(folder):
    for script, status, message in REFUSED:
        ran = lab(folder, LAB, script + "\n")
        check(ran.returncode == status, f"{script}: exit {ran.returncode}: {ran.stderr}")
        check(message in ran.stderr, f"{script}: {ran.stderr}")
    missing = armlet(folder, "lab", "cell.rbt", "--inputs", "nothing.jsonl")
    check(missing.returncode == 66, f"a missing script: exit {missing.returncode}")


def check_played(folder):
    """The same inputs give the same run, which its record gives once more; other inputs give another one."""
    script = '# lifts\n{"t": 0.5, "set": "height", "value": 0.1}\n{"t": 1, "press": "lift"}\n{"t": 1, "show": "high"}\n'
    first = lab(folder, LAB, script, "--quiet", "--hash", "--record", "run.arec")
    check(first.returncode == 0 and first.stderr == "", f"exit {first.returncode}: {first.stderr}")
    check(first.stdout.startswith("high = 0.1\nhash "), first.stdout)
    check(lab(folder, LAB, script, "--quiet", "--hash").stdout == first.stdout, "the same inputs give another run")
    again = armlet(folder, "replay", "--verify", "run.arec")
    check(again.returncode == 0, again.stderr)
    check(again.stdout.split()[-1] == first.stdout.split()[-1], f"{again.stdout} for {first.stdout}")
    other = lab(folder, LAB, script.replace("0.1}", "0.09}"), "--quiet", "--hash")
    check(other.stdout.split()[-1] != first.stdout.split()[-1], "other inputs give the same run")
    plain = armlet(folder, "run", "--quiet", "--hash", "cell.rbt")
    check(plain.returncode == 0, f"armlet run of a laboratory: {plain.stderr}")


def check_variables(folder):
    """Lambdas of rows read variables as they are when they are asked; lambdas inside of them copy them then."""
    program = """var parts = 0
fn count() -> int => parts
fn addTen() { parts += 10 }
lab l {
    plot a(fn() => parts)
    plot b(fn() => count())
    text c(fn() => f"{[1].map(fn(x) => x + parts)}")
    button more("More", fn() { addTen() })
}
every (1s) { parts += 1 }
wait(5s)
"""
    shown = '{"t": 4.5, "show": "a"}\n{"t": 4.5, "show": "b"}\n{"t": 4.5, "show": "c"}\n'
    ran = lab(folder, program, shown, "--quiet")
    check(ran.stdout == "a = 5\nb = 5\nc = [6]\n", ran.stdout + ran.stderr)
    ran = lab(folder, program, '{"t": 2.5, "press": "more"}\n' + shown, "--quiet")
    check(ran.stdout == "a = 15\nb = 15\nc = [16]\n", ran.stdout + ran.stderr)


EYE = """robot arm = robots.scara()
camera eye { on: arm; at: xyz(z: 20mm); size: [160, 120]; fov: 60deg; noise: 2.0 }
object card { shape: box(80mm, 60mm, 5mm); at: xyz(450mm, 120mm, 2.5mm); color: "white"; fixed: true }
var found = [10, 20; 30.5, 40]
lab cell {
    image photo(fn() => gray(eye.capture()))
    view plain(of: eye, wanted: [5, 6;])
    view marked(of: eye, overlay: fn() => found)
    view truth(of: eye, overlay: "truth")
    view broken(of: eye, overlay: fn() => [1, 2, 3;])
    image lost(fn() => eye.capture()[0:0, 0:0])
}
arm.moveJ(arm.ikine(xyz(450mm, 120mm, 260mm)), time: 1s)
for (i in range(3)) { let img = eye.capture(); print(img[80, 60].r, img[10, 10].g); wait(500ms) }
"""


def check_pictures(folder):
    """Cameras say in words and numbers what they show, and the program sees what it would have seen."""
    shows = ["photo", "plain", "marked", "truth", "broken"]
    script = "".join(f'{{"t": {t}, "show": "{each}"}}\n' for t in (1.2, 2) for each in shows)
    ran = lab(folder, EYE, script, "--quiet", "--hash")
    check(ran.returncode == 0 and ran.stderr == "", f"exit {ran.returncode}: {ran.stderr}")
    told = ran.stdout.splitlines()
    check("photo = image 160 x 120, grey" in told, ran.stdout)
    check("plain = image 160 x 120, RGB; 1 wanted [5, 6]" in told, ran.stdout)
    check("marked = image 160 x 120, RGB; 2 features [10, 20; 30.5, 40]" in told, ran.stdout)
    check("truth = image 160 x 120, RGB; 4 corners of card [" in ran.stdout, ran.stdout)
    check("broken = image 160 x 120, RGB; no features: " in ran.stdout and "1 x 3" in ran.stdout, ran.stdout)
    own = [line for line in told if "=" not in line]
    plain = armlet(folder, "run", "--quiet", "--hash", "cell.rbt")
    check(plain.stdout.splitlines() == own, f"{plain.stdout} for {own}")
    # A row whose function fails says why, as on the page; the run and the rows after it go on.
    lost = lab(folder, EYE, '{"t": 2, "show": "lost"}\n{"t": 2, "show": "photo"}\n', "--quiet")
    check(lost.returncode == 0 and lost.stderr == "", f"exit {lost.returncode}: {lost.stderr}")
    check("lost shows nothing: [0:0, 0:0] is no part of a picture" in lost.stdout, lost.stdout)
    check("photo = image 160 x 120, grey" in lost.stdout, lost.stdout)


def check_figures(folder):
    """Each figure and laboratory with a `lab` block has inputs beside it, which say in comments what they show."""
    played = 0
    for program in sorted([*FIGURES.rglob("*.rbt"), *LABORATORIES.glob("*.rbt")]):
        text = program.read_text()
        if "\nlab " not in text:
            continue
        script = program.with_suffix(".jsonl")
        check(script.exists(), f"{program.name} has a `lab` block and no {script.name}")
        lines = [line for line in text.splitlines() if line.strip() and not line.startswith("//")]
        check(len(lines) < MOST_LINES, f"{program.name} has {len(lines)} lines")
        ran = armlet(folder, "lab", program, "--inputs", script, "--quiet")
        check(ran.returncode == 0, f"{program.name}: exit {ran.returncode}: {ran.stderr}")
        wanted = [line[10:] for line in script.read_text().splitlines() if line.startswith("# expect: ")]
        for line in wanted:
            check(line in ran.stdout.splitlines(), f"{program.name}: no line `{line}` in\n{ran.stdout}")
        check(len(wanted) > 0, f"{script.name} expects nothing")
        played += 1
    check(played >= 12, f"{played} figures and laboratories were played")


def check_photograph(folder):
    """The name of a photograph is given in the laboratory; one that is not there is said to be missing."""
    for ending in ("rbt", "jpg"):
        shutil.copy(ROOT / "examples" / "cameras" / f"photograph.{ending}", folder)
    shutil.copy(folder / "photograph.jpg", folder / "mine.jpg")
    program = folder / "photograph.rbt"
    for file, exit_code in (("mine.jpg", 0), ("missing.jpg", 70)):
        script = folder / "script.jsonl"
        script.write_text(f'{{"t": 0, "set": "file", "value": "{file}"}}\n{{"t": 0, "press": "again"}}\n')
        ran = armlet(folder, "lab", program, "--inputs", script, "--quiet")
        check(ran.returncode == exit_code, f"{file}: exit {ran.returncode}: {ran.stderr}")
        if exit_code == 0:
            first, *found = ran.stdout.splitlines()[:4]
            check(ran.stdout.splitlines()[4:] == [first.replace("photograph", "mine"), *found], ran.stdout)
        else:
            check("missing.jpg" in ran.stderr, ran.stderr)


def check_missing(folder):
    """The command without the program of laboratories beside it says what is missing."""
    alone = folder / "alone"
    alone.mkdir()
    shutil.copy(COMMAND, alone / "armlet")
    done = subprocess.run([alone / "armlet", "lab", "--demo"], capture_output=True, text=True, timeout=60)
    check(done.returncode == 66 and "armlet-lab, which cannot be started" in done.stderr and "./dev build" in done.stderr,
          f"without armlet-lab: exit {done.returncode}: {done.stderr}")


with tempfile.TemporaryDirectory() as name:
    check_missing(Path(name))
    check_refused(Path(name))
    check_played(Path(name))
    check_variables(Path(name))
    check_pictures(Path(name))
    check_figures(Path(name))
    check_photograph(Path(name))
