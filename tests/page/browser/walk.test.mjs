// Any sequence of steps, instants and changes of the program leads where it leads in a model of the program: line, instant and variables.
import assert from "node:assert/strict";
import test, { after } from "node:test";
import { closeBrowser, lineOf, until, untilStatus, withLab } from "../laboratory.mjs";

after(closeBrowser);

// Numbers that look random and are the same in each run.
function numbers(seed) {
  let state = seed;
  return (most) => {
    state = (1103515245 * state + 12345) % 2147483648;
    return Math.floor((state / 2147483648) * most);
  };
}

// A program of waits: the statement on line i + 2 counts and takes durations[i] tenths of a second.
const textOf = (durations) => `var k = 0\n${durations.map((d, i) => `k = ${i + 1}\nwait(${(d / 10).toFixed(1)}s)\n`).join("")}`;

class Model {
  constructor(durations) {
    this.durations = durations;
    this.goTo(Infinity);
  }
  // The statements of the text with the instant at which they begin: line, t, and k before them.
  statements() {
    const all = [{ line: 1, t: 0, k: null }];
    let t = 0;
    this.durations.forEach((d, i) => {
      all.push({ line: 2 * i + 2, t, k: i }, { line: 2 * i + 3, t, k: i + 1 });
      t = Math.round(10 * t + d) / 10;
    });
    return [...all, { line: null, t, k: this.durations.length }];
  }
  get end() {
    return this.statements().at(-1).t;
  }
  // To an instant: behind all statements that last no time and begin there.
  goTo(t) {
    this.t = Math.min(t, this.end);
    const all = this.statements();
    this.at = all.findLastIndex((each) => each.t <= this.t + 1e-9);
  }
  over() {
    if (this.at < this.statements().length - 1) this.at++;
    this.t = this.statements()[this.at].t;
  }
  back() {
    if (this.at > 0) this.at--;
    this.t = this.statements()[this.at].t;
  }
  change(i, d) {
    const atEnd = this.t >= this.end - 1e-9;
    this.durations[i] = d;
    this.goTo(atEnd ? Infinity : this.t);
  }
}

for (const seed of [11, 2026]) {
  test(`steps, instants and changes in any order lead where they should (${seed})`, () => {
    const next = numbers(seed);
    const model = new Model(Array.from({ length: 5 }, () => 5 + next(20)));
    return withLab(textOf(model.durations), async (open) => {
      const page = await open();
      await untilStatus(page, new RegExp(`^${model.end.toFixed(2)} s`.replace(".", "\\.")));
      await page.getByRole("tab", { name: "Variables" }).click();
      await page.locator("h1").click();
      const done = [];
      const agrees = async () => {
        const { line, k } = model.statements()[model.at];
        const wanted = JSON.stringify([model.t.toFixed(2), line ?? "end", k === null ? "–" : String(k)]);
        const seen = () => page.evaluate((ended) => JSON.stringify([
          document.querySelector("output.time").textContent.split(" ")[0],
          ended ? "end" : Number([...document.querySelectorAll(".cm-line")].findIndex((each) => each.classList.contains("line-current")) + 1),
          [...document.querySelectorAll(".variables tr")].find((row) => row.querySelector(".name")?.textContent === "k")?.querySelector(".value").textContent ?? "–",
        ]), line === null);
        await until(async () => (await seen()) === wanted, async () => `after ${done.join(", ")}: ${await seen()} is not ${wanted}`);
      };
      await agrees();
      for (let step = 0; step < 24; step++) {
        const kind = next(6);
        const stepped = /over|back/.test(done.at(-1) ?? "");
        if (kind === 0) {
          done.push("Home");
          await page.keyboard.press("Home");
          model.goTo(0);
        } else if (kind === 1 && stepped) {
          done.push("back");
          await page.keyboard.press("ArrowLeft");
          model.back();
        } else if (kind === 2) {
          const i = next(model.durations.length);
          const d = 5 + next(20);
          done.push(`wait ${i} takes ${d}`);
          await lineOf(page, `k = ${i + 1}`).click();
          await page.keyboard.press("ArrowDown");
          await page.keyboard.press("Home");
          await page.keyboard.press("Shift+End");
          await page.keyboard.type(`wait(${(d / 10).toFixed(1)}s`, { delay: 40 });
          model.change(i, d);
          await untilStatus(page, new RegExp(`^${model.end.toFixed(2)} s`.replace(".", "\\.")));
          await page.locator("h1").click();
        } else if (kind === 3) {
          done.push("End");
          await page.keyboard.press("End");
          model.goTo(Infinity);
        } else {
          done.push("over");
          await page.keyboard.press("ArrowRight");
          model.over();
        }
        // Sometimes a person is faster than the answers.
        if (kind === 2 || next(3) > 0) await agrees();
      }
      await agrees();
      assert.ok(done.length === 24);
    });
  });
}
