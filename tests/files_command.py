#!/usr/bin/env python3
"""What the command reads and writes, and how it ends when that is not possible: files_command.py ARMLET."""

import os
import resource
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ARMLET = os.path.abspath(sys.argv[1])
MOVES = "moveJ(home())\nmoveJ('Syn', posJ([0.61, 0.94, 0.02, -0.33]), 2.0)\n"
RECORD = "record run every (100ms) { q: joints() }\nwait(1s)\nrun.save(%s)\n"
REJECTED, NO_FILE, FAILED, USAGE, STOPPED = 65, 66, 70, 64, 130


def run(folder, *arguments, **options):
    return subprocess.run([ARMLET, *arguments], cwd=folder, capture_output=True, text=True, timeout=60, **options)


def check(what, found, wanted):
    if found != wanted:
        sys.exit(f"{what}: {found!r} instead of {wanted!r}")


def names(folder):
    return sorted(os.listdir(folder))


def check_trace(folder):
    (folder / "p.rbt").write_text(MOVES)
    (folder / "bad.rbt").write_text("let = 3\n")
    (folder / "fails.rbt").write_text(MOVES + "print(1 / 0)\n")
    trace = folder / "t.csv"
    trace.write_text("old")
    for options, status in ((["bad.rbt"], REJECTED), (["none.rbt"], NO_FILE), (["p.rbt", "--robot", "r2d2"], USAGE)):
        check(f"status of {options}", run(folder, "run", *options, "--trace", "t.csv").returncode, status)
        check(f"the trace before, after {options}", trace.read_text(), "old")
    check("a run", run(folder, "run", "p.rbt", "--trace", "t.csv").returncode, 0)
    whole = trace.read_text()
    check("the end of a trace", whole.rstrip().split("\n")[-1].startswith("2.000000000,end,"), True)
    check("a run that fails", run(folder, "run", "fails.rbt", "--trace", "t.csv").returncode, FAILED)
    check("its trace is whole", trace.read_text().startswith(whole[:whole.index("2.000000000,end,")]), True)
    (folder / "p.csv").write_text(MOVES)
    os.symlink("p.csv", folder / "link.csv")
    for name in ("p.csv", "link.csv"):
        done = run(folder, "run", "p.csv", "--trace", name)
        check("a trace over the program", (done.returncode, (folder / "p.csv").read_text()), (USAGE, MOVES))
        check("its message", done.stderr, f"armlet: the trace {name} would take the place of p.csv\n")
    (folder / "uses.rbt").write_text('import "module.rbt" as m\n')
    (folder / "module.rbt").write_text("let a = 1\n")
    os.symlink("module.rbt", folder / "module.csv")
    check("a trace over a module", run(folder, "run", "uses.rbt", "--trace", "module.csv").returncode, USAGE)
    check("a trace where no folder is", run(folder, "run", "p.rbt", "--trace", "no/t.csv").returncode, NO_FILE)
    check("what is left", [n for n in names(folder) if n.startswith(".")], [])


def check_figures(folder):
    """Figures that a program does not save are left beside its trace."""
    (folder / "plots.rbt").write_text('figure("a"); plot([0, 1], [0, 1])\nfigure("b"); plot([0, 1], [1, 0])\nfigure("empty")\n')
    hint = '  2 figures not saved: savePlot("figures.svg") in the program saves them, --plots shows them here\n'
    done = run(folder, "run", "plots.rbt")
    check("how to see figures", done.stderr.endswith(hint), True)
    check("nothing is written", names(folder), ["plots.rbt"])
    check("figures that are shown", "not saved" in run(folder, "run", "--plots", "plots.rbt").stderr, False)
    done = run(folder, "run", "plots.rbt", "--trace", "run.jsonl")
    check("where figures are", (done.returncode, done.stderr.endswith("  2 figures in run.figures.svg\n")), (0, True))
    picture = (folder / "run.figures.svg").read_text()
    check("both are there", (">a<" in picture, ">b<" in picture), (True, True))
    run(folder, "run", "--quiet", "plots.rbt", "--trace", "run.jsonl")
    check("the same again", (folder / "run.figures.svg").read_text(), picture)
    (folder / "saves.rbt").write_text('figure("a"); plot([0, 1], [0, 1]); savePlot("a.svg")\nfigure("b"); plot([0, 1], [1, 0])\n')
    done = run(folder, "run", "saves.rbt", "--trace", "some.csv")
    check("what was not saved", done.stderr.endswith("  1 figure in some.figures.svg\n"), True)
    check("only that", ">a<" in (folder / "some.figures.svg").read_text(), False)
    (folder / "all.rbt").write_text('plot([0, 1], [0, 1]); savePlot("a.svg")\n')
    done = run(folder, "run", "all.rbt", "--trace", "all.csv")
    check("nothing to leave", ("figure" in done.stderr, (folder / "all.figures.svg").exists()), (False, False))
    (folder / "fails.rbt").write_text('plot([0, 1], [0, 1])\nprint(1 % 0)\n')
    check("a run that fails", run(folder, "run", "fails.rbt", "--trace", "f.csv").returncode, FAILED)
    check("leaves them too", (folder / "f.figures.svg").exists(), True)
    (folder / "no.figures.svg").mkdir()
    done = run(folder, "run", "plots.rbt", "--trace", "no.csv")
    check("figures that cannot be left", (done.returncode, "the figures no.figures.svg cannot be written" in done.stderr),
          (FAILED, True))


