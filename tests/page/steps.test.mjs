// What the laboratory is asked when a person goes to an instant and steps from there.
import assert from "node:assert/strict";
import test from "node:test";
import { source } from "./modules.mjs";

const { Intents } = await source("store/intents.ts");
const { Store } = await source("store/store.ts");
const { receive } = await source("store/receive.ts");

// A page in control of a run of 5 s. Questions wait until they are answered.
function stepping() {
  const store = new Store((work) => work());
  const asked = [];
  const ask = (message) => new Promise((resolve) => asked.push({ ...message, resolve }));
  const intents = new Intents(store, { send() {}, ask }, true);
  const hear = (message) => {
    store.change((s) => receive(s, message));
    intents.heard(message);
  };
  hear({ type: "welcome", protocol: 1, page: 1, file: "a.rbt", text: "a", text_version: 1 });
  hear({ type: "control", holder: 1, pages: [1] });
  hear({ type: "run", run: 1, state: "done", t_end: 5, text_version: 1 });
  hear({ type: "description", run: 1, robots: [], objects: [], elements: [] });
  hear({ type: "shown", run: 1 });
  const rest = () => new Promise((resolve) => setImmediate(resolve));
  return {
    intents, rest,
    state: store.state,
    asked: () => asked.map(({ type, t, how }) => (type === "goto" ? `goto ${t}` : `step ${how}`)),
    // Answers the oldest question that has none.
    async answer(t) {
      const question = asked.find((each) => !each.answered);
      question.answered = true;
      const instant = { type: "instant", run: 1, t, line: 1, variables: [], cursor: true, to: 1 };
      hear(instant);
      question.resolve(instant);
      await rest();
    },
  };
}

test("after a step the start is asked for again, and the next step comes behind it", async () => {
  const { intents, asked, answer, state } = stepping();
  await answer(5);
  intents.goTo(0);
  await answer(0);
  void intents.step("over");
  await answer(2);
  intents.goTo(0);
  await answer(0);
  void intents.step("over");
  await answer(2);
  assert.deepEqual(asked(), ["goto 5", "goto 0", "step over", "goto 0", "step over"]);
  assert.equal(state.t, 2);
});

test("a step without a pause is asked behind the instant that it begins at", async () => {
  const { intents, asked, answer, state } = stepping();
  intents.goTo(1); // while the first question has no answer
  void intents.step("over");
  assert.deepEqual(asked(), ["goto 5", "goto 1", "step over"]);
  await answer(5);
  await answer(1);
  await answer(3);
  assert.equal(state.t, 3);
});

test("who goes on during a step stays there", async () => {
  const { intents, asked, answer, state } = stepping();
  await answer(5);
  intents.goTo(0);
  await answer(0);
  void intents.step("over");
  intents.goTo(4);
  await answer(2);
  assert.equal(state.t, 4);
  assert.equal(asked().at(-1), "goto 4");
});

test("the same instant is asked for again after statements that last no time", async () => {
  const { intents, asked, answer } = stepping();
  await answer(5);
  intents.goTo(0);
  await answer(0);
  void intents.step("back");
  await answer(0);
  intents.goTo(0);
  assert.deepEqual(asked(), ["goto 5", "goto 0", "step back", "goto 0"]);
});

test("several steps in a row go on from each other", async () => {
  const { intents, asked, answer, state } = stepping();
  await answer(5);
  intents.goTo(0);
  await answer(0);
  for (let k = 0; k < 3; k++) void intents.step("over");
  for (const t of [1, 2, 3]) await answer(t);
  assert.deepEqual(asked(), ["goto 5", "goto 0", "step over", "step over", "step over"]);
  assert.equal(state.t, 3);
});
