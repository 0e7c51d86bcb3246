#!/usr/bin/env python3
"""Checks that the sources of the page of laboratories import in one direction: a folder of apps/lab/page/src imports only from
folders that stand above it in the table of apps/lab/page/README.md, and no file imports itself through others."""

import os
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = Path("apps/lab/page")

ROW = re.compile(r"^\| `(\w+)` \|", re.M)
# import ... from "x", export ... from "x", import "x", import("x"): only the page's own files, which begin with a dot.
IMPORT = re.compile(r"""\b(?:from|import)\s*\(?\s*["'](\.[^"']+)["']""")
REMARK = re.compile(r"^\s*//.*$", re.M)


def imports_of(source):
    """Each file of the sources, and the files that it imports; all as paths below the folder of sources."""
    found = {}
    for path in sorted(source.rglob("*.ts")):
        text = REMARK.sub("", path.read_text(encoding="utf-8"))
        names = (os.path.normpath(path.parent / name) for name in IMPORT.findall(text))
        found[path.relative_to(source).as_posix()] = sorted({os.path.relpath(name, source) for name in names if name.endswith(".ts")})
    return found


def folder_of(file):
    return file.split("/")[0] if "/" in file else ""


def faults_of_folders(imports, order):
    folders = {folder_of(file) for file in imports} - {""}
    for folder in sorted(folders - set(order)):
        yield f"src/{folder} has no row in {PAGE}/README.md"
    for folder in sorted(set(order) - folders):
        yield f"{PAGE}/README.md has a row for src/{folder}, which does not exist"
    place = {folder: number for number, folder in enumerate(order)}
    for file, others in imports.items():
        for other in others:
            mine, theirs = folder_of(file), folder_of(other)
            if mine != theirs and mine in place and place.get(theirs, len(order)) > place[mine]:
                yield f"src/{file} imports {other}, but {theirs or 'src'} does not stand above {mine} in the table of {PAGE}/README.md"


def circle_from(file, imports, path, done):
    """Files that import each other in turn, the first one again at the end; None: there are none that can be reached."""
    if file in path:
        return path[path.index(file):] + [file]
    if file in done:
        return None
    for other in imports.get(file, ()):
        found = circle_from(other, imports, path + [file], done)
        if found:
            return found
    done.add(file)
    return None


def faults(root):
    imports = imports_of(root / PAGE / "src")
    yield from faults_of_folders(imports, ROW.findall((root / PAGE / "README.md").read_text(encoding="utf-8")))
    done = set()
    for file in imports:
        circle = circle_from(file, imports, [], done)
        if circle:
            yield "a circle of imports: " + " -> ".join(circle)
            return


def main():
    root = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    found = list(faults(root))
    print("\n".join(found) if found else "page: in order")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
