#!/usr/bin/env python3
"""Checks that what comments and documents cite exists: sections, decisions, message codes and files.

usage: check_citations.py [FILE...]

Rules of the language are cited by the section of their subject. "Section 13.2" means docs/language.md, or the document that
says it if that has numbered headings; a section of a book stands behind its year. CHANGELOG.md is about the past and is left out.
In documents also code spans that are paths, such as `vm/heap` and `tests/unit/<layer>/`, and commands of ./dev.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
REFERENCE = "docs/language.md"
SOURCES = (".cpp", ".hpp", ".inc", ".def", ".g4", ".py", ".cmake", ".sh", ".txt", ".rbt", ".md")
LEFT_OUT = ("CHANGELOG.md", "LICENSE", "grammar/generated/", "tests/fuzz/corpus", "tests/mistakes/")

# Codes that tests use because no message has them.
MADE_UP = {"E0999", "E9999", "W0799", "R0699"}

NUMBER = r"\d{1,2}(?:\.\d{1,2})?"
LIST = rf"{NUMBER}(?:(?:,| and| to|;)\s+{NUMBER}(?![\d.]*\s*(?:mm|deg|s|%)\b))*"
SECTION = re.compile(rf"\b[Ss]ections?\s+({LIST})")
BARE = re.compile(rf"\breference,\s+({NUMBER})\b")
RULING = re.compile(r"\b[Rr]ulings?\s+\d+")
DECISION = re.compile(r"\b[Dd]ecisions?\s+(\d+(?:(?:,| and|, and)\s+\d+)*)\b")
CODE = re.compile(r"\b([ERW]\d{4})\b")
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")
NAME = re.compile(r"(?<![\w./<>{*-])((?:[\w.-]+/)*[\w-]+(?:\.[\w-]+)*\.(?:cpp|hpp|md|py|def|g4|inc|cmake))\b(?!/)")
SPAN = re.compile(r"`([\w.<>{},*-]+(?:/[\w.<>{},*-]+)+/?|[\w.-]+/)`")
COMMAND = re.compile(r"\./dev ([a-z]+)(?: ([a-z]+(?:-[a-z]+)?))?")
BOOK = re.compile(r"\b(?:1[89]|20)\d\d\b")


def tracked():
    out = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                         capture_output=True, text=True, check=True).stdout
    return [line for line in out.splitlines() if (ROOT / line).is_file()]


def catalogue():
    rows = "".join(p.read_text() for p in sorted(ROOT.glob("*/**/messages/*.def")))
    return set(re.findall(r"^ARMLET_MESSAGE\(([ERW]\d{4}),", rows, re.M))


def headings(text):
    """The numbers of the headings of a document: "13.2" of "### 13.2 Moves"."""
    return set(re.findall(rf"^#+ ({NUMBER})\.?\s", text, re.M))


def comments(path, text):
    """The text for readers: all of a document; of a source only its comments, in their lines."""
    if path.endswith((".md", ".txt", ".def")):
        return text
    if path.endswith(".rbt"):
        return "\n".join(re.sub(r"^.*?//", "//", line) if "//" in line else "" for line in text.splitlines())
    mark = r"(?://|#(?!\s*(?:include|define|if|endif|pragma|else)))"
    if path.endswith(".py"):
        return "\n".join(text.splitlines())
    return "\n".join((re.search(rf'(?:^|[\s;{{}})]){mark}.*', line) or [""])[0] for line in text.splitlines())


def joined(text):
    """Comments as one text, since sentences continue in the next line; and a line number for every character."""
    out, lines = [], []
    for number, line in enumerate(text.splitlines(), 1):
        line = re.sub(r"^\s*(?://+|#)\s?", "", line) + " "
        out.append(line)
        lines += [number] * len(line)
    return "".join(out), lines


def commands():
    """The commands of ./dev, and the parts of ./dev check."""
    usage = (ROOT / "dev").read_text()
    lists = dict(re.findall(r"^(rooms|parts)=\((.*)\)", (ROOT / "tools/check.sh").read_text(), re.M))
    parts = {part for part in lists["parts"].split() if part.isalpha()}
    return (set(re.findall(r"^\./dev ([a-z]+)", usage, re.M)),
            parts | {f"{kind}-{room}" for kind in ("dev", "asan", "tsan") for room in lists["rooms"].split()})


def branches(path):
    """The paths that are meant by one with {a,b}."""
    m = re.search(r"\{([^{}]*)\}", path)
    return [path] if not m else [b for each in m[1].split(",") for b in branches(path[:m.start()] + each + path[m.end():])]


class Checker:
    def __init__(self):
        self.files = tracked()
        self.codes = catalogue() | MADE_UP
        self.sections = headings((ROOT / REFERENCE).read_text())
        self.decisions = {int(m[1]) for f in self.files if (m := re.match(r"docs/decisions/(\d{4})-", f))}
        self.suffixes = {}
        for file in self.files:
            parts = file.split("/")
            for i in range(len(parts)):
                self.suffixes.setdefault("/".join(parts[i:]), file)
        self.paths = {*self.files, *(str(folder) for file in self.files for folder in pathlib.PurePosixPath(file).parents)}
        self.folders = {path.rsplit("/", 1)[-1] for path in self.paths - set(self.files)} - {"build"}
        self.commands, self.parts = commands()
        self.faults = []

    def fault(self, path, line, what):
        self.faults.append(f"{path}:{line}: {what}")

    def check(self, path):
        text = (ROOT / path).read_text(errors="replace")
        said = comments(path, text)
        flat, lines = joined(said)
        own = headings(text) if path.endswith(".md") else set()
        at = lambda m: lines[min(m.start(), len(lines) - 1)]
        for m in [*SECTION.finditer(flat), *BARE.finditer(flat)]:
            if BOOK.search(flat[max(0, m.start() - 90):m.start()]):
                continue
            for number in re.findall(NUMBER, m[1]):
                if number not in self.sections | own:
                    self.fault(path, at(m), f"there is no section {number}")
        for m in RULING.finditer(flat):
            self.fault(path, at(m), f"{m[0]}: cite the section of {REFERENCE} that has the rule")
        for m in DECISION.finditer(flat):
            for number in re.findall(r"\d+", m[1]):
                if int(number) not in self.decisions:
                    self.fault(path, at(m), f"there is no decision {number}")
        for m in CODE.finditer(flat):
            if m[1] not in self.codes and m[1][1:3] in ("01", "02", "03", "04", "05", "06", "07"):
                self.fault(path, at(m), f"there is no message {m[1]}")
        self.check_files(path, flat, at)
        if path.endswith(".md"):
            self.check_spans(path, text)

    def check_spans(self, path, text):
        for number, line in enumerate(text.splitlines(), 1):
            for m in SPAN.finditer(line):
                for branch in branches(m[1].strip("./")):
                    if branch.split("/")[0] in self.folders and not self.is_path(branch):
                        self.fault(path, number, f"there is no {branch}")
            for m in COMMAND.finditer(line):
                if m[1] not in self.commands:
                    self.fault(path, number, f"there is no command ./dev {m[1]}")
                elif m[1] == "check" and m[2] and m[2] not in self.parts and f"`{m[0]}" in line:
                    self.fault(path, number, f"./dev check has no part {m[2]}")

    def is_path(self, branch):
        """Whether a file or folder has this path or the end of it; `*`, `<layer>`, `NAME` and `...` are any name, and an
        ending may be left out."""
        wild = re.sub(r"<\w+>|\*+|\.\.\.|(?<![A-Za-z])[A-Z]{4,}(?![A-Za-z])", "\0", branch)
        wanted = re.compile(r"(?:.*/)?" + re.escape(wild).replace("\0", "[^/]*") + r"(?:\.\w+)*")
        return any(wanted.fullmatch(each) for each in self.paths)

    def check_files(self, path, flat, at):
        folder = pathlib.PurePosixPath(path).parent
        for m in LINK.finditer(flat) if path.endswith(".md") else ():
            if not re.match(r"\w+:", m[1]) and not (ROOT / folder / m[1]).exists():
                self.fault(path, at(m), f"there is no {m[1]}")
        for m in NAME.finditer(flat):
            name = m[1].lstrip("./")
            parts = [p for p in name.split("/") if p not in ("..", ".")]
            placeholder = re.search(r"[A-Z]{4,}", name) and not name.endswith(".md")
            if "/".join(parts) in self.suffixes or placeholder:
                continue
            self.fault(path, at(m), f"there is no file {m[1]}")


def main():
    checker = Checker()
    chosen = [str(pathlib.Path(f).resolve().relative_to(ROOT)) for f in sys.argv[1:]] or [
        f for f in checker.files if f.endswith(SOURCES) and not f.startswith(LEFT_OUT)]
    for path in chosen:
        checker.check(path)
    if checker.faults:
        sys.exit("\n".join(checker.faults))
    print(f"citations: all of {len(chosen)} files are right")


if __name__ == "__main__":
    main()
