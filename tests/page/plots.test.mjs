// Data of plots, figures and matrices, as people read them.
import assert from "node:assert/strict";
import test from "node:test";
import { source } from "./modules.mjs";

const { alignedRanges } = await source("numbers/axes.ts");
const { isPlottable, seriesOfPanel } = await source("numbers/figure.ts");
const { jointNames } = await source("numbers/joints.ts");
const { csvOf } = await source("numbers/series.ts");
const { roundedTogether, shownTable } = await source("elements/table_value.ts");

// Random numbers in [0, 1) that are the same in every run.
function random(seed) {
  let state = seed;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}

test("zero is at one height on all axes, and every value is within its axis", () => {
  const next = random(7);
  for (let k = 0; k < 2000; k++) {
    const extents = Array.from({ length: 1 + Math.floor(3 * next()) }, () => {
      const [a, b] = [0, 0].map(() => (next() < 0.15 ? 0 : (next() - 0.5) * 10 ** Math.floor(8 * next() - 4)));
      return next() < 0.05 ? null : [Math.min(a, b), Math.max(a, b)];
    });
    const ranges = alignedRanges(extents);
    const zero = ([low, high]) => -low / (high - low);
    ranges.forEach((range, i) => {
      const [low, high] = extents[i] ?? [0, 0];
      assert.ok(range[0] < range[1] && Number.isFinite(range[0]) && Number.isFinite(range[1]), JSON.stringify([extents, ranges]));
      assert.ok(range[0] <= Math.min(0, low) && range[1] >= Math.max(0, high), JSON.stringify([extents, ranges]));
      assert.ok(Math.abs(zero(range) - zero(ranges[0])) < 1e-9, JSON.stringify([extents, ranges]));
    });
    // Not more room than two axes of opposite signs need: each half, and a margin.
    if (extents.length < 3) ranges.forEach(([low, high], i) => {
      const [a, b] = extents[i] ?? [0, 0];
      const [least, most] = [Math.min(0, a), Math.max(0, b)];
      if (most > least) assert.ok(high - low <= 2.3 * (most - least), JSON.stringify([extents, ranges]));
    });
  }
  assert.deepEqual(alignedRanges([[0, 90], [0, 50]]).map(([low]) => low), [0, 0]);
});

const scara = { name: "arm", joints: ["rad", "rad", "m", "rad"].map((unit) => ({ unit })) };
const named = { name: "panda", joints: ["a", "b", "c"].map((name) => ({ unit: "rad", name })) };

test("columns of a plot have the names of joints where their units are those of an arm", () => {
  const of = (units, robots, name = "row", label = "") => jointNames(units, units.length, robots, [label, name]);
  assert.deepEqual(of(["rad", "rad", "m", "rad"], [scara]), ["q1", "q2", "q3", "q4"]);
  assert.deepEqual(of(["rad/s^2", "rad/s^2", "m/s^2", "rad/s^2"], [named, scara]), ["q1", "q2", "q3", "q4"]);
  assert.deepEqual(of(["Nm", "Nm", "N", "Nm"], [scara]), ["q1", "q2", "q3", "q4"]);
  assert.deepEqual(of(["rad", "rad", "rad"], [named], "q"), ["a", "b", "c"]);
  assert.equal(of(["rad", "rad", "rad"], [named], "orientation"), null);
  assert.equal(of(["rad", "m", "rad", "rad"], [scara]), null);
  assert.equal(of(["", "", "", ""], [scara]), null);
});

const axis = (unit, label = "", log = false) => ({ unit, label, log });
const panelOf = (...series) => ({ title: "", x: axis("s", "time"), y: axis("rad"), right: axis("m"), series: series.map((each) => ({ kind: "line", label: "", right: false, ...each })) });

