#!/usr/bin/env python3
"""Checks that grammar/generated/RbtTables.h is what the grammar says.

usage: check_tables.py MAKE_TABLES [--write]
"""
import pathlib
import subprocess
import sys

TABLES = pathlib.Path(__file__).resolve().parent.parent / "grammar" / "generated" / "RbtTables.h"


def main():
    made = subprocess.run([sys.argv[1]], check=True, capture_output=True, text=True).stdout
    if "--write" in sys.argv[2:]:
        TABLES.write_text(made)
    elif TABLES.read_text() != made:
        sys.exit("grammar/generated/RbtTables.h is not what grammar/make_tables.cpp writes: "
                 "run tools/check_tables.py build/release/grammar/make_tables --write")


if __name__ == "__main__":
    main()
