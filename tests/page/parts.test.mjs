// Parts of the page that need no browser: kinematics, binary messages, numbers in a text, files of plots.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { brotliCompressSync } from "node:zlib";
import { root, source } from "./modules.mjs";
import { readPng, smallPng } from "./small_png.mjs";

const kinematics = await source("store/kinematics.ts");
const { readRows, writeRows } = await source("protocol/rows.ts");
const { numberAt, pulled } = await source("editor/numbers.ts");
const { csvOf, svgOf } = await source("numbers/series.ts");
const { cellText, shownTable, tableOf } = await source("elements/table_value.ts");
const { fixed, rollPitchYaw, shownUnit } = await source("numbers/units.ts");
const { textToHash, hashToText } = await source("shell/link.ts");
const { isPublic } = await source("shell/share.ts");
const { positionText, poseText } = await source("shell/scene_tools.ts");
const { behindStatement, wantsValue } = await source("editor/placing.ts");
const { settingAt } = await source("editor/settings.ts");
const { fieldChange } = await source("editor/fields.ts");
const { statusOf } = await source("shell/status.ts");
const { initialState } = await source("store/state.ts");
const { rulerStep } = await source("timebar/bar.ts");
const { lanesOf } = await source("timebar/lanes.ts");
const { Run } = await source("store/run.ts");
const { textOf } = await source("scene/near.ts");
const { placeOfName } = await source("editor/names.ts");
const { nameForObject, objectText, placeForObject } = await source("editor/new_object.ts");
const { fromBase85, toBase85 } = await source("protocol/base85.ts");
const { extent, grasped } = await source("scene/fingers.ts");
const { neededPoints } = await source("scene/simplify.ts");

// Numbers of a fixed sequence between -1 and 1.
function sequence(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(1664525, state) + 1013904223) >>> 0;
    return state / 2147483648 - 1;
  };
}
function randomPose(next) {
  const q = [next(), next(), next(), next()];
  const norm = Math.hypot(...q);
  return [next(), next(), next(), ...q.map((v) => v / norm)];
}
const close = (a, b, tolerance) => a.forEach((v, i) => assert.ok(Math.abs(v - b[i]) <= tolerance, `${v} and ${b[i]} at ${i}`));

test("a pose becomes a rotation and comes back, up to the sign of its quaternion", () => {
  const next = sequence(7);
  for (let k = 0; k < 500; k++) {
    const pose = randomPose(next);
    if (k % 5 === 0) pose.splice(3, 4, 0, ...[[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.6, 0.8, 0], [0, -0.6, 0.8]][(k / 5) % 5]);
    const matrix = kinematics.poseMatrix(pose);
    for (let i = 0; i < 3; i++) assert.ok(Math.abs(Math.hypot(...matrix.slice(4 * i, 4 * i + 3)) - 1) < 1e-12);
    const back = kinematics.matrixPose(matrix);
    const sign = pose.slice(3).reduce((sum, v, i) => sum + v * back[3 + i], 0) < 0 ? -1 : 1;
    close(back, [...pose.slice(0, 3), ...pose.slice(3).map((v) => sign * v)], 1e-7);
  }
});

test("roll, pitch and yaw are those of Rz(yaw) Ry(pitch) Rx(roll)", () => {
  const next = sequence(11);
  const turn = (axis, a) => kinematics.poseMatrix([0, 0, 0, Math.cos(a / 2), ...axis.map((v) => v * Math.sin(a / 2))]);
  for (let k = 0; k < 200; k++) {
    const [roll, pitch, yaw] = [3 * next(), 1.5 * next(), 3 * next()];
    const m = kinematics.multiply(kinematics.multiply(turn([0, 0, 1], yaw), turn([0, 1, 0], pitch)), turn([1, 0, 0], roll));
    const found = rollPitchYaw(kinematics.matrixPose(m));
    close([found.roll, found.pitch, found.yaw], [roll, pitch, yaw], 1e-6);
  }
});

