#!/usr/bin/env python3
"""Checks words against docs/glossary.md, which has the words and the exceptions with their reasons.

usage: check_words.py [--advice [PATH...]]

- Documents and the changelog do not use the words of "Words not to be used". In comments, rows of messages and texts of the tools they are
  advice: the number is printed, and with --advice each use (below PATH, or in all files).
- The interpreter knows no robots: no word of "Words that the language does not know" is in its sources.
"""

import io
import re
import sys
import tokenize
from collections import Counter
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
from check_citations import comments, tracked

ROOT = Path(__file__).resolve().parent.parent
GLOSSARY = "docs/glossary.md"
SOURCES = (".cpp", ".hpp", ".inc", ".py", ".cmake", ".sh", ".ts", ".mjs", ".g4", ".def")
LEFT_OUT = ("grammar/generated/", "tests/fuzz/corpus", "tests/mistakes/", "tests/reference/", "apps/lab/page/dist/", "notices/", "build/")

INTERPRETER = ("interpreter/src", "interpreter/include")
ARM_A_CONDITION = re.compile(r"\barm\(")  # the verb
PUMA = r"puma\d*"  # a word with a number behind it
# The headlines are the language's; the pages of help below them are written for users of the library, with its programs.
MESSAGES = "interpreter/include/armlet/interpreter/messages/"


def tables(text, heading):
    """The tables below a heading of the second level, as lists of rows without their first line."""
    section = re.split(r"(?m)^## ", text[text.index(f"\n## {heading}\n") + 4:])[0]
    rows = [[cell.strip() for cell in line.strip("|").split("|")] if line.startswith("|") else None for line in section.splitlines()]
    found, table = [], []
    for row in rows + [None]:
        if row is not None:
            table.append(row)
        elif table:
            found.append(table[2:])
            table = []
    return found


def words_of(cell):
    return [word.strip() for word in cell.split(",") if word.strip()]


def pattern(words, flags=re.IGNORECASE):
    return re.compile(r"\b(?:" + "|".join(sorted((re.escape(word) for word in words), key=len, reverse=True)) + r")\b", flags)


class Glossary:
    def __init__(self, text):
        words, stays, files = tables(text, "Words not to be used")
        self.instead = {word: row[1] for row in words for word in words_of(row[0])}
        self.first = {word: words_of(row[0])[0] for row in words for word in words_of(row[0])}
        self.forbidden = pattern(self.instead)
        self.stays = pattern([word for row in stays for word in words_of(row[0])])
        self.files = {row[0]: words_of(row[1]) for row in files}
        robots, paths = tables(text, "Words that the language does not know")
        self.robots = re.compile(pattern([word for row in robots for word in words_of(row[0])]).pattern[:-3] + rf"|{PUMA})\b", re.IGNORECASE)
        self.paths = {row[0]: row[1] for row in paths}

    def uses(self, line):
        """The words of a line that have a better one."""
        line = self.stays.sub(lambda m: " " * len(m[0]), line)
        return [match[0] for match in self.forbidden.finditer(line)]

    def exception(self, name, word):
        """The row of the files that excepts a word in a file, or None."""
        for key, words in self.files.items():
            if (name == key or key.endswith("/") and name.startswith(key)) and ("all" in words or self.first[word.lower()] in words):
                return key
        return None


def python_prose(name, text):
    """Comments and documentation of a Python source with their lines; of a tool also its texts, which in tests are mostly data."""
    opened = True  # whether a string here stands alone on its line
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT or token.type == tokenize.STRING and (opened or name.startswith("tools/")):
            for offset, line in enumerate(token.string.splitlines()):
                yield token.start[0] + offset, re.sub(r"\{[^}]*\}", "{}", line)
        if token.type not in (tokenize.COMMENT, tokenize.NL):
            opened = token.type in (tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT)


def prose(name, text):
    """The lines of a file that are for readers, without code and addresses."""
    fenced = False
    for number, line in python_prose(name, text) if name.endswith(".py") else enumerate(comments(name, text).splitlines(), 1):
        if name.endswith(".md"):
            fenced ^= line.startswith("```")
            if fenced or line.startswith("    "):
                continue
            line = re.sub(r"\]\([^)]*\)", "]", line)
        yield number, re.sub(r"`[^`]*`", "`", line)


def kind_of(name):
    """document, comment, or None for what is not read."""
    if name.startswith(LEFT_OUT) or name in (GLOSSARY, "tools/check_words.py"):
        return None
    if name.endswith(".md"):
        return "document"
    return "comment" if name.endswith(SOURCES) or name in ("dev", "CMakeLists.txt") else None


def uses(glossary, names, excepted):
    """Kind, file, line and word of each use; exceptions that are needed are added to `excepted`."""
    for name in names:
        kind = kind_of(name)
        if not kind:
            continue
        for number, line in prose(name, (ROOT / name).read_text(encoding="utf-8", errors="replace")):
            for word in glossary.uses(line):
                if key := glossary.exception(name, word):
                    excepted.add(key)
                else:
                    yield kind, name, number, word


def robots_in_interpreter(glossary, names):
    used = set()
    for name in names:
        if not name.startswith(INTERPRETER) or not name.endswith((".hpp", ".cpp", ".def")):
            continue
        found = [(number, match[0])
                 for number, line in enumerate((ROOT / name).read_text(encoding="utf-8").splitlines(), 1)
                 if not name.startswith(MESSAGES) or line.startswith("ARMLET_MESSAGE")
                 for match in glossary.robots.finditer(ARM_A_CONDITION.sub("", line))]
        exception = next((key for key in glossary.paths if name.startswith(key)), None)
        if exception and found:
            used.add(exception)
        elif not exception:
            for number, word in found:
                yield f"{name}:{number}: `{word}` is a word of robots; move it to the library (stdlib/)"
    for key in glossary.paths.keys() - used:
        yield f"{GLOSSARY}: {key} is an unnecessary exception"


def main():
    glossary = Glossary((ROOT / GLOSSARY).read_text(encoding="utf-8"))
    names = tracked()
    excepted = set()
    found = list(uses(glossary, names, excepted))
    faults = [f"{name}:{number}: `{word}`: say {glossary.instead[word.lower()]}" for kind, name, number, word in found if kind == "document"]
    faults += list(robots_in_interpreter(glossary, names))
    faults += [f"{GLOSSARY}: {name} is an unnecessary exception" for name in glossary.files if name not in excepted]
    advice = [(name, number, word) for kind, name, number, word in found if kind == "comment"]
    if "--advice" in sys.argv[1:]:
        below = tuple(arg for arg in sys.argv[1:] if arg != "--advice") or ("",)
        for name, number, word in advice:
            if name.startswith(below):
                print(f"{name}:{number}: advice: `{word}`: say {glossary.instead[word.lower()]}")
    if faults:
        print("\n".join(faults))
        return 1
    counted = Counter(glossary.first[word.lower()] for _, _, word in advice)
    print("words: documents as in the glossary; advice for comments (--advice): " +
          ", ".join(f"{word} {number}" for word, number in counted.most_common()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
