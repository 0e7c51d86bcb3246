// A laboratory in one file, opened from the disk: the engine of the page itself does everything.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test, { after } from "node:test";
import { clock, closeBrowser, goTo, lineOf, ONE_MOVE, openPage, placeOf, typeAtEnd, until, untilStatus, viewTool, violations, withLab } from "../laboratory.mjs";
import { root } from "../modules.mjs";
import { STEPS, stepThrough } from "../stepping.mjs";

after(closeBrowser);

const engine = join(root, "build/wasm/laboratory.html");
const skip = existsSync(engine) ? false : "there is no engine for pages: ./dev wasm";

const PROGRAM = `import "parts/grips.rbt"
robot arm = robots.scara()
let lag = 2.0s
lab cell {
    title: "A cell in a file"
    sliders hand(of: arm, as: "x y z roll")
    field far(20deg, range: [0deg, 60deg])
    button go("Go", fn() { arm.moveJ(posJ(cell.far, 0deg, 0mm, 0deg), time: 1s) })
    plot angles(fn() => arm.joints())
}
arm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: lag)
arm.moveJ(posJ(-20deg, 30deg, grips.low, 0deg), time: 1s)
for (k in [5, -5]) { arm.moveJ(posJ(k * 1deg, 0deg, 0mm, 0deg), time: 1s) }
`;

