#!/usr/bin/env python3
"""What is linked and bundled is what notices/parts.json names, and whoever gets it gets the notices:
notices.py ARMLET BUILD_FOLDER.

Linked: the packages of Debian whose headers the objects of the build were compiled with, of the libraries on the lines of the linker,
and of those that the programs load. Bundled: what the lock file of the page names. Elsewhere than on Debian the former is left out."""

import base64
import gzip
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools"))
import check_notices

COMMAND, BUILD = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
LIST = json.loads(check_notices.LIST.read_text(encoding="utf-8"))
PARTS = LIST["parts"]
PAGE = ROOT / "apps" / "lab" / "page"
# Objects of programs that are not installed.
OTHERS = re.compile(r"^(tests|bench)/|/make_tables\.dir/")
# What the copyright files of Debian call a licence.
DEBIAN_SAYS = {"BSD-3-Clause": r"BSD", "MIT": r"Expat|MIT", "MPL-2.0": r"MPL-2", "Apache-2.0": r"Apache-2\.0", "BSL-1.0": r"BSL|Boost",
               "Zlib": r"zlib", "libpng-2.0": r"libpng", "LGPL-2.1-or-later": r"LGPL|Lesser", "GPL-3.0-or-later WITH GCC-exception-3.1": r"GCC Runtime Library Exception"}


def check(is_so, message):
    if not is_so:
        sys.exit(f"notices.py: {message}")


def output(*words):
    return subprocess.run(words, capture_output=True, text=True).stdout


def packages_of(files):
    """The packages of Debian that the files belong to; a file of none is an error."""
    found = {}
    paths = {str(Path(file).resolve()) for file in files} | {str(Path(file)) for file in files}
    for line in output("dpkg-query", "-S", *sorted(paths)).splitlines():
        names, _, path = line.rpartition(": ")
        for name in names.split(", "):
            found.setdefault(path, set()).add(name.split(":")[0])
    for file in files:  # where /lib is /usr/lib, packages have the former
        names = {name for path in (str(Path(file)), str(Path(file).resolve())) for form in (path, path.removeprefix("/usr")) for name in found.get(form, ())}
        if not names:
            names = {line.split(":")[0] for line in output("dpkg-query", "-S", f"*/{Path(file).resolve().name}").splitlines()}
        check(names, f"no package has {file}")
        yield names


def headers():
    """Headers of the system that installed programs and libraries are compiled with."""
    of_others, found = True, set()
    for line in output("ninja", "-C", str(BUILD), "-t", "deps").splitlines():
        if not line.startswith(" "):
            of_others = bool(OTHERS.search(line))
        elif not of_others and line.strip().startswith("/usr/"):
            found.add(line.strip())
    return found


def libraries():
    """Libraries on the lines of the linker of what is installed, and what these and the programs load."""
    names, found = set(), set()
    is_others = True
    for line in (BUILD / "build.ninja").read_text().splitlines():
        if line.startswith("build "):
            is_others = bool(OTHERS.search(line.removeprefix("build ")))
        elif not is_others and line.strip().startswith("LINK_LIBRARIES ="):
            found |= {word for word in line.split() if word.startswith("/usr/")}
            names |= {f"lib{word[2:]}.so" for word in line.split() if re.fullmatch(r"-l\w+", word)}
        elif not is_others and "DEFINES =" in line:
            names |= set(re.findall(r'_LIBRARY=\\+"(lib[^"\\]+)', line))
    for source in ROOT.glob("apps/armlet/**/*.cpp"):
        names |= set(re.findall(r'LoadedLibrary \w+\{"(lib[^"]+)"', source.read_text(encoding="utf-8")))
    built = [COMMAND, COMMAND.parent / "armlet-lab", COMMAND.parent / "armlet-mesh", BUILD / "lib" / "libarmlet_planning.so", BUILD / "lib" / "libarmlet_vision.so",
             BUILD / "lib" / "libarmlet_video.so"]
    for file in built:
        if file.exists():
            names |= set(re.findall(r"NEEDED.*\[(.*)\]", output("readelf", "-d", str(file))))
    known = output("ldconfig", "-p") or output("/sbin/ldconfig", "-p")
    for name in names:
        if re.match(r"lib(a|t|ub|l)san\.", name):  # of a build with sanitizers, which nobody installs
            continue
        places = re.findall(rf"^\s*{re.escape(name)}[. ].*=> (\S+)$", known, re.M)
        check(places, f"the library {name} is not there")
        found.add(places[0])
    return found


def check_linked():
    if not shutil.which("dpkg-query") or not (BUILD / "build.ninja").exists():
        print("what is linked is not compared: this is no Debian, or no build by ninja")
        return
    of_package = {package: part["name"] for part in PARTS for package in part.get("packages", [])}
    used = set()
    for files in (headers(), libraries()):
        check(files, "nothing of the system is used: the build was not understood")
        for names in packages_of(files):
            known = names & of_package.keys()
            check(known, f"{sorted(names)} is linked, but no part of notices/parts.json names it")
            used |= {of_package[name] for name in known}
    optional = {"converter": COMMAND.parent / "armlet-mesh", "planner": BUILD / "lib" / "libarmlet_planning.so",
                "vision": BUILD / "lib" / "libarmlet_vision.so", "video": BUILD / "lib" / "libarmlet_video.so"}
    for part in PARTS:
        places = set(part["in"] + part.get("loaded", []))
        is_there = any(place not in optional or optional[place].exists() for place in places)
        if "packages" in part and is_there:
            check(part["name"] in used, f"{part['name']} is named, but nothing of it is linked")


