#!/usr/bin/env python3
"""Serves laboratories and behaves badly at them: whatever comes, the laboratory goes on and sends the other pages the right messages.

Usage: server_command.py ARMLET
"""

import base64
import hashlib
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from urllib.parse import urlsplit

sys.path.insert(0, str(Path(__file__).resolve().parent))
from socket_client import BINARY, CLOSE, PING, TEXT, Page, Refused, Rows, get, http, is_message

PROGRAM = """let far = 30deg
moveJ(posJ(far, 30deg, 10mm, 0deg), time: 1s)
moveJ(posJ(0deg, 0deg, 0mm, 0deg), time: 1s)
"""


class Lab:
    """armlet lab as a process, ended by Ctrl-C."""

    def __init__(self, armlet, *arguments, errors="", environment=None, opens=False):
        """errors: what it has to say on its standard error; nothing otherwise."""
        begun = time.monotonic()
        self.errors = errors
        self.process = subprocess.Popen([*([armlet] if isinstance(armlet, str) else armlet), "lab", *arguments, *([] if opens else ["--no-open"])], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True, env={**os.environ, **(environment or {})})
        self.address = self.process.stdout.readline().strip()
        self.seconds = time.monotonic() - begun

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGINT)
        status = self.process.wait(timeout=60)
        errors = self.process.stderr.read()
        self.process.stdout.close()
        self.process.stderr.close()
        assert status == 0 and self.errors in errors and (self.errors or not errors), (status, errors)

    def memory(self, what="VmRSS"):
        """MB that the process holds at the moment; with "VmHWM", that it ever held."""
        for line in Path(f"/proc/{self.process.pid}/status").read_text().splitlines():
            if line.startswith(what):
                return int(line.split()[1]) / 1024
        return 0


def greet(address, **how):
    page = Page(address, **how)
    page.number = page.ask(type="hello", protocol=1)["page"]
    return page


def take_control(page):
    """Waits until the page has the control: those before it are noticed to have gone after a moment."""
    page.send(type="take")
    page.until(lambda m: is_message(m, "control", holder=page.number))


def run_text(page, text, version, seconds=60):
    """Sends a text and waits for the end of its run."""
    page.send(type="text", text=text, version=version)
    return page.until(lambda m: is_message(m, "run", text_version=version) and m["state"] != "running", seconds)[0]


def goes_on(address):
    """A new page can connect, and receives the whole run."""
    page = greet(address)
    run, seen = page.until(lambda m: is_message(m, "run") and m["state"] != "running")
    assert any(isinstance(each, Rows) and each.count for each in seen)
    page.close()
    return run


def refused(call):
    try:
        page = call()
    except (Refused, ConnectionError, socket.timeout):
        return True
    page.close()
    return False


def check_start(lab):
    assert lab.address.startswith("http://127.0.0.1:"), lab.address
    assert lab.seconds < 1.0, f"ready after {lab.seconds:.2f} s"
    status, body, head = get(lab.address)
    assert status == 200 and b"<html" in body.lower()[:2000], head
    assert "default-src 'none'" in head and "nosniff" in head and "no-referrer" in head, head
    assert goes_on(lab.address)["state"] == "done"


def check_door(lab):
    address, port = lab.address, urlsplit(lab.address).port
    wrong = f"/?token={'0' * 32}"
    for path, headers, method, status in [
            ("/", (), "GET", 403), (wrong, (), "GET", 403), ("/?token=", (), "GET", 403),
            (None, ("Host: evil.example",), "GET", 403), (None, (f"Host: evil.example:{port}",), "GET", 403),
            (None, (), "POST", 405), (None, (), "DELETE", 405), ("/etc/passwd", (), "GET", 404),
            ("/live", (), "GET", 403), (f"/live?token={address.split('=')[1]}", (), "GET", 400)]:
        answered, body, _ = get(address, path, headers, method)
        assert answered == status, (path, headers, method, answered)
        assert b"root:" not in body and PROGRAM.encode() not in body
    token = address.split("=")[1]
    _, page, headers = get(address)
    policy = re.search("Content-Security-Policy: (.*)", headers)[1]
    scripts = re.search("script-src ([^;]*)", policy)[1].split()
    assert "'unsafe-inline'" not in scripts and "blob:" not in scripts, policy
    script = page[page.rindex(b'<script type="module">') + 22:page.rindex(b"</script>")]
    assert f"'sha256-{base64.b64encode(hashlib.sha256(script).digest()).decode()}'" in scripts, policy
    for path in ["/../../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "//etc/passwd", "/.", "/page/dist/index.html",
                 f"/../../etc/passwd?token={token}", "/\x00"]:
        answered, body, _ = get(address, path)
        assert answered != 200 and b"root:" not in body, (path, answered)
    assert refused(lambda: Page(address, token="0" * 32))
    assert refused(lambda: Page(address, token=""))
    assert refused(lambda: Page(address, origin="http://evil.example"))
    assert refused(lambda: Page(address, origin="null"))
    assert refused(lambda: Page(address, host=f"evil.example:{port}", origin=f"http://evil.example:{port}"))
    for rubbish in [b"\x16\x03\x01\x02\x00", b"GET\r\n\r\n", b"\x00" * 5000, b"A" * 100_000, b"GET / HTTP/9.9\r\n\r\n",
                    b"GET / HTTP/1.1\r\nHost: " + b"x" * 60_000 + b"\r\n\r\n"]:
        try:
            assert b" 200 " not in http(address, rubbish, timeout=3)[:20], rubbish[:20]
        except OSError:
            pass
    goes_on(address)


