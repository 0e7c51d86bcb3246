// Windows of cameras: the picture at the instant of the time bar, what is marked in it, and the pyramid in the 3D view.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import test, { after } from "node:test";
import { ARM, closeBrowser, goTo, openPage, RED, recordingFile, shows, status, until, untilStatus, withLab } from "../laboratory.mjs";
import { root } from "../modules.mjs";

after(closeBrowser);

// Where pictures of these tests are put, to be looked at; nowhere without it.
const FOLDER = process.env.ARMLET_PAGE_PICTURES;
async function keep(page, name) {
  if (!FOLDER) return;
  mkdirSync(FOLDER, { recursive: true });
  await page.screenshot({ path: join(FOLDER, `${name}.png`) });
}

// A camera that looks down at a table; a red ball moves through its picture from left to right.
const BALL = `${ARM}camera eye { at: lookingAt(xyz(0mm, 400mm, 0mm), from: xyz(0mm, 300mm, 900mm)); size: [160, 120]; ground: false; light: "flat" }
object ball { shape: sphere(40mm); at: xyz(-150mm, 400mm, 40mm); color: "red"; fixed: true }
object tile { shape: box(120mm, 80mm, 5mm); at: xyz(60mm, 250mm, 2.5mm); color: "white"; fixed: true }
fn middle() -> matrix => eye.project([poseOf(ball).p])
lab cell {
    view window(of: eye, overlay: fn() => middle(), wanted: [130, 40;], label: "From above")
    view corners(of: eye, overlay: "truth")
    image other(fn() => gray(eye.capture()))
}
for (k in range(10)) { setPose(ball, xyz(-150mm + k * 30mm, 400mm, 40mm)); wait(200ms) }
`;

const element = (page, name) => page.locator(`.element.camera[aria-label="${name}"]`);

// The middle of the red pixels of a window, in pixels of its picture; null: there are none.
const redIn = (page, name) => element(page, name).locator("canvas").evaluate((canvas) => {
  const { data, width, height } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  let [count, x, y] = [0, 0, 0];
  for (let i = 0; i < width * height; i++) {
    if (data[4 * i] < 120 || data[4 * i + 1] > 60) continue;
    count++;
    x += i % width;
    y += Math.floor(i / width);
  }
  return count ? [x / count, y / count] : null;
});
const featureOf = (page, name) => element(page, name).locator("circle.feature").evaluate((dot) => [Number(dot.getAttribute("cx")), Number(dot.getAttribute("cy"))]);

test("the window shows the instant of the time bar, and its mark is where the ball is seen", () =>
  withLab(BALL, async (open) => {
    const page = await open();
    await untilStatus(page, /2\.00 s/);
    for (const [share, x] of [[0.02, 54], [0.5, 74], [0.97, 100]]) { // the ball goes to the right, px
      await goTo(page, share);
      await until(async () => Math.abs(((await redIn(page, "From above"))?.[0] ?? -1) - x) < 4, async () => `the ball is seen at ${await redIn(page, "From above")} at ${share}`);
      await new Promise((resolve) => setTimeout(resolve, 300));
      const [seen, marked] = [await redIn(page, "From above"), await featureOf(page, "From above")];
      assert.ok(Math.hypot(seen[0] - marked[0], seen[1] - marked[1]) < 3, `${seen} and ${marked} at ${share}`);
    }
    const note = await element(page, "From above").locator(".camera-note").innerText();
    assert.match(note, /eye · 160 x 120 · 1 feature, 1 wanted · largest error [\d.]+ px/);
    await until(async () => (await element(page, "From above").locator("path.way").count()) === 2, () => "no way of the feature");
    await until(async () => /[4-8] true corners/.test(await element(page, "corners").locator(".camera-note").innerText()), () => "not four corners of the tile");
    await until(async () => (await element(page, "other").locator("canvas").getAttribute("width")) === "160", () => "no computed picture");
    assert.equal(await redIn(page, "other"), null);
    await keep(page, "ball");
    await element(page, "From above").getByRole("button", { name: "Large" }).click();
    await until(async () => (await element(page, "From above").locator("canvas").boundingBox()).width > 600, () => "it does not become large");
    await keep(page, "ball_large");
  }));

