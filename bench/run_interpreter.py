#!/usr/bin/env python3
"""Times the interpreter against Lua 5.4, LuaJIT and g++ on the programs of bench/programs.

Prints CPU time in ms, the minimum of several interleaved runs, with each implementation's start-up taken off, and how
many times faster than its peers Armlet is, beside the targets; then what counting steps costs, how fast programs are
compiled, and start-up. Fails when two implementations print different things.
"""

import argparse
import math
import re
import resource
import shutil
import statistics
import subprocess
import sys
import time
from pathlib import Path

from make_program import program as long_program

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
PROGRAMS = ["fib", "nbody", "spectral", "mandel", "matmul", "trees", "strings"]
# Programs of other kinds, compared with Lua 5.4 only: LuaJIT does not have the whole numbers of Lua 5.4.
LISTS = ["fannkuch", "heapsort", "levenshtein", "lu"]
# More of them, written without knowledge of the strengths of the interpreter; no targets.
MORE = ["bst", "build", "chain", "collatz", "floyd", "knapsack", "letters", "life", "machine", "particles", "permute",
        "queens", "shuffle", "sieve", "tally", "words"]
EMPTY = "hello"


def compile_cpp(folder):
    """Compiles the C++ programs that are missing in the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in PROGRAMS + [EMPTY]:
        if not (folder / name).exists():
            source = HERE / "programs" / "cpp" / f"{name}.cpp"
            subprocess.run(["g++", "-O2", "-std=c++20", str(source), "-o", str(folder / name)], check=True)


def commands(armlet, cpp_folder):
    """For each implementation, a function from a program's name to the command that runs it."""
    lua = lambda tool: lambda name: [*tool.split(), str(HERE / "programs" / "lua" / f"{name}.lua")]
    result = {"armlet": armlet_command(armlet)}
    result |= {tool: lua(tool) for tool in ("lua5.4", "luajit -joff", "luajit") if shutil.which(tool.split()[0])}
    result["g++ -O2"] = lambda name: [str(cpp_folder / name)]
    return result


def armlet_command(armlet):
    return lambda name: [str(armlet), "run", str(HERE / "programs" / "rbt" / f"{name}.rbt")]


