// Pictures of cameras without a browser: messages, who is asked when, marks and paths, and where a camera stands in the 3D view.
import assert from "node:assert/strict";
import test from "node:test";
import { source } from "./modules.mjs";

const { readPicture } = await source("protocol/pictures.ts");
const { Pictures } = await source("store/pictures.ts");
const { Store } = await source("store/store.ts");
const { receive } = await source("store/receive.ts");
const { comingRun, shownRun } = await source("store/state.ts");
const { farthest, marksText, waysOf } = await source("elements/marks.ts");
const { openingOf, depthFor } = await source("scene/cameras.ts");
const { carrierFrame } = await source("store/carried.ts");
const { Rows } = await source("store/rows.ts");

function pictureMessage({ kind = 8, to = 7, channels = 3, width, height, pixels, told = { marks: [], fault: "" } }) {
  const text = new TextEncoder().encode(JSON.stringify(told));
  const data = new ArrayBuffer(24 + pixels.length + text.length);
  const head = new DataView(data);
  [kind, to, channels, width, height, text.length].forEach((n, i) => head.setUint32(4 * i, n, true));
  new Uint8Array(data, 24).set(pixels);
  new Uint8Array(data, 24 + pixels.length).set(text);
  return data;
}

test("a picture is read with its marks, in colour or grey", () => {
  const marks = [{ what: "feature", object: "", pixels: [[1.5, 0]] }];
  const { to, picture } = readPicture(pictureMessage({ width: 2, height: 1, pixels: [1, 2, 3, 250, 251, 252], told: { marks, fault: "none" } }));
  assert.equal(to, 7);
  assert.deepEqual([picture.width, picture.height, picture.fault], [2, 1, "none"]);
  assert.deepEqual([...picture.rgba], [1, 2, 3, 255, 250, 251, 252, 255]);
  assert.deepEqual(picture.marks, marks);
  const grey = readPicture(pictureMessage({ channels: 1, width: 1, height: 2, pixels: [9, 200] })).picture;
  assert.deepEqual([...grey.rgba], [9, 9, 9, 255, 200, 200, 200, 255]);
});

test("a message that is no picture, or is cut off, is none", () => {
  const whole = pictureMessage({ width: 2, height: 1, pixels: [1, 2, 3, 4, 5, 6] });
  assert.equal(readPicture(whole.slice(0, whole.byteLength - 1)), null);
  assert.equal(readPicture(new ArrayBuffer(8)), null);
  assert.equal(readPicture(pictureMessage({ kind: 6, width: 2, height: 1, pixels: [1, 2, 3, 4, 5, 6] })), null);
  assert.equal(readPicture(pictureMessage({ channels: 2, width: 1, height: 1, pixels: [1, 2] })), null);
});

const welcome = { type: "welcome", protocol: 1, page: 1, file: "a.rbt", text: "", text_version: 1 };
const runMessage = (run, more = {}) => ({ type: "run", run, state: "done", t_end: 4, text_version: 1, inputs: [], hash: "", error: null, ...more });
const view = (name) => ({ kind: "view", name, camera: "eye" });
const description = (run, elements = [view("a"), view("b")]) => ({ type: "description", run, robots: [], objects: [], cameras: [], elements });

// A laboratory whose answers come when the test lets them.
function asked() {
  const store = new Store((work) => work());
  const questions = [];
  store.change((s) => {
    for (const each of [welcome, runMessage(1), description(1), { type: "shown", run: 1 }]) receive(s, each);
  });
  const pictures = new Pictures(store, (element, run, t) => new Promise((resolve, reject) => questions.push({ element, run, t, resolve, reject })));
  const picture = (name) => shownRun(store.state).pictures.get(name);
  return { store, questions, pictures, picture };
}
const settled = () => new Promise((resolve) => setImmediate(resolve));
const some = { width: 1, height: 1, rgba: new Uint8ClampedArray(4), marks: [], fault: "" };

test("only what is shown is asked for, one question at a time, and once for an instant", async () => {
  const { questions, pictures, picture, store } = asked();
  await settled();
  assert.equal(questions.length, 0);
  pictures.want("a");
  pictures.want("b");
  pictures.want("gone"); // the run has no such element
  await settled();
  assert.deepEqual(questions.map((q) => [q.element, q.t]), [["a", 4]]);
  questions[0].resolve(some);
  await settled();
  assert.equal(picture("a").picture, some);
  assert.deepEqual(questions.map((q) => q.element), ["a", "b"]);
  questions[1].reject(new Error("There is no camera."));
  await settled();
  assert.equal(picture("b").fault, "There is no camera.");
  store.change((s) => (s.playing = true));
  await settled();
  assert.equal(questions.length, 2);
});

test("while a question is open the instant goes on, and only the newest is asked for; elements alternate", async () => {
  const { questions, pictures, store } = asked();
  pictures.want("a");
  pictures.want("b");
  await settled();
  for (const t of [1, 2, 3]) store.change((s) => (s.t = t));
  questions[0].resolve(some);
  await settled();
  assert.deepEqual([questions[1].element, questions[1].t], ["b", 3]);
  for (let i = 1; i < 7; i++) {
    store.change((s) => (s.t = 3 - 0.1 * i));
    questions[i].resolve(some);
    await settled();
  }
  assert.deepEqual(questions.map((q) => q.element), ["a", "b", "a", "b", "a", "b", "a", "b"]);
});

test("who leaves is not asked for any more, and inputs make another picture of the same instant", async () => {
  const { questions, pictures, store } = asked();
  const leave = pictures.want("a");
  await settled();
  questions[0].resolve(some);
  await settled();
  store.change((s) => receive(s, runMessage(1, { inputs: [{ t: 4, set: "gain", value: 2 }] })));
  await settled();
  assert.equal(questions.length, 2);
  questions[1].resolve(some);
  leave();
  store.change((s) => (s.t = 1));
  await settled();
  assert.equal(questions.length, 2);
});

