#!/usr/bin/env python3
"""Compares the public mathematics of the C++ headers with what docs/mathematics.md says of it.

usage: check_mathematics.py COMMAND [--list]

The document has a row for every public function and class of math, chain, model, kinematics, dynamics and trajectory: what a program calls
to reach it, or why it cannot; and a row for every function of the library's mathematical chapters that has no C++ function
of its own. --list prints the functions of the headers and of those chapters that are in no row.
"""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
DOCUMENT = ROOT / "docs" / "mathematics.md"
LAYERS = ("math", "chain", "model", "kinematics", "dynamics", "trajectory")


def without_comments(text):
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
    text = re.sub(r"//[^\n]*", "", text)
    text = re.sub(r'"(?:[^"\\]|\\.)*"', '""', text)
    return re.sub(r"^\s*#.*(?:\\\n.*)*$", "", text, flags=re.M)


def split_body(text, begin):
    """The end of the block whose { is at begin."""
    depth = 0
    for at in range(begin, len(text)):
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        if depth == 0:
            return at
    return len(text)


def declarations(text):
    """Pieces of a namespace: (head, body or None)."""
    at, start = 0, 0
    while at < len(text):
        if text[at] == ";":
            yield text[start:at], None
            start = at + 1
        elif text[at] == "{":
            end = split_body(text, at)
            yield text[start:at], text[at + 1:end]
            at, start = end, end + 1
        at += 1


def public_part(head, body):
    """The members of a class that are not private."""
    shown = not re.search(r"\bclass\b", head)
    parts = re.split(r"\b(public|private|protected)\s*:", body)
    out = parts[0] if shown else ""
    for word, part in zip(parts[1::2], parts[2::2]):
        if word == "public":
            out += part
    return out


def function_name(head):
    head = re.sub(r"\[\[.*?\]\]", "", head)
    while "<" in head and "operator" not in head:
        inner = re.sub(r"<[^<>]*>", " ", head)
        if inner == head:
            break
        head = inner
    head = re.sub(r"^\s*template\b", "", head)
    if re.search(r"\b(using|typedef|friend|static_assert|enum|extern)\b", head.split("(")[0]):
        return None
    if "=" in head.split("(")[0]:
        return None  # a constant
    found = re.match(r"[\w:<>,&*\s]*?\b(~?\w+|operator\S+)\s*\(", head, flags=re.S)
    return found[1] if found else None


def names_of(text):
    """Free functions, and classes with member functions, of a header."""
    functions, classes = set(), set()
    for head, body in declarations(text):
        if re.search(r"\bnamespace\b", head) and body is not None:
            inner = names_of(body)
            functions |= inner[0]
            classes |= inner[1]
            continue
        record = re.search(r"\b(?:struct|class)\s+(?:\[\[.*?\]\]\s*)?(\w+)(?:\s+final)?(?:\s*:[^:].*)?\s*$", head, flags=re.S)
        if record and body is not None:
            methods = {function_name(h) for h, _ in declarations(public_part(head, body))} - {None, record[1], "~" + record[1]}
            if {m for m in methods if not m.startswith("operator")}:
                classes.add(record[1])
            continue
        name = function_name(head)
        if name and not name.startswith("operator"):
            functions.add(name)
    return functions, classes


def headers():
    for layer in LAYERS:
        for path in sorted((ROOT / "runtime" / "include" / "armlet" / layer).glob("*.hpp")):
            functions, classes = names_of(without_comments(path.read_text()))
            yield f"{layer}/{path.name}", functions | classes


def library(command):
    """The names of the library by chapter."""
    says = subprocess.run([command, "help", "--markdown"], capture_output=True, text=True, check=True).stdout
    chapters, chapter = {}, None
    for line in says.splitlines():
        if line.startswith("## "):
            chapter = line[3:].strip()
            chapters[chapter] = set()
        elif line.startswith("### ") and chapter:
            chapters[chapter].update(re.findall(r"`([^`]+)`", line) or [line[4:].strip()])
    return chapters


def rows():
    """The rows of the document: {header: {C++ name: rest of the row}}, and {library name: reason}."""
    to_programs, to_cpp, header, part = {}, {}, None, None
    for line in DOCUMENT.read_text().splitlines():
        if line.startswith("## "):
            part = line[3:].strip()
        elif line.startswith("### "):
            header = line[4:].strip().strip("`")
            to_programs[header] = {}
        elif line.startswith("|") and not re.match(r"\|\s*(-|C\+\+|library)", line):
            cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
            names = re.findall(r"`([^`]+)`", cells[0])
            for name in names:
                if part == "From a program to C++":
                    to_cpp[name] = cells[1]
                else:
                    to_programs[header][name] = cells[1:]
    return to_programs, to_cpp


def expanded(calls, known):
    """Replaces `robots.*` by all names that begin with `robots.`."""
    for call in calls:
        yield from sorted(name for name in known if name.startswith(call[:-1])) if call.endswith(".*") else [call]


def lists_of(command):
    """Words, chapters, planners ... as the command lists them."""
    return json.loads(subprocess.run([command, "help", "--lists"], capture_output=True, text=True, check=True).stdout)


def unknown_planners(lists):
    """The names of planners in the document that do not exist."""
    known = {row["name"] for row in lists["planners"]}
    named = re.findall(r"the planners? ((?:`\w+`(?:, | and )?)+)", DOCUMENT.read_text())
    return sorted(set(re.findall(r"`(\w+)`", " ".join(named))) - known)


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--list"]):
        sys.exit(__doc__)
    chapters, lists = library(sys.argv[1]), lists_of(sys.argv[1])
    known = set().union(*chapters.values())
    mathematical = set().union(*(chapters[c["title"]] for c in lists["chapters"] if c["mathematics"]))
    to_programs, to_cpp = rows() if DOCUMENT.exists() else ({}, {})
    faults, reached, missing = [], set(), {}
    for header, names in headers():
        told = to_programs.pop(header, {})
        for name in sorted(names - told.keys()):
            missing.setdefault(header, []).append(name)
            faults.append(f"{header}: `{name}` is in no row")
        for name in sorted(told.keys() - names):
            faults.append(f"{header}: there is no `{name}`")
        for name, cells in told.items():
            calls = list(expanded(re.findall(r"`([^`]+)`", cells[0]), known))
            reached.update(calls)
            faults += [f"{header}: `{name}`: the library has no `{call}`" for call in calls if call not in known]
            if not calls and (len(cells) < 2 or not cells[1]):
                faults.append(f"{header}: `{name}` is reached by nothing, and no reason is given")
    faults += [f"{header}: there is no such header" for header in to_programs]
    alone = sorted(mathematical - reached - to_cpp.keys())
    faults += [f"`{name}` of the library is in no row" for name in alone]
    faults += [f"the library has no `{name}`" for name in sorted(to_cpp.keys() - known)]
    faults += [f"`{name}` of the library has no reason" for name, why in to_cpp.items() if not why]
    faults += [f"there is no planner `{name}`" for name in unknown_planners(lists)]
    if sys.argv[2:]:
        print(json.dumps({"headers": missing, "library": alone}, indent=1))
    if faults:
        sys.exit("\n".join(f"docs/mathematics.md: {fault}" for fault in faults))
    print(f"mathematics: {sum(len(names) for _, names in headers())} names of C++ and {len(mathematical)} of the library")


if __name__ == "__main__":
    main()
