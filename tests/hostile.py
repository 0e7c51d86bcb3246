#!/usr/bin/env python3
"""Gives the command input that no sane person would, and checks that it answers with a clear error: no crash, no hang.

Everything runs on a stack of 256 KB: whatever is deep in a program may not be deep in the native stack.

usage: hostile.py COMMAND
"""
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time

LEVELS = 200_000
STACK = 256 * 1024  # bytes
REJECTED, NO_FILE, FAILED, STOPPED = 65, 66, 70, 130

# name: (text, exit status, code of the message, options)
PROGRAMS = {
    "empty": ("", 0, "", []),
    "blank": (" \n\t\n", 0, "", []),
    "binary": (bytes((i * 7919 + i // 3) % 256 for i in range(100_000)), REJECTED, "E0123", []),
    "zeros": (b"print(1)\0\0\0", REJECTED, "E0123", []),
    "brackets_10_mb": ("(" * 10_000_000, REJECTED, "E0125", []),
    "parentheses": ("let x = " + "(" * LEVELS + "1" + ")" * LEVELS, REJECTED, "E0125", []),
    "square_brackets": ("let x = " + "[" * LEVELS + "]" * LEVELS, REJECTED, "E0125", []),
    "blocks": ("{" * LEVELS + "}" * LEVELS, REJECTED, "E0125", []),
    "list_braces": ("double[] x = " + "{" * LEVELS + "}" * LEVELS, REJECTED, "E0125", []),
    "calls": ("let x = " + "sin(" * LEVELS + "1" + ")" * LEVELS, REJECTED, "E0125", []),
    "indices": ("let x = [1]\nprint(x" + "[0]" * LEVELS + ")", REJECTED, "E0125", []),
    "members": ("let x = 1\nprint(x" + ".a" * LEVELS + ")", REJECTED, "E0125", []),
    "not": ("let x = " + "!" * LEVELS + "true", REJECTED, "E0125", []),
    "minus": ("let x = " + "- " * LEVELS + "1", REJECTED, "E0125", []),
    "powers": ("let x = 1" + "^1" * LEVELS, REJECTED, "E0125", []),
    "sums": ("let x = 1" + "+1" * LEVELS, REJECTED, "E0125", []),
    "conditions": ("let x = " + "true ? 1 : " * LEVELS + "1", REJECTED, "E0125", []),
    "casts": ("let x = " + "(int) " * LEVELS + "1", REJECTED, "E0125", []),
    "lambdas": ("let x = " + "fn() => " * LEVELS + "1", REJECTED, "E0125", []),
    "function_types": ("let x: " + "fn(" * LEVELS, REJECTED, "E0125", []),
    "array_types": ("let x: int" + "[]" * LEVELS + " = 1", REJECTED, "E0125", []),
    "else_ifs": ("if (true) {}" + " else if (true) {}" * LEVELS, REJECTED, "E0125", []),
    "loops": ("while (true) " * LEVELS + ";", REJECTED, "E0125", []),
    "long_text": ('let x = "' + "a" * 5_000_000 + '"\nprint(y)', REJECTED, "E0201", []),
    "endless_recursion": ("fn f(n: int) -> int { return f(n + 1) + 1 }\nprint(f(0))", FAILED, "R0624", []),
    "endless_loop": ("while (true) { }", FAILED, "R0622", ["--steps", "1000000"]),
    "endless_growth": ('var s = "x"\nwhile (true) { s = s + s }', FAILED, "R0628", []),
    "huge_array": ("double[] a = new double[1000000000000];", FAILED, "R0628", []),
    "table_with_nan": ('robot arm = dh([[0.0, 0.0, 0.0 / 0.0, 0.0]], types: "R", limits: [[-1.0, 1.0]])', FAILED, "R0630", []),
    "robot_without_joints": ("robot arm { base: xyz(0mm, 0mm, 0mm) }", REJECTED, "E0508", []),
    "negative_time": ("moveJ(home(), time: -1s)", REJECTED, "E0513", []),
    "negative_time_at_run_time": ("fn t() => 0.0 - 1.0\nmoveJ('Syn', home(), t())", FAILED, "R0609", []),
    "infinite_time": ("fn t() => 1.0 / 0.0\nmoveJ('Syn', home(), t())", FAILED, "R0612", []),
    "infinite_target": ("fn x() => 1m / 0.0\nmoveL(xyz(x(), 0m, 0m))", FAILED, "R0612", []),
    "zero_length_moves": ("moveJ(home(), time: 1s)\nmoveL(here())\nmoveJ(home())\nmoveJ('Syn', home(), 0.0)\n"
                          "assert(now() == 1s)", 0, "", []),
}


def chain(first, link, last, count=20_000):
    """Declarations that each lead to the next one, which stands behind it."""
    return first + "".join(link.replace("@+", str(i + 1)).replace("@", str(i)) for i in range(count)) + last


# Programs with more mistakes than one, of which ten are shown.
MESSAGES = {"nested_paths": 10, "chained_results": 10}
LINKS = "struct N { next: N[] }\nvar n = N([])\nvar m = N([])\nvar i = 0\n" \
        "while (i < 300000) { n = N([n]); m = N([m]); i = i + 1 }\n"
HUGGED = "fn f(n: int) -> double { return "
# The same for programs whose depth is not refused, or not by a limit of nesting.
DEEP = {
    "ifs_without_bodies": ("if (true) " * 180_000, REJECTED, "E0114", []),
    "else_without_ifs": ("if (true) ; else " * LEVELS, REJECTED, "", []),
    "loops_without_bodies": ("for (x in xs) " * LEVELS, REJECTED, "E0125", []),
    "dos_without_bodies": ("do " * LEVELS, REJECTED, "", []),
    "nested_dos": ("do { " * LEVELS + "} while (true);" * LEVELS, REJECTED, "E0125", []),
    "nested_tries": ("try { " * LEVELS + "} catch {}" * LEVELS, REJECTED, "E0125", []),
    "nested_tasks": ("parallel {" * 190 + "}" * 190, 0, "", []),
    "nested_settings": ("with (speed: 0.5) {" * 190 + "}" * 190, 0, "", []),
    "nested_paths": ("path {" * 190 + "}" * 190, REJECTED, "", []),
    "nested_switches": ("switch (1) { case 1: " * 90 + "}" * 90, 0, "", []),
    "deepest_blocks": ("{" * 190 + "}" * 190, 0, "", []),
    "deepest_parentheses": ("let x = " + "(" * 150 + "1" + ")" * 150, 0, "", []),
    "deepest_list": ("let x = " + "[" * 150 + "1" + "]" * 150 + "\nprint(x == x, x)", 0, "", []),
    "deepest_sum": ("let x = 1" + "+1" * 990 + "\nprint(x)", 0, "", []),
    "deepest_texts": ('let s = "a"\nlet x = s' + "+s" * 990 + "\nprint(x)", 0, "", []),
    "deepest_product": ("let x = eye(2)\nprint(x" + "*x" * 500 + ")", 0, "", []),
    "deepest_conditions": ("var c = true\nlet x = " + "c ? 1 : " * 190 + "1\nprint(x)", 0, "", []),
    "deepest_members": ('let x = "a"\nprint(x' + ".trim()" * 290 + ")", 0, "", []),
    "deepest_calls": ("let x = 0.5\nprint(" + "sin(" * 90 + "x" + ")" * 90 + ")", 0, "", []),
    "deepest_lambdas": ("let x = 1\nlet f = " + "fn() { return " * 60 + "x" + " }" * 60, 0, "", []),
    "deepest_types": ("fn f(x: int" + "[]" * 190 + ") {}", 0, "", []),
    "deepest_function_types": ("fn f(x: " + "fn(" * 150 + "int" + ") -> int" * 150 + ") {}", 0, "", []),
    "chained_members": ("let x = a" + ".b" * 900, REJECTED, "E0125", []),
    "chained_assignments": ("var x = 1\n" + "x = " * 20_000 + "1", 0, "", []),
    "chained_structs": (chain("", "struct S@ { a: S@+ }\n", "struct S20000 { a: int }\nfn f(a: S0) => a == a"), 0, "", []),
    "chained_defaults": (chain("", "struct S@ { a: S@+ = S@+() }\n", "struct S20000 { a: int = 0 }\nlet s = S0()"),
                         REJECTED, "E0125", []),
    "chained_results": (chain("", "fn f@(x: int) => f@+(x)\n", "fn f20000(x: int) => x\nprint(f0(1))"), REJECTED, "E0125", []),
    "chained_functions": (chain("", "fn f@() { f@+() }\n", "fn f20000() { wait(1s) }\nf0()"), FAILED, "R0624", []),
    "chained_variables": (chain("let a0 = 1\n", "let a@+ = a@ + 1\n", "print(a20000)"), 0, "", []),
    "long_links": (LINKS + "print(n == m)\nprint(f\"{n}\".length)\nn = N([])\nprint(1)", 0, "", []),
    "long_links_kept": (LINKS + "throw error(f\"{n}\")", FAILED, "R0627", []),
    "long_closures": ("var f = fn() => 1\nvar i = 0\nwhile (i < 300000) { let g = f; f = fn() => g(); i = i + 1 }\nprint(f())",
                      FAILED, "R0624", []),
    "recursion_in_solve": (HUGGED + "solve(fn(x) => x - 0.5 + 0.0 * f(n + 1), 0.0, 1.0) }\nprint(f(0))", FAILED, "R0624", []),
    "recursion_in_ode": (HUGGED + "ode(fn(t, y) => [f(n + 1)], [0.0], 0s, 1s, step: 1s).t.last / 1s }\nprint(f(0))",
                         FAILED, "R0624", []),
    "recursion_in_minimise": (HUGGED + "minimise(fn(v) => v[0]^2 + f(n + 1), [1.0])[0] }\nprint(f(0))", FAILED, "R0624", []),
    "recursion_in_sort": ("fn f(n: int) -> int { return sort([n, 1], fn(x) => f(x + 1))[0] }\nprint(f(0))", FAILED, "R0624", []),
    "recursion_in_a_task": ("fn f(n: int) -> int { return f(n + 1) + 1 }\nparallel { print(f(0)); wait(1s) }", FAILED, "R0624", []),
    "recursion_of_tasks": ("fn f(n: int) { when (true) { f(n + 1) } wait(1s) }\nf(0)", FAILED, "R0633", []),
    "shared_halves": ("struct N { a: N[] }\nvar n = N([])\nvar m = N([])\nvar i = 0\n"
                      "while (i < 60) { n = N([n, n]); m = N([m, m]); i = i + 1 }\nprint(n == m)", 0, "",
                      ["--steps", "100000"]),
    "shared_halves_shown": ("struct N { a: N[] }\nvar n = N([])\nvar i = 0\n"
                            "while (i < 60) { n = N([n, n]); i = i + 1 }\nprint(f\"{n}\".length)", FAILED, "R0622",
                            ["--steps", "100000"]),
}
PATIENCE = 60  # seconds: a hang, not a measure of speed


def on_small_stack():
    resource.setrlimit(resource.RLIMIT_STACK, (STACK, STACK))


def report(name, what, shown):
    print(f"{name}: {what}")
    print("   " + shown[:300].replace("\n", "\n   "))
    return 1


def check_program(command, folder, name, text, status, code, options):
    path = os.path.join(folder, name + ".rbt")
    with open(path, "wb") as file:
        file.write(text if isinstance(text, bytes) else text.encode())
    try:
        run = subprocess.run([command, "run", "--quiet", *options, path], capture_output=True, timeout=PATIENCE,
                             preexec_fn=on_small_stack)
    except subprocess.TimeoutExpired:
        return report(name, f"no answer within {PATIENCE} s", "")
    shown = run.stderr.decode(errors="replace")
    if run.returncode != status:
        return report(name, f"exit status {run.returncode}, expected {status}", shown)
    if code and f"error {code}:" not in shown:
        return report(name, f"no message {code}", shown)
    if shown.count("error ") > MESSAGES.get(name, 1):
        return report(name, "more than one message", shown)
    return 0


def check_other_commands(command, folder, name):
    """The other commands that read a program end too, with or without a message, on the file of check_program."""
    failed = 0
    for verb in ("check", "fmt"):
        try:
            run = subprocess.run([command, verb, os.path.join(folder, name + ".rbt")], capture_output=True,
                                 timeout=PATIENCE, preexec_fn=on_small_stack)
        except subprocess.TimeoutExpired:
            failed += report(name, f"no answer from {verb} within {PATIENCE} s", "")
            continue
        if run.returncode not in (0, 1, REJECTED):
            failed += report(name, f"exit status {run.returncode} of {verb}", run.stderr.decode(errors="replace"))
    return failed


def check_usage(command, folder):
    failed = 0
    missing = os.path.join(folder, "missing.rbt")
    cases = {
        "unknown file": (["run", missing], NO_FILE, "E0126"), "folder": (["run", folder], NO_FILE, "E0126"),
        "unknown command": (["fly"], 64), "unknown option": (["run", "--fly", missing], 64),
        "unknown robot": (["run", "--robot", "r2d2", __file__], 64), "unknown code": (["explain", "E9999"], 64),
        "help": (["--help"], 0), "version": (["--version"], 0), "a page": (["explain", "E0401"], 0),
    }
    for name, (arguments, status, *code) in cases.items():
        run = subprocess.run([command, *arguments], capture_output=True, timeout=PATIENCE)
        shown = (run.stdout + run.stderr).decode()
        if run.returncode != status or not shown:
            failed += report(name, f"exit status {run.returncode}, expected {status}", shown)
        elif code and f"error {code[0]}:" not in shown:
            failed += report(name, f"no message {code[0]}", shown)
    return failed


def check_interrupt(command, folder, name, text, options):
    """Ctrl-C stops the program under control, and the summary says where it stood."""
    path = os.path.join(folder, name + ".rbt")
    with open(path, "w") as file:
        file.write(text)
    process = subprocess.Popen([command, "run", *options, path], stderr=subprocess.PIPE, stdout=subprocess.PIPE)
    time.sleep(1.0)
    process.send_signal(signal.SIGINT)
    try:
        _, errors = process.communicate(timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        process.kill()
        return report(name, "Ctrl-C is not heard", "")
    shown = errors.decode()
    stopped = "error R0629:" in shown and "stopped by the user at t =" in shown
    if process.returncode != STOPPED or not stopped:
        return report(name, f"exit status {process.returncode}, expected {STOPPED}", shown)
    return 0


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    command = os.path.abspath(sys.argv[1])
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for name, (text, status, code, options) in PROGRAMS.items():
            failed += check_program(command, folder, name, text, status, code, options)
        for name, (text, status, code, options) in DEEP.items():
            failed += check_program(command, folder, name, text, status, code, options)
            failed += check_other_commands(command, folder, name)
        failed += check_usage(command, folder)
        failed += check_interrupt(command, folder, "busy", "var i = 0\nwhile (true) { i = 1 - i }", [])
        failed += check_interrupt(command, folder, "moving", "moveJ(home() + [0.5, 0, 0, 0], time: 100s)", ["--realtime"])
    print(f"{failed} failed" if failed else "all answered")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