test("marks are counted, and features compared with where they are wanted", () => {
  const marks = [{ what: "feature", object: "", pixels: [[0, 0], [3, 4]] }, { what: "wanted", object: "", pixels: [[0, 1], [0, 0]] }, { what: "truth", object: "card", pixels: [[1, 1]] }, { what: "truth", object: "box", pixels: [[1, 1], [2, 2]] }];
  assert.equal(marksText(marks), "2 features, 3 true corners, 2 wanted");
  assert.equal(marksText([{ what: "corner", object: "", pixels: [[1, 1]] }]), "1 corner");
  assert.equal(farthest(marks), 5);
  assert.equal(farthest(marks.slice(1)), null);
  assert.equal(farthest([marks[0], { ...marks[1], pixels: [[0, 0]] }]), null);
});

test("the paths of features are those of the rows, as far as the instant", () => {
  const rows = new Rows(5);
  const block = (first, values) => ({ kind: 3, run: 1, index: 0, columns: 5, first, count: values.length, rows: new Float64Array(values.flat()) });
  rows.add(block(0, [[0, 1, 2, 3, 4], [1, 5, 6, 7, 8], [2, 9, 10, 11, 12]]));
  const ways = waysOf(rows, 1, 20);
  assert.deepEqual(ways.map((way) => way.until), [2, 2]);
  assert.deepEqual(ways[1].points, [[3, 4], [7, 8], [11, 12]]);
  assert.deepEqual(waysOf(rows, -1, 20)[0], { points: [[1, 2], [5, 6], [9, 10]], until: 0 });
  assert.deepEqual(waysOf(undefined, 1, 20), []);
  // A jump ends one way and begins another.
  rows.add(block(3, [[3, 99, 98, 13, 14], [4, 97, 96, 15, 16]]));
  assert.deepEqual(waysOf(rows, 1, 20)[0], { points: [[1, 2], [5, 6], [9, 10]], until: 2 });
  assert.deepEqual(waysOf(rows, 3.5, 20)[0], { points: [[99, 98], [97, 96]], until: 1 });
  assert.equal(waysOf(rows, 3.5, 20)[1].points.length, 5);
});

test("the opening of a camera is what its lens sees, as wide as it is to be", () => {
  const lens = { size: [320, 240], focal: [300, 310], centre: [150, 125] };
  const z = depthFor(lens, 0.08);
  const corners = openingOf(lens, z);
  assert.ok(Math.abs(corners[1][0] - corners[0][0] - 0.08) < 1e-12);
  // Each corner is seen where the picture ends.
  const pixel = ([x, y, depth]) => [(x / depth) * 300 + 150, (y / depth) * 310 + 125];
  [[-0.5, -0.5], [319.5, -0.5], [319.5, 239.5], [-0.5, 239.5]].forEach((at, i) => pixel(corners[i]).forEach((v, k) => assert.ok(Math.abs(v - at[k]) < 1e-9)));
});

test("a camera goes with what carries it, and is not there when that is gone", () => {
  const { store } = asked();
  const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const at = (x, y, z) => [...IDENTITY.slice(0, 12), x, y, z, 1];
  const joint = { unit: "rad", lower: -3, upper: 3, max_speed: 1, T_before_joint: IDENTITY, T_joint_link: at(1, 0, 0) };
  const robot = { name: "arm", home: [Math.PI / 2, 0], joints: [joint, joint], T_world_base: IDENTITY, tool: { kind: "none", stroke: 0, radius: 0, length: 0, T_flange_tool: at(0, 0, 1) }, shapes: [] };
  const cube = { name: "cube", shape: "box", size: [1, 1, 1], color: "red", pose: [5, 0, 0, 1, 0, 0, 0] };
  store.change((s) => receive(s, { ...description(1), robots: [robot], objects: [cube] }));
  const run = shownRun(store.state);
  const place = (carrier) => carrierFrame(run, 1, carrier)?.slice(12, 15).map((v) => +v.toFixed(9));
  assert.deepEqual(place({ robot: null, link: 0, object: "" }), [0, 0, 0]);
  assert.deepEqual(place({ robot: null, link: 0, object: "cube" }), [5, 0, 0]);
  assert.deepEqual(place({ robot: 0, link: 0, object: "" }), [0, 0, 0]);
  assert.deepEqual(place({ robot: 0, link: 1, object: "" }), [0, 1, 0]);
  assert.deepEqual(place({ robot: 0, link: 2, object: "" }), [0, 2, 0]);
  assert.deepEqual(place({ robot: 0, link: -1, object: "" }), [0, 2, 1]);
  assert.equal(place({ robot: null, link: 0, object: "ball" }), undefined);
  assert.equal(place({ robot: 3, link: 0, object: "" }), undefined);
});

test("a run that takes long is reported while the one before is still shown", () => {
  const { store } = asked();
  assert.equal(comingRun(store.state), null);
  store.change((s) => {
    for (const each of [runMessage(2, { state: "running", t_end: 1, pictures: 40 }), description(2), { type: "shown", run: 2 }]) receive(s, each);
  });
  assert.equal(shownRun(store.state).id, 1);
  assert.deepEqual([comingRun(store.state).id, comingRun(store.state).taken], [2, 40]);
  store.change((s) => receive(s, runMessage(2, { pictures: 90 })));
  assert.equal(shownRun(store.state).id, 2);
  assert.equal(comingRun(store.state), null);
});
