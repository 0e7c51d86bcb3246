#!/usr/bin/env python3
"""One Ctrl-C ends every function of the library at the largest input: stop_library.py ARMLET [PART PARTS].

The functions are those of `armlet help --markdown`. Each needs a program that calls it without end: one of largest.txt,
one made from the types of its parameters, or, where same_work.txt says why its work does not grow, its example.
"""

import random
import re
import subprocess
import sys
from pathlib import Path

from stopping import stop_all

HERE = Path(__file__).resolve().parent
COMMAND = Path(sys.argv[1]).resolve()
PART, PARTS = (int(sys.argv[2]), int(sys.argv[3])) if len(sys.argv) > 3 else (0, 1)

BEGINS = {}  # seconds from which the stop comes, by program

# Large arguments by the type of a parameter: what declares them, and their name.
LARGE = {
    "D[]": ("let xs = linspace(0.5, 0.9, 2000000)", "xs"),
    "E[]": ("let xs = linspace(0.5, 0.9, 2000000)", "xs"),
    "(D^2)[]": ("let xs = linspace(0.5, 0.9, 2000000)", "xs"),
    "T[]": ("let xs = linspace(0.5, 0.9, 2000000)", "xs"),
    "U[]": ("let xs = linspace(0.5, 0.9, 2000000)", "xs"),
    "double[]": ("let xs = linspace(0.5, 0.9, 2000000)", "xs"),
    "int[]": ("let ks = range(2000000)", "ks"),
    "string": ('let s = "abcdefgh,".repeat(3000000)', "s"),
    "string[]": ('let ts = range(300000).map(fn(i) => "item" + i)', "ts"),
    "double[][]": ("let rs = range(300000).map(fn(i) => [0.1, 0.2, 0.3])", "rs"),
    "int[][]": ("let krs = range(300000).map(fn(i) => [1, 2, 3])", "krs"),
    "D[][]": ("let rs = range(300000).map(fn(i) => [0.1, 0.2, 0.3])", "rs"),
    "matrix": ("let m = ones(1500, 1500)", "m"),
    "matrix[]": ("let m = ones(1500, 1500)\nlet ms = [m, m, m]", "ms"),
}
SMALL = {"D": "0.5", "E": "0.5", "T": "0.95", "double": "0.5", "int": "3", "bool": "true", "posJ": "home()", "posC": "here()",
         "fn(T) -> U": "fn(x) => x", "fn(T) -> bool": "fn(x) => x < 2.0", "fn(U, T) -> U": "fn(a, b) => a + b"}


def reference():
    """(signature, example) of every function, in the order of the reference."""
    text = subprocess.run([COMMAND, "help", "--markdown"], capture_output=True, text=True, check=True).stdout
    rows = []
    for page in re.split(r"\n(?=##+ )", text):
        if not page.startswith("### "):
            continue
        signatures = []
        for block in re.findall(r"```text\n(.*?)```", page, re.S):
            for line in block.rstrip().split("\n"):
                if line.startswith(" "):
                    signatures[-1] += " " + line.strip()
                else:
                    signatures.append(line)
        example = page.split("\nExample:\n", 1)
        lines = example[1].strip("\n").split("\n") if len(example) > 1 else []
        body = "\n".join(line[4:] for line in lines if line.startswith("    ") or not line)
        rows += [(each, body.strip()) for signature in signatures for each in choices(signature)]
    return rows


def choices(signature):
    """The signatures of a row with unions, "f(q: posJ | double[]) -> double": one for each choice of types."""
    stored = re.fullmatch(r"(.*\] = )([^()]*)", signature)  # image[x, y] = int | Color
    if stored:
        return [stored[1] + each for each in stored[2].split(" | ")]
    begin = signature.find("(")
    if " | " not in signature or begin < 0:
        return [signature]
    end = closing(signature, begin)
    all_ = [""]
    for parameter in split_parameters(signature[begin + 1:end]):
        name, _, types = parameter.partition(": ")
        all_ = [f"{one}{', ' if one else ''}{name}: {each}" for one in all_ for each in types.split(" | ")]
    return [signature[:begin + 1] + one + signature[end:] for one in all_]


def sections(path):
    """[(beginnings of signatures, program)] of a file of programs. `@ 0.4` at the end of a head: what comes before the
    call takes so many seconds, and the program is stopped after them."""
    out = []
    for part in re.split(r"^=== ", path.read_text(), flags=re.M)[1:]:
        head, body = part.split("\n", 1)
        head, _, seconds = head.partition(" @ ")
        out.append((head.split(" | "), body))
        if seconds:
            BEGINS[body] = float(seconds)
    return out


def same_work(path):
    """Beginnings of the signatures of functions whose work does not grow."""
    lines = [line for line in path.read_text().split("\n") if line and not line.startswith("#")]
    return [beginning for line in lines for beginning in line.split(" | ")]


