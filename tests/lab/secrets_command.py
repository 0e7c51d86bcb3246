#!/usr/bin/env python3
"""Where the token of a laboratory comes from and where it does not stand: secrets_command.py ARMLET."""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
from server_command import PROGRAM, Lab, goes_on


def check_tokens(armlet, program):
    """Tokens come from a file or a variable, are long, and stand on no command line; who is open to others is warned."""
    own, file = "a-token-of-our-own-of-22", Path(program).with_name("token")
    file.write_text(own + "\n")
    file.chmod(0o600)
    warning = "not encrypted"
    with Lab(armlet, program, "--host", "0.0.0.0", "--token-file", str(file), errors=warning) as lab:
        assert lab.address.endswith(f"/?token={own}"), lab.address
        goes_on(lab.address)
    with Lab(armlet, program, environment={"ARMLET_LAB_TOKEN": own}) as lab:
        assert lab.address.endswith(f"/?token={own}"), lab.address
        assert own not in Path(f"/proc/{lab.process.pid}/cmdline").read_text()
    file.chmod(0o644)
    with Lab(armlet, program, "--token-file", str(file), errors="chmod 600") as lab:
        assert lab.address.endswith(f"/?token={own}"), lab.address

    def refused(arguments, status, message, environment=None):
        done = subprocess.run([armlet, "lab", program, "--no-open", *arguments], capture_output=True, text=True,
                              env={**os.environ, **(environment or {})}, timeout=60)
        assert done.returncode == status and message in done.stderr and not done.stdout, (arguments, done)

    refused(["--token", own], 64, "--token-file")
    refused([], 64, "ARMLET_LAB_TOKEN: a token has 22 to 200 characters, and this one 21", {"ARMLET_LAB_TOKEN": "x" * 21})
    refused([], 64, "letters, digits", {"ARMLET_LAB_TOKEN": "with spaces, but long enough"})
    for text, message in [("short\n", "this one 5"), ("", "no token in it")]:
        file.write_text(text)
        refused(["--token-file", str(file)], 64, message)
    refused(["--token-file", str(file) + ".none"], 66, "token.none")


def check_browser(armlet, program):
    """What opens the browser has the address in a file of this user, not on its command line."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        opener = folder / "xdg-open"
        opener.write_text(f'#!/bin/sh\necho "$@" >{folder}/arguments.part\ncp "${{1#file://}}" {folder}/page\n'
                          f'stat -c "%a" "${{1#file://}}" >>{folder}/arguments.part\nmv {folder}/arguments.part {folder}/arguments\n')
        opener.chmod(0o700)
        environment = {"PATH": f"{folder}:{os.environ['PATH']}", "DISPLAY": ":7", "XDG_RUNTIME_DIR": str(folder)}
        with Lab(armlet, program, environment=environment, opens=True) as lab:
            until = time.monotonic() + 30
            while not (folder / "arguments").exists() and time.monotonic() < until:
                time.sleep(0.02)
            address, mode = (folder / "arguments").read_text().split()
            assert address.startswith("file://") and lab.address.split("=")[1] not in address, address
            assert mode == "600", mode
            assert f'url={lab.address}"' in (folder / "page").read_text()
        assert not Path(address.removeprefix("file://")).exists()


with tempfile.TemporaryDirectory() as place:
    shown = Path(place) / "program.rbt"
    shown.write_text(PROGRAM)
    check_tokens(sys.argv[1], str(shown))
    check_browser(sys.argv[1], str(shown))
