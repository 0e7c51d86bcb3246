#!/usr/bin/env python3
"""Checks the size limits of the style: file 500 lines, header 300, function 60, CMakeLists.txt 40 without lists of sources."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

FILE, HEADER, FUNCTION, CMAKE = 500, 300, 60, 40
FOLDERS = ("runtime", "grammar", "interpreter", "stdlib", "apps", "tests", "bench", "examples", "cmake", "tools")
SKIPPED = ("grammar/generated/", "apps/lab/page/dist/")
CODE = {".hpp", ".h", ".cpp", ".def", ".inc", ".g4", ".py", ".sh", ".cmake", ".rbt"}

NOT_A_FUNCTION = re.compile(r"^\s*(namespace|extern|class|struct|union|enum)\b|=\s*$")
SOURCES = re.compile(r"^\s+(src/[\w/]+/)?( ?\w+)( \w+)*\)?\n", re.M)  # folders and names, as armlet_add_library takes them
INITIALISERS = re.compile(r"\)\s*(noexcept\s*)?:[^:]")


def opens_function(head):
    """Whether a brace after this text (everything since the last ; or block) opens a function body."""
    if ")" not in head or NOT_A_FUNCTION.search(head):
        return False
    return not INITIALISERS.search(head) or head.rstrip()[-1] in ")}"


def code_only(text):
    """The text with comments, strings and preprocessor lines blanked, line breaks kept."""
    pattern = r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|^[ \t]*#(?:\\\n|[^\n])*'
    return re.sub(pattern, lambda m: "\n" * m.group(0).count("\n"), text, flags=re.S | re.M)


def functions(text):
    """(first line, number of lines) of every outermost function body, signature excluded."""
    line, head, heads = 1, "", []
    function_depth = start = None
    for char in code_only(text):
        line += char == "\n"
        if char == "{":
            if function_depth is None and opens_function(head):
                function_depth, start = len(heads), line
            heads.append(head)
            head = ""
        elif char == "}":
            head = heads.pop() + "{}" if heads else ""
            if len(heads) == function_depth:
                yield start, line - start + 1
                function_depth, head = None, ""
            if ")" not in head:
                head = ""
        else:
            head = "" if char == ";" else head + char


def faults(path, name):
    text = path.read_text(encoding="utf-8")
    if path.name == "CMakeLists.txt":
        text = SOURCES.sub("", text)
    lines = text.count("\n")
    limit = CMAKE if path.name == "CMakeLists.txt" else HEADER if path.suffix in (".hpp", ".h") else FILE
    if lines > limit:
        yield f"{name}: {lines} lines; at most {limit}"
    if path.suffix in (".hpp", ".h", ".cpp"):
        for line, length in functions(text):
            if length > FUNCTION:
                yield f"{name}:{line}: function of {length} lines; at most {FUNCTION}"


def main():
    root = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    files = [root / "CMakeLists.txt", root / "dev"]
    for folder in FOLDERS:
        files += [p for p in sorted((root / folder).rglob("*")) if p.suffix in CODE or p.name == "CMakeLists.txt"]
    found = []
    for path in files:
        name = path.relative_to(root).as_posix()
        if path.is_file() and not name.startswith(SKIPPED):
            found += faults(path, name)
    print("\n".join(found) if found else "sizes: within the limits")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