// Writes the program and what it takes, exports it, and gives the file to `work`.
async function exported(work, options = []) {
  const folder = mkdtempSync(join(tmpdir(), "armlet-alone-"));
  try {
    mkdirSync(join(folder, "parts"));
    writeFileSync(join(folder, "cell.rbt"), PROGRAM);
    writeFileSync(join(folder, "parts/grips.rbt"), "let low = 10mm\n");
    const armlet = (...given) => execFileSync(process.env.ARMLET_COMMAND, given, { cwd: folder, stdio: ["ignore", "pipe", "pipe"] }).toString();
    armlet("lab", "cell.rbt", "--export", "cell.html", "--engine", engine, ...options);
    await work(join(folder, "cell.html"), armlet, folder);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

async function opened(file, work) {
  const page = await openPage(`file://${file}`, { acceptDownloads: true });
  try {
    await work(page);
    assert.deepEqual(page.problems, []);
  } finally {
    await page.context().close();
  }
}

const laboratoryIn = (file) => JSON.parse(/id="armlet-laboratory">([^<]*)</.exec(readFileSync(file, "utf8"))[1]);

test("one file has everything: it runs, is edited, steps, completes, takes inputs and is saved", { skip }, () =>
  exported(async (file, armlet, folder) => {
    assert.ok(statSync(file).size <= 4e6, `${statSync(file).size} bytes`);
    const hash = /hash (\w+)/.exec(armlet("run", "cell.rbt", "--hash", "--quiet"))[1];
    assert.equal(laboratoryIn(file).runs[0].hash, hash);
    const handed = join(folder, "handed.html");
    await opened(file, async (page) => {
      await untilStatus(page, /4 moves, 5\.00 s/);
      assert.equal(await page.title(), "A cell in a file – laboratory");
      assert.equal(await page.locator("header .file").innerText(), "cell.rbt · arm");
      assert.ok(!(await page.locator(".message").isVisible()), "the hash is that of the command");
      await typeAtEnd(page, "arm.moveJ(posJ(90deg, -30deg, 80mm, 0deg), time: 1.5s)\n");
      await untilStatus(page, /5 moves, 6\.50 s/);
      await typeAtEnd(page, "arm.mov");
      await page.locator(".problem").first().waitFor();
      await page.keyboard.type("e");
      await page.locator(".cm-tooltip-autocomplete li", { hasText: "moveJ" }).first().waitFor();
      await page.keyboard.press("Escape");
      for (let k = 0; k < 8; k++) await page.keyboard.press("Backspace");
      await untilStatus(page, /5 moves, 6\.50 s/);
      const { x, y } = await placeOf(page, "let lag", "lag");
      await page.mouse.move(x, y); // at once: in between it would come to rest on another word, whose text then lies over this one
      await page.locator(".tip-code", { hasText: "lag" }).waitFor();
      await page.mouse.move(5, 5);
      await page.getByRole("button", { name: "Go", exact: true }).click();
      await untilStatus(page, /6 moves, 7\.50 s/);
      await page.keyboard.press("Escape");
      const bar = await page.locator(".bar").boundingBox();
      await page.mouse.click(bar.x + 0.5 * bar.width, bar.y + 40);
      await until(async () => /^3\.\d+ \/ 7\.50 s/.test(await clock(page).innerText()), () => clock(page).innerText());
      assert.deepEqual(await violations(page), []);
      const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Hand in" }).click()]);
      assert.equal(download.suggestedFilename(), "cell.html");
      await download.saveAs(handed);
    });
    const saved = laboratoryIn(handed);
    assert.match(saved.text, /90deg, -30deg/);
    const last = saved.runs.at(-1);
    assert.deepEqual(last.inputs.map((input) => input.press), ["go"]);
    assert.deepEqual(saved.files, { "parts/grips.rbt": "let low = 10mm\n" });
    await opened(handed, async (page) => {
      await untilStatus(page, /6 moves, 7\.50 s/);
      assert.ok(!(await page.locator(".message").isVisible()), "every run came out as it was saved");
      await page.getByRole("tab", { name: /Runs/ }).click();
      // One that only went on where another had ended is one with it.
      assert.equal(await page.locator(".run").count(), new Set(saved.runs.map((run) => run.text)).size);
      const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Record" }).click()]);
      await download.saveAs(join(folder, "recorded.html"));
    });
    assert.ok(statSync(join(folder, "recorded.html")).size < 0.5 * statSync(file).size);
    await opened(join(folder, "recorded.html"), (page) => untilStatus(page, /recording, 6 moves, 7\.50 s/));
    // A change made outside of the page is reported.
    writeFileSync(handed, readFileSync(handed, "utf8").replaceAll(last.hash, "0123456789abcdef"));
    await opened(handed, async (page) => {
      await page.locator(".message", { hasText: "computes otherwise" }).waitFor();
    });
  }));

// A laboratory in one file that takes nothing from elsewhere.
async function alone(text, work) {
  const folder = mkdtempSync(join(tmpdir(), "armlet-alone-"));
  try {
    writeFileSync(join(folder, "a.rbt"), text);
    execFileSync(process.env.ARMLET_COMMAND, ["lab", "a.rbt", "--export", "a.html", "--engine", engine], { cwd: folder, stdio: "pipe" });
    await opened(join(folder, "a.html"), work);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

test("in one file steps go over, into and out of calls and back, breakpoints hold, variables follow", { skip }, () => alone(STEPS, stepThrough));

test("in one file the program is laid out, mended with one click, gone through in time, and its elements move the arm", { skip }, () =>
  alone(STEPS, async (page) => {
    await untilStatus(page, /2 moves, 2\.00 s/);
    await typeAtEnd(page, "go( 30deg )\n");
    await untilStatus(page, /3 moves, 3\.00 s/);
    await page.keyboard.press("Shift+Alt+F");
    await lineOf(page, "go(30deg)").waitFor();
    await untilStatus(page, /3 moves, 3\.00 s/);
    await typeAtEnd(page, "arm.movej(posJ(0deg, 0deg, 0mm, 0deg), time: 1s)\n");
    await page.getByRole("button", { name: /^Fix:/ }).first().click();
    await untilStatus(page, /4 moves, 4\.00 s/);
    // The time bar is dragged; the tool goes along.
    const hand = page.locator("output.where");
    const end = await hand.innerText();
    const bar = await page.locator(".bar").boundingBox();
    await page.mouse.move(bar.x + 80, bar.y + 40);
    await page.mouse.down();
    await page.mouse.move(bar.x + 0.4 * bar.width, bar.y + 40, { steps: 5 });
    await page.mouse.up();
    await until(async () => (await hand.innerText()) !== end, () => "the hand has not moved");
    await page.getByRole("tab", { name: "Variables" }).click();
    await page.locator(".variables .name", { hasText: "arm" }).waitFor();
    // A slider is dragged: at the end the run goes on with it.
    await page.getByRole("button", { name: "To the end" }).click();
    const before = await hand.innerText();
    const slider = page.locator(".elements input[type=range]").first();
    const box = await slider.boundingBox();
    await page.mouse.move(box.x + 0.5 * box.width, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.8 * box.width, box.y + box.height / 2, { steps: 6 });
    await page.mouse.up();
    await until(async () => (await hand.innerText()) !== before, () => "the arm did not follow the slider");
    await page.getByRole("tab", { name: /Runs/ }).click();
    assert.ok((await page.locator(".run").count()) >= 3);
  }));

// The pixels of the first camera window at three instants, each once they no longer change.
async function picturesOf(page) {
  const canvas = page.locator(".element.camera canvas").first();
  const pixels = () => canvas.evaluate((it) => {
    const copy = new OffscreenCanvas(it.width, it.height).getContext("2d", { willReadFrequently: true });
    copy.drawImage(it, 0, 0);
    const { data } = copy.getImageData(0, 0, it.width, it.height);
    let hash = 2166136261;
    for (const byte of data) hash = Math.imul(hash ^ byte, 16777619);
    return `${it.width} x ${it.height} ${hash >>> 0}`;
  });
  const found = [];
  for (const share of [0.05, 0.4, 0.95]) {
    await goTo(page, share);
    let last = "";
    await until(async () => {
      const now = await pixels(), known = found.at(-1);
      const rests = now === last && now !== known;
      last = now;
      if (!rests) await new Promise((resolve) => setTimeout(resolve, 400));
      return rests;
    }, () => `the picture at ${share} does not come to rest`);
    found.push(last);
  }
  return found;
}

test("in one file cameras show the pixels that a served laboratory shows", { skip }, async () => {
  const text = readFileSync(join(root, "examples/24_camera_window.rbt"), "utf8");
  let served, here;
  await withLab(text, async (open) => {
    const page = await open();
    await untilStatus(page, /moves?, [\d.]+ s/);
    served = await picturesOf(page);
  });
  await alone(text, async (page) => {
    await untilStatus(page, /moves?, [\d.]+ s/);
    here = await picturesOf(page);
    if (process.env.ARMLET_PAGE_PICTURES) await page.screenshot({ path: join(process.env.ARMLET_PAGE_PICTURES, "camera_in_one_file.png") });
  });
  assert.deepEqual(here, served);
  assert.equal(new Set(here).size, 3);
});

// What a program's texts would do if they were read as a page.
const SCRIPT = '</script><script>hacked = 1</script><!--<script><img src=x onerror="hacked = 2">';
const HOSTILE = `// ${SCRIPT}
print("${SCRIPT.replaceAll('"', "'")}")
lab cell {
    title: "${SCRIPT.replaceAll('"', "'")}"
    text intro("${SCRIPT.replaceAll('"', "'")}")
}
wait(1s)
`;

for (const [how, ending, why] of [["--record", [], false], ["--export", ["--engine", engine], skip]]) {
  test(`texts of a program are no scripts of a page that the command writes: ${how}`, { skip: why }, async () => {
    const folder = mkdtempSync(join(tmpdir(), "armlet-hostile-"));
    try {
      writeFileSync(join(folder, "a.rbt"), HOSTILE);
      execFileSync(process.env.ARMLET_COMMAND, ["lab", "a.rbt", how, "a.html", ...ending], { cwd: folder, stdio: "pipe" });
      const again = join(folder, "again.html");
      const look = async (page) => {
        await untilStatus(page, /1\.00 s/);
        assert.match(await page.locator("h1").innerText(), /^<\/script>/);
        await page.waitForTimeout(300);
        assert.equal(await page.evaluate(() => globalThis.hacked), undefined);
      };
      await opened(join(folder, "a.html"), async (page) => {
        await look(page);
        if (how === "--record") return;
        const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Hand in" }).click()]);
        await download.saveAs(again);
      });
      if (how === "--export") await opened(again, look);
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  });
}

test("a recording has variables, tables and what is near along the run", async () => {
  const folder = mkdtempSync(join(tmpdir(), "armlet-record-"));
  try {
    writeFileSync(join(folder, "a.rbt"), `robot arm = robots.scara()
object post { shape: box(60mm, 60mm, 400mm); at: xyz(350mm, 250mm, 200mm); fixed: true }
lab cell { table q(fn() => [arm.joints()]) }
var n = 0
arm.moveJ(posJ(0deg, 60deg, 0mm, 0deg), time: 1s)
n = 1
arm.moveJ(posJ(20deg, 40deg, 0mm, 0deg), time: 2s)
n = 2
`);
    execFileSync(process.env.ARMLET_COMMAND, ["lab", "a.rbt", "--record", "a.html"], { cwd: folder, stdio: "pipe" });
    await opened(join(folder, "a.html"), async (page) => {
      await untilStatus(page, /recording, 2 moves, 3\.00 s/);
      await page.getByRole("tab", { name: "Variables" }).click();
      const bar = await page.locator(".bar").boundingBox();
      const goTo = (t) => page.mouse.click(bar.x + 76 + (t / 3) * (bar.width - 90), bar.y + 30);
      const n = page.locator(".variables tr", { hasText: /^n/ }).locator(".value");
      const q2 = page.locator(".element", { hasText: "q" }).locator("td").nth(1);
      for (const [t, value] of [[0.5, "0"], [2, "1"], [0.2, "0"], [3, "2"]]) {
        await goTo(t);
        await until(async () => (await n.innerText()) === value, async () => `n is ${await n.innerText()} at ${t}, not ${value}`);
      }
      await until(async () => /^40 deg/.test(await q2.innerText()), () => q2.innerText());
      await goTo(1);
      await until(async () => /^60 deg|^59\.[5-9]/.test(await q2.innerText()), () => q2.innerText());
      await goTo(3);
      await page.locator(".labels .label", { hasText: / deep in "?post/ }).first().waitFor();
      await (await viewTool(page, "Clearance")).click();
      await goTo(1.8);
      await page.locator(".labels .label", { hasText: / mm to / }).first().waitFor();
    });
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});

test("a run is recorded by the command as a page that needs nothing", async () => {
  const folder = mkdtempSync(join(tmpdir(), "armlet-record-"));
  try {
    writeFileSync(join(folder, "a.rbt"), ONE_MOVE);
    execFileSync(process.env.ARMLET_COMMAND, ["lab", "a.rbt", "--record", "a.html"], { cwd: folder, stdio: "pipe" });
    await opened(join(folder, "a.html"), async (page) => {
      await untilStatus(page, /recording, 1 move, 2\.00 s/);
      assert.equal(await page.getByRole("button", { name: "Hand in" }).count(), 0);
    });
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
