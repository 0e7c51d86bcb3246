// A laboratory that runs, and pages of a browser on it.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { axeSource, chromium, root } from "./modules.mjs";
import { readPng } from "./small_png.mjs";

export const PATIENCE = Number(process.env.ARMLET_PATIENCE ?? 60_000); // ms: pictures are drawn by the processor, beside other tests
const FLAGS = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking",
  ...(process.env.ARMLET_PAGE ? ["--disable-features=LocalNetworkAccessChecks"] : [])];
const built = join(root, "apps/lab/page/dist/index.html");

let browser = null;
async function theBrowser() {
  browser ??= await chromium.launch({ executablePath: process.env.ARMLET_CHROMIUM ?? "/usr/bin/chromium", args: FLAGS });
  return browser;
}

// A page that remembers what its console said; `problems` must be empty at the end of a test.
export async function openPage(address, options = {}) {
  const context = await (await theBrowser()).newContext({ viewport: { width: 1200, height: 760 }, reducedMotion: "reduce", ...options });
  context.setDefaultTimeout(PATIENCE);
  const page = await context.newPage();
  page.problems = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && !/GPU stall|GL Driver/.test(message.text()) && page.problems.push(message.text()));
  page.on("pageerror", (error) => page.problems.push(error.stack ?? error.message));
  page.on("request", (request) => {
    const { protocol, host } = new URL(request.url());
    const own = ["data:", "blob:", "file:"].includes(protocol) || host === new URL(address).host;
    if (!own) page.problems.push(`asked for ${request.url()}`);
  });
  const other = process.env.ARMLET_PAGE; // a page just built, shown in place of the command's own
  if (other) await page.route((url) => url.pathname === "/", (route) => route.fulfill({ path: other, contentType: "text/html; charset=utf-8" }));
  await options.before?.(page);
  await page.goto(address, { timeout: PATIENCE });
  return page;
}

// Serves a program; `text` is written to a file, or the demo is shown, or the file `missing`, which does not exist. `files` lie beside it, by
// their names.
export async function serve(text = null, files = {}, missing = null) {
  const folder = mkdtempSync(join(tmpdir(), "armlet-lab-"));
  const file = join(folder, "program.rbt");
  if (text !== null) writeFileSync(file, text);
  for (const [name, bytes] of Object.entries(files)) writeFileSync(join(folder, name), bytes);
  const command = spawn(process.env.ARMLET_COMMAND, ["lab", ...(missing ? [join(folder, missing)] : text === null ? ["--demo"] : [file]), "--no-open", "--port", "0"], { stdio: ["ignore", "pipe", "pipe"] });
  let complaints = "";
  command.stderr.on("data", (data) => (complaints += data));
  const address = await new Promise((resolve, reject) => {
    createInterface({ input: command.stdout }).on("line", (line) => {
      const found = /http:\S+/.exec(line);
      if (found) resolve(found[0]);
    });
    command.on("exit", (code) => reject(new Error(`armlet lab ended with ${code}: ${complaints}`)));
  });
  return {
    address,
    folder,
    open: (options) => openPage(address, options),
    close() {
      command.removeAllListeners("exit");
      command.kill();
      rmSync(folder, { recursive: true, force: true });
    },
  };
}

// A page from a file, with a recording in it instead of a laboratory.
export function recordingFile(messages) {
  const file = join(mkdtempSync(join(tmpdir(), "armlet-recording-")), "recording.html");
  const json = JSON.stringify(messages).replaceAll("<", "\\u003c");
  writeFileSync(file, readFileSync(built, "utf8").replace('<div id="page"></div>', () => `<div id="page"></div><script type="application/json" id="armlet-recording">${json}</script>`));
  return `file://${file}`;
}

export async function closeBrowser() {
  await browser?.close();
  browser = null;
}

// Where a download was put.
export async function saved(download) {
  const file = join(mkdtempSync(join(tmpdir(), "armlet-recording-")), "saved.html");
  await download.saveAs(file);
  return file;
}

// Runs `work` with pages on a laboratory; afterwards no page may have complained.
export async function withLab(text, work, files = {}, missing = null) {
  const lab = await serve(text, files, missing);
  const pages = [];
  try {
    await work(async (options) => {
      const page = await lab.open(options);
      pages.push(page);
      return page;
    }, lab);
    for (const page of pages) assert.deepEqual(page.problems, []);
  } finally {
    for (const page of pages) await page.context().close();
    lab.close();
  }
}