def check_outside(armlet):
    """A page reads what programs may read, below the folder of the program, and nothing else."""
    secret = "47114711"
    with tempfile.TemporaryDirectory() as around:
        folder = Path(around, "lab")
        folder.mkdir()
        Path(around, "secret.rbt").write_text(f"let secret = {secret}\n")
        Path(around, "secret.csv").write_text(f"a,b\n{secret},2\n")
        for name in ("secret.rbt", "secret.csv"):
            (folder / f"link-{name}").symlink_to(f"../{name}")
        (folder / "program.rbt").write_text(PROGRAM)
        with Lab(armlet, str(folder / "program.rbt")) as lab:
            token = lab.address.split("=")[1]
            for name in ("../secret.csv", "/etc/passwd", "program.rbt", "..%2fsecret.csv", "%2e%2e/secret.csv", "", "x" * 3000):
                answered, body, _ = get(lab.address, f"/file?token={token}&name={name}")
                assert answered == 404 and secret.encode() not in body, (name, answered)
            page = greet(lab.address)
            page.until(lambda m: is_message(m, "run") and m["state"] != "running")
            reads = ['import "{}"\nprint(secret)\n', 'robot r = urdf("{}")\n', 'object o {{ shape: mesh("{}"); at: xyz() }}\n']
            paths = ["../secret.rbt", f"{around}/secret.rbt", "link-secret.rbt", "../secret.csv", f"{around}/secret.csv",
                     "link-secret.csv", "/etc/passwd"]
            for version, text in enumerate((read.format(path) for read in reads for path in paths), 200):
                page.send(type="text", text=text, version=version)
                told, seen = page.until(lambda m: is_message(m, "diagnostics", text_version=version) and not m["runs"]
                                        or is_message(m, "run", text_version=version) and m["state"] != "running")
                assert told["type"] == "diagnostics" or told["state"] == "failed", (text, told)
                assert not any(secret in str(each) or "root:" in str(each) for each in seen), text
            page.close()
        assert sorted(os.listdir(folder)) == ["link-secret.csv", "link-secret.rbt", "program.rbt"]


def check_half_open(armlet, program):
    """A page that is in control and has gone without a word, as a machine without power, loses it."""
    with Lab(armlet, program) as lab:
        gone = greet(lab.address)
        gone.until(lambda m: is_message(m, "run") and m["state"] != "running")
        page = greet(lab.address)
        page.send(type="take")
        page.until(lambda m: is_message(m, "control", holder=page.number), seconds=60)
        page.close()
        gone.close()


def check_large_frame(lab):
    """A frame that says it has a gigabyte, and comes: the connection ends when there is more than any message has."""
    before = lab.memory("VmHWM")
    pages = [greet(lab.address) for _ in range(4)]
    sent = 0
    for page in pages:
        page.send_frame(TEXT, b"", claimed=1_000_000_000)
    for page in pages:
        page.socket.settimeout(10)
        try:
            while sent < 4_000_000_000:
                sent += page.socket.send(b"z" * 65_536)
        except (ConnectionError, socket.timeout):
            pass
    assert sent < 1_000_000_000, f"{sent} bytes were taken"
    assert lab.memory("VmHWM") < before + 300, f"{before} MB, then {lab.memory('VmHWM')} MB"
    for page in pages:
        page.close()
    assert goes_on(lab.address)["state"] == "done"