test("the tool of two links in a plane is where trigonometry says", () => {
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const link = (a) => ({ unit: "rad", lower: -3, upper: 3, max_speed: 1, T_before_joint: identity, T_joint_link: [...identity.slice(0, 12), a, 0, 0, 1] });
  const slide = { ...link(0), unit: "m" };
  const robot = { name: "r", home: [], joints: [link(0.4), link(0.3), slide], T_world_base: identity, tool: { T_flange_tool: identity }, shapes: [] };
  const next = sequence(3);
  for (let k = 0; k < 100; k++) {
    const [a, b, z] = [3 * next(), 3 * next(), next()];
    const tool = kinematics.toolFrame(robot, [a, b, z]);
    close(tool.slice(12, 15), [0.4 * Math.cos(a) + 0.3 * Math.cos(a + b), 0.4 * Math.sin(a) + 0.3 * Math.sin(a + b), z], 1e-12);
  }
});

test("links that copy a joint move by their ratio and offset", () => {
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const along = (a) => [...identity.slice(0, 12), a, 0, 0, 1];
  const row = (joint, ratio, offset, a) => ({ unit: "rad", T_before_joint: identity, T_joint_link: along(a), joint, ratio, offset });
  const joint = { unit: "rad", lower: -3, upper: 3, max_speed: 1, T_before_joint: identity, T_joint_link: identity };
  const robot = { joints: [joint, joint], rows: [row(0, 1, 0, 2), row(0, -1, 0, 0), row(1, 1, 0, 3), row(1, -0.5, 0.25, 0)], T_world_base: identity, tool: { T_flange_tool: identity } };
  const [a, b] = [0.4, 0.7];
  const frames = kinematics.shapeFrames(robot, [a, b]);
  assert.equal(frames.length, 6);
  const tool = kinematics.toolFrame(robot, [a, b]);
  assert.ok(Math.abs(tool[12] - (2 * Math.cos(a) + 3 * Math.cos(b))) < 1e-12);
  assert.ok(Math.abs(tool[13] - (2 * Math.sin(a) + 3 * Math.sin(b))) < 1e-12);
  assert.ok(Math.abs(Math.atan2(tool[1], tool[0]) - (0.5 * b + 0.25)) < 1e-12);
  assert.equal(kinematics.linkOfJoint(robot, 1), 2);
  assert.equal(kinematics.jointsAtLimits(robot, [3, 0]).join(), "true,false");
});

test("binary messages come back as they were written; others are refused", () => {
  const block = { kind: 1, run: 4, index: 2, columns: 3, first: 7, count: 2, rows: new Float64Array([0, 1.5, -2, 0.25, Math.PI, 1e300]) };
  const data = writeRows(block);
  assert.deepEqual(readRows(data), block);
  assert.equal(readRows(data.slice(0, 23)), null);
  assert.equal(readRows(data.slice(0, 48)), null);
});

test("numbers are found with their sign where that is no operator", () => {
  const found = (line, column) => numberAt(line, column)?.text ?? null;
  assert.equal(found("let a = 80mm", 9), "80");
  assert.equal(found("posJ(-20.5deg, 3)", 6), "-20.5");
  assert.equal(found("a - 5", 4), "5");
  assert.equal(found("a-5", 2), "5");
  assert.equal(found("x = -5", 4), "-5");
  assert.equal(found("joint3.x", 5), null);
  assert.equal(found("a + b", 1), null);
});

test("a pulled number keeps its digits", () => {
  assert.equal(pulled("0.61", 3), "0.64");
  assert.equal(pulled("2.0", -25), "-0.5");
  assert.equal(pulled("80", 10), "90");
  assert.equal(pulled("-1", 1), "0");
  assert.equal(pulled("0.1", -1), "0.0");
  const next = sequence(5);
  for (let k = 0; k < 300; k++) {
    const text = (100 * next()).toFixed(k % 4);
    const steps = Math.round(50 * next());
    assert.equal(Number(pulled(pulled(text, steps), -steps)), Number(text));
  }
});

test("a plot as a file has its units, and its texts cannot become markup", () => {
  const series = { t: new Float64Array([0, 1]), columns: [{ label: 'q1, "first"', unit: "deg", values: new Float64Array([2, 3]) }] };
  assert.equal(csvOf(series), 't [s],"q1, ""first"" [deg]"\n0,2\n1,3\n');
  const svg = svgOf("<script>", { ...series, columns: [{ ...series.columns[0], label: "<b>" }] }, ["#000"]);
  assert.ok(!svg.includes("<script>") && !svg.includes("<b>"));
});