def check_full(folder):
    """A limit on the size of files stands for a full device."""
    (folder / "p.rbt").write_text(MOVES)
    (folder / "saves.rbt").write_text(RECORD % '"run.csv"')
    (folder / "t.csv").write_text("old")
    (folder / "run.csv").write_text("old")
    limit = {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (200, 200))}
    done = run(folder, "run", "--quiet", "p.rbt", "--trace", "t.csv", **limit)
    check("a trace that does not fit", (done.returncode, (folder / "t.csv").read_text()), (FAILED, "old"))
    check("its message", done.stderr, "armlet: the trace t.csv cannot be written: File too large; "
          "what was there before is as it was\n")
    done = run(folder, "run", "--quiet", "saves.rbt", **limit)
    check("a table that does not fit", (done.returncode, (folder / "run.csv").read_text()), (FAILED, "old"))
    check("its reason", "error R0626" in done.stderr and "File too large" in done.stderr, True)
    (folder / "ugly.rbt").write_text("print( 1 )\n" * 100)
    check("fmt of a file that does not fit", run(folder, "fmt", "ugly.rbt", **limit).returncode, NO_FILE)
    check("it stays", (folder / "ugly.rbt").read_text(), "print( 1 )\n" * 100)
    check("what is left", [n for n in names(folder) if n.startswith(".")], [])


def check_kinds(folder):
    (folder / "p.rbt").write_text(MOVES)
    for name in ("pipe.rbt", "pipe.csv", "pipe.urdf"):
        os.mkfifo(folder / name)
    (folder / "imports.rbt").write_text('import "pipe.rbt"\n')
    (folder / "reads.rbt").write_text('let r = urdf("pipe.urdf")\n')
    (folder / "saves.rbt").write_text(RECORD % '"pipe.csv"')
    for arguments, status in ((["run", "pipe.rbt"], NO_FILE), (["check", "pipe.rbt"], NO_FILE),
                              (["fmt", "pipe.rbt"], NO_FILE), (["robot", "pipe.urdf"], NO_FILE),
                              (["run", "p.rbt", "--world", "pipe.rbt"], NO_FILE),
                              (["run", "p.rbt", "--trace", "pipe.csv"], NO_FILE),
                              (["run", "imports.rbt"], REJECTED), (["run", "reads.rbt"], FAILED),
                              (["run", "saves.rbt"], FAILED)):
        done = run(folder, *arguments)
        check(f"{arguments}", (done.returncode, "it is a pipe, not a file" in done.stderr), (status, True))
    done = run(folder, "run", "--quiet", "/dev/stdin", input="print(1 + 1)\n")
    check("a program from standard input", (done.returncode, done.stdout), (0, "2\n"))


