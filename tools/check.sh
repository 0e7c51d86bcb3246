#!/usr/bin/env bash
# Everything a change must pass. Called by `./dev check`; needs clang-format, and uses antlr4 and clang-tidy when present.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

step() { printf '== %s\n' "$*"; }
ours() { git ls-files --cached --others --exclude-standard -- "$@" | grep -v '^grammar/generated/' || true; }

step format
ours '*.cpp' '*.hpp' '*.h' | xargs -r clang-format --dry-run --Werror

step layers, messages, names, sizes, structure and words
python3 tools/check_layers.py
python3 tools/check_messages.py
python3 tools/check_names.py
python3 tools/check_notices.py
python3 tools/check_sizes.py
python3 tools/check_structure.py
python3 tools/check_words.py

if command -v antlr4 >/dev/null; then
  step grammar: the committed parser is the one that the tool makes
  rm -rf build/grammar && mkdir -p build/grammar
  cmake -D generated="$PWD/build/grammar" -P grammar/regenerate.cmake
  diff -r --exclude RbtTables.h build/grammar grammar/generated  # a test checks the tables
fi

step build and test, with assertions
./dev test dev
step build and test, with the address and undefined-behaviour sanitizers
./dev test asan
step build and test, optimised
./dev test

step the page of laboratories in a browser
./dev test page

step one definition of everything: linked as a whole
./dev build odr armlet test_interpreter
step build with the other compiler
./dev build clang
step the same hashes of runs in debug and release, and from both compilers
tools/same_hashes.py build/bin/armlet build/dev/bin/armlet
tools/same_hashes.py build/bin/armlet build/clang/bin/armlet

step programs in WebAssembly as natively
./dev wasm

if command -v clang-tidy >/dev/null; then
  step clang-tidy on what has changed since the last commit
  git diff --name-only --diff-filter=d HEAD -- '*.cpp' | grep -v '^grammar/generated/' |
    xargs -r clang-tidy -p build/dev --quiet
fi
step all in order
