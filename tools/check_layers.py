#!/usr/bin/env python3
"""Checks that every #include respects the layers of the architecture and the fences around heavy headers, and that
portable sources use what every platform and compiler has; and that docs/architecture.md says the same of layers and rooms."""

import os
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

RUNTIME = ["core", "math", "mesh", "chain", "model", "kinematics", "trajectory", "dynamics", "world", "image", "camera", "vision", "collision", "planning", "grasp", "plot", "backend"]

# layer: the layers whose public headers it may include, besides its own.
MAY_INCLUDE = {
    "core": [],
    "math": ["core"],
    "mesh": ["core", "math", "image"],
    "chain": ["core", "math"],
    "model": ["core", "math", "mesh", "chain"],
    "kinematics": ["core", "math", "chain", "model"],
    "dynamics": ["core", "math", "chain", "model"],
    "trajectory": ["core", "math", "chain", "model", "kinematics", "dynamics"],
    "world": ["core", "math", "image", "mesh"],
    "collision": ["core", "math", "mesh", "chain", "model", "kinematics", "trajectory", "world"],
    "planning": ["core", "math", "chain", "model", "kinematics", "trajectory", "world", "collision"],
    "grasp": ["core", "math"],
    "image": ["core", "math"],
    "vision": ["core", "math", "chain", "image"],
    "camera": ["core", "math", "mesh", "world", "image", "vision"],
    "plot": ["core", "math", "image"],
    "backend": ["core", "math", "plot", "image"],
    "cell": RUNTIME,
    "control": RUNTIME + ["cell"],
    "interpreter": ["core", "math"],
    "stdlib": ["interpreter", "cell", "control"] + RUNTIME,
}
EVERYTHING = list(MAY_INCLUDE)

# library: room: the rooms whose headers it may include, besides its own; they stand above it here.
ROOMS = {
    "interpreter": {
        "base": [],
        "vocabulary": ["base"],
        "ast": ["base"],
        "habits": ["base"],
        "hir": ["base", "vocabulary", "ast"],
        "program": ["base", "vocabulary", "ast", "hir"],
        "syntax": ["base", "vocabulary", "ast"],
        "check": ["base", "vocabulary", "ast", "hir"],
        "lower": ["base", "vocabulary", "ast", "hir", "program"],
        "vm": ["base", "vocabulary", "ast", "hir", "program"],
        "driver": ["base", "vocabulary", "ast", "habits", "hir", "program", "syntax", "check", "lower", "vm"],
        "editor": ["base", "vocabulary", "ast", "hir", "program", "syntax", "check", "lower", "vm", "driver"],
        "format": ["base", "vocabulary", "ast", "syntax"],
    },
    "stdlib": {
        "messages": [],
        "host": [],
        "values": ["messages", "host"],
        "rules": ["messages", "host", "values"],
        "moves": ["messages", "host", "values"],
        # Bindings: the functions of the language. None includes those of another room.
        "numbers": ["messages", "host", "values", "rules"],
        "robot": ["messages", "host", "values", "rules", "moves"],
        "world": ["messages", "host", "values", "rules"],
        "motion": ["messages", "host", "values", "rules", "moves"],
        "trajectory": ["messages", "host", "values", "rules", "moves"],
        "dynamics": ["messages", "host", "values", "rules", "moves"],
        "plot": ["messages", "host", "values", "rules", "moves"],
        "vision": ["messages", "host", "values", "rules", "moves"],
        "laboratory": ["messages", "host", "values"],
        # Runs of programs with these functions.
        "session": ["messages", "host", "values", "rules", "moves", "motion", "laboratory"],
        "controls": ["messages", "host", "values", "laboratory", "session"],
        "workspace": ["messages", "host", "values", "session"],
    },
}
# library: room: its public headers, by folder or by name, in include/armlet/LIBRARY.
PUBLIC_ROOMS = {
    "interpreter": {
        "base": "messages/ call_part diagnostic failure foreign_name object output render run source type unit virtual_time world_names host/memory",
        "vocabulary": "native answer resource later work sorting binding/thunk binding/waiting binding/dims_fact binding/map_values host/compile_options "
                      "host/table_text",
        "program": "host/program",
        "vm": "script_function define define_type binding/ host/",
        "driver": "engine host reference host/watchdog",
        "editor": "editor/",
        "format": "format",
    },
    "stdlib": {
        "host": "host host_frames laboratory_rows mesh_converter session_log",
        "values": "robot_text",
        "session": "help_topics install session session_options text_change",
        "controls": "laboratory_controls",
        "workspace": "load_world workspace",
    },
}
ROOM_OF = {library: {name: room for room, names in rooms.items() for name in names.split()} for library, rooms in PUBLIC_ROOMS.items()}

