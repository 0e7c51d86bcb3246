#!/usr/bin/env bash
# Fetches the foreign sources that the WebAssembly build compiles: tools/wasm_sources.sh FOLDER
#
# The sources of ANTLR's C++ runtime and of fmt are those of the installed Debian packages, from the same archive; system headers are
# linked one by one, because the system's C library must not be found. Nothing outside of FOLDER changes: apt uses its own package lists
# there.
set -euo pipefail
folder=$(realpath -m "$1")
mkdir -p "$folder"/{apt/lists/partial,apt/cache/archives/partial,include}
cd "$folder"

apt_here=(-o Dir::Etc::SourceList="$folder/apt/sources.list" -o Dir::Etc::SourceParts=/dev/null
          -o Dir::State::Lists="$folder/apt/lists" -o Dir::Cache="$folder/apt/cache" -o APT::Sandbox::User=root)

# source LINK PACKAGE BINARY: the sources of an installed package, as the folder LINK.
source_of() {
  local link=$1 package=$2 version
  version=$(dpkg-query -W -f '${Version}' "$3")
  [[ $(cat "$link.version" 2>/dev/null) == "$version" && -d $link ]] && return
  if [[ ! -s apt/sources.list ]]; then
    apt-get indextargets --format 'deb-src $(REPO_URI) $(CODENAME) $(COMPONENT)' \
      'Created-By: Packages' 'Origin: Debian' 'Component: main' | sort -u >apt/sources.list
    apt-get "${apt_here[@]}" update >apt/log 2>&1 || { tail apt/log >&2; exit 1; }
  fi
  rm -rf "$link" "$package-"*/
  apt-get "${apt_here[@]}" source "$package=$version" >apt/log 2>&1 || { tail apt/log >&2; exit 1; }
  ln -sfn "$(echo "$package-"*/)" "$link"
  echo "$version" >"$link.version"
}

source_of antlr4 antlr4-cpp-runtime libantlr4-runtime-dev
source_of fmt fmtlib libfmt-dev
for header in eigen3/Eigen eigen3/unsupported nlohmann utf8cpp/utf8 utf8cpp/utf8.h; do
  ln -sfn "/usr/include/$header" "include/${header##*/}"
done