def split_parameters(text):
    """The parameters between the brackets, at commas that are inside of no other brackets."""
    out, depth, begin = [], 0, 0
    for i, letter in enumerate(text):
        depth += letter in "([{"
        depth -= letter in ")]}"
        if letter == "," and depth == 0:
            out.append(text[begin:i].strip())
            begin = i + 1
    return out + [text[begin:].strip()] if text[begin:].strip() else out


def closing(text, begin):
    """Where the bracket that opens at `begin` closes."""
    depth = 0
    for i in range(begin, len(text)):
        depth += text[i] in "([{"
        depth -= text[i] in ")]}"
        if depth == 0:
            return i
    return len(text)


def by_types(signature):
    """A program that calls a function with large arguments; None if it takes none, or others."""
    operator = re.fullmatch(r"(-?)(\S+?)(?: (\S+) (\S+))? -> (\S+)", signature)
    declared = []

    def value(kind):
        if kind in LARGE:
            declared.append(LARGE[kind][0])
            return LARGE[kind][1]
        return SMALL.get(kind)

    if operator and "(" not in operator[2].replace("(D^2)", "") and "." not in operator[2]:
        values = [value(kind) for kind in operator.group(2, 4) if kind]
        sign = operator[3]
        call = f"{values[0]} {sign} {values[-1]}" if sign else operator[1] + str(values[0])
    else:
        begin = signature.find("(")
        if begin < 0 or " " in signature[:begin]:
            return None
        values = []
        for parameter in split_parameters(signature[begin + 1:closing(signature, begin)]):
            kind = parameter.split(": ", 1)[-1]
            if " = " in kind or kind.endswith("?"):
                break
            values.append(value(kind))
        name = signature[:begin]
        if "." in name and values and values[0] is not None:
            call = values[0] + name[name.find("."):] + (f"({', '.join(map(str, values[1:]))})" if values[1:] else "")
        else:
            call = f"{name}({', '.join(map(str, values))})"
    if None in values or not declared:
        return None
    lines = sorted(set("\n".join(declared).split("\n")))
    return "\n".join(lines) + "\nwhile (true) { let result = " + call + " }\n"


def of_example(example):
    """The example without end, in the first form that the checker takes."""
    before, last = example[:example.rfind("\n") + 1], example[example.rfind("\n") + 1:]
    def loop(text):
        return "while (true) {\n    try {\n" + text + "\n    } catch (e) { }\n}"

    for text in (loop(example), loop("let result = " + example), loop(f"print({example})"),
                 before + loop("let result = " + last), before + loop(last), example + "\nwhile (true) { }",
                 "robot one { " + example + " }\nwhile (true) { }",
                 "robot arm = robots.scara()\ncamera eye { on: arm }\nlab one { " + example + " }\nwhile (true) { }"):
        check = subprocess.run([COMMAND, "check", "/dev/stdin"], input=text, capture_output=True, text=True, check=False)
        if check.returncode == 0:
            return text
    return None


def programs(faults):
    """(signature, program) of each function; faults are reported for those that have none."""
    large = sections(HERE / "largest.txt")
    same = same_work(HERE / "same_work.txt")
    used = set()
    for signature, example in reference():
        found = [(beginnings, body) for beginnings, body in large if any(map(signature.startswith, beginnings))]
        is_same = [beginning for beginning in same if signature.startswith(beginning)]
        used |= {beginning for beginnings, _ in found for beginning in beginnings if signature.startswith(beginning)}
        used |= set(is_same)
        if found and is_same:
            faults.append(f"{signature} is in largest.txt and in same_work.txt")
        made = [body for _, body in found] or [of_example(example) if is_same else by_types(signature)]
        for body in made:
            if body is None:
                faults.append(f"{signature} has no program: write one with its largest input in largest.txt, or name it "
                              "in same_work.txt with the reason why its work does not grow")
            else:
                yield signature, body
    for beginning in [b for beginnings, _ in large for b in beginnings] + same:
        if beginning not in used:
            faults.append(f"no function begins with {beginning!r} any more")


def main():
    faults = []
    rows = list(dict.fromkeys((body, signature) for signature, body in programs(faults)))
    bodies = list(dict.fromkeys(body for body, _ in rows))
    names = {body: signature for body, signature in reversed(rows)}
    instants = random.Random(42)
    work = [(names[body], body, BEGINS.get(body, 0.0) + instants.uniform(0.05, 0.4)) for body in bodies]
    longest = (0.0, 0.0, "")
    for name, body, run in stop_all(COMMAND, work[PART::PARTS]):
        longest = max(longest, (run.cpu, run.seconds, name))
        if run.fault:
            faults.append(f"{name}: {run.fault}\n{body}")
    print(f"{len(bodies)} programs for {len(rows)} functions; the longest took {longest[0]:.3f} s of the processor and "
          f"{longest[1]:.3f} s to stop: {longest[2]}")
    if faults:
        sys.exit("stop_library.py:\n" + "\n".join(faults))


main()