// The pixels of the 3D view that have so much more of one colour than of the others: how many, and their middle, which is
// [NaN, NaN] without any. `is` is [0 red, 1 green, 2 blue; how much].
export async function spotLike(page, [channel, above]) {
  const { data, width } = readPng(await page.locator(".stage canvas").screenshot());
  const others = [0, 1, 2].filter((k) => k !== channel);
  let count = 0;
  const sum = [0, 0];
  for (let i = 0; i < data.length; i += 3) {
    if (data[i + channel] <= above + Math.max(data[i + others[0]], data[i + others[1]])) continue;
    count++;
    sum[0] += (i / 3) % width;
    sum[1] += Math.floor(i / 3 / width);
  }
  return { count, middle: sum.map((each) => each / count) };
}
export const pixelsLike = async (page, is) => (await spotLike(page, is)).count;
export const RED = [0, 70];
export const GREEN = [1, 70];
export const BLUE = [2, 70];

// Waits until the 3D view has at least so many pixels like `is`, and at most so many.
export async function shows(page, what, is, least, most = Infinity) {
  let count = 0;
  await until(async () => (count = await pixelsLike(page, is)) >= least && count <= most, () => `${count} pixels are ${what}, not ${least} to ${most}`);
}

// Looks at the instant after this share of the run, by a click on the time bar.
export async function goTo(page, share) {
  const bar = await page.locator(".bar").boundingBox();
  await page.mouse.click(bar.x + 64 + share * (bar.width - 72), bar.y + 40);
  await page.mouse.move(2, 2);
}

export const status = (page) => page.locator(".status");
export const clock = (page) => page.locator("output.time");

// Waits until the status line reads like `pattern`.
export async function untilStatus(page, pattern) {
  await until(async () => pattern.test(await status(page).innerText()), () => status(page).innerText().then((text) => `the status reads "${text}", not ${pattern}`));
}

export async function until(holds, otherwise) {
  const end = Date.now() + PATIENCE;
  while (!(await holds())) {
    if (Date.now() > end) assert.fail(await otherwise());
    await new Promise((resolve) => setTimeout(resolve, 60));
  }
}

export async function untilClock(page, pattern) {
  await until(async () => pattern.test(await clock(page).innerText()), async () => `the clock reads ${await clock(page).innerText()}, not ${pattern}`);
}

// A button over the 3D view; in a narrow one some are behind another.
export async function viewTool(page, name) {
  await page.locator(".scene-tools").waitFor();
  const button = page.locator(".scene-tools").getByRole("button", { name, exact: true });
  if (!(await button.isVisible())) await page.getByRole("button", { name: "More tools" }).click();
  return button;
}

export const lineOf = (page, text) => page.locator(".cm-line", { hasText: text }).first();

// Where a word of the program is on the screen.
export async function placeOf(page, line, word) {
  return lineOf(page, line).evaluate((element, wanted) => {
    element.scrollIntoView({ block: "nearest" });
    element.closest(".cm-scroller").scrollLeft = 0; // what is at its start lies behind the numbers of lines otherwise
    const walker = document.createTreeWalker(element, NodeFilter.SHOW_TEXT);
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      const at = node.data.indexOf(wanted);
      if (at < 0) continue;
      const range = document.createRange();
      range.setStart(node, at);
      range.setEnd(node, at + wanted.length);
      const box = range.getBoundingClientRect();
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    }
    throw new Error(`no ${wanted} in ${element.textContent}`);
  }, word);
}

// Programs of one move: of two seconds, and of one.
export const ARM = "robot arm = robots.scara()\n";
export const ONE_MOVE = `${ARM}arm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 2s)\n`;
export const SHORT_MOVE = "arm.moveJ(posJ(30deg, 30deg, 0mm, 0deg), time: 1s)\n";

// Drops files onto the view at once, by their names; each is its bytes, or how many zeros it has. `at`: shares of the view.
export async function dropFiles(page, files, at = [0.5, 0.75]) {
  await page.locator(".stage canvas").evaluate((canvas, [all, [x, y]]) => {
    const data = new DataTransfer();
    for (const [name, given] of all) data.items.add(new File([typeof given === "number" ? new Uint8Array(given) : Uint8Array.from(atob(given), (c) => c.charCodeAt(0))], name));
    const box = canvas.getBoundingClientRect();
    const options = { dataTransfer: data, bubbles: true, cancelable: true, clientX: box.x + x * box.width, clientY: box.y + y * box.height };
    canvas.dispatchEvent(new DragEvent("dragover", options));
    canvas.dispatchEvent(new DragEvent("drop", options));
  }, [Object.entries(files).map(([name, bytes]) => [name, typeof bytes === "number" ? bytes : bytes.toString("base64")]), at]);
}

// Puts text at the end of the program, as a person would.
export async function typeAtEnd(page, text) {
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+End");
  await page.keyboard.insertText(text);
}

// What accessibility tools complain about.
export async function violations(page) {
  await page.evaluate(axeSource());
  const found = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  return found.violations.map((v) => `${v.id}: ${v.nodes.slice(0, 3).map((n) => `${n.target.join(" ")} (${n.any[0]?.message ?? n.none[0]?.message ?? v.help})`).join("; ")}`);
}
