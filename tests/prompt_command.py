#!/usr/bin/env python3
"""The prompt, through a pipe and in a terminal: prompt_command.py ARMLET."""

import os
import pty
import re
import select
import signal
import subprocess
import sys
import tempfile
import termios
import time
from pathlib import Path

ARMLET = str(Path(sys.argv[1]).resolve())
PATIENCE = 60.0  # s, for a slow machine


def check(what, holds, found=""):
    if not holds:
        sys.exit(f"{what}\n--- found:\n{found}")


def piped(text, *arguments, folder=None):
    return subprocess.run([ARMLET, *arguments], input=text, capture_output=True, text=True, timeout=PATIENCE, cwd=folder)


def check_pipe():
    done = piped("let a = 40mm\na * 2\nprint(a * 2)\nfn twice(x: double) -> double {\n  return 2 * x\n}\nprint(twice(3))\n")
    check("a pipe gets what the program prints and nothing else", done.stdout == "80 mm\n6.0\n" and done.stderr == "", done)
    check("status of a session without mistakes", done.returncode == 0, done)

    done = piped("let a = 1\nlet b = nowhere + 1\nprint(a)\n")
    check("a line that cannot be read changes nothing", done.stdout == "1\n" and "E02" in done.stderr, done)
    check("a session with a mistake ends with 70", done.returncode == 70, done)

    done = piped("var a = 1\na = 2; moveJ(posJ(10deg, 20deg, 50mm, 0deg), time: 1s); a = [1, 2][5]\nprint(a)\nprint(now())\n")
    check("an error leaves names and clock as they were", done.stdout == "1\n0 s\n" and "R06" in done.stderr, done)

    done = piped('let s = """\n  a\n    b\n  """\nprint(s)\n')
    check("a text over several lines is one entry", done.stdout == "a\n  b\n" and done.stderr == "", done)

    done = piped("let p = poseOf(cube)\n")
    check("a thing of the world is explained", 'write object("cube")' in done.stderr, done)


def check_classic():
    """The first program of the paper's style, line by line."""
    done = piped("double[] q = {0.6, 0.9, 0.1, 0};\nposJ p = new posJ(q);\nmoveJ('Syn', p, 2.0);\nprint(joints());\n")
    check("a program in the classic style", done.returncode == 0 and "posJ" in done.stdout or "deg" in done.stdout, done)


def check_commands():
    lines = [
        "let p = xyz(300mm, 120mm, 200mm)", "moveJ(p, time: 2s)", "print(now())", ":undo 2", ":redo", "print(now())",
        ":type p.x", ":units 90deg", ":where", ":nonsense", "?moveL", "??torque", ":explain E0401", ":undo x",
    ]
    done = piped("\n".join(lines) + "\n")
    out = done.stdout
    check("going back and forth", re.findall(r"^[0-9.]+ s$|^t = .*", out, re.M)[:4] ==
          ["2 s", "t = 0.00 s, robots, objects and names as before", "t = 2.00 s, done again", "2 s"], done)
    check("what was undone is named", "  moveJ(p, time: 2s)" in out, done)
    check(":type", re.search(r"^length$", out, re.M), done)
    check(":units", "90 deg" in out and "1.5707963" in out, done)
    check(":where", "joints (" in out and "hand at" in out, done)
    check("a command that does not exist", ":names" in done.stderr or ":help lists all" in done.stderr, done)
    check("?name is the page of a name", "moveL(" in out and "straight" in out, done)
    check("??word finds pages", re.search(r"^invDyn +", out, re.M), done)
    check(":explain", "E0401" in out, done)
    check("a number of lines that is none", '"x" is not a number from 1 on' in done.stderr, done)