def run(command):
    """(CPU seconds, wall seconds, what it printed with blanks made equal, or None if it failed)."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.perf_counter()
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
    wall = time.perf_counter() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return cpu, wall, " ".join(done.stdout.decode().split()) if done.returncode == 0 else None


def resident_megabytes(command):
    """Largest memory of a program that runs for some milliseconds, sampled while it runs."""
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
    peak = 0
    while child.poll() is None:
        status = Path(f"/proc/{child.pid}/status").read_text()
        lines = [line for line in status.splitlines() if line.startswith("VmHWM")]
        peak = max([peak] + [int(line.split()[1]) for line in lines])
        time.sleep(0.001)
    return peak / 1024


def measure(implementations, name, runs):
    """For each implementation (CPU seconds, output); the runs are interleaved."""
    best = {}
    for _ in range(runs):
        for tool, command in implementations.items():
            cpu, _, output = run(command(name))
            if tool not in best or cpu < best[tool][0]:
                best[tool] = (cpu, output)
    return best


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


# Peer: the speed of Armlet relative to it, at least on every program, and at least in the geometric mean.
TARGETS = {"lua5.4": (2.0, 3.0), "luajit -joff": (1.0, 1.0)}
LIST_TARGETS = {"lua5.4": (2.6, 2.6)}
ALL_TARGET = 3.4  # relative to Lua 5.4, in the mean of both lists


def print_times(implementations, names, runs, targets):
    """Prints the table; returns whether all outputs agree, and how many times faster than Lua 5.4 the programs are."""
    tools = list(implementations)
    peers = [tool for tool in tools if tool != "armlet"]
    startup = {tool: cpu for tool, (cpu, _) in measure(implementations, EMPTY, runs).items()}
    print(f"{'CPU ms':12}" + "".join(f"{t:>14}" for t in tools) + "".join(f"{'vs ' + t:>17}" for t in peers))
    ratios = {peer: [] for peer in peers}
    agree = True
    for name in names:
        best = measure(implementations, name, runs)
        times = {tool: max(best[tool][0] - startup[tool], 1e-4) for tool in tools}
        outputs = {tool: output for tool, (_, output) in best.items()}
        if len(set(outputs.values())) != 1 or None in outputs.values():
            agree = False
            print(f"{name:12} outputs differ: {outputs}")
            continue
        for peer in peers:
            ratios[peer].append(times[peer] / times["armlet"])
        row = f"{name:12}" + "".join(f"{times[t] * 1e3:14.1f}" for t in tools)
        print(row + "".join(f"{ratios[p][-1]:16.2f}x" for p in peers), flush=True)
    if all(ratios.values()):
        blank = " " * 14 * len(tools)
        print(f"{'geom. mean':12}{blank}" + "".join(f"{geometric_mean(ratios[p]):16.2f}x" for p in peers))
        goals = [f">= {targets[p][0]:g}, mean {targets[p][1]:g}" if p in targets else "" for p in peers]
        print(f"{'target':12}{blank}" + "".join(f"{goal:>17}" for goal in goals))
    return agree, ratios.get("lua5.4", [])


def print_all_times(implementations, names, runs):
    """Prints the table of each list of programs; returns whether all outputs agree."""
    known = [name for name in names if name in PROGRAMS]
    lists = [name for name in names if name in LISTS]
    more = [name for name in names if name in MORE]
    agree, ratios = print_times(implementations, known, runs, TARGETS) if known else (True, [])
    plain = {tool: command for tool, command in implementations.items() if tool in ("armlet", "lua5.4")}
    if lists:
        also, others = print_times(plain, lists, runs, LIST_TARGETS)
        agree = agree and also
        ratios = ratios + others
    if known and lists and ratios:
        print(f"all {len(ratios)} programs: {geometric_mean(ratios):.2f} times Lua 5.4 in the geometric mean "
              f"(target {ALL_TARGET})")
    if more:
        agree = print_times(plain, more, runs, {})[0] and agree
    return agree


def instructions(command):
    """Instructions executed, the same number every time, by valgrind; None without it."""
    if not shutil.which("valgrind"):
        return None
    done = subprocess.run(["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", *command],
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL)
    counted = re.search(r"Collected : (\d+)", done.stderr.decode())
    return int(counted[1]) if done.returncode == 0 and counted else None


def print_step_cost(armlet, uncounted, names, runs):
    """Compares with a command that differs only in not counting steps: time, and instructions executed.

    Times vary by a few per cent with the addresses that the linker chooses; instruction counts do not."""
    if not uncounted.exists():
        print(f"cost of counting steps: not measured, {uncounted} is not built")
        return
    both = {"counted": armlet_command(armlet), "uncounted": armlet_command(uncounted)}
    startup = measure(both, EMPTY, runs)
    times, counts = [], []
    for name in names:
        best = measure(both, name, runs)
        spent = {tool: best[tool][0] - startup[tool][0] for tool in both}
        times.append(spent["counted"] / spent["uncounted"])
        executed = {tool: instructions(command(name)) for tool, command in both.items()}
        if None not in executed.values():
            counts.append(executed["counted"] / executed["uncounted"])
    for what, ratios in (("time", times), ("instructions", counts)):
        if ratios and len(ratios) == len(names):
            listed = ", ".join(f"{name} {(ratio - 1) * 100:+.1f} %" for name, ratio in zip(names, ratios))
            mean = (geometric_mean(ratios) - 1) * 100
            print(f"cost of counting steps, {what}: {mean:+.1f} % in the mean (target 5 %): {listed}")


def print_compile_speed(armlet, folder, runs):
    """Reading, checking and compiling a program of a megabyte."""
    path = folder / "long.rbt"
    path.write_text(long_program(1_000_000))
    check = {"long": lambda _: [str(armlet), "check", str(path)], "empty": armlet_command(armlet)}
    best = measure(check, EMPTY, runs)
    seconds = best["long"][0] - best["empty"][0]
    megabytes = path.stat().st_size / 1e6
    print(f"parse, check and compile: {megabytes / seconds:.2f} MB/s of {megabytes:.2f} MB (target 2 MB/s)")


def print_startup(implementations, runs):
    """Wall time of an almost empty program, median of interleaved runs, and memory of a small one."""
    walls = {tool: [] for tool in implementations}
    for _ in range(runs):
        for tool, command in implementations.items():
            walls[tool].append(run(command(EMPTY))[1] * 1e3)
    medians = {tool: statistics.median(values) for tool, values in walls.items()}
    print("start-up, wall ms, median: " + ", ".join(f"{tool} {ms:.2f}" for tool, ms in medians.items()))
    more = medians["armlet"] - medians["g++ -O2"]
    memory = resident_megabytes(implementations["armlet"]("fib"))
    print(f"armlet needs {more:.2f} ms more than an empty C++ program (target 1.2 ms), and {memory:.1f} MB of memory "
          "(target 12 MB)")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", nargs="*", metavar="PROGRAM", help=f"of {' '.join(PROGRAMS + LISTS + MORE)}; all without it")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--armlet", type=Path, default=ROOT / "build" / "bin" / "armlet")
    parser.add_argument("--uncounted", type=Path, default=ROOT / "build" / "release" / "bench" / "armlet_uncounted")
    options = parser.parse_args()
    cpp_folder = ROOT / "build" / "bench"
    compile_cpp(cpp_folder)
    implementations = commands(options.armlet, cpp_folder)
    names = options.programs or PROGRAMS + LISTS + MORE
    agree = print_all_times(implementations, names, options.runs)
    print_step_cost(options.armlet, options.uncounted, [name for name in names if name in PROGRAMS], 3 * options.runs)
    print_compile_speed(options.armlet, cpp_folder, options.runs)
    print_startup(implementations, 20 * options.runs)
    return 0 if agree else 1


if __name__ == "__main__":
    sys.exit(main())
