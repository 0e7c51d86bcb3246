#!/usr/bin/env python3
"""A host with other flags than the library's: it works if it defines EIGEN_DONT_VECTORIZE, whatever its registers, and is
refused by the compiler, with what to do, if it does not: check_layout.py COMPILER PREFIX.

Types of Eigen have an alignment that follows from -mavx and the like, so the structs of the library would be read wrongly."""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

COMPILER, PREFIX = sys.argv[1], Path(sys.argv[2])
GUARD = "armlet/math/eigen_layout.hpp"
SAFE = "-DEIGEN_DONT_VECTORIZE"
WIDE = {"-msse4.2": "sse4_2", "-mavx2 -mfma": "avx2", "-mavx512f -mavx512dq -mfma": "avx512dq"}

HOST = """#include <armlet/backend/recorder.hpp>
#include <armlet/cell/cell.hpp>
#include <armlet/kinematics/forward.hpp>
#include <armlet/model/catalog.hpp>
#include <cstdio>

// Listens with structs of its own size, and asks for a pose.
int main() {
  armlet::Recorder recorder;
  armlet::Cell cell;
  cell.set_backend(&recorder);
  cell.add_robot(armlet::make_robot("puma560"), "arm");
  cell.begin();
  cell.end();
  const auto robot = armlet::make_robot("puma560");
  const auto T_base_tool = armlet::forward(*robot, robot->home());
  std::printf("%zu %.17g %.17g\\n", sizeof(armlet::Event), T_base_tool.translation().x(), T_base_tool.translation().z());
}
"""


def check(is_so, message):
    if not is_so:
        sys.exit(f"check_layout.py: {message}")


def compiled(folder, flags, program=None):
    source = folder / "host.cpp"
    source.write_text(HOST)
    command = [COMPILER, "-std=c++20", *flags, f"-I{PREFIX}/include", "-isystem", eigen(), source]
    libraries = [str(next(PREFIX.rglob(f"libarmlet_{name}.a"))) for name in ("runtime", "core")]
    command += ["-o", program, *libraries, "-lfmt", "-ldl", "-lpng", "-lz"] if program else ["-fsyntax-only"]
    return subprocess.run(command, capture_output=True, text=True)


def eigen():
    for place in ("/usr/include/eigen3", "/usr/local/include/eigen3"):
        if Path(place).is_dir():
            return place
    sys.exit("check_layout.py: Eigen was not found")


def check_every_header():
    """Whatever header with types of Eigen a host includes first, the guard is among what it includes."""
    texts = {str(path.relative_to(PREFIX / "include")): path.read_text(encoding="utf-8") for path in (PREFIX / "include").rglob("*.hpp")}

    def reached(name, seen):
        if name in texts and name not in seen:
            seen.add(name)
            for each in re.findall(r'#include "([^"]+)"', texts[name]):
                reached(each, seen)
        return seen

    with_eigen = [name for name, text in texts.items() if re.search(r"#include <(unsupported/)?Eigen/", text)]
    check(len(with_eigen) > 20, f"only {len(with_eigen)} headers with types of Eigen were found")
    for name in with_eigen:
        check(GUARD in reached(name, set()), f"{name} has types of Eigen and does not include {GUARD}")


def main():
    check_every_header()
    known = Path("/proc/cpuinfo").read_text() if Path("/proc/cpuinfo").exists() else ""
    is_x86 = " sse2 " in known
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        program = folder / "host"
        plain = compiled(folder, [SAFE], program)
        check(plain.returncode == 0, f"with {SAFE}: {plain.stderr[:2000]}")
        expected = subprocess.run([program], capture_output=True, text=True).stdout
        check(expected, "the host prints nothing")
        for flags, register in WIDE.items() if is_x86 else ():
            refused = compiled(folder, flags.split())
            check(refused.returncode != 0, f"{flags} without {SAFE} compiles")
            check("add -DEIGEN_DONT_VECTORIZE" in refused.stderr, f"{flags}: {refused.stderr[:2000]}")
            wide = compiled(folder, [SAFE, *flags.split()], program)
            check(wide.returncode == 0, f"{flags} with {SAFE}: {wide.stderr[:2000]}")
            if f" {register}" in known:
                printed = subprocess.run([program], capture_output=True, text=True).stdout
                check(printed.split()[0] == expected.split()[0], f"{flags}: {printed} for {expected}")
        for flag, word in [("-DEIGEN_DEFAULT_TO_ROW_MAJOR", "ROW_MAJOR"), ("-DEIGEN_DEFAULT_DENSE_INDEX_TYPE=int", "INDEX_TYPE")]:
            refused = compiled(folder, [SAFE, flag])
            check(refused.returncode != 0 and word in refused.stderr, f"{flag}: {refused.stderr[:500]}")


main()
