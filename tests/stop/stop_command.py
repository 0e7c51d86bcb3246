#!/usr/bin/env python3
"""One Ctrl-C ends what a program does, wherever it comes: stop_command.py ARMLET.

Programs that were hard to stop, and 200 random ones at random instants.
"""

import random
import sys
from pathlib import Path

from stopping import stop_all

COMMAND = Path(sys.argv[1]).resolve()

PROGRAMS = {
    "many bodies": """
        for (i in range(6000)) { box(1mm, 1mm, 1mm).spawn("o" + i, at: xyz(0mm, 0mm, 0.5mm)) }
        while (true) { }""",
    "distances of robots": """
        robot a = robots.panda()
        robot b = robots.ur5()
        var n = 0
        while (true) { if (distance(a, b) < 1mm) n += 1 }""",
    "moves among many bodies": """
        robot arm = robots.panda()
        for (i in range(1000)) { box(5mm, 5mm, 5mm).spawn("o" + i, at: xyz(0.3m + 0.01m * (i % 30), 0.01m * (i / 30), 0.5m)) }
        with (collisions: "report") { while (true) { try { arm.moveJ(arm.randomJoints()) } catch (e) { } } }""",
    "failures in finally blocks": """
        fn f(n: int) { try { f(n + 1) } finally { f(n + 1) } }
        f(0)""",
    "waits in a finally block": """
        try { while (true) { wait(1s) } } finally { while (true) { wait(1s) } }""",
    "a condition in a finally block": """
        try { while (true) { wait(1s) } } finally { wait until false }""",
    "moves in a finally block": """
        try { while (true) { wait(1s) } } finally { while (true) { moveJ(home(), time: 1s) } }""",
    "a loop in a finally block": """
        try { while (true) { wait(1s) } } finally { while (true) { } }""",
    "planning in a finally block": """
        robot arm = robots.panda()
        object wall { shape: box(50mm, 2m, 1m), at: xyz(0.4m, 0m, 0.5m) }
        try { while (true) { wait(1s) } }
        finally { while (true) { try { let t = arm.plan(arm.randomJoints()) } catch (e) { } } }""",
    "finally blocks of branches": """
        fn stay() { try { while (true) { wait(1ms) } } finally { while (true) { wait(1ms) } } }
        parallel { stay(); stay(); stay() }""",
    "lists of lists": """
        while (true) { let rows = range(1000000).map(fn(i) => [i]) }""",
}

RANDOM_PROGRAMS = 200
PIECES = [
    "let NAME = range(20000).map(fn(x) => x * x % 97).filter(fn(x) => x > 3)",
    "let NAME = sort(range(5000).map(fn(x) => string(x * 7919 % 1009)))",
    'let NAME = "abc,".repeat(20000).split(",").join(";")',
    'let NAME = "abc,".repeat(50000).replace("b", "xx").upper()',
    "let NAME = inv(0.01 * ones(120, 120) + eye(120))",
    "let NAME = ones(200, 200) * ones(200, 200)",
    "let NAME = svd(ones(60, 60) + eye(60))",
    "var NAME = [0: 0]\nfor (NAMEk in range(2000)) { NAME[NAMEk] = NAMEk }",
    "let NAME = arm.ikine(arm.fkine(arm.randomJoints()))",
    "let NAME = arm.ikineInfo(xyz(3m, 0m, 0m))",
    "arm.moveJ(arm.randomJoints())",
    "arm.moveL(arm.here() * xyz(0mm, 0mm, 5mm))",
    "wait(10ms)",
    "wait until now() > 1000s",
    "let NAME = arm.baseParameters()",
    "let NAME = arm.simulate(law: fn(t, q, qd) => zeros(7), during: 200ms, every: 10ms)",
    "let NAME = arm.plan(arm.randomJoints())",
    "let NAME = deep(300)",
    "fails(7)",
    'throw error("no", kind: "none")',
    "let NAME = distance(arm, part)",
    "let NAME = ode(fn(t, y) => [-y[0], y[1]], [1.0, 2.0], 0s, 1s, step: 100us)",
    "let NAME = minimise(fn(v) => sum(v .* v), ones(20))",
    "let NAME = solve(fn(x) => x * x - 2.0, 0.0, 5.0)",
    'print("text", 1.5, range(300))',
    'box(9mm, 9mm, 9mm).spawn("NAME" + now(), at: xyz(1m, 1m, 1m))',
    "setPose(part, xyz(0.5m, 0.5m, 0.1m))",
]
BEGIN = """robot arm = robots.panda()
object part { shape: box(40mm, 40mm, 40mm), at: xyz(0.6m, 0.5m, 0.02m) }
fn deep(n: int) -> int { if (n == 0) { return 0 }; return 1 + deep(n - 1) }
fn fails(n: int) { if (n == 0) { throw error("deep", kind: "none") }; try { fails(n - 1) } finally { fails(n - 1) } }
"""


class Program:
    """A random program without end. Whatever fails in it is caught."""

    def __init__(self, number):
        self.random = random.Random(number)
        self.names = 0
        self.text = BEGIN
        for task in ("first", "second"):
            self.text += f"fn {task}() {{\n{self.block(2)}}}\n"
        self.text += "while (true) {\n    wait(1ms)\n    try {\n" + self.block(0) + "    } catch (e) { }\n}\n"

    def name(self):
        self.names += 1
        return f"v{self.names}"

    def block(self, depth):
        return "".join(self.statement(depth) + "\n" for _ in range(self.random.randint(1, 4)))

    def statement(self, depth):
        kind = self.random.randrange(12) if depth < 4 else 11
        inner = lambda: self.block(depth + 1)
        if kind <= 1:
            return f"for ({self.name()} in range({self.random.randint(2, 60)})) {{\n{inner()}}}"
        if kind == 2:
            return f"try {{\n{inner()}}} catch ({self.name()}) {{\n{inner()}}}"
        if kind == 3:
            return f"try {{\n{inner()}}} finally {{\n{inner()}}}"
        if kind == 4 and depth < 2:
            return "parallel { first(); second() }"
        if kind == 5:
            return f"with (speed: 0.5) {{\n{inner()}}}"
        if kind == 6:
            return "try { wait(1s) } finally { while (true) { wait(1s) } }" if self.random.random() < 0.2 else "wait(1s)"
        return self.random.choice(PIECES).replace("NAME", self.name())


def main():
    instants = random.Random(12)
    cases = [(name, text, instants.uniform(0.05, 0.5)) for name, text in PROGRAMS.items() for _ in range(2)]
    cases += [(f"random program {i}", Program(i).text, instants.uniform(0.01, 0.3)) for i in range(RANDOM_PROGRAMS)]
    faults = []
    longest = (0.0, 0.0, "")
    for name, text, run in stop_all(COMMAND, cases):
        longest = max(longest, (run.cpu, run.seconds, name))
        if run.fault:
            faults.append(f"{name}: {run.fault}\n{text}")
    print(f"{len(cases)} runs; the longest took {longest[0]:.3f} s of the processor and {longest[1]:.3f} s to stop: "
          f"{longest[2]}")
    if faults:
        sys.exit(f"stop_command.py: {len(faults)} faults\n" + "\n".join(faults))


main()
