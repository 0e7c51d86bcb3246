// Shapes that are only shown, and the pictures of links, without a browser.
import assert from "node:assert/strict";
import test from "node:test";
import { source } from "./modules.mjs";

const { receive, receiveRows } = await source("store/receive.ts");
const { initialState } = await source("store/state.ts");
const { recordingOf } = await source("store/recording.ts");
const { readRows } = await source("protocol/rows.ts");
const { DrawingsView } = await source("scene/drawings.ts");
const { ArmView } = await source("scene/arm.ts");
const { light } = await source("scene/palette.ts");

globalThis.CSS = { supports: () => true }; // of browsers
const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const at = (x, y, z) => [...IDENTITY.slice(0, 12), x, y, z, 1];
const joint = { unit: "rad", lower: -3, upper: 3, max_speed: 1, T_before_joint: IDENTITY, T_joint_link: at(1, 0, 0) };
const tool = { kind: "none", stroke: 0, radius: 0, length: 0, T_flange_tool: at(0, 0, 0.5) };
const robot = { name: "arm", home: [Math.PI / 2, 0], joints: [joint, joint], T_world_base: IDENTITY, tool, shapes: [] };
const cube = { name: "cube", shape: "box", size: [1, 1, 1], color: "red", pose: [5, 6, 7, 1, 0, 0, 0] };
const drawing = (more) => ({ t: 0, name: "a", kind: "arrow", text: "", color: "#ff0000", robot: null, link: -1, object: "", span: null, ...more });
// t, number, x, y, z, qw, qx, qy, qz, sizes.
const row = (t, number, z, sizes = [0.5, 0.01, 0]) => [t, number, 0, 0, z, 1, 0, 0, 0, ...sizes];
const gone = (t, number) => row(t, number, 0, [0, 0, 0]);

function runOf(drawings, rows) {
  const state = initialState();
  receive(state, { type: "run", run: 1, state: "done", t_end: 2, text_version: 1 });
  receive(state, { type: "description", run: 1, robots: [robot], objects: [cube], elements: [] });
  receive(state, { type: "drawings", run: 1, first: 0, items: drawings });
  receiveRows(state, { kind: 7, run: 1, index: 0, columns: 12, first: 0, count: rows.length, rows: new Float64Array(rows.flat()) });
  return { state, run: state.runs.get(1) };
}

// Where the copies of a form are, by the order in which they were added: [x, y, z] of their origins.
function placesOf(view) {
  return view.group.children.map((mesh) => Array.from({ length: mesh.count }, (_, i) => [...mesh.instanceMatrix.array.slice(16 * i + 12, 16 * i + 15)].map((x) => Math.round(x * 1000) / 1000)));
}

test("a shape is what it received last, from when it was drawn until it is gone", () => {
  const { run } = runOf([drawing()], [row(0.5, 0, 1), row(1, 0, 2), gone(1.5, 0)]);
  assert.equal(run.drawingRows.rowAt(0, 0.4), -1);
  assert.equal(run.drawingRows.rowAt(0, 0.5), 0);
  assert.equal(run.drawingRows.rowAt(0, 0.9), 0); // nothing is between two rows
  assert.equal(run.drawingRows.rowAt(0, 1.2), 1);
  assert.equal(run.drawingRows.rowAt(0, 1.6), -1);
  assert.equal(run.drawingRows.rowAt(7, 1), -1);
});

test("rows that are sent again replace those before", () => {
  const { state, run } = runOf([drawing()], [row(0, 0, 1), row(1, 0, 2)]);
  receiveRows(state, { kind: 7, run: 1, index: 0, columns: 12, first: 1, count: 1, rows: new Float64Array(row(1.2, 0, 9)) });
  assert.equal(run.drawingRows.count, 2);
  assert.equal(run.drawingRows.at(run.drawingRows.rowAt(0, 2), 4), 9);
  assert.equal(run.drawingRows.rowAt(0, 1.1), 0);
});

test("shapes are where the world, an object, a link and the tool point are", () => {
  const on = [{}, { object: "cube" }, { robot: 0, link: 0 }, { robot: 0, link: 1 }, { robot: 0, link: 2 }, { robot: 0, link: -1 }, { object: "none" }];
  const { run } = runOf(on.map((each, i) => drawing({ ...each, name: `${i}`, kind: "line" })), on.map((_, i) => row(0, i, 0.25)));
  const view = new DrawingsView(true);
  const labels = [];
  view.place(run, 1, labels);
  assert.deepEqual(placesOf(view), [[[0, 0, 0.25], [5, 6, 7.25], [0, 0, 0.25], [0, 1, 0.25], [0, 2, 0.25], [0, 2, 0.75]]]);
  assert.deepEqual(labels, []);
});

