#!/usr/bin/env bash
# Everything a change must pass, or one part of it: tools/check.sh [PART]. Called by `./dev check`; needs clang-format, and
# uses antlr4 and clang-tidy when present.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

rooms=(interpreter runtime library scripts commands)
parts=(texts grammar "${rooms[@]/#/dev-}" "${rooms[@]/#/asan-}" tests "${rooms[@]/#/tsan-}" page whole clang native wasm tidy)

step() { printf '== %s\n' "$*"; }
ours() { git ls-files --cached --others --exclude-standard -- "$@" | grep -v '^grammar/generated/' || true; }

texts() {
  step format
  ours '*.cpp' '*.hpp' '*.h' | xargs -r clang-format --dry-run --Werror
  step changelog, citations, decisions, layers, messages, names, notices, the page, parameters, sizes, structure and words
  python3 tools/check_changelog.py
  python3 tools/check_citations.py
  python3 tools/check_decisions.py
  python3 tools/check_layers.py
  python3 tools/check_messages.py
  python3 tools/check_names.py
  python3 tools/check_notices.py
  python3 tools/check_page.py
  python3 tools/check_parameters.py
  python3 tools/check_sizes.py
  python3 tools/check_structure.py
  python3 tools/check_words.py
}

grammar() {
  command -v antlr4 >/dev/null || { step 'grammar: antlr4 is not installed, so the parser is not compared'; return 0; }
  step grammar: the committed parser is the one that the tool makes
  rm -rf build/grammar && mkdir -p build/grammar
  cmake -D generated="$PWD/build/grammar" -P grammar/regenerate.cmake
  diff -r --exclude RbtTables.h build/grammar grammar/generated  # a test compares RbtTables.h
}

# tests_of PRESET ROOM: one part of the tests with assertions (dev) or with sanitizers (asan, tsan).
tests_of() {
  local names
  case $2 in
    interpreter) names='^unit[.](interpreter|host|opcodes|checked|convert|oracle)$|^fuzz[.]' ;;
    runtime) names='^layer[.]|^unit[.](backend|camera|cell|chain|collision|control|core|dynamics|grasp|image|kinematics|math|mesh|model|opencv|planning|plot|support|trajectory|vision|world)$' ;;
    library) names='^unit[.](apps|lab|stdlib)$' ;;
    scripts) names='^(tests/scripts|examples)/' ;;
    commands) names='[.](command|server|secrets|read|write)$|^(hostile|trace[.]numpy)$' ;;
  esac
  step "tests of $2 in build/$1"
  ./dev test "$1" "$names"
}

tests() {
  step build and test, optimised
  ./dev test
}

page() {
  step the page of laboratories in a browser
  ./dev test page
}

whole() {
  step one definition of everything: linked as a whole
  ./dev build odr armlet test_interpreter
}

clang() {
  step build with the other compiler
  ./dev build clang
  step the same hashes of runs in debug and release, and from both compilers
  ./dev build
  ./dev build dev armlet
  tools/same_hashes.py build/bin/armlet build/dev/bin/armlet
  tools/same_hashes.py build/bin/armlet build/clang/bin/armlet
}

native() {
  step the same hashes of runs and pixels with the widest instructions of this machine
  ./dev build
  ./dev build native armlet test_camera
  tools/same_hashes.py build/bin/armlet build/native/bin/armlet
  build/native/tests/test_camera -tc='*recorded bits*'
}

wasm() {
  step programs in WebAssembly as natively
  ./dev wasm
}

tidy() {
  command -v clang-tidy >/dev/null || { step 'clang-tidy is not installed'; return 0; }
  step clang-tidy on what has changed since the last commit
  git diff --name-only --diff-filter=d HEAD -- '*.cpp' | grep -v '^grammar/generated/' |
    xargs -r clang-tidy -p build/dev --quiet
}

(($#)) || set -- "${parts[@]}"
for part; do
  [[ " ${parts[*]} " == *" $part "* ]] || { echo "check: there is no part $part; parts are: ${parts[*]}" >&2; exit 64; }
done
for part; do
  case $part in
    dev-* | asan-* | tsan-*) tests_of "${part%%-*}" "${part#*-}" ;;
    *) "$part" ;;
  esac
done
step all in order
