// Measures in a browser what docs/performance.md says of the page: how soon mistakes, paths and pictures are there. Served by the
// command, and as one file where there is an engine. Without a graphics processor pictures are drawn by the processor, so times
// of frames are measured with and without drawing.
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { closeBrowser, openPage, serve, typeAtEnd, untilStatus } from "./laboratory.mjs";
import { root } from "./modules.mjs";

// A program of 60 simulated seconds in about a thousand lines.
function longProgram() {
  const moves = Array.from({ length: 30 }, (_, k) => `arm.moveJ(posJ(${20 * (k % 3)}deg, ${60 - 10 * (k % 5)}deg, ${10 + k}mm, 0deg), time: 2s)`);
  const lines = Array.from({ length: 970 }, (_, k) => `let a${k} = ${k} * 1mm + 2mm`);
  return `robot arm = robots.scara()\n${lines.join("\n")}\n${moves.join("\n")}\n`;
}

// Three robots, fifty objects and twenty plots over 60 s.
function largeLaboratory() {
  const bases = ["", "base: xyz(1200mm, 0mm, 0mm)", "base: xyz(-1200mm, 0mm, 0mm)"];
  const robots = bases.map((at, k) => `robot arm${k} = robots.scara(${at})`);
  const objects = Array.from({ length: 50 }, (_, k) => `object thing${k} { shape: box(30mm, 30mm, 30mm); at: xyz(${-450 + 100 * (k % 10)}mm, ${-700 - 80 * Math.floor(k / 10)}mm, 15mm) }`);
  const plots = Array.from({ length: 20 }, (_, k) => `    plot p${k}(fn() => arm${k % 3}.joints())`);
  const moves = Array.from({ length: 30 }, (_, k) => `arm${k % 3}.moveJ(posJ(${30 * (k % 4)}deg, ${60 - 10 * (k % 5)}deg, ${10 + k}mm, 0deg), time: 2s)`);
  return `${robots.join("\n")}\n${objects.join("\n")}\nlab much {\n${plots.join("\n")}\n}\n${moves.join("\n")}\n`;
}

const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];
const ms = (value) => `${value.toFixed(0)} ms`;

// Reports to the page's own code when an answer of a type has come, whatever carries it.
const listening = (page) => page.addInitScript(() => {
  const heard = (data) => {
    if (typeof data !== "string" || !globalThis.whenAnswered) return;
    const { type, resolve } = globalThis.whenAnswered;
    const message = data[0] === "{" ? JSON.parse(data) : {};
    if (message.type !== type || (type === "run" && message.state !== "done")) return;
    globalThis.whenAnswered = null;
    requestAnimationFrame(() => setTimeout(() => resolve(performance.now()))); // behind the picture with it
  };
  for (const name of ["WebSocket", "Worker"]) {
    const Original = globalThis[name];
    globalThis[name] = class extends Original {
      constructor(...given) {
        super(...given);
        this.addEventListener("message", (event) => heard(event.data));
      }
    };
  }
});

// Milliseconds from the key to the first answer of one type that is about the newest text.
async function keyTo(page, type, key, back) {
  const times = [];
  for (let k = 0; k < 7; k++) {
    await page.evaluate((wanted) => {
      globalThis.answered = new Promise((resolve) => (globalThis.whenAnswered = { type: wanted, resolve }));
      addEventListener("keydown", () => (globalThis.keyAt = performance.now()), { once: true, capture: true });
    }, type);
    await page.keyboard.press(k % 2 ? back : key);
    times.push(await page.evaluate(() => globalThis.answered.then((at) => at - globalThis.keyAt)));
    await page.waitForTimeout(900);
  }
  return median(times);
}

// What the page does after each step of a drag over the time bar, and until its next picture is there.
async function drag(page) {
  const times = await page.evaluate(async () => {
    const bar = document.querySelector(".bar");
    const box = bar.getBoundingClientRect();
    bar.setPointerCapture = () => {};
    const event = (type, s) => bar.dispatchEvent(new PointerEvent(type, { clientX: box.x + 76 + s * (box.width - 90), clientY: box.y + 40, pointerId: 1, bubbles: true }));
    event("pointerdown", 0);
    const all = [];
    for (let k = 0; k < 15; k++) {
      const begun = performance.now();
      event("pointermove", k / 15);
      const handled = performance.now() - begun;
      const [worked, whole] = await new Promise((resolve) => requestAnimationFrame(() => {
        const frame = performance.now();
        // What was asked for before this runs before it, and the view draws in the frame after.
        requestAnimationFrame(() => setTimeout(() => resolve([performance.now() - frame, performance.now() - begun])));
      }));
      all.push({ handled, worked, whole });
    }
    event("pointerup", 1);
    return all;
  });
  return ["handled", "whole"].map((name) => median(times.map((each) => each[name])));
}

// Remembers when the run is there, painted and can be worked with, and when the view in space is drawn; ms from the navigation.
const noting = (page) => page.addInitScript(() => {
  const look = () => {
    const now = performance.now();
    if (/\d s$/.test(document.querySelector(".status")?.textContent ?? "")) globalThis.readyAt ??= now;
    if (document.querySelector("output.where")?.textContent) return requestAnimationFrame(() => (globalThis.drawnAt = performance.now()));
    requestAnimationFrame(look);
  };
  look();
});

async function measure(name, page) {
  await untilStatus(page, /60\.00 s/);
  await page.waitForFunction(() => globalThis.drawnAt);
  const [ready, drawn] = await page.evaluate(() => [globalThis.readyAt, globalThis.drawnAt]);
  console.log(`${name}: open to interactive ${ms(ready)}, to the view in space ${ms(drawn)}`);
  await page.waitForTimeout(2000);
  await typeAtEnd(page, "// ");
  await untilStatus(page, /60\.00 s/);
  console.log(`${name}: key to diagnostics, 1,000 lines: ${ms(await keyTo(page, "diagnostics", "x", "Backspace"))}`);
  console.log(`${name}: key to the path of 60 s: ${ms(await keyTo(page, "run", "x", "Backspace"))}, of which 150 ms are the pause in typing`);
}

async function ended(page) {
  await page.context().close();
}

const before = async (page) => {
  await noting(page);
  await listening(page);
};

const long = await serve(longProgram());
try {
  await ended(await long.open()); // the browser itself starts
  const page = await long.open({ before });
  await measure("served", page);
  await ended(page);
} finally {
  long.close();
}

const engine = join(root, "build/wasm/laboratory.html");
if (existsSync(engine)) {
  const folder = mkdtempSync(join(tmpdir(), "armlet-measure-"));
  writeFileSync(join(folder, "long.rbt"), longProgram());
  execFileSync(process.env.ARMLET_COMMAND, ["lab", "long.rbt", "--export", "long.html", "--engine", engine], { cwd: folder, stdio: "ignore" });
  const page = await openPage(`file://${join(folder, "long.html")}`, { before });
  await measure("one file", page);
  await ended(page);
  rmSync(folder, { recursive: true, force: true });
}

const large = await serve(largeLaboratory());
try {
  const page = await large.open();
  await untilStatus(page, /60\.00 s/);
  await page.waitForTimeout(2000);
  const [handled, whole] = await drag(page);
  console.log(`drag of the time bar, 3 robots, 50 objects, 20 plots: ${handled.toFixed(1)} ms of script, ${ms(whole)} to the picture, drawn as this machine can`);
  await ended(page);
} finally {
  large.close();
  await closeBrowser();
}
