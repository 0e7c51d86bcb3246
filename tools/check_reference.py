#!/usr/bin/env python3
"""Compares what documents repeat of the tables in the sources with those tables: docs/stdlib.md, and the blocks between
"begin of NAME" and "end of NAME" in other files: lists in the language reference and the manual page, the dictionary of
the fuzzer.

usage: check_reference.py COMMAND [--write]

--write brings the documents up to date.
"""
import difflib
import json
import pathlib
import re
import subprocess
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent


def output(command, *arguments):
    return subprocess.run([command, "help", *arguments], capture_output=True, text=True, check=True).stdout


def filled(text):
    return textwrap.fill(text, 118, break_long_words=False, break_on_hyphens=False) + "\n"


def traces(lists):
    """The extensions of trace files, for the manual page, where no line may begin with a dot."""
    formats = [f"\\&{entry['ending']} ({entry['holds']})" for entry in lists["traces"]]
    return filled("; ".join(formats) + ".")


def planners(lists):
    """The table of planners in the language reference."""
    rows = [f"| `{row['name']}` | {row['does']} |\n" for row in lists["planners"]]
    return "\n| planner | motion |\n|---|---|\n" + "".join(rows) + "\n"


def in_backticks(words):
    return " ".join(f"`{word}`" for word in words)


def words(lists):
    """The words in section 3 of the language reference."""
    reserved = [row["word"] for row in lists["words"] if not row["soft"]]
    soft = [row["word"] for row in lists["words"] if row["soft"]]
    return filled(f"**Reserved words** ({len(reserved)}): `{' '.join(reserved)}`.") + filled(
        f"**Soft words**, special only where the grammar expects them, otherwise ordinary names: `{' '.join(soft)}`.")


def units(lists):
    """Section 6 of the language reference. The letter mu is written with two characters, which look alike."""
    found = {}
    for row in lists["units"]:
        if "\u03bc" not in row["unit"]:
            found.setdefault(row["of"], []).append(row["unit"])
    rows = [f"| {dimension} | {in_backticks(names)} |\n" for dimension, names in found.items()]
    return "\n| dimension | units |\n|---|---|\n" + "".join(rows).replace("| number |", "| a plain number |") + "\n"


def entries(texts):
    """Lines of a dictionary for libFuzzer: quoted, bytes beyond ASCII as \\xAB."""
    quoted = (text.replace("\\", "\\\\").replace('"', '\\"') for text in dict.fromkeys(texts))
    return "".join(f'"{"".join(c if c.isascii() else "".join(f"{chr(92)}x{b:02X}" for b in c.encode()) for c in text)}"\n'
                   for text in quoted)


def signs(_):
    """The marks of the grammar, as they are written there."""
    grammar = (ROOT / "grammar" / "RbtLexer.g4").read_text()
    marks = grammar[grammar.index("- marks"):].split("\n// ---", 1)[0]
    return entries(re.sub(r"\\(.)", r"\1", mark) for mark in re.findall(r"^[A-Z]+ : '(.*)' ;$", marks, re.M))


def names(lists):
    """Functions of the library; fields of its types with a dot in front."""
    simple = [name for name in lists["names"] if re.fullmatch(r"[A-Za-z_][\w.]*", name)]
    return entries(name if name.startswith("robots.") else name[name.rfind("."):] if "." in name else name
                   for name in simple)


# For each file, its blocks and the functions that make their contents.
BLOCKS = {"docs/armlet.1": {"traces": traces},
          "docs/language.md": {"words": words, "units": units, "planners": planners},
          "tests/fuzz/rbt.dict": {"words": lambda lists: entries(row["word"] for row in lists["words"]), "signs": signs,
                                  "units": lambda lists: entries("2" + row["unit"] for row in lists["units"]),
                                  "names": names}}


def with_block(text, name, content):
    """The text with what has to be between the lines that begin and end the block."""
    begin = re.search(rf"^.*\bbegin of {name}\b.*\n", text, re.M)
    end = re.search(rf"^.*\bend of {name}\b.*\n", text, re.M)
    if not begin or not end:
        sys.exit(f"there is no block {name}")
    return text[:begin.end()] + content + text[end.start():]


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--write"]):
        sys.exit(__doc__)
    lists = json.loads(output(sys.argv[1], "--lists"))
    wanted = {"docs/stdlib.md": output(sys.argv[1], "--markdown")}
    for name, blocks in BLOCKS.items():
        wanted[name] = (ROOT / name).read_text()
        for block, content in blocks.items():
            wanted[name] = with_block(wanted[name], block, content(lists))
    stale = []
    for name, says in wanted.items():
        document = ROOT / name
        written = document.read_text()
        if sys.argv[2:]:
            document.write_text(says)
        elif says != written:
            sys.stdout.writelines(list(difflib.unified_diff(written.splitlines(True), says.splitlines(True),
                                                            str(document), "armlet help", n=1))[:60])
            stale.append(str(document))
    if stale:
        sys.exit(f"{' and '.join(stale)}: out of date: {sys.argv[0]} COMMAND --write")
    print("reference: up to date")


if __name__ == "__main__":
    main()