# name: (pattern of the header, folders that may include it). Public headers may never include it.
FENCES = {
    "ANTLR": (r"antlr4|Rbt(Lexer|Parser)", ["interpreter/src/syntax/", "grammar/", "tests/unit/interpreter/syntax/"]),
    "urdfdom": (r"urdf_(model|parser)/|console_bridge/", ["runtime/src/model/urdf_read.cpp", "runtime/src/model/descriptions/urdf_library."]),
    "nlohmann": (r"nlohmann/", ["runtime/src/mesh/", "interpreter/src/base/diagnostic/", "apps/", "tests/"]),
    "OMPL": (r"ompl/|boost/", ["runtime/src/planning/ompl/"]),
    "Assimp": (r"^assimp/", ["apps/mesh/converter/assimp_import.cpp"]),
    "Coin": (r"^Inventor/", ["apps/mesh/converter/vrml_import.cpp"]),
    "TinyXML-2": (r"^tinyxml2", ["apps/mesh/converter/xml_check.cpp"]),
    "OpenSSL": (r"^openssl/", ["apps/mesh/client/sha256.cpp"]),
    "libpng": (r"^png\.h", ["runtime/src/image/png_write.cpp"]),
    "zlib": (r"^zlib\.h", ["runtime/src/image/png_frame.cpp", "tests/fuzz/fuzz_picture.cpp"]),
    "stb": (r"^stb/", ["runtime/src/image/stb_decode.cpp", "runtime/src/image/jpeg_write.cpp",
                     "apps/armlet/storyboard/make_glyphs.cpp"]),
    "OpenCV": (r"opencv2/", ["runtime/src/vision/opencv/", "apps/armlet/video/opencv/", "tests/unit/opencv/", "tests/unit/video/",
                           "tests/video/read_video.cpp", "bench/bench_vision.cpp"]),
    "the system": (r"^(sys/.*|(dirent|dlfcn|fcntl|poll|pthread|sched|signal|termios|time|ucontext|unistd)\.h"
                   r"|csignal|ctime|fstream|future|semaphore|thread|emscripten.*)$",
                   ["runtime/src/core/posix/", "runtime/src/core/bare/", "apps/", "tests/", "bench/", "examples/"]),
    "vector intrinsics": (r"^([a-z]*mmintrin|immintrin|x86intrin|arm_neon|wasm_simd128)\.h$", []),
}

# Use core/platform.hpp and core/files.hpp instead of these, so that the libraries run on all platforms that those support.
PLATFORM = re.compile(r"std::(thread|jthread|this_thread)\b|\b(steady|system|high_resolution)_clock\b"
                      r"|\b(fs|filesystem)::(exists|is_\w+|status|canonical|weakly_canonical|absolute|current_path"
                      r"|create_\w+|remove\w*|rename|copy\w*|file_size|\w*directory_iterator)\b")
PORTABLE = ("runtime/", "interpreter/", "stdlib/")
PLATFORMS = ("runtime/src/core/posix/", "runtime/src/core/bare/")

# Algorithms of std::ranges that clang 14 can compile, and that cmake/wasm/missing_cxx20.hpp adds to emscripten's library.
RANGES = re.compile(r"std::(?:ranges|views)::(\w+)")
READABLE = set("""all_of any_of binary_search copy count count_if end equal find find_if find_if_not for_each is_sorted lower_bound
    max_element min_element minmax_element move none_of reverse sort stable_sort transform upper_bound""".split())

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def layer_of(path):
    """The layer a file belongs to, or None for those that may include anything public."""
    parts = path.parts
    if parts[0] == "runtime":
        return parts[3] if parts[1] == "include" else parts[2]
    return parts[0] if parts[0] in ("interpreter", "stdlib") else None


def room_of(library, part):
    """The room of a header or source below LIBRARY/src or LIBRARY/include/armlet."""
    if part.parts[0] in ROOMS[library]:
        return part.parts[0]
    name = part.with_suffix("").relative_to(library).as_posix() if part.parts[0] == library else ""
    return ROOM_OF[library].get(name) or ROOM_OF[library].get(name.split("/")[0] + "/")


def faults_of_rooms(path, header):
    library = path.parts[0]
    rooms = ROOMS.get(library, {})
    if not header.startswith((*(f"{room}/" for room in rooms), f"armlet/{library}/")) or not rooms:
        return
    room = room_of(library, path.relative_to(f"{library}/src" if path.parts[1] == "src" else f"{library}/include/armlet"))
    target = room_of(library, Path(header.removeprefix("armlet/")))
    if room is None or target is None:
        yield f"{path if room is None else header} is in no room of {library}: PUBLIC_ROOMS in tools/check_layers.py"
    elif target not in rooms[room] + [room]:
        yield f"{room} may not include {header} of {target}; it may include: {', '.join(rooms[room] + [room])}"