def check_frames(lab):
    """Frames that no browser would send close the connection, or are answered with an error."""
    def send_raw(page, data):
        page.socket.sendall(data)

    hostile = [
        lambda p: p.send_frame(BINARY, b"\x00" * 100),
        lambda p: p.send_frame(TEXT, b"x" * 1_200_000),
        lambda p: [p.send_frame(TEXT if i == 0 else 0, b"y" * 300_000, last=False) for i in range(5)],
        lambda p: p.send_frame(TEXT, b"short", claimed=1 << 62),
        lambda p: p.send_frame(TEXT, b"short", claimed=(1 << 64) - 1),
        lambda p: p.send_frame(11, b"unknown"),
        lambda p: send_raw(p, os.urandom(4000)),
        lambda p: send_raw(p, b"\x81"),
        lambda p: p.send_frame(CLOSE, b"\x03\xe8"),
    ]
    for number, misbehave in enumerate(hostile):
        page = greet(lab.address)
        try:
            misbehave(page)
        except OSError:
            pass
        page.close()
        assert goes_on(lab.address)["state"] == "done", number
    check_large_frame(lab)
    page = greet(lab.address)
    for message in [b"", b"{", b"[]", b"null", b'{"type": "nothing", "seq": 7}', b"\xff\xfe", b"[" * 50_000,
                    b'{"type": "hello", "type": "text"}']:
        page.send_frame(TEXT, message)
        assert page.until_type("error")["reason"] in ("message", "refused"), message
    page.send_frame(PING, b"are you there")
    page.send(type="format")
    page.until_type("formatted")
    page.send_frame(TEXT, b'{"type": "for', last=False)
    page.send_frame(0, b'mat"}', last=True)
    page.until_type("formatted")
    page.close()


def check_programs(lab):
    """Programs that never end, or want everything, are ended; the laboratory answers meanwhile."""
    page = greet(lab.address)
    take_control(page)
    version = 100
    for text in ["while (true) { }\n", "while (true) { wait(1ms) }\n", "int[] a = {}\nwhile (true) { a.push(1) }\n",
                 "string s = \"x\"\nwhile (true) { s = s + s }\n", "fn f(k: int) -> int { return f(k + 1) }\nprint(f(0))\n",
                 "while (true) { print(\"x\") }\n", "parallel { { while (true) { } } { while (true) { wait(1ms) } } }\n",
                 "while (true) { moveJ(posJ(10deg, 0deg, 0mm, 0deg), time: 1s)\nmoveJ(posJ(0deg, 0deg, 0mm, 0deg), time: 1s) }\n"]:
        version += 1
        page.send(type="text", text=text, version=version)
        begun = time.monotonic()
        page.ask(type="hover", at=[1, 0])
        assert time.monotonic() - begun < 20.0, text  # for ever otherwise
    done = run_text(page, PROGRAM, version + 1)
    assert done["state"] == "done", done
    run_text(page, "while (true) { wait(1ms) }\n", version + 2, seconds=120)
    page.ask(type="goto", t=300.0, seconds=60)
    run_text(page, PROGRAM, version + 3)
    assert lab.memory() < 1500, lab.memory()
    page.close()


def check_flood(lab):
    """A page that sends without end and one that takes up nothing keep nobody else waiting."""
    deaf = greet(lab.address)
    deaf.send(type="fetch", run=1)
    flood = greet(lab.address)
    over = threading.Event()

    def send():
        try:
            while not over.is_set():
                flood.send(type="complete", at=[1, 0])
        except OSError:
            pass

    sender = threading.Thread(target=send)
    sender.start()
    try:
        page = greet(lab.address)
        worst = 0.0
        for _ in range(30):
            begun = time.monotonic()
            page.ask(type="hover", at=[1, 5])
            worst = max(worst, time.monotonic() - begun)
        assert worst < 2.0, worst
        before = lab.memory()
        time.sleep(2)
        assert lab.memory() < before + 100, (before, lab.memory())
        page.close()
    finally:
        over.set()
        flood.socket.shutdown(socket.SHUT_RDWR)
        sender.join()
        flood.close()
        deaf.close()
    goes_on(lab.address)


def check_inputs(lab):
    """Inputs without end, each of which would be a run of its own, keep nobody else waiting either."""
    flood = greet(lab.address)
    take_control(flood)
    text = "lab cell {\n    field gap(20deg, range: [0deg, 60deg])\n}\nmoveJ(posJ(10deg, cell.gap, 10mm, 0deg), time: 1s)\nwait(2s)\n"
    run_text(flood, text, 5000)
    over = threading.Event()
    sent, taken = [0], [0]

    def send():
        try:
            while not over.is_set():
                flood.send(type="input", set="gap", value=0.1 + 1e-4 * (sent[0] % 1000), t=0.5)
                sent[0] += 1
        except OSError:
            pass

    def receive():
        try:
            while not over.is_set():
                taken[0] += is_message(flood.receive(5), "taken")
        except (OSError, ConnectionError, TimeoutError):
            pass

    threads = [threading.Thread(target=each) for each in (send, receive)]
    for each in threads:
        each.start()
    try:
        page = greet(lab.address)
        worst = 0.0
        for _ in range(20):
            begun = time.monotonic()
            page.ask(type="hover", at=[1, 5])
            worst = max(worst, time.monotonic() - begun)
            time.sleep(0.1)
        assert worst < 5.0 and sent[0] > 1000, (worst, sent)
        assert lab.memory() < 500, lab.memory()
    finally:
        over.set()
        try:
            flood.socket.shutdown(socket.SHUT_RDWR)
        except OSError:
            pass  # it was sent away
        for each in threads:
            each.join()
        flood.close()
    take_control(page)
    assert run_text(page, PROGRAM, 5001)["state"] == "done"
    page.close()
    goes_on(lab.address)