test("speeds and forces of joints are shown in their units", () => {
  assert.deepEqual(["rad/s", "m/s", "rad/s^2", "m/s^2", "Nm", "N"].map((unit) => shownUnit(unit).unit), ["deg/s", "mm/s", "deg/s²", "mm/s²", "N m", "N"]);
  assert.equal(shownUnit("m/s").factor, 1000);
});

test("quantities are shown in degrees and millimetres", () => {
  assert.equal(shownUnit("rad", "/s").unit, "deg/s");
  assert.equal(shownUnit("m").factor, 1000);
  assert.equal(shownUnit("N").unit, "N");
});

test("tasks and signals have lanes behind those of robots, and say what they are", () => {
  const run = new Run(1);
  run.robots = [{ name: "arm" }, { name: "a very long name" }];
  run.moves = [{ robot: 1, span: [2, 0, 2, 9], t0: 0, t1: 2, text: "arm moveJ" }];
  run.textVersion = 4;
  run.stretches = [
    { kind: "signal", name: "lamp", t0: 0, t1: 1, value: false },
    { kind: "task", name: "branch 2 of parallel on line 12", t0: 0, t1: 1, span: [13, 0, 13, 4] },
    { kind: "task", name: "", t0: 0, t1: 2, span: [12, 0, 14, 1] },
    { kind: "task", name: "cell.go", t0: 1, t1: 2, span: [2, 0, 2, 4] },
    { kind: "signal", name: "lamp", t0: 1, t1: 2, value: true },
    { kind: "signal", name: "speed", t0: 0, t1: 1.5, value: 2.5 },
    { kind: "signal", name: "speed", t0: 1.5, t1: 2, value: 2.5 },
  ];
  const state = { text: "first\n  second line  \n", textVersion: 4 };
  const lanes = lanesOf(run, state);
  assert.deepEqual(lanes.map((lane) => lane.name), ["arm", "a very lo…", "program", "part 2 :12", "go", "lamp", "speed"]);
  assert.deepEqual(lanes.map((lane) => lane.blocks.length), [0, 1, 1, 1, 1, 2, 1]);
  assert.equal(lanes[4].blocks[0].text, "cell.go, line 2: second line");
  assert.deepEqual(lanes[5].blocks.map((block) => [block.name, block.low]), [["off", true], ["on", false]]);
  assert.deepEqual([lanes[6].blocks[0].text, lanes[6].blocks[0].t1], ["signal speed is 2.5", 2]);
  assert.deepEqual(lanes[2].blocks[0].lines, [12, 14]);
  // The text of another version is not that of the run.
  assert.equal(lanesOf(run, { ...state, textVersion: 5 })[4].blocks[0].text, "cell.go, line 2: ");
  assert.equal(lanesOf(null, state).length, 1);
});

test("a depth that is a lower bound is reported as one", () => {
  const pair = (more) => ({ distance: -0.02, body: { text: "link 3 of `arm`", at: [0, 0, 0] }, other: { text: "`shell`", at: [0, 0, 0] }, ...more });
  assert.equal(textOf(pair()), "link 3 of arm is 20 mm deep in shell");
  assert.equal(textOf(pair({ at_least: true })), "link 3 of arm is at least 20 mm deep in shell");
  assert.equal(textOf(pair({ at_least: true, felt: true, distance: -0.004 })), "link 3 of arm presses at least 4.0 mm into shell");
});

test("a program travels in an address and comes back; what is not one is refused", async () => {
  const text = "let größe = 80mm // μ\n".repeat(20);
  assert.equal(await hashToText(await textToHash(text)), text);
  const next = sequence(13);
  const noise = Array.from({ length: 60000 }, () => String.fromCharCode(48 + Math.floor(37 * (next() + 1)))).join("");
  assert.equal(await textToHash(noise), null);
  assert.equal(await hashToText("#p=not_deflated"), null);
  assert.equal(await hashToText("#other"), null);
});

test("a link is made only to a page that others can open", () => {
  const at = (address, alone = true) => isPublic(new URL(address), alone);
  assert.equal(at("https://course.example/lab.html"), true);
  assert.equal(at("http://192.168.1.20/lab.html"), true);
  for (const own of ["http://127.0.0.1:8820/", "http://localhost:5173/", "http://lab.localhost/", "http://[::1]/", "http://0.0.0.0:80/", "file:///home/x/lab.html"]) assert.equal(at(own), false, own);
  assert.equal(at("https://course.example/lab.html", false), false); // a served laboratory: its address contains a secret
});