def check_names(folder):
    outside = folder / "outside"
    inside = folder / "inside"
    outside.mkdir()
    inside.mkdir()
    os.symlink("../outside/made.csv", inside / "dangling.csv")
    os.symlink("../outside", inside / "way")
    (outside / "module.rbt").write_text("let a = 1\n")
    for name in ("saves.rbt", ".bashrc", "run.csv.sh", "dangling.csv", "way/made.csv", "../made.csv"):
        program = RECORD % f'"{name}"'
        (inside / "saves.rbt").write_text(program)
        done = run(inside, "run", "saves.rbt")
        is_table = name.endswith(".csv")  # other endings are refused before the run
        check(f"saving {name}", (done.returncode, f"error {'R0626' if is_table else 'E0534'}" in done.stderr),
              (FAILED if is_table else REJECTED, True))
        check("the program", (inside / "saves.rbt").read_text(), program)
    (inside / "plots.rbt").write_text('plot([0, 1], [0, 1])\nsavePlot("dangling.svg")\n')
    os.symlink("../outside/made.svg", inside / "dangling.svg")
    check("a picture through a link", run(inside, "run", "plots.rbt").returncode, FAILED)
    (inside / "imports.rbt").write_text('import "way/module.rbt"\n')
    check("a module through a link", run(inside, "check", "imports.rbt").returncode, REJECTED)
    check("nothing was written", names(outside), ["module.rbt"])


def check_closed_output(folder):
    (folder / "long.rbt").write_text("for (i in range(10000000)) { print(i) }\n")
    with open(folder / "errors", "w+") as errors:
        process = subprocess.Popen([ARMLET, "run", "--trace", "t.csv", "long.rbt"], cwd=folder, stdout=subprocess.PIPE,
                                   stderr=errors)
        process.stdout.readline()
        process.stdout.close()
        check("a reader that leaves", process.wait(60), -signal.SIGPIPE)
        errors.seek(0)
        check("it is quiet", errors.read(), "")
    check("its trace", (folder / "t.csv").exists(), True)
    process = subprocess.Popen([ARMLET, "help", "--markdown"], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    process.stdout.close()
    check("a reader that never read", (process.wait(60), process.stderr.read()), (-signal.SIGPIPE, b""))
    process.stderr.close()
    # What is opened first must not become standard output.
    (folder / "p.rbt").write_text(MOVES + "print(1)\n")
    done = subprocess.run([ARMLET, "run", "--quiet", "--trace", "u.csv", "p.rbt"], cwd=folder, stderr=subprocess.PIPE,
                          timeout=60, preexec_fn=lambda: os.close(1))
    check("no standard output", (done.returncode, b"could not be written" in done.stderr), (FAILED, True))
    check("the trace begins with its heading", (folder / "u.csv").read_text().startswith("t [s],what,"), True)


def check_interrupts(folder):
    """Ctrl-C at any moment ends the process with its status, or before it has begun, and leaves no unfinished file."""
    (folder / "endless.rbt").write_text("try { while (true) { } } finally { while (true) { } }\n")
    delay, stopped = 0.0002, 0
    while stopped < 5:  # from before its first instruction until the program runs, however slow the machine is
        process = subprocess.Popen([ARMLET, "run", "--trace", "t.csv", "endless.rbt"], cwd=folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(delay)
        process.send_signal(signal.SIGINT)
        time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        status = process.wait(60)
        check(f"status {status} after {delay} s is one of the two", status in (STOPPED, -signal.SIGINT), True)
        stopped += status == STOPPED
        delay *= 1.3
    check("what is left", [n for n in names(folder) if n.startswith(".")], [])


def check_long_motion(folder):
    """Ctrl-C ends a motion of years, of which the trace gets a row every 10 ms; what was written is whole rows."""
    (folder / "years.rbt").write_text('speedC([0.0, 0.0, 0.0, 0.0, 0.0, 0.0], during: 1e9s)\n')
    process = subprocess.Popen([ARMLET, "run", "--trace", "t.csv", "years.rbt"], cwd=folder, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    while process.poll() is None and not any((folder / n).stat().st_size > 100_000 for n in names(folder)):
        time.sleep(0.05)
    process.send_signal(signal.SIGINT)
    try:
        status = process.wait(30)
    finally:
        process.kill()
    check("stopped in the middle of a long motion", status, STOPPED)
    lines = (folder / "t.csv").read_text().splitlines()
    check("the last row is whole", len(lines[-1].split(",")), len(lines[0].split(",")))


for part in (check_trace, check_figures, check_full, check_kinds, check_names, check_closed_output, check_interrupts,
             check_long_motion):
    with tempfile.TemporaryDirectory() as name:
        part(Path(name))
