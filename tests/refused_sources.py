#!/usr/bin/env python3
"""Mistakes in C++ that the compiler finds: refused_sources.py COMPILER ROOT.

Each row is a function body, and words of the compiler's message; the first row has no mistake.
"""

import subprocess
import sys

COMPILER, ROOT = sys.argv[1:3]

BEGIN = """
#include "armlet/interpreter/diagnostic.hpp"
using namespace armlet;
constexpr CatalogEntry kRow{"E0901", "", "`{}` is {}", ""};
Diagnostic made() { return %s; }
"""

ROWS = (
    ('make_diagnostic("E0207", {}, {"moveL", "via"})', None),
    ("make_diagnostic(kRow, {}, {\"a\", \"b\"})", None),
    ('make_diagnostic(Headline::own("R0606", "none"), {})', None),
    ('make_diagnostic("E9999", {}, {"a"})', "no message with this code"),
    ('make_diagnostic("E0207", {}, {"moveL"})', "another number of arguments"),
    ('make_diagnostic("E0207", {})', "another number of arguments"),
    ('make_diagnostic(kRow, {}, {"a"})', "another number of arguments"),
    ('make_diagnostic(Headline::own("R9999", "none"), {})', "no message with this code"),
    ('make_diagnostic(Headline("E0207"), {})', "another number of arguments"),
)


def messages(expression):
    done = subprocess.run(
        [COMPILER, "-std=c++20", "-fsyntax-only", f"-I{ROOT}/interpreter/include", f"-I{ROOT}/runtime/include", "-x", "c++", "-"],
        input=BEGIN % expression, capture_output=True, text=True)
    return None if done.returncode == 0 else done.stderr


def main():
    for expression, words in ROWS:
        said = messages(expression)
        if words is None and said is not None:
            sys.exit(f"{expression} does not compile:\n{said}")
        if words is not None and said is None:
            sys.exit(f"{expression} compiles")
        if words is not None and words not in said:
            sys.exit(f"{expression}: the compiler does not say {words!r}:\n{said}")
    print(f"{len(ROWS)} expressions")


if __name__ == "__main__":
    main()