test("marks of the ruler stand at round numbers", () => {
  for (const [span, room, step] of [[10, 10, 1], [9.74, 8, 2], [0.05, 10, 0.005], [600, 7, 100]]) assert.ok(Math.abs(rulerStep(span, room) - step) < 1e-12);
});

test("values of a program become tables: rows, records, columns, a row, one value", () => {
  assert.deepEqual(tableOf([[1, 2], [3, 4]]), { header: [], rows: [[1, 2], [3, 4]] });
  assert.deepEqual(tableOf([{ a: 1, b: 2 }, { b: 3 }]), { header: ["a", "b"], rows: [[1, 2], [null, 3]] });
  assert.deepEqual(tableOf({ a: [1, 2], b: [3] }), { header: ["a", "b"], rows: [[1, 3], [2, null]] });
  assert.deepEqual(tableOf({ mass: 2, name: "cube" }), { header: [], rows: [["mass", 2], ["name", "cube"]] });
  assert.deepEqual(tableOf([1, 2]), { header: [], rows: [[1, 2]] });
  assert.deepEqual(tableOf("x"), { header: [], rows: [["x"]] });
  assert.deepEqual([tableOf([]).rows, tableOf(null).rows, tableOf(undefined).rows], [[], [], []]);
  assert.deepEqual([cellText(-1.23456789), cellText(1e-9), cellText(3), cellText(null), cellText([1, 2])], ["−1.2346", "0", "3", "–", "[1, 2]"]);
});

test("tables are read in degrees and millimetres, with units in the header or behind the numbers", () => {
  const q = [Math.PI / 2, -Math.PI / 4, 0.15];
  const units = ["rad", "rad", "m"];
  assert.deepEqual(shownTable([q, q], [units, units], ["a", "b", "c"]), { header: ["a [deg]", "b [deg]", "c [mm]"], rows: [["90", "−45", "150"], ["90", "−45", "150"]] });
  assert.deepEqual(shownTable([q], [units]), { header: [], rows: [["90 deg", "−45 deg", "150 mm"]] });
  assert.deepEqual(shownTable([1, 2], "m"), { header: [], rows: [["1000 mm", "2000 mm"]] });
  assert.deepEqual(shownTable([{ name: "a", far: 0.002 }, { name: "b", far: 1 }], [{ name: "", far: "m" }, { name: "", far: "m" }]), { header: ["name", "far [mm]"], rows: [["a", "2"], ["b", "1000"]] });
  assert.deepEqual(shownTable({ mass: 2, size: [1, 2] }, { mass: "kg", size: "m" }), { header: [], rows: [["mass", "2 kg"], ["size", "[1000, 2000] mm"]] });
  // What has other units in one column, or none, or is missing.
  assert.deepEqual(shownTable([[1, 1], [1, null]], [["m", "rad"], ["kg", ""]], ["x", "y"]).rows, [["1000 mm", "57.296"], ["1 kg", "–"]]);
  assert.deepEqual(shownTable([[1, 2], [3, 4]], "", ["x", "y"]), { header: ["x", "y"], rows: [["1", "2"], ["3", "4"]] });
  assert.deepEqual(shownTable([1], undefined), { header: [], rows: [["1"]] });
  assert.deepEqual(shownTable(undefined, undefined, ["x"]), { header: ["x"], rows: [] });
});

test("numbers of one cell that have several units have each its own", () => {
  const { header, rows } = shownTable([{ w: [Math.PI, 0.5], n: 2 }], [{ w: ["rad/s", "m/s"], n: "" }]);
  assert.deepEqual(header, ["w", "n"]);
  assert.deepEqual(rows, [["[180 deg/s, 500 mm/s]", "2"]]);
});

test("what is zero when it is rounded has no sign", () => {
  assert.deepEqual([fixed(-0.004, 2), fixed(-0, 1), fixed(-0.006, 2), fixed(12.34, 1)], ["0.00", "0.0", "-0.01", "12.3"]);
});

