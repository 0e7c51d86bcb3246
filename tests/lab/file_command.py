#!/usr/bin/env python3
"""Saves programs from pages: the laboratory writes the file that it was started with, and no other, and follows changes from outside.

Usage: file_command.py ARMLET
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from server_command import PROGRAM, Lab, greet, run_text
from socket_client import is_message


def saved(page, **how):
    answer = page.ask(type="save", **how)
    return answer if answer["type"] == "error" else answer["type"]


def check_file(armlet):
    """The page in control writes the file of the program, that file alone, and as a whole or not at all."""
    with tempfile.TemporaryDirectory() as around:
        folder = Path(around, "lab")
        folder.mkdir()
        real, program, other = folder / "real.rbt", folder / "program.rbt", folder / "other.rbt"
        real.write_text(PROGRAM)
        real.chmod(0o640)
        program.symlink_to("real.rbt")
        other.write_text("// other\n")
        with Lab(armlet, str(program)) as lab:
            page = greet(lab.address)
            run_text(page, "wait(2s)\n", 1)
            assert saved(page) == "saved"
            assert program.is_symlink() and real.read_text() == "wait(2s)\n" and real.stat().st_mode & 0o777 == 0o640
            # Whatever a message says besides, no other file is written.
            run_text(page, "wait(3s)\n", 2)
            for name in ("other.rbt", "../secret.rbt", f"{around}/secret.rbt"):
                assert saved(page, name=name, file=name, path=name, text="// stolen\n") == "saved"
            assert other.read_text() == "// other\n" and real.read_text() == "wait(3s)\n" and not Path(around, "secret.rbt").exists()
            follower = greet(lab.address)
            assert saved(follower)["reason"] == "control" and saved(follower, replaces=True)["reason"] == "control"

            # Another program changes the file: it appears, unless there are edits.
            real.write_text("wait(4s)\n")
            assert page.until_type("text")["text"] == "wait(4s)\n"
            assert page.until(lambda m: is_message(m, "run") and m["state"] == "done")[0]["t_end"] == 4
            run_text(page, "wait(5s)\n", 10)
            real.write_text("wait(6s)\n")
            page.until_type("document", changed=True, text="wait(6s)\n")
            assert saved(page)["reason"] == "changed" and real.read_text() == "wait(6s)\n"
            assert saved(page, replaces=True) == "saved" and real.read_text() == "wait(5s)\n"

            # What cannot be written stays as it is, and says why.
            run_text(page, "wait(7s)\n", 11)
            real.chmod(0o440)
            assert "read-only" in saved(page)["message"] and real.read_text() == "wait(5s)\n"
            real.chmod(0o640)
            secret = Path(around, "secret.rbt")
            secret.write_text("// secret\n")
            real.unlink()
            real.symlink_to("../secret.rbt")  # a link that takes the place of the file is not followed
            assert saved(page, replaces=True)["reason"] == "refused" and secret.read_text() == "// secret\n"
            real.unlink()
            assert saved(page) == "saved" and real.read_text() == "wait(7s)\n"
            assert sorted(os.listdir(folder)) == ["other.rbt", "program.rbt", "real.rbt"]
            for each in (real, program, other):
                each.unlink()
            folder.rmdir()
            assert saved(page)["reason"] == "refused" and not folder.exists()
            page.close()
            follower.close()


def check_full_disk(armlet):
    """Without space for the new text the file keeps the old one. A limit of the process stands for a full disk."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder, "program.rbt")
        program.write_text(PROGRAM)
        limited = ["bash", "-c", 'ulimit -f 8; exec "$@"', "lab", armlet]  # blocks of 1024 bytes
        with Lab(limited, str(program)) as lab:
            page = greet(lab.address)
            run_text(page, "// " + "x" * 20_000 + "\n", 1)
            answer = saved(page)
            assert answer["reason"] == "refused" and "File too large" in answer["message"], answer
            assert program.read_text() == PROGRAM and os.listdir(folder) == ["program.rbt"]
            page.close()


def check_new_file(armlet):
    """A program that does not exist begins from a template; its file is made by the first save."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder, "new.rbt")
        with Lab(armlet, str(program), errors="new.rbt does not exist yet") as lab:
            page = greet(lab.address)
            text = page.until(lambda m: is_message(m, "document"))[1]
            assert not text[-1]["exists"] and not program.exists()
            page.until(lambda m: is_message(m, "run") and m["state"] == "done")
            assert saved(page) == "saved" and "robot arm" in program.read_text()
            page.close()
        for wrong in ("new.txt", "nothing/new.rbt"):
            done = subprocess.run([armlet, "lab", str(Path(folder, wrong)), "--no-open"], capture_output=True, text=True)
            assert done.returncode == 66 and "E0126" in done.stderr, done


def main():
    for check in (check_file, check_full_disk, check_new_file):
        check(sys.argv[1])


if __name__ == "__main__":
    main()