def check_debian():
    """Versions, and licences as the packages themselves say."""
    for part in PARTS:
        file = Path("/usr/share/doc") / part.get("debian", "-") / "copyright"
        if not file.exists():
            continue
        text = file.read_text(encoding="utf-8", errors="replace")
        check(re.search(DEBIAN_SAYS[part["licence"]], text, re.I), f"{file} says nothing of {part['licence']}")
        version = output("dpkg-query", "-W", "-f", "${Version}", part["debian"])
        if "version" in part:
            check(version.startswith(part["version"]), f"{part['name']} is {version}, not {part['version']}")


def check_bundled():
    lock = json.loads((PAGE / "package-lock.json").read_text())["packages"]
    locked = {path.removeprefix("node_modules/"): entry["version"] for path, entry in lock.items() if path and not entry.get("dev")}
    named = {part["npm"]: part for part in PARTS if "npm" in part}
    for name in locked.keys() - LIST["not_bundled"].keys():
        check(name in named, f"the page depends on {name}, which notices/parts.json does not name")
        check(named[name]["version"] == locked[name], f"{name} is {locked[name]}, not {named[name]['version']}")
    for name in set(named) | set(LIST["not_bundled"]):
        check(name in locked, f"notices/parts.json names {name}, which the page does not depend on")
    # Of the engine: the sources that its build takes.
    script = (ROOT / "tools" / "wasm_sources.sh").read_text()
    taken = {"antlr4": "ANTLR 4 runtime for C++", "fmt": "fmt", "eigen3": "Eigen", "nlohmann": "JSON for Modern C++", "utf8cpp": "UTF8-CPP"}
    links = set(re.findall(r"^source_of (\w+) ", script, re.M)) | {name.split("/")[0] for name in re.search(r"for header in (.*); do", script)[1].split()}
    check(links == taken.keys(), f"the engine is built of {sorted(links)}")
    runtime = {part["name"] for part in PARTS if part.get("sources") == ["emscripten"]}
    check({part["name"] for part in PARTS if "engine" in part["in"]} == set(taken.values()) | runtime, "other parts are named of the engine")


def unpacked(text):
    """Base 85 with the signs of apps/wasm/pack_laboratory.mjs, then gzip."""
    ours = "".join(chr(digit + (40 if digit < 20 else 42)) for digit in range(85))
    theirs = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+-;<=>?@^_`{|}~"  # of the module
    return gzip.decompress(base64.b85decode(text.strip().translate(str.maketrans(ours, theirs)))).decode()


def check_has_notices(what, text):
    """Whether a page names what it and its engine contain."""
    for part in PARTS:
        if {"page", "engine"} & set(part["in"]):
            for line in [part["name"], *part["copyright"]]:
                check(line in text, f"{what} does not say \"{line}\"")
    for name in sorted({text for part in PARTS if {"page", "engine"} & set(part["in"]) for text in part["texts"]}):
        for line in check_notices.text_of(name).splitlines():
            check(line.strip().strip('"') in text or '"' in line, f"{what} has no text of {name}: {line}")


def check_given():
    """The command, the pages that it serves, records and exports, and what is installed."""
    printed = subprocess.run([COMMAND, "--notices"], capture_output=True, text=True)
    check(printed.returncode == 0 and printed.stdout == check_notices.NOTICE.read_text(encoding="utf-8"), f"armlet --notices: {printed.stdout[:200]}{printed.stderr}")
    check("NOTICE" in (ROOT / "cmake" / "ArmletInstall.cmake").read_text(), "NOTICE is not installed")
    check_has_notices("the page", (PAGE / "dist" / "index.html").read_text(encoding="utf-8"))
    node = shutil.which("node") or shutil.which("nodejs")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "cell.rbt").write_text("robot arm = robots.scara()\narm.moveJ(posJ(10deg, 0deg, 0mm, 0deg), time: 1s)\n")
        recorded = subprocess.run([COMMAND, "lab", "cell.rbt", "--record", "recorded.html"], cwd=folder, capture_output=True, text=True)
        check(recorded.returncode == 0, f"--record: {recorded.stderr}")
        check_has_notices("a recorded page", (folder / "recorded.html").read_text(encoding="utf-8"))
        if not node:
            print("an exported laboratory is not tried: there is no node")
            return
        # The engine is stood in for: it takes a quarter of an hour to build, and the notices are in the page around it.
        (folder / "armlet.js").write_text("var createArmlet;\n")
        (folder / "armlet.wasm").write_bytes(b"\0asm")
        version = output(COMMAND, "--version").split()[-1]
        subprocess.run([node, ROOT / "apps" / "wasm" / "pack_laboratory.mjs", version, PAGE / "dist", folder / "armlet.js",
                        folder / "armlet.wasm", folder / "laboratory.html"], check=True)
        exported = subprocess.run([COMMAND, "lab", "cell.rbt", "--export", "cell.html", "--engine", "laboratory.html"], cwd=folder, capture_output=True, text=True)
        check(exported.returncode == 0, f"--export: {exported.stderr}")
        page = (folder / "cell.html").read_text(encoding="utf-8")
        check_has_notices("an exported laboratory", unpacked(re.search(r'id="armlet-page">([^<]*)<', page)[1]))


check(not subprocess.run([sys.executable, ROOT / "tools" / "check_notices.py"], stdout=sys.stderr).returncode, "NOTICE or the page's list is old")
check_linked()
check_debian()
check_bundled()
check_given()
