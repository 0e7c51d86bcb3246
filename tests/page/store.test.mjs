// The store of the page without a browser: messages in, state out.
import assert from "node:assert/strict";
import test from "node:test";
import { source } from "./modules.mjs";

const { receive, receiveRows } = await source("store/receive.ts");
const { adviceOfRun, initialState, shownRun, isStale, currentLine } = await source("store/state.ts");
const { recordingOf } = await source("store/recording.ts");
const { firstText, reopen } = await source("alone/saved.ts");
const { pageWithLaboratory, pageWithRecording } = await source("home/source.ts");
const { readRows } = await source("protocol/rows.ts");
const { Store } = await source("store/store.ts");

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const at = (x, y, z) => [...IDENTITY.slice(0, 12), x, y, z, 1];
const joint = { unit: "rad", lower: -3, upper: 3, max_speed: 1, T_before_joint: IDENTITY, T_joint_link: at(1, 0, 0) };
const robot = { name: "arm", home: [0, 0], joints: [joint, joint], T_world_base: IDENTITY, tool: { kind: "none", stroke: 0, radius: 0, length: 0, T_flange_tool: IDENTITY }, shapes: [] };

const welcome = { type: "welcome", protocol: 1, page: 1, file: "a.rbt", text: "let a = 1\n", text_version: 3 };
const run = (number, more = {}) => ({ type: "run", run: number, state: "done", t_end: 2, label: "", parent: null, parts_at: null, text_version: 3, inputs: [], hash: "", error: null, ...more });
const description = (number) => ({ type: "description", run: number, robots: [robot], objects: [{ name: "cube", shape: "box", size: [1, 1, 1], color: "red", pose: [0, 0, 0, 1, 0, 0, 0] }], elements: [] });
const block = (kind, columns, first, rows) => ({ kind, run: 1, index: 0, columns, first, count: rows.length, rows: new Float64Array(rows.flat()) });
const sample = (t, q) => [t, q, -q, 0, 0, 0, 0, 2 * t, 0, 0, 1, 0, 0, 0];

function told(...messages) {
  const state = initialState();
  for (const message of messages) receive(state, message);
  return state;
}
const shown = (number, more) => [run(number, more), description(number), { type: "shown", run: number }];

test("a welcome gives the text, and the editor takes it", () => {
  const state = told(welcome);
  assert.equal(state.text, "let a = 1\n");
  assert.equal(state.textFrom, 1);
  assert.equal(state.connection, "open");
});

test("after a reconnection the newer text of the editor stays", () => {
  const state = told(welcome);
  state.text = "let a = 2\n";
  state.textVersion = 9;
  receive(state, { ...welcome, page: 2 });
  assert.equal(state.text, "let a = 2\n");
});

test("a run that is done is shown at its end", () => {
  const state = told(welcome, ...shown(1));
  assert.equal(shownRun(state).id, 1);
  assert.equal(state.t, 2);
});

test("a running run does not replace the one that is looked at until it has come as far", () => {
  const state = told(welcome, ...shown(1));
  state.t = 1;
  for (const message of shown(2, { state: "running", t_end: 0.5 })) receive(state, message);
  assert.equal(state.shown, 1);
  receive(state, run(2, { state: "running", t_end: 1.2 }));
  assert.equal(state.shown, 2);
  assert.equal(state.t, 1);
});

test("who looks at the end waits for the end of the next run, and goes along when a run goes on", () => {
  const state = told(welcome, ...shown(1));
  for (const message of shown(2, { state: "running", t_end: 5 })) receive(state, message);
  assert.equal(state.shown, 1);
  receive(state, run(2, { t_end: 7 }));
  assert.deepEqual([state.shown, state.t], [2, 7]);
  receive(state, run(2, { t_end: 8 }));
  assert.equal(state.t, 8);
});

test("who looks at the start stays there, also while the next run has only begun", () => {
  const state = told(welcome, ...shown(1));
  state.t = 0;
  for (const message of [run(2, { state: "running", t_end: 0 }), description(2), { type: "shown", run: 2 }]) receive(state, message);
  receive(state, run(2, { state: "running", t_end: 1 }));
  receive(state, run(2, { t_end: 3 }));
  assert.equal(state.shown, 2);
  assert.equal(state.t, 0);
  // The first run of a page is followed to its end.
  const first = told(welcome, run(1, { state: "running", t_end: 0 }), description(1), { type: "shown", run: 1 });
  receive(first, run(1, { t_end: 3 }));
  assert.equal(first.t, 3);
});

