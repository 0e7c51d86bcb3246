#!/usr/bin/env bash
# Runs programs in the WebAssembly module as natively: tests/wasm/run.sh COMMAND WRITE_PROGRAMS COUNT
# the examples, sixty pictures, and COUNT random programs. Status 77: there is no module that is up to date; `./dev wasm` makes one.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
command=$(realpath "$1") write_programs=$(realpath "$2")

if ! [[ -f build/wasm/armlet.wasm && $(ninja -C build/wasm -n 2>&1) == *'no work to do'* ]]; then
  echo 'there is no build of the module that is up to date: ./dev wasm'
  exit 77
fi
node tests/wasm/measure.mjs build/wasm/armlet.js examples/01_pick_and_place.rbt
node tests/wasm/page.mjs build/wasm/armlet.js
node tests/wasm/same_as_native.mjs "$command" build/wasm/armlet.js examples
node tests/wasm/same_as_native.mjs "$command" build/wasm/armlet.js tests/cameras/pictures
programs=$(mktemp -d)
trap 'rm -rf "$programs"' EXIT
"$write_programs" "$programs" "$3"
node tests/wasm/same_as_native.mjs "$command" build/wasm/armlet.js --steps 200000 "$programs"