test("every kind is drawn, texts as labels of their height and colour", () => {
  const kinds = ["arrow", "line", "disk", "ellipsoid", "capsule", "text", "something new"];
  const { run } = runOf(kinds.map((kind, i) => drawing({ kind, name: kind, text: kind === "text" ? "<b>" : "", color: i % 2 ? "blue" : "#ff0000" })), kinds.map((_, i) => row(0, i, 0, [0.2, 0.1, 0.05])));
  const view = new DrawingsView(true);
  const labels = [];
  view.place(run, 0, labels);
  const count = view.group.children.reduce((sum, mesh) => sum + mesh.count, 0);
  assert.equal(count, 2 + 1 + 1 + 1 + 3);
  assert.equal(view.meshes().children.length, count);
  assert.equal(labels.length, 1);
  assert.equal(labels[0].text, "<b>");
  assert.equal(labels[0].height, 0.2);
  assert.equal(labels[0].color, "#0000ff"); // blue
});

test("eight times the arrows are eight times the work", () => {
  // What is read of the shapes and of their rows for one picture: the same number on every machine, which time is not.
  const reads = (n) => {
    let count = 0;
    const counted = (target) => new Proxy(target, { get: (of, key) => (count++, of[key]) });
    const { run } = runOf(Array.from({ length: n }, (_, i) => drawing({ name: `a${i}` })), Array.from({ length: 3 * n }, (_, i) => row(Math.floor(i / n), i % n, 1)));
    run.drawings = run.drawings.map(counted);
    const at = run.drawingRows.at.bind(run.drawingRows);
    run.drawingRows.at = (...place) => (count++, at(...place));
    const view = new DrawingsView(true);
    view.place(run, 1.5, []);
    assert.equal(view.group.children[0].count, n);
    return count;
  };
  const [few, many] = [reads(1000), reads(8000)];
  assert.ok(few >= 1000 && many <= 8 * few, `${few} reads for 1,000, ${many} for 8,000`);
});

test("a recording has its shapes", () => {
  const { state, run } = runOf([drawing()], [row(0, 0, 1), row(1, 0, 2)]);
  const messages = recordingOf(state, run);
  const again = initialState();
  for (const message of messages) {
    if (message.binary) receiveRows(again, readRows(Uint8Array.from(Buffer.from(message.binary, "base64")).buffer));
    else receive(again, message);
  }
  assert.deepEqual(again.runs.get(1).drawings, run.drawings);
  assert.equal(again.runs.get(1).drawingRows.rowAt(0, 1.5), 1);
});

test("shapes that a description gives stay beside the meshes of their link, others stood in for them", () => {
  const shape = (more) => ({ link: 1, kind: "cylinder", role: "link", T: IDENTITY, radius: 0.1, length: 0.1, ...more });
  const pictures = [{ link: 1, file: "both", T: IDENTITY }, { link: 1, file: "seen", T: IDENTITY, use: "picture" }, { link: 1, file: "felt", T: IDENTITY, use: "collision" }];
  const solids = [shape({ kind: "box", size: [1, 1, 1] })];
  const arm = (shapes) => {
    const asked = [];
    const view = new ArmView({ ...robot, shapes, solids, pictures }, light, false, { library: { model: (file) => (asked.push(file), { group: view?.linkOf(0)?.clone() ?? holder.clone(), hasMaterials: true }) } });
    return { view, asked };
  };
  const holder = new ArmView(robot, light, false).linkOf(0);
  const visible = (view) => view.linkOf(1).children.filter((node) => node.isMesh).map((node) => node.visible);
  const given = arm([shape({ given: true }), shape()]);
  given.view.stand([0, 0]);
  assert.deepEqual(visible(given.view), [true, false]);
  assert.deepEqual([...new Set(given.asked)], ["both", "seen"]);
  given.asked.length = 0;
  given.view.asSolids = true;
  given.view.stand([0, 0]);
  assert.deepEqual(visible(given.view), [true]);
  assert.deepEqual([...new Set(given.asked)], ["both", "felt"]);
});