def check_crowd(lab):
    """200 connections, most of which say nothing or half of something."""
    parts = urlsplit(lab.address)
    crowd = []
    for number in range(200):
        try:
            each = socket.create_connection((parts.hostname, parts.port), 2)
            crowd.append(each)
            if number % 3 == 0:
                each.sendall(b"GET /live?token")
        except OSError:
            break
    page = None
    begun = time.monotonic()
    while page is None:  # those that say nothing are sent away after a while
        try:
            page = greet(lab.address, timeout=60)
        except (OSError, Refused, ConnectionError):
            assert time.monotonic() - begun < 20
    page.ask(type="hover", at=[1, 5])
    page.close()
    for each in crowd:
        each.close()
    pages = []
    for _ in range(60):  # pages that do everything right, but are too many
        try:
            pages.append(greet(lab.address, timeout=10))
        except (OSError, Refused, ConnectionError):
            break
    assert 30 <= len(pages) <= 60, len(pages)
    pages[0].ask(type="hover", at=[1, 5])
    pages[-1].ask(type="hover", at=[1, 5])
    for each in pages:
        each.close()
    begun = time.monotonic()
    while refused(lambda: greet(lab.address)):  # until it is noticed that they have gone
        assert time.monotonic() - begun < 30
        time.sleep(0.2)
    goes_on(lab.address)


def check_pages(lab):
    """Two pages: one shows, the other follows; the control is passed on; a page that returns sees the present state."""
    teacher = greet(lab.address)
    take_control(teacher)
    student = greet(lab.address)
    answer = student.ask(type="text", text="wait(1s)\n", version=900)
    assert is_message(answer, "error", reason="control"), answer
    run_text(teacher, "wait(3s)\n", 901)
    assert student.until_type("text")["text"] == "wait(3s)\n"
    teacher.ask(type="goto", t=1.5)
    seen = student.until(lambda m: is_message(m, "instant") and m["cursor"])[0]
    assert seen["t"] == 1.5 and "to" not in seen
    student.send(type="take")
    assert teacher.until(lambda m: is_message(m, "control") and m["wishes"])[0]["wishes"] == [student.number]
    teacher.send(type="give", to=student.number)
    student.until(lambda m: is_message(m, "control") and m["holder"] == student.number)
    run_text(student, PROGRAM, 902)
    student.close()
    teacher.close()
    assert goes_on(lab.address)["text_version"] == 902


def check_host_and_port(armlet, program):
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        done = subprocess.run([armlet, "lab", program, "--no-open", "--port", str(port)], capture_output=True, text=True)
        assert done.returncode == 70 and str(port) in done.stderr, done
    for wrong in [["--port", "70000"], ["--demo"]]:
        done = subprocess.run([armlet, "lab", program, "--no-open", *wrong], capture_output=True, text=True)
        assert done.returncode == 64 and done.stderr, (wrong, done)
    done = subprocess.run([armlet, "lab", "nothing/nothing.rbt", "--no-open"], capture_output=True, text=True)
    assert done.returncode == 66, done
    with Lab(armlet, "--demo") as lab:
        assert goes_on(lab.address)["state"] == "done"


def main():
    armlet = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        program = os.path.join(folder, "program.rbt")
        Path(program).write_text(PROGRAM)
        only = sys.argv[2:]
        with Lab(armlet, program) as lab:
            for check in (check_start, check_door, check_frames, check_pages, check_programs, check_flood, check_inputs, check_crowd):
                if only and check.__name__ not in only:
                    continue
                begun = time.monotonic()
                check(lab)
                print(f"{check.__name__}: {time.monotonic() - begun:.1f} s, {lab.memory():.0f} MB", flush=True)
        if not only:
            check_host_and_port(armlet, program)
            check_half_open(armlet, program)
            check_outside(armlet)
        assert os.listdir(folder) == ["program.rbt"]


if __name__ == "__main__":
    main()
