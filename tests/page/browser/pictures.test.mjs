// The figures of the paper as laboratories look as in docs/images; ARMLET_UPDATE_DOCS=1 makes these pictures again.
import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import test, { after } from "node:test";
import { closeBrowser, clock, until, untilStatus, withLab } from "../laboratory.mjs";
import { root } from "../modules.mjs";
import { readPng, smallPng } from "../small_png.mjs";

after(closeBrowser);

// The programs with recorded inputs: the names of their files, and the folders of these.
const folders = new Map(["examples/figures", "examples/figures/cameras"].flatMap((folder) =>
  readdirSync(join(root, folder)).filter((name) => name.endsWith(".jsonl")).map((name) => [name.replace(".jsonl", ""), join(root, folder)])));
const names = [...folders.keys()];

// What people do there, but for what is only shown.
function inputsOf(name) {
  const lines = readFileSync(join(folders.get(name), `${name}.jsonl`), "utf8").split("\n").filter((line) => line.startsWith("{"));
  return lines.map((line) => JSON.parse(line)).filter((input) => !input.show);
}

// The messages of the page itself can be joined by others.
const joining = (page) => page.addInitScript(() => {
  const Original = WebSocket;
  globalThis.WebSocket = class extends Original {
    constructor(...given) {
      super(...given);
      globalThis.say = (message) => this.send(JSON.stringify(message));
      this.addEventListener("message", (event) => {
        if (typeof event.data !== "string") return;
        const message = JSON.parse(event.data);
        if (message.type === "taken") globalThis.taken = (globalThis.taken ?? 0) + 1;
        if (message.type === "error") globalThis.refused = message.message;
        if (message.type === "run") globalThis.runState = message.state;
        if (message.type === "instant") globalThis.seenAt = message.t;
      });
    }
  };
});

// Two pictures by their pixels: the mean difference, and the largest of a square of 16 pixels; 0 to 255.
function difference(one, other) {
  const [a, b] = [readPng(one), readPng(other)];
  if (a.width !== b.width || a.height !== b.height) return { mean: 255, most: 255 };
  let [sum, most] = [0, 0];
  for (let y = 0; y < a.height; y += 16) {
    for (let x = 0; x < a.width; x += 16) {
      let [square, count] = [0, 0];
      for (let v = y; v < Math.min(y + 16, a.height); v++) {
        for (let i = 3 * (v * a.width + x); i < 3 * (v * a.width + Math.min(x + 16, a.width)); i++, count++) square += Math.abs(a.data[i] - b.data[i]);
      }
      sum += square;
      most = Math.max(most, square / count);
    }
  }
  return { mean: sum / a.data.length, most };
}

assert.ok(names.length >= 11, `figures: ${names}`);
for (const name of names) {
  test(`${name} looks as its picture`, () =>
    withLab(readFileSync(join(folders.get(name), `${name}.rbt`), "utf8"), async (open) => {
      const page = await open({ viewport: { width: 1100, height: 700 }, colorScheme: "light", before: joining });
      await untilStatus(page, /\d s$/);
      let count = 0;
      for (const input of inputsOf(name)) {
        await page.evaluate((message) => globalThis.say({ type: "input", ...message }), input);
        const wanted = ++count;
        await until(async () => page.evaluate((n) => globalThis.taken === n && globalThis.runState === "done" || globalThis.refused, wanted), () => `an input was not taken: ${JSON.stringify(input)}`);
        assert.equal(await page.evaluate(() => globalThis.refused), undefined);
      }
      const hints = page.locator(".hint button:visible");
      while (await hints.count()) await hints.first().click();
      await until(async () => !/running/.test(await page.locator(".status").innerText()), () => "it runs for ever");
      const bar = await page.locator(".bar").boundingBox();
      const before = await clock(page).innerText();
      await page.mouse.click(bar.x + 0.47 * bar.width, bar.y + 40);
      if (!before.endsWith("/ 0.00 s")) await until(async () => (await clock(page).innerText()) !== before, () => `the clock stays at ${before}`);
      // The view is fitted again, because the scene has changed since its start.
      await page.getByRole("button", { name: "Fit", exact: true }).click();
      await page.mouse.move(2, 2);
      await page.evaluate(() => document.activeElement?.blur());
      // Values of elements at the instant come with it.
      const t = Number(/^[\d.]+/.exec(await clock(page).innerText())[0]);
      await until(async () => Math.abs((await page.evaluate(() => globalThis.seenAt)) - t) < 0.006, () => `there are no values for ${t} s`);
      await page.waitForTimeout(700);
      const file = join(root, `docs/images/${name.slice(0, 5)}.png`);
      if (process.env.ARMLET_UPDATE_DOCS) {
        const { width, height, data } = readPng(await page.screenshot());
        writeFileSync(file, smallPng(width, height, data));
      }
      assert.ok(existsSync(file), `${file} is missing`);
      // On a busy machine figures and the view may be drawn a little later.
      let mean = 255, most = 255;
      for (let k = 0; k < 5 && (mean >= 3 || most >= 60); ++k) {
        if (k > 0) await page.waitForTimeout(1000);
        ({ mean, most } = difference(await page.screenshot(), readFileSync(file)));
      }
      assert.ok(mean < 3 && most < 60, `the picture differs from ${file}: ${mean.toFixed(2)} in the mean, ${most.toFixed(0)} in a square (${await clock(page).innerText()})`);
    }));
}
