#!/usr/bin/env python3
"""Checks what keeps the parts of the sources small and their lists whole.

- No folder has more than 25 files side by side.
- No type has more than 20 public members that others can write, and none more than 30 public functions.
- Every folder of sources has its purpose in docs/architecture.md.
- No switch of the interpreter has a `default`: with one, the compiler would not name the kind that was forgotten.
"""

import re
import subprocess
import sys
from collections import Counter
from pathlib import Path, PurePosixPath

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
from check_names import ROOT, TYPE, tokens_of, type_named, without_noise

FILES, MEMBERS, CALLS = 25, 20, 30
FOLDERS = ("runtime", "interpreter", "stdlib", "apps", "tests", "bench")

# Folders that may have any size: their files are the items of a collection.
COLLECTIONS = {
    "docs/decisions": "numbered in the order in which they were made, listed by their README.md",
    "tests/fuzz/corpus": "inputs of the fuzzer, read by programs",
    "tests/reference/messages": "what programs print, one file for each of tests/mistakes",
    "bench/programs/lua": "each beside the program of the same name in ../rbt",
    "bench/programs/rbt": "each beside the program of the same name in ../lua",
}
# Types that may have more public functions, and why.
MANY_FUNCTIONS = {
    "Cell": "one object owns all that changes in a run; its parts are the cameras, signals, trails, contacts and the clock so far",
    "Host": "what the library keeps of a run: its parts have no owners of their own yet",
    "Session": "what a host does with a session, which has no other door",
    "Robot": "a value that never changes: what it has, and copies with one thing changed",
    "World": "objects, frames and fastenings of one scene, which have to agree with one another",
    "Vm": "what a host does with a program that runs",
    "Heap": "one function for each kind of object",
    "Emitter": "one function for each form of an instruction",
    "Laboratory::State": "what the server asks of a laboratory, all under one lock",
}
# Documents that list the folders below these ones by name, with their purposes.
DOCUMENTED = {"docs/architecture.md": ("runtime/src", "interpreter/src", "stdlib/src", "interpreter/include/armlet/interpreter")}

IS_FUNCTION = re.compile(r"\b(operator|friend|using|typedef|static|static_assert|enum|template|constexpr)\b")


def tracked():
    out = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=ROOT, capture_output=True, text=True)
    if out.returncode == 0:
        return [PurePosixPath(name) for name in out.stdout.splitlines() if (ROOT / name).exists()]
    return [PurePosixPath(p.relative_to(ROOT).as_posix()) for folder in FOLDERS + ("docs", "tools") for p in (ROOT / folder).rglob("*")
            if p.is_file() and "__pycache__" not in p.parts]


def large_folders(files):
    counted = Counter(str(path.parent) for path in files)
    for folder, number in sorted(counted.items()):
        if number > FILES and folder not in COLLECTIONS:
            yield f"{folder}: {number} files side by side; at most {FILES}"
    for folder in COLLECTIONS:
        if counted[folder] <= FILES:
            yield f"{folder} is an unnecessary exception"


def unnamed_folders(files):
    """Folders of sources that the document about them does not name in backticks."""
    for document, parents in DOCUMENTED.items():
        named = set(re.findall(r"`([\w/]+)`", (ROOT / document).read_text(encoding="utf-8")))
        for parent in parents:
            for folder in sorted({path.parent for path in files if path.is_relative_to(parent)}):
                name = str(folder.relative_to(parent))
                if name != "." and name not in named:
                    yield f"{document} does not name `{name}` of {parent}"


def declared(words):
    """How many variables a statement in the body of a type declares: 2 for `double x = 0.0, y = 0.0`."""
    text = " ".join(words)
    if not words or IS_FUNCTION.search(text) or words[0] in TYPE and len(words) < 3:
        return 0
    depth, number, in_value = 0, 1, False
    for i, word in enumerate(words):
        if word in "(<[{" and not in_value:
            if word == "(" and depth == 0:
                return 0  # a function
            depth += 1
        elif word in ")>]}" and not in_value:
            depth -= 1
        elif word == "=" and depth == 0:
            in_value = True
        elif word == "," and depth == 0:
            number += 1
            in_value = False
    constant = words[0] == "const" and "*" not in words or words[-1:] == ["const"]
    return 0 if constant else number


