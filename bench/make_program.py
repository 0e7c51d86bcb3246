#!/usr/bin/env python3
"""Writes a long program that passes the checker: the work of a robot cell, repeated with other names and numbers."""

import sys

UNIT = """\
// Station {n}: takes boxes from a tray and puts them on a pallet.
struct Tray{n} {{ corner: posC; pitch: length; rows: int; columns: int; weights: double[] }}
enum State{n} {{ Idle, Picking, Placing, Failed }}

let tray{n} = Tray{n}(corner: xyz({x}mm, -120mm, 15mm), pitch: 55.5mm, rows: {r}, columns: 4, weights: [0.5, 1.25, {n}.0])

fn slot{n}(t: Tray{n}, index: int) -> posC {{
    let row = index / t.columns
    let column = index % t.columns
    return t.corner * xyz(t.pitch * row, t.pitch * column, 0mm)
}}

fn mean{n}(values: double[]) -> double {{
    var total = 0.0
    for (v in values) {{ total += v }}
    if (values.length == 0) {{ throw error("no values at station {n}", kind: "Empty") }}
    return total / values.length
}}

fn route{n}(start: double, goal: double, steps: int) -> double[] {{
    var points = new double[steps]
    for (int i = 0; i < steps; i++) {{
        let s = double(i) / (steps - 1)              // 0 to 1
        let smooth = 10 * s ^ 3 - 15 * s ^ 4 + 6 * s ^ 5
        points[i] = start + (goal - start) * smooth
    }}
    return points
}}

double[][] distances{n}(double[] xs, double[] ys) {{
    double[][] d = new double[xs.length][ys.length];
    for (int i = 0; i < xs.length; i++) {{
        for (int j = 0; j < ys.length; j++) {{
            double dx = xs[i] - ys[j];
            if (dx < 0.0 && i != j || dx > {x}.5) {{ dx = -dx; }} else {{ dx *= 2.0; }}
            d[i][j] = Math.sqrt(dx * dx + 1.0e-3);
        }}
    }}
    return d;
}}

fn advance{n}(state: State{n}, failures: int) -> State{n} {{
    switch (state) {{
        case State{n}.Idle: return State{n}.Picking
        case State{n}.Picking: return failures > {r} ? State{n}.Failed : State{n}.Placing
        case State{n}.Placing: return State{n}.Idle
        case State{n}.Failed: return State{n}.Failed
    }}
}}

var work{n} = 0.0
try {{
    for (k in range(3)) {{ work{n} += mean{n}(tray{n}.weights) * k + route{n}(0.0, 1.5, 8)[k] }}
    let far = distances{n}([0.25, 0.5], [1.0, {n}.0])
    if (far[0][1] > 10.0) {{ print(f"station {n} is far away: {{far[0][1]:.2f}} after {{work{n}:.3f}}") }}
}} catch (e) {{
    print("station {n}:", e.message)
}}
"""


def program(size):
    """A program of about `size` bytes."""
    units = []
    while sum(map(len, units)) < size:
        n = len(units) + 1
        units.append(UNIT.format(n=n, x=100 + 37 * n % 400, r=2 + n % 5))
    return "\n".join(units)


if __name__ == "__main__":
    sys.stdout.write(program(int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000))