test("pictures come back as they were written", () => {
  const next = sequence(29);
  const colors = Array.from({ length: 200 }, () => [next(), next(), next()].map((v) => Math.round(127.5 * (v + 1))));
  const rgb = Buffer.from(Array.from({ length: 31 * 17 }, (_, i) => colors[(i * i) % 200]).flat());
  assert.deepEqual(readPng(smallPng(31, 17, rgb)), { width: 31, height: 17, data: rgb });
  assert.throws(() => readPng(Buffer.concat([smallPng(1, 1, Buffer.from([1, 2, 3])).fill(16, 24, 25)])));
});

test("positions are written as programs write them", () => {
  assert.equal(positionText([Math.PI / 6, -0.0505, -Math.PI / 2], ["rad", "m", "rad"]), "posJ(30deg, -50.5mm, -90deg)");
  const half = Math.SQRT1_2;
  assert.equal(poseText([0.3, -0.12, 0.4, half, 0, 0, half]), "pose(x: 300mm, y: -120mm, z: 400mm, roll: 0deg, pitch: 0deg, yaw: 90deg)");
});

test("names are found where they are declared, then as texts, then anywhere but in comments", () => {
  const text = "// object cube was here\nlet rodent = 1\nobject cube { shape: box(1mm, 1mm, 1mm) }\ninsertObj(\"rod\")\nlab cell {\n    plot q(fn() => 1)\n    field q2(1)\n}\narm.moveJ(q)\n";
  const at = (name, kinds) => {
    const place = placeOfName(text, name, kinds);
    return place === null ? null : text.slice(text.lastIndexOf("\n", place) + 1, place + name.length);
  };
  assert.equal(at("cube", "object|robot"), "object cube");
  assert.equal(at("rod", "object|robot"), 'insertObj("rod');
  assert.equal(at("q", "plot"), "    plot q");
  assert.equal(at("arm", "object|robot"), "arm");
  assert.equal(at("was", "object|robot"), null);
  assert.equal(at("a(b", "object"), null);
});

test("fingers close on what is held, over a moment before the grasp and after the release", () => {
  const along = [0, 1, 0];
  const pose = [0, 0, 0, 1, 0, 0, 0];
  const turned = [0, 0, 0, Math.SQRT1_2, 0, 0, Math.SQRT1_2]; // a quarter about z
  const near = (value, wanted) => assert.ok(Math.abs(value - wanted) < 1e-12, `${value} is not ${wanted}`);
  const box = { shape: "box", size: [0.03, 0.05, 0.2] };
  near(extent(box, pose, along), 0.05);
  near(extent(box, turned, along), 0.03);
  near(extent({ shape: "cylinder", size: [0.02, 0.1] }, pose, along), 0.04);
  near(extent({ shape: "cylinder", size: [0.02, 0.1] }, [0, 0, 0, Math.SQRT1_2, Math.SQRT1_2, 0, 0], along), 0.1);
  near(extent({ shape: "sphere", size: [0.02] }, turned, along), 0.04);
  const run = { events: [
    { t: 0, what: "added", object: 0, robot: null },
    { t: 2, what: "attached", object: 0, robot: 1 },
    { t: 5, what: "detached", object: 0, robot: 1 },
  ] };
  assert.equal(grasped(run, 1, 1), null);
  near(grasped(run, 1, 1.925).closed, 0.5);
  assert.deepEqual(grasped(run, 1, 2), { object: 0, closed: 1 });
  assert.deepEqual(grasped(run, 1, 4.9), { object: 0, closed: 1 });
  near(grasped(run, 1, 5.075).closed, 0.5);
  assert.equal(grasped(run, 1, 6), null);
  assert.equal(grasped(run, 0, 3), null);
});

// The distance of p from the straight piece from a to b.
function away(p, a, b) {
  const d = b.map((v, k) => v - a[k]);
  const length = Math.hypot(...d) ** 2;
  const s = length > 0 ? Math.min(1, Math.max(0, p.reduce((sum, v, k) => sum + (v - a[k]) * d[k], 0) / length)) : 0;
  return Math.hypot(...p.map((v, k) => v - a[k] - s * d[k]));
}

