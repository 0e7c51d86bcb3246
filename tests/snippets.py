#!/usr/bin/env python3
"""Runs every program (a block marked rbt) of the README and the documents.

usage: snippets.py COMMAND ROOT

A block after a line `<!-- fails: CODE -->` must fail with that message. All others must run. Blocks of C++ in
docs/embedding.md must stand in the hosts that they are taken from, which are built and run by tests of their own.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"(?:<!-- fails: (\w+) -->\n)?```rbt\n(.*?)```", re.DOTALL)
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
    command, root = sys.argv[1], pathlib.Path(sys.argv[2])
    failed, blocks = check_hosts(root), 0
    with tempfile.TemporaryDirectory() as folder:
        for document in sorted([*root.glob("*.md"), *root.glob("docs/**/*.md")]):
            for number, match in enumerate(BLOCK.finditer(document.read_text()), 1):
                blocks += 1
                failed += check(command, folder, document, number, match[2], match[1])
    print(f"{blocks} programs, {failed} failed")
    sys.exit(1 if failed or not blocks else 0)


if __name__ == "__main__":
    main()
