// Measures in a browser what docs/performance.md says of the page: how soon mistakes, paths and pictures are there.
import { closeBrowser, typeAtEnd, untilStatus, serve } from "./laboratory.mjs";

// A program of 60 simulated seconds in about a thousand lines.
function longProgram() {
  const moves = Array.from({ length: 30 }, (_, k) => `arm.moveJ(posJ(${20 * (k % 3)}deg, ${60 - 10 * (k % 5)}deg, ${10 + k}mm, 0deg), time: 2s)`);
  const lines = Array.from({ length: 970 }, (_, k) => `let a${k} = ${k} * 1mm + 2mm`);
  return `robot arm = robots.scara()\n${lines.join("\n")}\n${moves.join("\n")}\n`;
}

const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];

// Milliseconds from the key to the first answer of one type that is about the newest text.
async function keyTo(page, type, key, back) {
  const times = [];
  for (let k = 0; k < 9; k++) {
    await page.evaluate((wanted) => {
      globalThis.answered = new Promise((resolve) => (globalThis.whenAnswered = { type: wanted, resolve }));
      addEventListener("keydown", () => (globalThis.keyAt = performance.now()), { once: true, capture: true });
    }, type);
    await page.keyboard.press(k % 2 ? back : key);
    times.push(await page.evaluate(() => globalThis.answered.then((at) => at - globalThis.keyAt)));
    await page.waitForTimeout(600);
  }
  return median(times);
}

const lab = await serve(longProgram());
try {
  const started = Date.now();
  const page = await lab.open({
    before: (fresh) => fresh.addInitScript(() => {
      const Original = WebSocket;
      globalThis.WebSocket = class extends Original {
        constructor(...given) {
          super(...given);
          this.addEventListener("message", (event) => {
            if (typeof event.data !== "string" || !globalThis.whenAnswered) return;
            const { type, resolve } = globalThis.whenAnswered;
            const message = JSON.parse(event.data);
            if (message.type === type && (type !== "run" || message.state === "done")) requestAnimationFrame(() => resolve(performance.now()));
          });
        }
      };
    }),
  });
  await untilStatus(page, /60\.00 s/);
  console.log(`open to interactive: ${Date.now() - started} ms`);
  await typeAtEnd(page, "// ");
  await untilStatus(page, /60\.00 s/);
  console.log(`key to diagnostics, 1,000 lines: ${(await keyTo(page, "diagnostics", "x", "Backspace")).toFixed(0)} ms`);
  console.log(`key to the end of a run of 60 s (150 ms of it are the pause): ${(await keyTo(page, "run", "x", "Backspace")).toFixed(0)} ms`);
  const frames = await page.evaluate(async () => {
    const bar = document.querySelector(".bar");
    const box = bar.getBoundingClientRect();
    const times = [];
    const event = (type, s) => bar.dispatchEvent(new PointerEvent(type, { clientX: box.x + 76 + s * (box.width - 90), clientY: box.y + 40, pointerId: 1, bubbles: true }));
    bar.setPointerCapture = () => {};
    event("pointerdown", 0);
    for (let k = 0; k < 60; k++) {
      const begun = performance.now();
      event("pointermove", k / 60);
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      times.push(performance.now() - begun);
    }
    event("pointerup", 1);
    return times;
  });
  console.log(`drag of the bar of time to the next frame: ${median(frames).toFixed(0)} ms`);
  await page.context().close();
} finally {
  lab.close();
  await closeBrowser();
}