def check_questions():
    def asked(*lines):
        return piped("\n".join(lines) + "\n")

    done = asked("help")
    check("help alone lists the commands", done.returncode == 0 and ":undo" in done.stdout and "??" in done.stdout, done)
    for line in ("help moveL", "help(moveL)", 'help("moveL")', "man moveL", "?moveL"):
        done = asked(line)
        check(f"{line} shows a page", done.returncode == 0 and done.stdout.startswith("moveL("), done)
    for name in ("print", "moveJ", "ikine"):
        done = asked(name)
        check(f"{name} alone says how it is called", done.returncode == 0 and f"it is called as {name}(...)" in done.stdout, done)
    done = asked("let help = 3mm", "help", "fn man() { print(7) }", "man()")
    check("names of the session come first", re.findall(r"^7$", done.stdout, re.M) and ":undo" not in done.stdout, done)
    done = asked("?speed")
    check("a setting is a summary", len(done.stdout.splitlines()) < 20 and "speed is a setting of" in done.stdout
          and re.search(r"\d+ more: \?\?speed all", done.stdout), done)
    done = asked("??speed all")
    check("all of them on request", len(done.stdout.splitlines()) > 20, done)
    done = asked("?object")
    check("a long page is short", len(done.stdout.splitlines()) < 16 and "more forms: ?object all" in done.stdout, done)
    done = asked("?object all")
    check("and whole on request", len(done.stdout.splitlines()) > 30, done)
    for words, name in (("inverse kinematics", "ikine"), ("jacob0", "jacobian"), ("trplot", "draw.arrow"), ("SE3", "posC")):
        done = asked("??" + words)
        check(f"??{words} finds {name}", done.stdout.startswith(name + " "), done)
    done = asked("??", "?nosuchthing", "??no page says this")
    check("questions without an answer", "such as ??inverse kinematics" in done.stderr and done.stderr.count("there is no page") == 2, done)


def check_going():
    lines = ["let a = 1", "moveJ(posJ(10deg, 20deg, 50mm, 0deg), time: 2s)", "print(now())", ":goto 1.5s", ":where", "print(9)", ":redo 2",
             ":goto 0.5s", ":undo 2", "print(now())", ":runs", "wait(4s)", ":goto 5s", ":goto soon", ":runs 1", ":goto 1s", ":runs 7"]
    with tempfile.TemporaryDirectory() as folder:
        done = piped("\n".join(lines) + "\n", "--record", "going.arec", folder=folder)
        out = done.stdout
        check("a time in the middle of a line", "t = 1.50 s, in [2]: moveJ(" in out and "joints (9 deg" in out, done)
        check("no line begins in the middle of another", "9\n" not in out and "[2] is under way at t = 1.50 s" in done.stderr, done)
        check("from there on", "t = 2.00 s, done again\n  moveJ(posJ(10deg, 20deg, 50mm, 0deg), time: 2s)\n  print(now())" in out, done)
        check("and back", "t = 0.00 s, robots, objects and names as before\n  let a = 1\n  moveJ(" in out, done)
        check("another line is another run", re.search(r"^0 s\n  1  to t = 2.00 s, 3 lines: print\(now", out, re.M), done)
        check("a time that was not reached", "The run has come to t = 4 s; there is no t = 5 s" in done.stderr, done)
        check("what is no time", "write :goto with a time" in done.stderr, done)
        check("a run that was left is taken up", "t = 2.00 s, behind [3]: print(now())" in out, done)
        check("a run that there is not", "there is no run 7; :runs lists" in done.stderr, done)

        replayed = subprocess.run([ARMLET, "replay", "going.arec"], capture_output=True, text=True, timeout=PATIENCE, cwd=folder)
        check("the record has what counts", replayed.stdout == "" and replayed.returncode == 0, replayed)

        lines = ["var n = 1", "n = 2; moveJ(posJ(10deg, 20deg, 50mm, 0deg), time: 2s)", "n = [1][3]", "print(n, now())", "wait(1s)", ":undo", "print(now())"]
        done = piped("\n".join(lines) + "\n", "--record", "kept.arec", folder=folder)
        replayed = subprocess.run([ARMLET, "replay", "kept.arec", "--quiet"], capture_output=True, text=True, timeout=PATIENCE, cwd=folder)
        check("the session once more, without what failed or was undone", replayed.stdout == "2 2 s\n2 s\n" and replayed.returncode == 0, replayed)
        verified = subprocess.run([ARMLET, "replay", "kept.arec", "--verify"], capture_output=True, text=True, timeout=PATIENCE, cwd=folder)
        check("event by event", verified.stdout.startswith("the same run") and verified.returncode == 0, verified)
        there = subprocess.run([ARMLET, "replay", "kept.arec", "--to", "1s"], capture_output=True, text=True, timeout=PATIENCE, cwd=folder)
        check("a time of it", "joints 5 deg, 55 deg" in there.stdout and "n: int = 2" in there.stdout, there)