test("a shorter run takes the instant back to its end", () => {
  const state = told(welcome, ...shown(1));
  state.t = 1.5;
  for (const message of shown(2, { t_end: 1 })) receive(state, message);
  assert.equal(state.t, 1);
});

test("rows grow in place, may begin again, and leave no gap", () => {
  const state = told(welcome, ...shown(1));
  receiveRows(state, block(1, 14, 0, [sample(0, 0), sample(1, 1)]));
  receiveRows(state, block(1, 14, 5, [sample(9, 9)]));
  assert.equal(shownRun(state).tracks[0].count, 2);
  receiveRows(state, block(1, 14, 2, [sample(2, 0)]));
  assert.deepEqual(shownRun(state).qAt(0, 0.5), [0.5, -0.5]);
  assert.equal(shownRun(state).tracks[0].toolSpeed(0), 2);
  receiveRows(state, block(1, 14, 0, [sample(0, 4)]));
  assert.equal(shownRun(state).tracks[0].count, 1);
});

test("a robot without rows stands at its home, and the tool with it", () => {
  const state = told(welcome, ...shown(1));
  assert.deepEqual(shownRun(state).qAt(0, 1), [0, 0]);
  assert.deepEqual(shownRun(state).toolAt(0, 1).slice(0, 3), [2, 0, 0]);
});

test("what motors give is read between its rows, jumps where two have one time, and is a share where the most is known", () => {
  const state = told(welcome, ...shown(1));
  assert.equal(shownRun(state).forcesAt(0, 1), null);
  assert.deepEqual(shownRun(state).sharesAt(0, 1), []);
  const [first, second] = [{ ...joint, max_force: 20 }, { ...joint, max_force: null }];
  receive(state, { ...description(1), robots: [{ ...robot, joints: [first, second] }] });
  receiveRows(state, block(4, 3, 0, [[0, 2, 1], [1, 4, 1], [1, 10, 7], [2, 10, 7]]));
  const one = shownRun(state);
  assert.deepEqual(one.forcesAt(0, 0.5), [3, 1]);
  assert.deepEqual(one.forcesAt(0, 1), [10, 7]);
  assert.deepEqual(one.forcesAt(0, 9), [10, 7]);
  assert.deepEqual(one.sharesAt(0, 1.5), [0.5, null]);
  assert.equal(one.forcesAt(1, 1), null);
});

test("an object is there from its appearance to its removal, and who holds it is known", () => {
  const state = told(welcome, ...shown(1));
  const items = [["added", 0.5, null], ["attached", 1, 0], ["detached", 1.5, null], ["removed", 1.8, null]].map(([what, t, r]) => ({ t, what, object: 0, robot: r }));
  receive(state, { type: "objects", run: 1, first: 0, items });
  receiveRows(state, block(2, 8, 0, [[1, 0, 0, 0, 1, 0, 0, 0], [1.5, 1, 0, 0, 1, 0, 0, 0]]));
  const now = shownRun(state);
  assert.equal(now.objectAt(0, 0.2), null);
  assert.equal(now.objectAt(0, 1.25)[0], 0.5);
  assert.equal(now.objectAt(0, 1.9), null);
  assert.deepEqual([now.holderAt(0, 0.7), now.holderAt(0, 1.2), now.holderAt(0, 1.6)], [null, 0, null]);
});

test("the cursor of another page moves the instant; an answer to an own question does not take it back", () => {
  const state = told(welcome, ...shown(1));
  const instant = { type: "instant", run: 1, t: 0.5, cursor: true, line: 2, variables: [] };
  // The laboratory counts in nanoseconds: its answer may be about another t than the question.
  receive(state, { ...instant, t: 0.5000000004, to: 7 });
  assert.equal(state.t, 2);
  assert.equal(state.instant.t, 0.5000000004);
  receive(state, { ...instant, to: null });
  assert.equal(state.t, 0.5);
});

test("lines and moves answer for instants and for lines", () => {
  const state = told(welcome, ...shown(1));
  receive(state, { type: "statements", run: 1, first: 0, items: [[0, 3], [1, 4]] });
  receive(state, { type: "moves", run: 1, first: 0, items: [{ robot: 0, span: [3, 0, 3, 9], t0: 0, t1: 1, text: "moveJ" }, { robot: 0, span: [4, 0, 4, 9], t0: 1, t1: 2, text: "moveL" }] });
  state.t = 0.5;
  assert.equal(currentLine(state), 3);
  assert.deepEqual(shownRun(state).movesOfLine(4).map((m) => m.text), ["moveL"]);
  assert.deepEqual(shownRun(state).stops(), [0, 1, 2]);
  receive(state, { type: "instant", run: 1, t: 0.5, line: 7, variables: [] });
  assert.equal(currentLine(state), 7);
});

