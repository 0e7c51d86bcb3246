#!/usr/bin/env python3
"""Times the interpreter against Lua 5.4, LuaJIT and g++ on the programs of bench/programs.

Prints CPU time in ms, the minimum of several interleaved runs, with each implementation's start-up taken off, and how
many times faster than its peers Armlet is; then start-up by itself. Fails when two implementations print different things.
"""

import argparse
import math
import resource
import shutil
import statistics
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
PROGRAMS = ["fib", "nbody", "spectral", "mandel", "matmul", "trees", "strings"]
EMPTY = "hello"


def compile_cpp(folder):
    """Compiles the C++ programs into the folder, those that are missing."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in PROGRAMS + [EMPTY]:
        if not (folder / name).exists():
            source = HERE / "programs" / "cpp" / f"{name}.cpp"
            subprocess.run(["g++", "-O2", "-std=c++20", str(source), "-o", str(folder / name)], check=True)


def commands(armlet, cpp_folder):
    """Implementation: function from a program's name to the command that runs it."""
    lua = lambda tool: lambda name: [tool, str(HERE / "programs" / "lua" / f"{name}.lua")]
    result = {"armlet": lambda name: [str(armlet), "run", str(HERE / "programs" / "rbt" / f"{name}.rbt")]}
    result |= {tool: lua(tool) for tool in ("lua5.4", "luajit") if shutil.which(tool)}
    result["g++ -O2"] = lambda name: [str(cpp_folder / name)]
    return result


def run(command):
    """(CPU seconds, wall seconds, what it printed with blanks made equal, or None if it failed)."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.perf_counter()
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
    wall = time.perf_counter() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return cpu, wall, " ".join(done.stdout.decode().split()) if done.returncode == 0 else None


def measure(implementations, name, runs):
    """Implementation: (CPU seconds, output), runs interleaved."""
    best = {}
    for _ in range(runs):
        for tool, command in implementations.items():
            cpu, _, output = run(command(name))
            if tool not in best or cpu < best[tool][0]:
                best[tool] = (cpu, output)
    return best


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


def print_times(implementations, names, runs):
    """Prints the table; returns whether all outputs agree."""
    tools = list(implementations)
    peers = [tool for tool in tools if tool != "armlet"]
    startup = {tool: cpu for tool, (cpu, _) in measure(implementations, EMPTY, runs).items()}
    print(f"{'CPU ms':10}" + "".join(f"{t:>10}" for t in tools) + "".join(f"{'vs ' + t:>12}" for t in peers))
    ratios = {peer: [] for peer in peers}
    agree = True
    for name in names:
        best = measure(implementations, name, runs)
        times = {tool: max(best[tool][0] - startup[tool], 1e-4) for tool in tools}
        row = f"{name:10}" + "".join(f"{times[t] * 1e3:10.1f}" for t in tools)
        outputs = {tool: output for tool, (_, output) in best.items()}
        if len(set(outputs.values())) != 1 or None in outputs.values():
            agree = False
            print(f"{name:10} outputs differ: {outputs}")
            continue
        for peer in peers:
            ratios[peer].append(times[peer] / times["armlet"])
            row += f"{ratios[peer][-1]:11.2f}x"
        print(row, flush=True)
    if all(ratios.values()):
        means = "".join(f"{geometric_mean(ratios[p]):11.2f}x" for p in peers)
        print(f"{'geom. mean':10}" + " " * 10 * len(tools) + means)
    return agree


def print_startup(implementations, runs):
    """Wall time of an almost empty program, median of interleaved runs."""
    walls = {tool: [] for tool in implementations}
    for _ in range(runs):
        for tool, command in implementations.items():
            walls[tool].append(run(command(EMPTY))[1] * 1e3)
    medians = {tool: statistics.median(values) for tool, values in walls.items()}
    print("start-up, wall ms, median: " + ", ".join(f"{tool} {ms:.2f}" for tool, ms in medians.items()))
    print(f"armlet needs {medians['armlet'] - medians['g++ -O2']:.2f} ms more than an empty C++ program")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="*", metavar="PROGRAM", help=f"of {' '.join(PROGRAMS)}; all without it")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--armlet", type=Path, default=ROOT / "build" / "bin" / "armlet")
    options = parser.parse_args()
    cpp_folder = ROOT / "build" / "bench"
    compile_cpp(cpp_folder)
    implementations = commands(options.armlet, cpp_folder)
    agree = print_times(implementations, options.programs or PROGRAMS, options.runs)
    print_startup(implementations, 20 * options.runs)
    return 0 if agree else 1


if __name__ == "__main__":
    sys.exit(main())