def check_own_pages():
    """What was declared here has a page too."""
    lines = ["/// The middle of two lengths, on the way.", "fn middle(a: length, b: length) -> length { return (a + b) / 2 }",
             "/// Between two parts.", "let gap = 30mm", "?middle", "?gap", "?mvoeL", "?nothing at all"]
    done = piped("\n".join(lines) + "\n")
    check("a function of the session with its documentation",
          "fn middle(a: length, b: length) -> length\n  The middle of two lengths, on the way.\n" in done.stdout, done)
    check("a variable too", "gap: length\n  Between two parts.\n" in done.stdout, done)
    check("a name that is nearly right", "did you mean moveL?" in done.stderr, done)


def check_recording():
    """The session is left for `armlet replay` when the prompt is asked to, and not before."""
    with tempfile.TemporaryDirectory() as folder:
        lines = ["print(1)", ":record on", "print(2)", ":record off", ":record mine.arec", "moveJ(home() + [0.1, 0, 0, 0])", ":record a.txt",
                 ":record no/a.arec"]
        done = piped("\n".join(lines) + "\n", folder=folder)
        check("a file that is none", "write :record on" in done.stderr and "no/a.arec cannot be written" in done.stderr, done)
        check("nothing is left after off", os.listdir(folder) == [], os.listdir(folder))
        done = piped("\n".join(lines[:6]) + "\n", folder=folder)
        check("the one that was asked for", os.listdir(folder) == ["mine.arec"], os.listdir(folder))
        again = subprocess.run([ARMLET, "replay", "mine.arec", "--verify"], capture_output=True, text=True, timeout=PATIENCE, cwd=folder)
        check("all of it", again.stdout.startswith("the same run"), again)
        piped("\n".join(lines[:3]) + "\n", folder=folder)
        again = subprocess.run([ARMLET, "replay", "session.arec", "--quiet"], capture_output=True, text=True, timeout=PATIENCE, cwd=folder)
        check("from its first line on", again.stdout == "1\n2\n", again)


def check_files():
    with tempfile.TemporaryDirectory() as folder:
        done = piped("let a = 2\nlet b = a + missing\nprint(a)\n:save kept.rbt\n:save kept.txt\n", folder=folder)
        check("errors are left out of what is saved", Path(folder, "kept.rbt").read_text() == "let a = 2\nprint(a)\n", done)
        lines = "var n = 1\nn + 1\nlet xs = [4, 5]\nxs\nprint(xs)\nlet n = 9\nprint(n)\n:save asked.rbt\n"
        asked = piped(lines, folder=folder)
        check("questions are comments in what is saved", Path(folder, "asked.rbt").read_text() ==
              "var n = 1\n// n + 1\nlet xs = [4, 5]\n// xs\nprint(xs)\n// let n = 9\nprint(n)\n", asked)
        check("and are named", "[2], [4], [6]" in asked.stdout, asked)
        check("only programs are saved", "a program is a .rbt file" in done.stderr, done)
        done = piped(":load kept.rbt\nprint(a + 1)\n:load nothing.rbt\n", folder=folder)
        check("a file is loaded as if it were typed", done.stdout.startswith("2\n3\n"), done)
        run = subprocess.run([ARMLET, "run", "--quiet", "kept.rbt"], capture_output=True, text=True, cwd=folder, timeout=PATIENCE)
        check("what was saved runs", (run.returncode, run.stdout) == (0, "2\n"), run)


def check_examples():
    """A program that comes line by line prints what it prints as a file."""
    folder = Path(__file__).resolve().parent.parent / "examples"
    compared = 0
    for path in sorted([*folder.glob("*.rbt"), *folder.glob("figures/*.rbt")]):
        text = path.read_text()
        if re.search(r"^(record|lab)\b", text, re.M):
            continue  # it records what is behind it in its own text, or has functions that name what comes later
        whole = subprocess.run([ARMLET, "run", "--quiet", path.name], capture_output=True, text=True, timeout=PATIENCE, cwd=path.parent)
        lines = piped(text, folder=path.parent)
        check(f"{path.name} line by line", lines.stdout == whole.stdout and (lines.returncode == 0) == (whole.returncode == 0), lines)
        compared += 1
    check("there are examples", compared > 20, compared)


