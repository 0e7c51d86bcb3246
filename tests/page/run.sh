#!/usr/bin/env bash
# run.sh parts|browser|pictures|measure FOLDER [ARMLET]: tests of the page of laboratories. Modules for them are put into FOLDER.
# parts: what needs no browser. browser: the page in Chromium, on laboratories of the command ARMLET. pictures: those of docs/images, made again. measure: how fast the page is.
# Says why and ends with 77 where Node, npm or Chromium cannot be had.
set -euo pipefail
what=$1 modules=$(realpath -m "$2") here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
skip() { printf 'skipped: %s\n' "$*"; exit 77; }

[[ $what != browser || -n ${ARMLET_TRY_BROWSER:-} ]] || skip 'the page is tried in a browser by ./dev test page'
command -v node >/dev/null || skip "node is not installed"
(($(node -p 'process.versions.node.split(".")[0]') >= 18)) || skip "node $(node --version) is older than 18"
mkdir -p "$modules"
exec 9>"$modules/lock"
flock 9  # one at a time puts modules there
if ! cmp -s "$here/package-lock.json" "$modules/installed"; then
  command -v npm >/dev/null || skip "npm is not installed, and the modules of the tests are not there"
  cp "$here/package.json" "$here/package-lock.json" "$modules"
  (cd "$modules" && npm ci --ignore-scripts --no-audit --no-fund >npm.log 2>&1) ||
    skip "npm could not get the modules of the tests: $(tail -n 1 "$modules/npm.log")"
  cp "$here/package-lock.json" "$modules/installed"
fi
flock -u 9
export ARMLET_PAGE_MODULES=$modules

[[ $what != parts ]] || exec node --test "$here"/*.test.mjs
ARMLET_CHROMIUM=${ARMLET_CHROMIUM:-$(command -v chromium || true)}
[[ -x $ARMLET_CHROMIUM ]] || skip "chromium is not installed"
export ARMLET_CHROMIUM ARMLET_COMMAND=$(realpath "$3")
case $what in
  browser) exec node --test "$here"/browser/*.test.mjs ;;
  pictures | measure) exec node "$here/$what.mjs" "${@:4}" ;;
esac
