#!/usr/bin/env python3
"""Runs every program (a block marked rbt) of the README and the documents.

usage: snippets.py COMMAND ROOT

A block after a line `<!-- fails: CODE -->` must fail with that message. All others must run. A table with a column "in Armlet" is a
program too: the code of that column from top to bottom, after the last block of its section, if there is one that runs.

Blocks marked text are compared with what is printed, moves and messages included. After `<!-- prints -->` a block is all that the
program before it prints; after `<!-- prints a part -->` its lines are among these, in this order; after `<!-- reports -->` it is what
`armlet test` prints, and after `<!-- plays -->` what `armlet lab` prints with the inputs of the block marked json before it. After
`<!-- prompt -->` it is a dialogue with the prompt of the command, which is repeated.

Blocks of C++ in docs/embedding.md must stand in the hosts that they are taken from, which are built and run by tests of their own.
"""
import difflib
import os
import pathlib
import pty
import re
import select
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"(?:<!-- fails: (\w+) -->\n)?```rbt\n(.*?)```", re.DOTALL)
INPUTS = re.compile(r"```json\n(.*?)```", re.DOTALL)
SHOWN = re.compile(r"<!-- (prints|prints a part|reports|plays|prompt) -->\n```text\n(.*?)```", re.DOTALL)
TABLE = re.compile(r"(?:^\|.*\n)+", re.MULTILINE)
COLUMN = "in Armlet"
VERBS = {"reports": "test", "plays": "lab"}
FILE = re.compile(r"(?:(?<= --> )|^)\S+\.rbt(?=:|$)", re.MULTILINE)
PROMPT = "rbt> "
CPP = re.compile(r"```cpp\n(.*?)```", re.DOTALL)
HOSTS = ("tests/embed", "tests/unit/host", "tests/unit/stdlib", "examples/embed")
ERROR = re.compile(r"^error (\w+):", re.MULTILINE)


def is_fine(run, code):
    return code in ERROR.findall(run.stderr) if code else run.returncode == 0


def check(command, folder, document, number, text, code):
    path = pathlib.Path(folder) / f"{document.stem}_{number}.rbt"
    path.write_text(text)
    run = subprocess.run([command, "run", "--quiet", path], capture_output=True, text=True, timeout=60, cwd=folder)
    if is_fine(run, code):
        return 0
    print(f"{document}, block {number}: exit status {run.returncode}\n{run.stderr}")
    return 1


def cells(row):
    return [cell.strip().replace(r"\|", "|") for cell in re.split(r"(?<!\\)\|", row.strip()[1:-1])]


def programs_of_tables(text):
    for table in TABLE.finditer(text):
        header, _, *rows = table[0].splitlines()
        if COLUMN not in cells(header):
            continue
        column = cells(header).index(COLUMN)
        section = text.rfind("\n## ", 0, table.start()) + 1
        blocks = [block[2] for block in BLOCK.finditer(text, section, table.start()) if not block[1]]
        code = [code for row in rows for code in re.findall("`([^`]+)`", cells(row)[column])]
        yield "\n".join([*blocks[-1:], *code]) + "\n"


def printed(command, verb, folder, text, inputs):
    """All that `run`, `test` or `lab` prints for a program, in the order of a terminal."""
    path = pathlib.Path(folder) / "shown.rbt"
    path.write_text(text)
    words = [verb, path.name]
    if verb == "lab":
        path.with_suffix(".jsonl").write_text(inputs)
        words += ["--inputs", "shown.jsonl"]
    run = subprocess.run([command, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60, cwd=folder)
    return run.stdout


def dialogue(command, folder, lines):
    """What a terminal without colours shows when these lines are typed at the prompt."""
    pid, terminal = pty.fork()
    if pid == 0:
        os.chdir(folder)
        os.environ.update({"TERM": "dumb", "HOME": folder, "XDG_STATE_HOME": folder})
        os.execv(command, [command])
    shown = ""
    for line in [None, *lines, None]:
        if line is not None:
            os.write(terminal, (line + "\n").encode())
        elif shown:
            os.write(terminal, b"\x04")
            break
        while not shown.endswith(PROMPT) and select.select([terminal], [], [], 60)[0]:
            shown += os.read(terminal, 65536).decode()
        shown = shown[:-len(PROMPT)] + "\0"  # where an entry begins
    os.waitpid(pid, 0)
    os.close(terminal)
    return shown.replace("\r\n", "\n").replace("\0", PROMPT).removesuffix(PROMPT)


def is_part(lines, whole):
    rest = iter(whole)
    return all(line in rest for line in lines)


def check_shown(command, folder, document):
    """How many blocks of a document are not what its programs, or the prompt, show."""
    text, failed = document.read_text(), 0
    for match in SHOWN.finditer(text):
        kind, wanted = match[1], FILE.sub("FILE", match[2]).splitlines()
        if kind == "prompt":
            found = dialogue(command, folder, [line[len(PROMPT):] for line in wanted if line.startswith(PROMPT)])
        else:
            program = list(BLOCK.finditer(text, 0, match.start()))[-1][2]
            inputs = INPUTS.findall(text, 0, match.start())[-1:]
            found = printed(command, VERBS.get(kind, "run"), folder, program, "".join(inputs))
        found = FILE.sub("FILE", found).splitlines()
        if not (is_part(wanted, found) if kind == "prints a part" else wanted == found):
            line = text.count("\n", 0, match.start()) + 1
            print("\n".join(difflib.unified_diff(wanted, found, f"{document}:{line}", "shown now", lineterm="")))
            failed += 1
    return failed


def unindented(text):
    return "\n".join(line.strip() for line in text.strip().splitlines())


def check_hosts(root):
    hosts = [unindented(host.read_text()) for folder in HOSTS for host in (root / folder).rglob("*.cpp")]
    failed = 0
    for match in CPP.finditer((root / "docs" / "embedding.md").read_text()):
        if not any(unindented(match[1]) in host for host in hosts):
            print(f"docs/embedding.md: in no host:\n{match[1]}")
            failed += 1
    return failed


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    command, root = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])
    failed, blocks = check_hosts(root), 0
    with tempfile.TemporaryDirectory() as folder:
        for document in sorted([*root.glob("*.md"), *root.glob("docs/**/*.md")]):
            text = document.read_text()
            programs = [(match[2], match[1]) for match in BLOCK.finditer(text)]
            programs += [(program, None) for program in programs_of_tables(text)]
            for number, (program, code) in enumerate(programs, 1):
                blocks += 1
                failed += check(command, folder, document, number, program, code)
            failed += check_shown(command, folder, document)
    print(f"{blocks} programs, {failed} failed")
    sys.exit(1 if failed or not blocks else 0)


if __name__ == "__main__":
    main()