test("in the 3D view the camera has its picture", () =>
  withLab(BALL.replace(ARM, "").replace("lookingAt(xyz(0mm, 400mm, 0mm), from: xyz(0mm, 300mm, 900mm))", "lookingAt(xyz(0mm, 400mm, 40mm), from: xyz(0mm, 380mm, 110mm))").replaceAll("-150mm", "0mm").replace("k * 30mm", "k * 0mm"), async (open) => {
    const page = await open();
    await untilStatus(page, /2\.00 s/);
    await keep(page, "pyramid");
    await shows(page, "red: the ball and its picture", RED, 60);
  }));

test("a program with many pictures says how far it is, and the page stays usable meanwhile", () =>
  withLab(BALL, async (open) => {
    const page = await open();
    await untilStatus(page, /2\.00 s/);
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+End");
    await page.keyboard.insertText("var sum = 0\nfor (k in range(900)) { setPose(ball, xyz(-150mm + (k % 300) * 1mm + k * 0.001mm, 400mm, 40mm)); sum += blur(eye.capture(), sigma: 6.0)[80, 60].r; wait(20ms) }\n");
    // The run before can be looked into while the next one is running.
    await until(async () => /running anew/.test(await status(page).innerText()), () => status(page).innerText());
    const before = (await redIn(page, "From above"))[0];
    await goTo(page, 0.02);
    await until(async () => (await redIn(page, "From above"))[0] < before - 8, () => "the window stays as it was");
    const told = new Set();
    const end = Date.now() + 120_000;
    while (Date.now() < end) {
      const text = await status(page).innerText();
      told.add(text);
      if (/20\.\d\d s/.test(text)) break;
    }
    const pictures = [...told].flatMap((text) => /running(?: anew)?(?: at line \d+)?, [\d.]+ s, (\d+) pictures?/.exec(text)?.[1] ?? []).map(Number);
    assert.ok(pictures.length >= 2, [...told].join(" | "));
    assert.deepEqual(pictures, [...pictures].sort((a, b) => a - b));
    assert.match([...told].at(-1), /20\.\d\d s/);
  }));

test("the laboratory of visual servoing: corners come to where they are wanted", () =>
  withLab(readFileSync(join(root, "examples/24_camera_window.rbt"), "utf8"), async (open) => {
    const page = await open({ viewport: { width: 1400, height: 860 } });
    await untilStatus(page, /\d\.\d\d s/);
    const window = element(page, "What the hand sees");
    const error = async () => Number(/largest error ([\d.]+) px/.exec(await window.locator(".camera-note").innerText())?.[1] ?? NaN);
    await until(async () => (await error()) < 1, async () => `the error is ${await error()}`);
    await until(async () => (await window.locator("path.way").count()) === 8, () => "not the ways of four corners");
    await keep(page, "servo_end");
    await goTo(page, 0.4);
    await until(async () => (await error()) > 3, async () => `the error is ${await error()}`);
    await new Promise((resolve) => setTimeout(resolve, 500));
    await keep(page, "servo_begin");
  }));

test("a recording has the windows without pictures, and says so", async () => {
  const run = { run: 1, state: "done", t_end: 1, label: "", parent: null, parts_at: null };
  const page = await openPage(recordingFile([
    { type: "welcome", protocol: 1, page: 1, file: "a.rbt", text: "", text_version: 1, demo: false },
    { type: "runs", list: [run] },
    { ...run, type: "run", text_version: 1, inputs: [], hash: "", error: null },
    { type: "description", run: 1, robots: [], objects: [], cameras: [], elements: [{ kind: "view", name: "window", camera: "eye" }] },
    { type: "shown", run: 1 },
  ]));
  await until(async () => /no pictures/.test(await element(page, "window").innerText()), () => element(page, "window").innerText());
  assert.deepEqual(page.problems, []);
  await page.context().close();
});
