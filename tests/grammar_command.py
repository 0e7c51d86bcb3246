#!/usr/bin/env python3
"""Runs the command of grammar/README.md as it is written, with a stand-in for the ANTLR tool.

usage: grammar_command.py ROOT
"""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

# Writes into the given file, relative to the folder in which it runs, what the build then changes.
TOOL = """#!/usr/bin/env python3
import pathlib, sys
out = pathlib.Path(sys.argv[sys.argv.index("-o") + 1])
if not out.is_dir():
    sys.exit(f"{out} is not there")
name = pathlib.Path(sys.argv[-1]).stem
text = f"{name}::Initializer {name}::_init;\\n"
(out / f"{name}.cpp").write_text(text)
(out / f"{name}.h").write_text("static Initializer _init;\\n")
(out / f"{name}.tokens").write_text("")
"""


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    command = re.search(r"^    (cmake .*)$", (root / "grammar" / "README.md").read_text(), re.M)
    with tempfile.TemporaryDirectory() as folder:
        copy, tools = pathlib.Path(folder) / "copy", pathlib.Path(folder) / "tools"
        shutil.copytree(root / "grammar", copy / "grammar")
        tools.mkdir()
        (tools / "antlr4").write_text(TOOL)
        (tools / "antlr4").chmod(0o755)
        path = f"{tools}{os.pathsep}{os.environ['PATH']}"
        subprocess.run(shlex.split(command[1]), cwd=copy, env=os.environ | {"PATH": path}, check=True)
        for name in ("RbtLexer", "RbtParser"):
            made = (copy / "grammar" / "generated" / f"{name}.cpp").read_text()
            header = (copy / "grammar" / "generated" / f"{name}.h").read_text()
            if f"void {name}::prepare() {{" not in made or "static void prepare();" not in header:
                sys.exit(f"{name}.cpp was not made again:\n{made[:400]}")
            if (copy / "grammar" / "generated" / f"{name}.tokens").exists():
                sys.exit(f"{name}.tokens was left")
    print("grammar: the command of its README works")


if __name__ == "__main__":
    main()