test("a line of fewer points goes nowhere farther from the whole one than it may", () => {
  const next = sequence(23);
  for (let k = 0; k < 60; k++) {
    const dimensions = 3 + (k % 2);
    const walk = [Array.from({ length: dimensions }, next)];
    // Some stand still, some go back on themselves.
    for (let i = 0; i < 300; i++) walk.push(walk.at(-1).map((v, c) => v + (k % 3 === 0 && i % 50 < 20 ? 0 : 0.05 * Math.sin(i / 9 + c + k) + 0.004 * next())));
    const tolerance = 0.002 * (1 + k % 5);
    const needed = neededPoints(walk, tolerance);
    assert.deepEqual([needed[0], needed.at(-1)], [0, walk.length - 1]);
    for (let j = 1; j < needed.length; j++) {
      assert.ok(needed[j] > needed[j - 1]);
      for (let i = needed[j - 1]; i <= needed[j]; i++) assert.ok(away(walk[i], walk[needed[j - 1]], walk[needed[j]]) <= tolerance * (1 + 1e-12));
    }
  }
  const straight = Array.from({ length: 6000 }, (_, i) => [0.001 * i, 0.002 * i, 0]);
  assert.deepEqual(neededPoints(straight, 1e-6), [0, 5999]);
  assert.deepEqual(neededPoints([[1, 2]], 1), [0]);
  assert.deepEqual(neededPoints([], 1), []);
});

test("the page has at most 420 kB by brotli, without the fonts of formulas", () => {
  const page = readFileSync(join(root, "apps/lab/page/dist/index.html"), "utf8").replace(/url\(data:font[^)]*\)/g, "");
  const { length } = brotliCompressSync(page);
  assert.ok(length < 420e3, `${length} bytes`);
});

test("an object goes behind the last one, whatever stands in braces, texts and remarks", () => {
  const at = (text) => text.slice(0, placeForObject(text));
  assert.equal(at(""), "");
  assert.equal(at("// a remark\n\nprint(1)\n"), "// a remark\n");
  assert.equal(at('import "a.rbt"\nprint(1)\n'), 'import "a.rbt"\n');
  const robot = "robot arm {\n    joint revolute(a: 1m) // }\n}\n";
  assert.equal(at(`${robot}arm.moveJ(q)\n`), robot);
  const objects = `${robot}object a {\n    shape: box(1mm, 1mm, 1mm)\n    at: xyz() /* } \nobject */ }\nobject b { shape: mesh("}.glb") }\n`;
  assert.equal(at(`${objects}fn f() {\nobject c { }\n}\n`), objects);
  assert.equal(at(`${objects}// object d\n`), objects);
  assert.equal(at("object a { shape: box(1mm, 1mm, 1mm) }"), "object a { shape: box(1mm, 1mm, 1mm) }");
});

test("an object has a name that is free and can be written", () => {
  assert.equal(nameForObject("My-Part.glb", "", []), "my_Part");
  assert.equal(nameForObject("part.glb", "object part { }\nlet part2 = 1", ["part3"]), "part4");
  assert.equal(nameForObject("7 up.glb", "", []), "thing_7_up");
  assert.equal(nameForObject("\u00e4.glb", "", []), "thing");
  assert.equal(nameForObject("if.glb", "", ["if"]), "if2");
  assert.equal(objectText("a", "a.glb", [0.1234567, -0.00001, 0.05]), 'object a { shape: mesh("a.glb"); at: xyz(123.5mm, 0mm, 50mm) }\n');
});

test("bytes come back from their digits to the base 85", () => {
  for (let size = 0; size < 70; size++) {
    const bytes = Uint8Array.from({ length: size }, (_, i) => (i * 151 + size * 89) & 255);
    const text = toBase85(bytes);
    assert.ok(!/[<=]/.test(text));
    assert.deepEqual(fromBase85(text), bytes);
  }
});

test("a position is a value in brackets and behind equals signs, otherwise a statement", () => {
  const at = (text) => wantsValue(text.replace("|", ""), text.indexOf("|"));
  for (const text of ["moveL(|", "let p = |", "f(a, |)", "let ps = [|", "return |", "f(fn() => g(|", "if (a) { moveL(|) }"]) assert.ok(at(text), text);
  for (const text of ["|", "|// a", "// f(|", "/* ( */ |", 'print("(") |', "if (a) {|", "moveL(a)|", 'print("a|")', "f(a)\n|"]) assert.ok(!at(text), text);
});

