// What the laboratory is sent while a person types, without a browser and with a clock of the test's own.
import assert from "node:assert/strict";
import test, { after, beforeEach } from "node:test";
import { source } from "./modules.mjs";

const { Intents } = await source("store/intents.ts");
const { Store } = await source("store/store.ts");
const { receive } = await source("store/receive.ts");

// ---- a clock: time passes only in pass()
const real = { setTimeout, clearTimeout, now: performance.now };
let now = 0;
let timers = [];
globalThis.setTimeout = (work, wait = 0) => {
  const timer = { work, at: now + wait };
  timers.push(timer);
  return timer;
};
globalThis.clearTimeout = (timer) => (timers = timers.filter((each) => each !== timer));
Object.defineProperty(performance, "now", { value: () => now, configurable: true, writable: true }); // read-only in Node 18
function pass(ms) {
  const end = now + ms;
  for (;;) {
    const next = timers.filter((each) => each.at <= end).sort((a, b) => a.at - b.at)[0];
    if (!next) break;
    timers = timers.filter((each) => each !== next);
    now = Math.max(now, next.at);
    next.work();
  }
  now = end;
}
beforeEach(() => {
  now = 1000;
  timers = [];
});
after(() => {
  Object.assign(globalThis, { setTimeout: real.setTimeout, clearTimeout: real.clearTimeout });
  performance.now = real.now;
});

// A page in control of a laboratory that answers on request.
function typing() {
  const store = new Store((work) => work());
  const sent = [];
  const intents = new Intents(store, { send: (message) => sent.push({ ...message, at: now }), ask: () => Promise.reject(new Error("nobody")) }, true);
  const hear = (message) => {
    store.change((s) => receive(s, message));
    intents.heard(message);
  };
  hear({ type: "welcome", protocol: 1, page: 1, file: "a.rbt", text: "a", text_version: 1 });
  hear({ type: "control", holder: 1, pages: [1] });
  sent.length = 0;
  const texts = () => sent.filter((each) => each.type === "text");
  return {
    texts, hear, intents,
    type: (text) => intents.typeText(text),
    // Diagnostics of the newest text that was sent, or of another version.
    answer: (version = texts().at(-1).version) => hear({ type: "diagnostics", text_version: version, runs: true, items: [] }),
  };
}

test("the first key is checked at once, and the text runs after a pause", () => {
  const { type, texts, answer } = typing();
  type("ab");
  assert.deepEqual(texts().map((each) => [each.text, each.run, each.at]), [["ab", false, 1000]]);
  answer();
  pass(149);
  assert.equal(texts().length, 1);
  pass(1);
  assert.deepEqual(texts().map((each) => [each.text, each.run ?? true, each.at]).at(-1), ["ab", true, 1150]);
  answer();
  pass(1000);
  assert.equal(texts().length, 2);
});

// The run of the newest text has ended.
function ended({ hear, texts }) {
  const { version } = texts().at(-1);
  hear({ type: "diagnostics", text_version: version, runs: true, items: [] });
  hear({ type: "run", run: version, state: "done", t_end: 1, text_version: version });
}

test("after a run of less than 50 ms the first key runs at once, and the text again after a pause", () => {
  const page = typing();
  const { type, texts } = page;
  const ran = () => texts().filter((each) => each.run ?? true).map((each) => [each.text, each.at]);
  type("ab");
  pass(150);
  pass(40);
  ended(page);
  pass(1000);
  const at = now;
  type("abc");
  assert.deepEqual(ran().at(-1), ["abc", at]);
  pass(10);
  ended(page);
  pass(30);
  type("abcd"); // a key that follows soon
  pass(100);
  assert.deepEqual(ran().at(-1), ["abc", at]);
  pass(50);
  assert.deepEqual(ran().at(-1), ["abcd", at + 190]);
  // All of it is one change.
  const changes = texts().filter((each) => each.change).map((each) => each.change);
  assert.equal(changes.at(-1), changes.at(-2));
  assert.notEqual(changes.at(-1), changes[0]);
});

test("after a slow run the first key is only checked", () => {
  const page = typing();
  const { type, texts } = page;
  type("ab");
  pass(150);
  pass(80);
  ended(page);
  pass(1000);
  type("abc");
  assert.equal(texts().at(-1).run, false);
});

test("all texts of one number that is pulled are one change, those of another number another one", () => {
  const page = typing();
  const changes = [];
  for (const [text, place] of [["a1", 1], ["a2", 1], ["a3", 1], ["b3", 7]]) {
    page.intents.pullText(text, place);
    changes.push(page.texts().at(-1).change);
    ended(page);
  }
  assert.equal(new Set(changes.slice(0, 3)).size, 1);
  assert.notEqual(changes[3], changes[2]);
});

test("of keys that follow soon only the last text is checked, 30 ms after the check before", () => {
  const { type, texts, answer } = typing();
  for (const text of ["ab", "abc", "abcd"]) {
    type(text);
    pass(5);
    if (text === "ab") answer();
  }
  pass(14);
  assert.equal(texts().length, 1);
  pass(1);
  assert.deepEqual(texts().map((each) => [each.text, each.at]), [["ab", 1000], ["abcd", 1030]]);
});

test("there is one check at a time: the next one goes when the one before it is answered", () => {
  const { type, texts, answer } = typing();
  type("ab");
  pass(40);
  type("abc");
  pass(40);
  type("abcd");
  assert.equal(texts().length, 1);
  answer(texts()[0].version - 1); // of an older text
  assert.equal(texts().length, 1);
  answer();
  assert.deepEqual(texts().map((each) => each.text), ["ab", "abcd"]);
  answer();
  assert.equal(texts().length, 2);
});

test("a text that was undone before its check is not sent again", () => {
  const { type, texts, answer } = typing();
  type("ab");
  pass(10);
  type("abc");
  type("ab");
  answer();
  pass(30);
  assert.deepEqual(texts().map((each) => each.text), ["ab"]);
  pass(150);
  assert.deepEqual(texts().map((each) => [each.text, each.run ?? true]), [["ab", false], ["ab", true]]);
});

test("a check that was lost with the connection holds up none", () => {
  const { type, texts, hear } = typing();
  type("ab");
  hear({ type: "welcome", protocol: 1, page: 2, file: "a.rbt", text: "a", text_version: 1 });
  hear({ type: "control", holder: 2, pages: [2] });
  assert.deepEqual(texts().map((each) => [each.text, each.run ?? true]), [["ab", false], ["ab", true]]);
  hear({ type: "diagnostics", text_version: texts().at(-1).version, runs: true, items: [] });
  pass(40);
  type("abc");
  assert.equal(texts().at(-1).text, "abc");
  assert.equal(texts().at(-1).at, now);
});