test("the lines of a figure lie over one axis, in degrees and millimetres, with their steps and gaps", () => {
  const { t, columns, below } = seriesOfPanel(panelOf({ label: "a", x: [0, 1, 1, 2], y: [0, Math.PI, 0, null] }, { label: "b", right: true, x: [0.5, 2], y: [0.1, 0.2] }));
  assert.deepEqual(below, { label: "time", unit: "s", log: false });
  assert.deepEqual(t.map((v) => +v.toFixed(6)), [0, 0.5, 1, 1, 2]);
  assert.ok(t[3] > t[2]);
  assert.deepEqual(columns[0].values.map((v) => (typeof v === "number" ? +v.toFixed(9) : v)), [0, undefined, 180, 0, null]);
  assert.deepEqual([...columns[1].values], [undefined, 100, undefined, undefined, 200]);
  assert.deepEqual(columns.map((c) => [c.label, c.unit, c.right]), [["a", "deg", false], ["b", "mm", true]]);
  assert.equal(csvOf(seriesOfPanel(panelOf({ label: "a", x: [0, 1], y: [0, Math.PI] }))), "time [s],a [deg]\n0,0\n1,180\n");
});

test("lines of a figure without names have those of the joints", () => {
  const lines = [0, 1, 2, 3].map((k) => ({ right: k === 2, x: [0, 1], y: [0, 1] }));
  const names = (robots, of = lines) => seriesOfPanel(panelOf(...of), robots).columns.map((c) => c.label);
  assert.deepEqual(names([scara]), ["q1", "q2", "q3", "q4"]);
  assert.deepEqual(names([named]), ["line 1", "line 2", "line 3", "line 4"]);
  assert.deepEqual(names([scara], lines.map((each, k) => ({ ...each, label: `a${k}` }))), ["a0", "a1", "a2", "a3"]);
});

test("a map, a loop and bars stay pictures", () => {
  assert.equal(isPlottable(panelOf({ x: [0, 1], y: [0, 1] })), true);
  assert.equal(isPlottable(panelOf({ x: [0, 1, 0], y: [0, 1, 2] })), false);
  assert.equal(isPlottable(panelOf({ x: [0, null], y: [0, 1] })), false);
  assert.equal(isPlottable(panelOf({ kind: "bars", x: [0, 1], y: [0, 1] })), false);
  assert.equal(isPlottable({ ...panelOf({ x: [0, 1], y: [0, 1] }), x: axis("m"), y: axis("m") }), false);
});

test("elements of a matrix are rounded by the largest one, and rows and columns have names", () => {
  const M = [[1.375386112, -0.01104333859, 6e-7], [-0.01104333859, 1.3117042, 0.7246985572], [6e-7, 0.7246985572, 0.000594]];
  assert.deepEqual(roundedTogether(M), [["1.375", "−0.011", "0"], ["−0.011", "1.312", "0.725"], ["0", "0.725", "0.001"]]);
  assert.deepEqual(roundedTogether([[1e-9, 2e-12], [3e-10, 0]]), [["1.00e-9", "2.00e-12"], ["3.00e-10", "0"]]);
  assert.deepEqual(roundedTogether([[1, 2], [3, -4]]), [["1", "2"], ["3", "−4"]]);
  assert.deepEqual(roundedTogether([[0, 0], [0, 0]]), [["0", "0"], ["0", "0"]]);
  const names = [["q1", "q2", "q3"]];
  assert.deepEqual(shownTable(M, "", [], names).header, ["", "q1", "q2", "q3"]);
  assert.deepEqual(shownTable(M, "", [], names).rows.map((row) => row[0]), ["q1", "q2", "q3"]);
  const J = Array.from({ length: 6 }, (_, i) => [i, 2, 3.5]);
  assert.deepEqual(shownTable(J, "", [], names).rows.map((row) => row[0]), ["vx", "vy", "vz", "ωx", "ωy", "ωz"]);
  assert.deepEqual(shownTable([[1, 0, 2], [0, 1, 3], [0, 0, 1]], "", [], names).header, ["", "1", "2", "3"]); // not symmetric: a pose in the plane
  assert.deepEqual(shownTable([[0.1, 0.2], [0.3, 0.4]], "m"), { header: ["[mm]", "1", "2"], rows: [["1", "100", "200"], ["2", "300", "400"]], named: true });
});