def is_function(words):
    """Whether a statement in the body of a type declares a function: `int n() const`, not `std::function<int()> n`."""
    if {"using", "friend", "static_assert", "typedef", "enum"} & set(words):
        return False
    depth = 0
    for word in words:
        if word == "operator":
            return True
        if word == "(" and depth == 0:
            return True
        if word == "=" and depth == 0:
            return False
        depth += (word == "<") - (word == ">")
    return False


def public_functions(text):
    """(name, line, number of public functions, constructors included) of every class and struct."""
    scopes = []  # of each open brace: [name, line, number, is public now], or None for what is no type
    head = []
    for token, line in tokens_of(without_noise(text)):
        inside = scopes[-1] if scopes else None
        if token == "{":
            name = type_named(head) if "(" not in head else None
            if not name and inside is not None and inside[3]:
                inside[2] += is_function(head)
            scopes.append([name, line, 0, "class" not in head] if name else None)
            head = []
        elif token == "}":
            closed = scopes.pop() if scopes else None
            if closed is not None:
                yield tuple(closed[:3])
            head = ["="]  # what follows belongs to a value or to a declaration that was counted
        elif token == ";":
            if inside is not None and inside[3]:
                inside[2] += is_function(head)
            head = []
        elif token == ":" and head[-1:] in (["public"], ["private"], ["protected"]):
            if inside is not None:
                inside[3] = head[-1] == "public"
            head = []
        elif head == ["="] and token not in ",)":
            head = [token]
        else:
            head.append(token)


def public_members(text):
    """(name, line, number of public variables) of every class and struct."""
    scopes = []  # of each open brace: [name, line, number, is public now], or None for what is no type
    head = []
    for token, line in tokens_of(without_noise(text)):
        inside = scopes[-1] if scopes else None
        if token == "{":
            name = type_named(head) if "(" not in head else None
            scopes.append([name, line, 0, "class" not in head] if name else None)
            if not name and inside is not None and "(" not in head and "enum" not in head:
                head.append("{")  # the initial value of a variable: double x{};
                continue
            head = [] if name else head + ["{"]
        elif token == "}":
            closed = scopes.pop() if scopes else None
            if closed is not None:
                yield tuple(closed[:3])
                head = ["struct"]  # a declaration follows
            elif "(" in head:
                head = []
            elif head and "{" in head:
                head = head[:head.index("{")]
            else:
                head = []
        elif token == ";":
            if inside is not None and inside[3]:
                inside[2] += declared(head)
            head = []
        elif token == ":" and head[-1:] in (["public"], ["private"], ["protected"]):
            if inside is not None:
                inside[3] = head[-1] == "public"
            head = []
        else:
            head.append(token)


def large_types(files):
    many = set()
    for path in files:
        if path.suffix not in (".hpp", ".cpp") or path.parts[0] not in FOLDERS:
            continue
        text = (ROOT / path).read_text(encoding="utf-8")
        for name, line, number in public_members(text):
            if number > MEMBERS:
                yield f"{path}:{line}: {name} has {number} public members that others can write; at most {MEMBERS}"
        for name, line, number in public_functions(text):
            if number <= CALLS:
                continue
            many.add(name)
            if name not in MANY_FUNCTIONS:
                yield f"{path}:{line}: {name} has {number} public functions; at most {CALLS}"
    for name in sorted(set(MANY_FUNCTIONS) - many):
        yield f"{name} is an unnecessary exception of MANY_FUNCTIONS in tools/check_structure.py"


def switches_with_default(files):
    for path in files:
        if path.suffix in (".hpp", ".cpp", ".def") and path.is_relative_to("interpreter/src"):
            text = without_noise((ROOT / path).read_text(encoding="utf-8"))
            for match in re.finditer(r"\bdefault\s*:", text):
                yield f"{path}:{text.count(chr(10), 0, match.start()) + 1}: `default:`; list the remaining kinds"


def main():
    files = tracked()
    faults = [*large_folders(files), *unnamed_folders(files), *large_types(files), *switches_with_default(files)]
    print("\n".join(faults) if faults else "structure: within the limits")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