def folders_of_rooms(src):
    """folder of a library's sources: the folders whose headers it includes."""
    used = {}
    for path in sorted(src.rglob("*.[ch]pp")):
        folder = path.relative_to(src).parent
        for header in re.findall(r'^#include "(\w[\w/]*/\w+\.hpp)"', path.read_text(encoding="utf-8"), re.MULTILINE):
            if (src / header).exists() and Path(header).parent != folder:
                used.setdefault(folder, set()).add(Path(header).parent)
    return used


def circles(root):
    """Folders of a library that include one another, and rooms that may include what stands behind them."""
    for library, rooms in ROOMS.items():
        used = folders_of_rooms(root / library / "src")
        while ends := {folder for folder in used if not used[folder] & set(used) or all(folder not in names for names in used.values())}:
            used = {folder: names for folder, names in used.items() if folder not in ends}
        if used:
            yield f"{library}/src: a circle of includes among {', '.join(sorted(map(str, used)))}"
        order = list(rooms)
        for room, names in rooms.items():
            for wrong in [name for name in names if order.index(name) >= order.index(room)]:
                yield f"tools/check_layers.py: {room} may not use {wrong}, which stands behind it"


def layer_of_header(path, header, layer):
    """The layer an included header belongs to, or None for a foreign one and one of the same folder."""
    if header.startswith("../"):
        return layer_of(Path(os.path.normpath(path.parent / header)))
    parts = header.split("/")
    if len(parts) == 3 and parts[0] == "armlet":
        return parts[1]
    if layer in RUNTIME + ["cell", "control"] and parts[0] in MAY_INCLUDE:
        return parts[0]  # private runtime headers are included as <layer>/file.hpp
    return None


def faults_in_line(path, header):
    layer = layer_of(path)
    target = layer_of_header(path, header, layer)
    allowed = EVERYTHING if layer is None else MAY_INCLUDE.get(layer, []) + [layer]
    if layer is not None and layer not in MAY_INCLUDE:
        yield f"'{layer}' is not a layer of the architecture"
    elif target is not None and target not in allowed:
        yield f"{layer} may not include {header}; it may include: {', '.join(allowed)}"
    yield from faults_of_rooms(path, header)
    if path.parts[:2] == ("examples", "embed") and header.startswith("../"):
        yield f"a host program includes installed headers only, not {header}"
    for name, (pattern, folders) in FENCES.items():
        if re.search(pattern, header) and not any(str(path).startswith(f) for f in folders):
            yield f"{name} may only be included in {' and '.join(folders) or 'no source'}"


def faults_in_file(path, text):
    is_portable = str(path).startswith(PORTABLE) and not str(path).startswith(PLATFORMS)
    for number, line in enumerate(text.splitlines(), 1):
        if is_portable and (asked := PLATFORM.search(line.split("//")[0])):
            yield f"{path}:{number}: {asked.group(0)} belongs to the platform: use armlet/core/platform.hpp or armlet/core/files.hpp"
        for name in RANGES.findall(line.split("//")[0]) if is_portable else ():
            if name not in READABLE:
                yield f"{path}:{number}: other compilers do not have std::ranges::{name}; use std::{name}"
        match = INCLUDE.match(line)
        if match:
            for fault in faults_in_line(path, match.group(1)):
                yield f"{path}:{number}: {fault}"


def faults_of_document(root):
    """Rows of the tables of docs/architecture.md, "| `name` | core, math | ...", that say something else than the graphs here.
    "Above" means all rows above, and what stands behind "without" is taken away again."""
    text = (root / "docs/architecture.md").read_text(encoding="utf-8")
    for head, graph in (("| layer | may include |", MAY_INCLUDE), ("| room | may include", ROOMS["interpreter"]),
                        ("| room of the library | may include |", ROOMS["stdlib"])):
        said = {}
        for name, cell in re.findall(r"^\| `(\w+)` \| (.*?) \|", text[text.index(head):].split("\n\n")[0], re.MULTILINE):
            cell, _, left_out = cell.partition("without")
            named = {word for word in re.findall(r"\w+", cell) if word in graph}
            said[name] = named | (set(said) - set(re.findall(r"\w+", left_out)) if "above" in cell else set())
        for name in graph:
            if said.get(name) != set(graph[name]):
                yield (f"docs/architecture.md: the row of `{name}` says {', '.join(sorted(said.get(name, ['nothing'])))}; "
                       f"it may include: {', '.join(sorted(graph[name]))}")


def sources(root):
    for folder in ("runtime", "interpreter", "stdlib", "apps", "tests", "bench", "examples"):
        for suffix in ("*.hpp", "*.h", "*.cpp"):
            yield from sorted((root / folder).rglob(suffix))


def main():
    root = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    faults = [*circles(root), *faults_of_document(root)]
    for path in sources(root):
        faults += faults_in_file(path.relative_to(root), path.read_text(encoding="utf-8"))
    print("\n".join(faults) if faults else "layers: in order")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