test("a text with mistakes leaves the last good run, as one that is stale", () => {
  const state = told(welcome, ...shown(1), { type: "diagnostics", text_version: 4, runs: false, items: [{ severity: "error", code: "E0101", message: "no", span: [1, 0, 1, 2] }] });
  assert.equal(state.shown, 1);
  assert.equal(isStale(state), true);
});

test("messages that are not known are left alone", () => {
  const state = told(welcome, { type: "weather", sun: true });
  assert.equal(state.connection, "open");
});

test("old runs are forgotten, the shown one never", () => {
  const state = told(welcome, ...shown(1));
  for (let k = 2; k < 200; k++) receive(state, run(k));
  assert.ok(state.runs.has(1));
  assert.ok(state.runs.size <= 41);
});

test("views are called for what they look at, once for many changes", () => {
  let work = null;
  const store = new Store((w) => (work = w));
  const seen = [];
  store.watch((s) => [s.t], (s) => seen.push(s.t));
  work();
  store.change((s) => (s.speed = 2));
  work();
  store.change((s) => (s.t = 1));
  store.change((s) => (s.t = 2));
  work();
  assert.deepEqual(seen, [0, 2]);
});

test("a recorded run, sent again, is the same run", () => {
  const state = told(welcome, ...shown(1, { hash: "ab", label: "<first>" }));
  receive(state, { type: "objects", run: 1, first: 0, items: [{ t: 0.5, what: "added", object: 0, robot: null }] });
  receive(state, { type: "moves", run: 1, first: 0, items: [{ robot: 0, span: [3, 0, 3, 9], t0: 0, t1: 1, text: "moveJ" }] });
  receive(state, { type: "figures", run: 1, index: 0, title: "f", svg: "<svg/>" });
  receiveRows(state, block(1, 14, 0, [sample(0, 0), sample(1, 1)]));
  receiveRows(state, block(2, 8, 0, [[1, 0, 0, 0, 1, 0, 0, 0]]));
  receiveRows(state, block(3, 2, 0, [[1, Math.PI]]));
  receiveRows(state, block(4, 3, 0, [[0, 1, 2], [1, 3, 4]]));
  const recording = recordingOf(state, shownRun(state));
  const again = initialState();
  for (const message of recording) {
    if (message.binary) receiveRows(again, readRows(Uint8Array.from(atob(message.binary), (c) => c.charCodeAt(0)).buffer));
    else receive(again, JSON.parse(JSON.stringify(message)));
  }
  const [one, other] = [shownRun(state), shownRun(again)];
  for (const name of ["state", "tEnd", "hash", "label", "robots", "objects", "events", "moves", "figures", "forceRows"]) assert.deepEqual(other[name], one[name], name);
  assert.deepEqual(recordingOf(again, other), recording);
  assert.equal(again.text, state.text);
  const page = pageWithRecording('<body><div id="page"></div></body>', recording);
  assert.ok(!page.includes("<first>"));
});

test("a recording stands at instants that it knows, with the state there", async () => {
  const { looksOf, timesToLook } = await source("store/recording.ts");
  const { Intents } = await source("store/intents.ts");
  const { Store } = await source("store/store.ts");
  const store = new Store((work) => work());
  const { state } = store;
  for (const message of [welcome, ...shown(1)]) receive(state, message);
  const run = state.runs.get(1);
  const times = timesToLook(run);
  assert.equal(times[0], 0);
  assert.equal(times.at(-1), run.tEnd);
  assert.ok(run.moves.every((move) => times.includes(move.t0) && times.includes(move.t1)));
  const told = [0, 0.5, 2].map((t, i) => ({ type: "instant", to: i, run: 1, t, cursor: false, line: 3, variables: [{ scope: 0, name: "n", type: "int", value: String(i) }], values: { a: { value: 1 }, b: { value: i } } }));
  const looks = looksOf(told);
  assert.deepEqual(Object.keys(looks[1].values), ["b"]);
  assert.ok(!("line" in looks[1].instant), "what is as before is left out");
  receive(state, { type: "looks", run: 1, items: looks });
  const intents = new Intents(store, { send() {}, ask: () => Promise.reject(new Error("nobody is there")) }, false);
  for (const [asked, t, n] of [[0.2, 0, "0"], [0.3, 0.5, "1"], [1.2, 0.5, "1"], [1.3, 2, "2"], [99, 2, "2"], [-1, 0, "0"]]) {
    intents.goTo(asked);
    assert.equal(state.t, t);
    assert.equal(state.instant.variables[0].value, n);
    assert.equal(state.instant.line, 3);
    assert.deepEqual(run.values, { a: { value: 1 }, b: { value: Number(n) } });
  }
});