def check_messages():
    """An entry that fails gets the message of a file, but for what only a whole text shows: later entries may change its variables."""
    folder = Path(__file__).resolve().parent / "scripts" / "errors"
    others, compared = [], 0
    for path in sorted(folder.rglob("*.rbt"))[::6]:
        if "modules" in path.parts or re.search(r"^import|^// (run|exit|with|file|args|options)", path.read_text(), re.M):
            continue
        alone = subprocess.run([ARMLET, "run", "--quiet", path.name], capture_output=True, text=True, timeout=PATIENCE, cwd=path.parent)
        entered = piped(f":load {path.name}\n", folder=path.parent)
        shown = [re.sub(r" +$", "", text, flags=re.M) for text in (alone.stderr.replace(path.name, "[1]"), entered.stderr)]
        compared += 1
        if shown[0] != shown[1]:
            others.append((path.name, *shown))
    check("messages are compared", compared > 60, compared)
    check("messages of entries are those of files", len(others) <= compared // 25, others)


def check_interrupted_pipe():
    """Ctrl-C ends what comes through a pipe."""
    made = subprocess.Popen([ARMLET], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    made.stdin.write("print(1)\nwhile (true) { wait(1ms) }\nprint(2)\n")
    made.stdin.flush()
    check("lines run as they come", made.stdout.readline() == "1\n", made)
    time.sleep(0.3)
    made.send_signal(signal.SIGINT)
    out, err = made.communicate(timeout=PATIENCE)
    check("Ctrl-C stops the program and ends the command", (made.returncode, out) == (130, "") and "stopped" in err, (made.returncode, out, err))


class Terminal:
    """A prompt in a terminal of its own."""

    def __init__(self, home, term="xterm"):
        self.text = ""
        self.raw = ""
        self.pid, self.fd = pty.fork()
        if self.pid == 0:
            os.environ.update({"TERM": term, "HOME": home, "XDG_STATE_HOME": home})
            os.execv(ARMLET, [ARMLET])

    def type(self, keys):
        os.write(self.fd, keys.encode())

    def expect(self, pattern, what):
        """Reads on until the pattern appears in what has not been matched yet."""
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            found = re.search(pattern, self.text, re.S)
            if found:
                self.text = self.text[found.end():]
                return found
            if select.select([self.fd], [], [], 0.2)[0]:
                try:
                    piece = os.read(self.fd, 65536).decode(errors="replace")
                except OSError:
                    piece = ""
                if not piece:
                    break
                self.raw += piece
                self.text += re.sub(r"\x1b\[[0-9;?]*[A-Za-z]|\x1b[()][0-9A-Z]|[\x07\x08\x0e\x0f]", "", piece)
        sys.exit(f"{what}: {pattern!r} did not appear\n--- found:\n{self.text}")

    def end(self):
        last = ""
        end = time.monotonic() + PATIENCE
        again = 0.0
        while time.monotonic() < end:
            try:
                if time.monotonic() > again:  # a key that comes before the line is being edited stands in it
                    self.type("\x15\x04" if again > 0.0 else "\x04")
                    again = time.monotonic() + 1.0
                if select.select([self.fd], [], [], 0.05)[0]:
                    last += os.read(self.fd, 65536).decode(errors="replace")
            except OSError:
                pass
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid:
                return os.waitstatus_to_exitcode(status)
        os.kill(self.pid, signal.SIGKILL)
        sys.exit(f"Ctrl-D did not end the prompt\n--- last:\n{self.text}{last}")


def check_stopping(home):
    """Ctrl-C while lines run again, and SIGTERM while a line is edited."""
    slow = Terminal(home)
    slow.expect(r"rbt> ", "the prompt")
    slow.type("var n = 0\n")
    slow.type("for (i in range(30000000)) { n = (n + i) % 7919 }\n")
    slow.type("let seen = n\n")
    slow.type("print(\"there\", n == seen)\n")
    slow.expect(r"\nthere true", "a line that takes long")
    slow.type("let z = 1\n:undo\n")
    slow.expect(r":undo", "the request to go back")
    time.sleep(0.15)
    slow.type("\x03")
    found = slow.expect(r"stopped; all as it was|as before", "Ctrl-C while lines run again")
    check("Ctrl-C gives up going back", "stopped" in found.group(), slow.text)
    slow.type("print(\"still\", z)\n")
    slow.expect(r"\nstill 1", "all is as it was")
    slow.expect(r"rbt> ", "the prompt goes on")
    before = Terminal(home, "dumb")
    before.expect(r"rbt> ", "a prompt that edits nothing")
    plain = termios.tcgetattr(before.fd)[3]
    edited = termios.tcgetattr(slow.fd)[3]
    check("a line that is edited changes the terminal", edited & termios.ICANON == 0, edited)
    os.kill(slow.pid, signal.SIGTERM)
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end and termios.tcgetattr(slow.fd)[3] & termios.ICANON == 0:
        time.sleep(0.05)
    check("SIGTERM leaves the terminal as it was", termios.tcgetattr(slow.fd)[3] == plain, termios.tcgetattr(slow.fd))
    check("and ends the command", os.waitstatus_to_exitcode(os.waitpid(slow.pid, 0)[1]) == 130)
    before.end()


def check_motions(home):
    """What a class would do: fetch something, look, go back, go on."""
    arm = Terminal(home)
    arm.expect(r"rbt> ", "the prompt")
    arm.type("let c = object(\"cube\");\n")
    arm.type("moveJ(above(poseOf(c), 80mm), time: 2s)\n")
    arm.expect(r"\[t = 2\.00 s\] scara moveJ", "above the cube")
    arm.type("moveL(poseOf(c), speed: 200mm/s)\n")
    arm.expect(r"scara moveL", "at the cube")
    arm.type("grasp(c)\n")
    arm.expect(r"grasp\(c\).*rbt> ", "in the gripper")
    arm.type("moveJ(home(), time: 2s)\n")
    arm.expect(r"scara moveJ 2\.00 s, hand at (\([^)]*\))", "carried away")
    arm.type(":objects\n")
    away = arm.expect(r"cube +\(([^)]*)\) mm +held by scara", "the cube is in the gripper").group(1)
    arm.type(":undo\n")
    arm.expect(r"as before\s+moveJ\(home\(\)", "back to before the motion")
    arm.type(":objects\n")
    there = arm.expect(r"cube +\(([^)]*)\) mm +held by scara", "the cube is back, and still in the gripper").group(1)
    check("the cube went back with the gripper", there != away, (there, away))
    arm.type(":undo\n")
    arm.expect(r"as before\s+grasp\(c\)", "back to before the grasp")
    arm.type(":where\n")
    check("nothing is held", "holds" not in arm.expect(r"joints \(.*rbt> ", "where it is").group(), arm.text)
    arm.type(":redo 2\n")
    arm.expect(r"done again\s+grasp\(c\)\s+moveJ\(home\(\)", "both again")
    arm.type(":objects\n")
    check("the same as first", arm.expect(r"cube +\(([^)]*)\) mm +held by scara", "in the gripper").group(1) == away, arm.text)
    arm.type(":steps\n")
    arm.expect(r"2(\.0+)? s", "how the last move was planned")
    arm.type(":speed 1x\n")
    arm.expect(r"at 1 times", "the speed of the clock")
    arm.type("moveJ(home() + [0.8, 0, 0, 0], time: 1500ms)\n")
    shown = [arm.expect(r"t = (\d+\.\d+) s   scara \((.*?)\), hand at \(([^)]*)\)", "a line under the motion").groups() for _ in range(8)]
    check("time, joints and tool go on", all(a != b for a, b in zip(shown[0], shown[-1])), shown)
    arm.expect(r"scara moveJ 1\.50 s, hand at", "the end of the motion")
    arm.type("moveJ(home(), time: 20s)\n")
    arm.expect(r"t = \d+\.\d+ s   scara", "a long motion")
    begun = time.monotonic()
    arm.type("\x03")
    arm.expect(r"stopped; t = \d+\.\d+ s, all as it was before this line", "Ctrl-C in the middle of it")
    check("at once", time.monotonic() - begun < 10.0, begun)
    arm.type("figure(\"f\"); plot([0.0, 1.0, 2.0], [0.0, 1.0, 4.0])\n:plot\n")
    arm.expect(r"[\u2801-\u28ff]", "dots of braille")
    arm.type("let lost = 3 +* 4\n")
    arm.expect(r"error E\d{4}", "a mistake")
    check("colours where the terminal has them", "\x1b[" in arm.raw.split("let lost")[-1], arm.raw[-400:])
    check("Ctrl-D ends with 0", arm.end() == 0)


def check_terminal(home):
    terminal = Terminal(home)
    terminal.expect(r"Armlet [0-9.]+ +robot scara \(4 joints\).*:help lists commands", "the greeting")
    terminal.expect(r"rbt> ", "the prompt")
    terminal.type("above(xyz(30cm, 10cm, 10cm), 8cm).z\n")
    terminal.expect(r"180 mm +length", "the value of an expression with its type")
    terminal.type("ans * 2\n")
    terminal.expect(r"360 mm +length", "the last value is ans")
    terminal.type("let width = 4cm;\nwid\t\n")
    terminal.expect(r"40 mm +length", "Tab completes a name of the session")
    terminal.type(":\t\t")
    terminal.expect(r":help .*:undo .*:where", "Tab lists the commands")
    terminal.type("\x15?moveS\t\n")
    terminal.expect(r"moveSpline\(", "Tab completes the name of a page")
    terminal.type("if (width > 1cm) {\n")
    terminal.expect(r"\.\.\.> ", "a block goes on in the next line")
    terminal.type("print(\"wide\")\n}\n")
    terminal.expect(r"\nwide", "the block runs")
    terminal.type("moveJ('Sy\t")
    terminal.expect(r"moveJ\('Sy\s*n", "Tab completes the name of a planner")
    terminal.type("\x15moveJ(posJ(20deg, 30deg, 50mm, 0deg), time: 1s)\n")
    terminal.expect(r"\[t = 1\.00 s\] \S+ moveJ 1\.00 s, hand at", "a move is reported")
    terminal.type("quit\n")
    terminal.expect(r":quit or press Ctrl-D", "how to leave")
    terminal.type("lett x = 3\n")
    terminal.expect(r"error E\d{4}", "a mistake gets the message of a file")
    terminal.expect(r"rbt> ", "the prompt after a mistake")
    terminal.type("while (true) { wait(1ms) }\n")
    time.sleep(0.5)
    terminal.type("\x03")
    terminal.expect(r"stopped; t = 1\.00 s", "Ctrl-C stops what runs, and all is as it was")
    terminal.expect(r"rbt> ", "the prompt after Ctrl-C")
    terminal.type("half a li\x03")
    terminal.expect(r"\^C.*rbt> ", "Ctrl-C forgets what was typed")
    terminal.type("print(now())\n")
    terminal.expect(r"\n1 s", "the session goes on")
    terminal.type(":undo\n")
    terminal.expect(r"t = 1\.00 s", "the last line printed only")
    terminal.type("\x1b[A\x1b[A\n")
    terminal.expect(r"\n1 s", "the arrow key fetches an earlier line")
    terminal.expect(r"rbt> ", "the prompt after that")
    for home_key in ["\x1b[H", "\x1bOH", "\x1b[1~", "\x1b[7~", "\x1b[1;5H"]:
        for end_key in ["\x1b[F", "\x1bOF", "\x1b[4~", "\x1b[8~", "\x1b[1;5F"]:
            terminal.type(f"00{home_key}4{end_key}1\n")
            terminal.expect(r"\n4001 +int", f"{home_key!r} goes to the start, {end_key!r} to the end")
    for back, on in [("\x1b[1;5D", "\x1b[1;5C"), ("\x1b[1;3D", "\x1b[1;3C"), ("\x1bOd", "\x1bOc")]:
        terminal.type(f"20 + 30{back}{back}1{on}5\n")
        terminal.expect(r"\n1235 +int", f"{back!r} and {on!r} go by words")
    terminal.type("let half = 21\nhalf * 1\nnow()\nhal\x1b[5~\x1b[F00\n")
    terminal.expect(r"\n2100 +int", "Page Up finds the entry that begins like the line")
    terminal.type("\x1b[2~\x1b[15~\x1bOP7 * 6\n")
    terminal.expect(r"42 +int", "keys without a use here leave nothing")
    check("Ctrl-D ends with 0", terminal.end() == 0)

    again = Terminal(home)
    again.expect(r"rbt> ", "the prompt of the next session")
    again.type("\x1b[A")
    again.expect(r"7 \* 6", "lines of earlier sessions are kept")
    again.type("\x15")
    again.end()

    check_stopping(home)
    dumb = Terminal(home, "dumb")
    dumb.expect(r"rbt> ", "the prompt in a terminal without cursor keys")
    dumb.type("1 + 1\n")
    dumb.expect(r"2 +int", "a value there")
    dumb.type("let lost = 3 +* 4\n")
    dumb.expect(r"error E\d{4}.*rbt> ", "a mistake there")
    check("nothing that such a terminal does not know", "\x1b" not in dumb.raw, dumb.raw)
    check("Ctrl-D there", dumb.end() == 0)


check_pipe()
check_classic()
check_commands()
check_questions()
check_going()
check_own_pages()
check_recording()
check_files()
check_examples()
check_messages()
check_interrupted_pipe()
with tempfile.TemporaryDirectory() as home_folder:
    check_terminal(home_folder)
    check_motions(home_folder)
