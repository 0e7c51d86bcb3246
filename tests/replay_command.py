#!/usr/bin/env python3
"""Recorded runs are the same in another process, also stopped ones; bad records are refused: replay_command.py ARMLET."""

import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

COMMAND = Path(sys.argv[1]).resolve()
ROOT = Path(__file__).resolve().parent.parent
LATE = {"end_of_time.rbt"}  # three years, of which every 10 ms would be reported
FNV_OFFSET, FNV_PRIME = 0xCBF29CE484222325, 0x100000001B3


def armlet(folder, *words, timeout=120):
    return subprocess.run([COMMAND, *words], cwd=folder, capture_output=True, timeout=timeout)


def fail(message):
    sys.exit(f"replay_command.py: {message}")


def check(is_so, message):
    if not is_so:
        fail(message)


def programs(folder):
    """Copies, beside which they may write."""
    for source in ("examples", "tests/scripts/tasks"):
        copies = folder / source
        shutil.copytree(ROOT / source, copies)
        for path in sorted(copies.rglob("*.rbt")):
            if "modules" not in path.parts and path.name not in LATE:
                yield path


def check_programs(folder):
    """Each is recorded, and replayed where there is nothing."""
    ran = 0
    record = folder / "run.arec"
    for path in programs(folder):
        first = armlet(path.parent, "run", "--quiet", "--hash", "--steps", "2000000", "--record", record, path.name)
        if first.returncode not in (0, 70):
            continue
        ran += 1
        (folder / "empty").mkdir(exist_ok=True)
        same = armlet(folder / "empty", "replay", "--verify", record)
        check(same.returncode == 0, f"{path}: {same.stderr.decode()}")
        number = first.stdout.split()[-1]
        check(same.stdout == b"the same run, hash " + number + b"\n", f"{path}: {same.stdout} for {number}")
        again = armlet(folder / "empty", "replay", "--quiet", record)
        check(again.returncode == first.returncode, f"{path}: exit {again.returncode}, first {first.returncode}")
        check(again.stdout + b"hash " + number + b"\n" == first.stdout, f"{path}: other output")
        check(again.stderr == first.stderr, f"{path}: {again.stderr.decode()}")
        check(not any((folder / "empty").iterdir()), f"{path}: the replay has written files")
    check(ran > 40, f"only {ran} programs ran")


def check_interrupted(folder):
    """Ctrl-C at some moment, which the record keeps."""
    (folder / "spin.rbt").write_text("var n = 0\ntry { while (true) { n += 1 } } finally { print(n); moveJ(home()) }\n")
    (folder / "move.rbt").write_text("moveJ(home() + [1, 0, 0, 0], time: 20s)\n")
    for words in (["spin.rbt"], ["--realtime", "move.rbt"]):
        run = subprocess.Popen([COMMAND, "run", "--record", "run.arec", *words], cwd=folder, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE)
        time.sleep(0.5)
        run.send_signal(signal.SIGINT)
        first = run.communicate(timeout=60)
        check(run.returncode == 130, f"{words}: {first}")
        same = armlet(folder, "replay", "--verify", "run.arec")
        check(same.returncode == 0, f"{words}: {same.stderr.decode()}")
        again = armlet(folder, "replay", "--quiet", "run.arec")
        check(again.returncode == 130 and again.stdout == first[0], f"{words}: {again.stdout} for {first[0]}")


def with_sum(text):
    value = FNV_OFFSET
    for byte in text:
        value = (value ^ byte) * FNV_PRIME % 2**64
    return text + b"sum 16\n%016x\n" % value


def check_bad(folder):
    """Each is refused with what was expected, and nothing runs."""
    (folder / "p.rbt").write_text("print(1)\nlet h = home()\nwait(10s)\nmoveJ(h + [0.1, 0, 0, 0])\n")
    armlet(folder, "run", "--quiet", "--record", "p.arec", "p.rbt")
    whole = (folder / "p.arec").read_bytes()
    body = whole[:-24]
    check(with_sum(body) == whole, "the sum of a record is another one")
    cases = [
        (whole[:len(whole) // 2], 65, "cut short"),
        (whole.replace(b" 0.", b" 9.", 1), 65, "another version"),
        (whole.replace(b"print(1)", b"print(2)"), 65, "changed after it was written"),
        (b"print(1)\n", 65, "does not begin with `armlet-log`"),
        (b"", 65, "does not begin with `armlet-log`"),
        (with_sum(body.replace(b"\nlimits", b"\nlimets")), 65, "expected a known kind of record"),
        (with_sum(re.sub(rb"\nend [^\0]*", b"", body)[:-3]), 65, "expected"),
        (with_sum(body.replace(b"scara", b"scary")), 65, "scary"),
        (with_sum(body.replace(b"print(1)", b"print(x)")), 65, "x"),
        (with_sum(body.replace(b"print(1)", b"print(2)")), 70, "the same until t = 0 s"),
        (with_sum(body.replace(b"[0.1,", b"[0.2,")), 70, "the same until t = 10 s"),
    ]
    for content, status, words in cases:
        (folder / "bad.arec").write_bytes(content)
        done = armlet(folder, "replay", "--verify", "bad.arec")
        check(done.returncode == status and words in done.stderr.decode(), f"{words}: {done}")
    for words, status, says in [
        (["replay", "none.arec"], 66, "there is no such file"),
        (["replay", "--to", "99s", "p.arec"], 64, "there is no t = 99 s to go to"),
        (["replay", "--to", "soon", "p.arec"], 64, "such as 3.2s"),
        (["run", "--record", "p.txt", "p.rbt"], 64, "a record is an .arec file"),
        (["run", "--record", "no/p.arec", "p.rbt"], 66, "cannot be written"),
    ]:
        done = armlet(folder, *words)
        check(done.returncode == status and says in done.stderr.decode(), f"{words}: {done}")
    shown = armlet(folder, "replay", "--to", "250 ms", "p.arec").stdout.decode()
    check("t = 0.25 s\n" in shown and "robot scara" in shown and "line 3, waits for a time" in shown, shown)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        check_programs(folder)
        check_interrupted(folder)
        check_bad(folder)


if __name__ == "__main__":
    main()
