#!/usr/bin/env python3
"""What hosts see of an installed package: check_package.py COMPILER PREFIX BUILD

The public headers of the language are read alone, without exceptions and without Eigen's folder, and none brings along
Eigen or ANTLR. Nothing of the parser is visible: its symbols are hidden in the library, and a host that shows its own shows
none of them. That host is run.
"""
import pathlib
import re
import subprocess
import sys

COMPILER, PREFIX, BUILD = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
FOREIGN = re.compile(r"/Eigen/|antlr4", re.IGNORECASE)
PARSER = re.compile(r"Rbt(Lexer|Parser)")


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def header_faults():
    include = PREFIX / "include"
    headers = sorted((include / "armlet" / "interpreter").rglob("*.hpp")) + sorted((include / "armlet" / "core").glob("*.hpp"))
    if len(headers) < 30:
        yield f"only {len(headers)} headers in {include}"
    text = "".join(f'#include "{header.relative_to(include)}"\n' for header in headers)
    done = subprocess.run([COMPILER, "-std=c++20", "-fno-exceptions", "-M", f"-I{include}", "-x", "c++", "-"],
                          input=text, capture_output=True, text=True)
    read = subprocess.run([COMPILER, "-std=c++20", "-fno-exceptions", "-fsyntax-only", f"-I{include}", "-x", "c++", "-"],
                          input=text, capture_output=True, text=True)
    if done.returncode or read.returncode:
        yield f"the headers cannot be read alone:\n{done.stderr}{read.stderr}"
    for name in sorted(set(word for word in done.stdout.split() if FOREIGN.search(word))):
        yield f"the headers of the language bring along {name}"
    for header in headers:
        if re.search(r"\blang::|namespace lang\b", header.read_text()):
            yield f"{header} shows the inside of the interpreter"


def symbol_faults():
    (library,) = PREFIX.glob("lib*/**/libarmlet_interpreter.a")
    seen = 0
    for line in run("readelf", "--symbols", "--wide", str(library)).splitlines():
        fields = line.split()
        if len(fields) == 8 and PARSER.search(fields[7]) and fields[6] != "UND" and fields[4] in ("GLOBAL", "WEAK"):
            seen += 1
            if fields[5] != "HIDDEN":
                yield f"{library.name} shows {fields[7]}"
    if seen < 100:
        yield f"only {seen} symbols of the parser in {library}: is it there?"


def shown_faults():
    (host,) = BUILD.rglob("language_only")
    shown = [line.split()[-1] for line in run("nm", "--dynamic", "--defined-only", str(host)).splitlines()]
    ours = [name for name in shown if re.search(r"antlr|Rbt", name)]
    if ours or "main" not in shown:
        yield f"the host shows {ours[:10]}, {len(ours)} in all"


def host_faults():
    (host,) = BUILD.rglob("language_only")
    said = run(str(host))
    expected = '42\n`speed` takes a speed, and was given an int; give its unit, such as "m/s".\nR0606\n'
    if said != expected:
        yield f"the host says {said!r}"


def main():
    faults = [fault for check in (header_faults, symbol_faults, shown_faults, host_faults) for fault in check()]
    print("\n".join(faults) if faults else "the package: in order")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