test("a statement ends where its brackets are closed", () => {
  const text = "// f(\nlet a = f(\n    1, // )\n    2)\nif (a) {\n    g()\n}\nend()";
  const behind = (line) => text.slice(behindStatement(text, line).at);
  assert.equal(behind(2), "if (a) {\n    g()\n}\nend()");
  assert.equal(behind(5), "end()");
  assert.equal(behind(6), "}\nend()");
  assert.equal(behindStatement(text, 6).indent, "    ");
  assert.equal(behind(8), "");
  assert.equal(behind(null), "");
});

test("the setting at the cursor is the one whose argument it is in, also before its name", () => {
  const at = (text) => settingAt(text.replace("|", ""), text.indexOf("|"));
  assert.equal(at("moveL(p, |speed: 100mm/s)"), "speed");
  assert.equal(at("moveL(p, speed: 1|00mm/s)"), "speed");
  assert.equal(at("moveL(p,| time: 1s, speed: 2)"), "time");
  assert.equal(at("moveL(|p, speed: 2)"), null);
  assert.equal(at("moveL(f(a: 1), |b)"), null);
  assert.equal(at("moveL(f(1, |b: 2), c: 3)"), "b");
});

test("a field gets another value at the start, written with its unit", () => {
  const text = '// field load(1kg)\nlab a {\n    field load(0.5kg, range: [0kg, 5kg])\n    field n(3)\n    field on(true, label: "on, or not")\n    field name("a, b")\n}\n';
  const written = (element, value) => {
    const change = fieldChange(text, element, value);
    return change && text.slice(0, change.from) + change.insert + text.slice(change.to);
  };
  assert.equal(written({ kind: "field", name: "load", unit: "kg", factor: 1 }, 2), text.replace("(0.5kg", "(2kg"));
  assert.equal(written({ kind: "field", name: "load", unit: "g", factor: 1e-3 }, 0.25), text.replace("(0.5kg", "(250g"));
  assert.equal(written({ kind: "field", name: "n", type: "int" }, 7), text.replace("n(3)", "n(7)"));
  assert.equal(written({ kind: "field", name: "on" }, false), text.replace("(true", "(false"));
  assert.equal(written({ kind: "field", name: "name" }, 'c"d'), text.replace('"a, b"', '"c\\"d"'));
  assert.equal(written({ kind: "field", name: "none" }, 1), null);
});

test("the status counts moves and collisions; only a run without mistakes and advice is good", () => {
  const state = initialState();
  state.connection = "open";
  const run = new Run(1);
  Object.assign(run, { state: "done", tEnd: 3, described: true });
  run.moves.push(...["moveJ", "moveL", ""].map((text) => ({ robot: 0, t0: 0, t1: 1, text })));
  state.runs.set(1, run);
  state.shown = 1;
  const told = () => statusOf(state, true);
  assert.deepEqual(told(), ["2 moves, 3.00 s", "good"]);
  const collision = (line, message) => ({ severity: "advice", code: "W0711", message, t: 1, span: [line, 0, line, 5] });
  run.advice.push(collision(2, "a"), collision(2, "a"), collision(3, "b"));
  assert.deepEqual(told(), ["2 moves, 3.00 s, 3 collisions", "advice"]);
  run.advice.push({ severity: "advice", code: "W0707", message: "c", t: 1 });
  assert.deepEqual(told(), ["2 moves, 3.00 s, 3 collisions, advice: 1", "advice"]);
  run.advice = [];
  state.diagnostics = [{ severity: "advice", code: "W0709", message: "never used" }];
  state.diagnosedVersion = 0;
  assert.deepEqual(told(), ["2 moves, 3.00 s, advice: 1", "advice"]);
  run.statements = [[0, 1], [3, 7]];
  run.state = "stopped";
  assert.deepEqual(told(), ["still running at line 7, stopped at 3.00 s", "advice"]);
  run.state = "running";
  run.advice = [];
  state.diagnostics = [];
  assert.deepEqual(told(), ["running at line 7, 3.0 s", "quiet"]);
  run.state = "failed";
  assert.deepEqual(told(), ["failed at 3.00 s", "error"]);
  state.diagnostics = [{ severity: "error", code: "E0201", message: "d" }];
  assert.deepEqual(told(), ["1 mistake: the last good run is shown", "error"]);
});
