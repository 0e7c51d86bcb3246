#!/usr/bin/env python3
"""Checks the one-definition rule: no type and no inline function is defined twice under one full name.

A linker keeps one of two definitions with the same name and says nothing. What only one file needs belongs into an
anonymous namespace. Reads namespaces, types and inline functions with a small scanner, not a compiler; the preset
`odr` links everything with -flto -Wodr.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ["runtime", "interpreter", "stdlib", "apps", "tests", "bench"]
# Separate programs, which are never linked with the rest.
APART = ["tests/embed/", "runtime/src/core/bare/"]  # built instead of others of the same names

NOISE = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<d>[^(\s]*)\(.*?\)(?P=d)"|"(?:\\.|[^"\\\n])*"'
    r"|(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+'|^[ \t]*#(?:[^\n\\]|\\\n|\\.)*", re.S | re.M)
TOKEN = re.compile(r"[A-Za-z_]\w*|::|\[\[|\]\]|->|[{}();<>=,:&*~\[\]]|[^\s\w]|\d[\w.']*")
TYPE = ("struct", "class", "union", "enum")


def without_noise(text):
    """The text without comments, literals and lines of the preprocessor, with its line breaks."""
    return NOISE.sub(lambda m: ('""' if m[0][0] in '"R' else " ") + "\n" * m[0].count("\n"), text)


def tokens_of(text):
    line = 1
    at = 0
    for match in TOKEN.finditer(text):
        line += text.count("\n", at, match.start())
        at = match.start()
        yield match[0], line


def namespace_named(head):
    """The parts of the name in `namespace a::b`; [None] if it has none."""
    words = [w for w in head[head.index("namespace") + 1:] if re.match(r"[A-Za-z_]", w)]
    return words or [None]


def type_named(head):
    """The name of the type that `head` begins to define, or None."""
    depth = 0
    for i, word in enumerate(head):
        depth += (word == "<") - (word == ">")
        if depth > 0 or word not in TYPE:
            continue
        rest = [w for w in head[i + 1:] if w not in ("class", "struct", "final", "alignas")]
        while rest and rest[0] in ("[[", "("):
            end = "]]" if rest[0] == "[[" else ")"
            rest = rest[rest.index(end) + 1:]
        if "(" in rest:  # a function that returns a type spelled with its key word
            return None
        until = next((j for j, w in enumerate(rest) if w == ":"), len(rest))
        return None if "<" in rest[:until] else "".join(rest[:until]) or None  # a specialisation defines no name
    return None


def parameter_types(words):
    """The tokens of a parameter list without the names of the parameters and their defaults."""
    kept = []
    depth = 0
    in_default = False
    for i, word in enumerate(words):
        depth += (word in "(<[") - (word in ")>]")
        following = words[i + 1] if i + 1 < len(words) else ")"
        if depth <= 1 and word == ",":
            in_default = False
        in_default = in_default or word == "="
        named = i > 1 and re.match(r"[A-Za-z_]", word) and following in (",", ")", "=") and words[i - 1] not in ("(", ",", "::")
        if not in_default and not (named and depth <= 1):
            kept.append(word)
        if depth == 0:
            break
    return " ".join(kept)


def is_specialised_constant(head):
    """Whether `head` gives a constant template another value: template <> inline constexpr int kName<T> = 1."""
    return "=" in head and head[head.index("=") - 1] == ">"


def inline_name(head):
    """Name, and for functions types of the parameters, of what `head` begins to define, if several files may define it."""
    if not {"inline", "constexpr", "consteval", "template"} & set(head) or "static" in head:
        return None
    if "template" in head:  # parameters of the template are types, not the function
        depth = 0
        for i in range(head.index("template") + 1, len(head)):
            depth += (head[i] == "<") - (head[i] == ">")
            if depth == 0:
                break
        head = head[i + 1:]
        if head and head[0] in TYPE:  # a specialisation for a type of function
            return None
    until = next((i for i, word in enumerate(head) if word in ("(", "=", "[")), len(head))
    if until == 0 or not re.match(r"[A-Za-z_]", head[until - 1]):
        return None
    if until < len(head) and head[until] == "(":
        return head[until - 1] + parameter_types(head[until:])
    return head[until - 1] if "inline" in head else None  # a constant that is not inline belongs to its file


def definitions(text):
    """Every (full name, line) of a type or inline function defined in a namespace that has a name."""
    scopes = []  # for each open brace: names of a namespace, or None for anything else
    head = []
    for token, line in tokens_of(without_noise(text)):
        if token == "{":
            inside = all(scope is not None for scope in scopes)
            names = None
            if inside and "namespace" in head and "using" not in head:
                names = namespace_named(head)
            elif inside and head:
                path = [name for scope in scopes for name in scope]
                found = type_named(head) or inline_name(head)
                if found and None not in path:
                    yield "::".join([*path, found]), line
            scopes.append(names)
            head = []
        elif token == "}":
            if scopes:
                scopes.pop()
            head = []
        elif token == ";":
            if "inline" in head and "=" in head and not is_specialised_constant(head) and all(scope is not None for scope in scopes):
                path = [name for scope in scopes for name in scope]
                if None not in path:
                    yield "::".join([*path, inline_name(head) or "?"]), line
            head = []
        else:
            head.append(token)


def main():
    places = {}
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.[ch]pp")):
            name = path.relative_to(ROOT).as_posix()
            if any(name.startswith(apart) for apart in APART):
                continue
            for what, line in definitions(path.read_text(encoding="utf-8")):
                places.setdefault(what, []).append(f"{name}:{line}")
    faults = {what: where for what, where in places.items() if len(where) > 1}
    for what, where in sorted(faults.items()):
        print(f"{what} is defined {len(where)} times: {', '.join(where)}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