test("a page carries one laboratory or one recording, and a recording no engine", () => {
  const text = (page, id) => new RegExp(`id="${id}">([^<]*)<`).exec(page)?.[1];
  const bare = '<div id="page"></div><script type="text/plain" class="armlet-part" id="armlet-engine">AAAA</script><script type="text/plain" id="armlet-worker">a < b</script><script id="armlet-page">BBBB</script>';
  const first = pageWithLaboratory(bare, { text: "</script><b>", n: 1 });
  const second = pageWithLaboratory(first, { n: 2 });
  assert.deepEqual(JSON.parse(text(first, "armlet-laboratory")), { text: "</script><b>", n: 1 });
  assert.deepEqual(JSON.parse(text(second, "armlet-laboratory")), { n: 2 });
  assert.equal(second.match(/id="armlet-laboratory"/g).length, 1);
  const recorded = pageWithRecording(pageWithRecording(second, ["$&"]), ["$1"]);
  assert.deepEqual(JSON.parse(text(recorded, "armlet-recording")), ["$1"]);
  for (const id of ["armlet-engine", "armlet-worker", "armlet-laboratory"]) assert.ok(!recorded.includes(id), id);
  assert.ok(recorded.includes("BBBB"));
});

// A laboratory as reopen() sees it: a text makes a run, an input one that goes on with it.
function laboratoryOf(first, hashOf) {
  const runs = [];
  const told = [];
  const heard = [];
  let shown = 0;
  const add = (text, inputs) => {
    runs.push({ text, inputs });
    shown = runs.length;
    told.push({ type: "run", run: shown, state: "done", hash: hashOf(text, inputs) }, { type: "shown", run: shown });
  };
  add(first, []);
  return {
    runs, heard, now: () => runs[shown - 1],
    send: (message) => {
      heard.push(message.type);
      if (message.type === "text") add(message.text, []);
      if (message.type === "show") told.push({ type: "shown", run: (shown = message.run) });
      if (message.type === "input") add(runs[shown - 1].text, [...runs[shown - 1].inputs, { t: message.t, press: message.press }]);
    },
    settle: async () => told.splice(0),
  };
}

test("a laboratory that was saved has its runs again, each from the one most like it", async () => {
  const press = (t) => ({ t, press: "go" });
  const hashOf = (text, inputs) => `${text}${inputs.map((i) => i.t)}`;
  const run = (number, text, ...inputs) => ({ run: number, label: `run ${number}`, text, inputs, state: "done", hash: hashOf(text, inputs) });
  const saved = { text: "c!", shown: 7, runs: [run(1, "a"), run(4, "a", press(1)), run(5, "b"), run(7, "a", press(1), press(2)), run(8, "c")] };
  const laboratory = laboratoryOf(firstText(saved), hashOf);
  assert.deepEqual(await reopen(saved, laboratory), []);
  assert.deepEqual(laboratory.now(), { text: "a", inputs: [press(1), press(2)] });
  assert.deepEqual(laboratory.heard, ["hello", "input", "text", "show", "input", "text", "text", "show"]);
  const other = laboratoryOf("a", () => "another");
  assert.deepEqual(await reopen(saved, other), saved.runs.map((each) => each.label));
  const empty = laboratoryOf("wrong text", hashOf);
  assert.deepEqual(await reopen({ text: "wrong text", shown: 0, runs: [] }, empty), []);
  assert.deepEqual(empty.heard, ["hello"]);
});

test("advice of a run is there once for each line, with how often it came, and not while an older text is shown", () => {
  const advice = (t, line) => ({ severity: "advice", code: "W0711", message: "they collide", span: [line, 4, line, 9], t });
  const state = told(welcome, ...shown(1), { type: "advice", run: 1, first: 0, items: [advice(0, 3), advice(1, 4)] });
  receive(state, { type: "advice", run: 1, first: 2, items: [advice(2, 3)] });
  assert.deepEqual(adviceOfRun(state).map((each) => [each.span[0], each.t, each.times]), [[3, 0, 2], [4, 1, 1]]);
  receive(state, { type: "diagnostics", text_version: 4, runs: false, items: [{ severity: "error", code: "E0201", message: "no", span: [1, 0, 1, 1] }] });
  assert.deepEqual(adviceOfRun(state), []);
  receive(state, { type: "diagnostics", text_version: 5, runs: true, items: [] });
  assert.equal(recordingOf(state, shownRun(state)).find((each) => each.type === "advice").items.length, 3);
});
