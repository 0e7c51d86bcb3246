// The program is changed, and what follows from it is seen at once.
import assert from "node:assert/strict";
import test, { after } from "node:test";
import { clock, closeBrowser, lineOf, openPage, placeOf, saved, status, typeAtEnd, until, untilStatus, withLab } from "../laboratory.mjs";

after(closeBrowser);

const PROGRAM = `robot arm = robots.scara()
let lag = 2.0s
arm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: lag)
arm.moveJ(posJ(-20deg, 30deg, 10mm, 0deg), time: 1s)
`;

test("a program is loaded with its run: moves beside their lines, sliders of its robot", () =>
  withLab(PROGRAM, async (open) => {
    const page = await open();
    await untilStatus(page, /2 moves, 3\.00 s/);
    assert.match(await page.locator(".gutter-margin").innerText(), /2\.00 s\s+1\.00 s/);
    assert.match(await page.locator(".gutter-margin span").first().getAttribute("title"), /moveJ.*, to -?\d+\.\d, -?\d+\.\d, -?\d+\.\d mm$/);
    assert.match(await page.locator(".file").innerText(), /^program\.rbt · arm$/);
    assert.equal(await page.getByRole("slider", { name: /^q\d, / }).count(), 4);
    assert.match(await clock(page).innerText(), /3\.00 \/ 3\.00 s/);
  }));

test("typing runs the program again and draws another path", () =>
  withLab(PROGRAM, async (open) => {
    const page = await open();
    await untilStatus(page, /3\.00 s/);
    const before = await page.locator(".stage").screenshot();
    await typeAtEnd(page, "arm.moveJ(posJ(90deg, -30deg, 80mm, 0deg), time: 1.5s)\n");
    await untilStatus(page, /3 moves, 4\.50 s/);
    assert.notDeepEqual(await page.locator(".stage").screenshot(), before);
  }));

test("a number is pulled with Alt and the mouse, with the wheel and from the keyboard", () =>
  withLab(PROGRAM, async (open) => {
    const page = await open();
    await untilStatus(page, /3\.00 s/);
    const { x, y } = await placeOf(page, "let lag", "2.0");
    await page.keyboard.down("Alt");
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 40, y, { steps: 5 });
    await page.mouse.up();
    await until(async () => /let lag = 3\.0s/.test(await lineOf(page, "let lag").innerText()), () => lineOf(page, "let lag").innerText());
    await untilStatus(page, /2 moves, 4\.00 s/);
    const there = await placeOf(page, "let lag", "3.0");
    await page.mouse.move(there.x, there.y);
    await page.mouse.wheel(0, -100);
    await page.keyboard.up("Alt");
    await untilStatus(page, /2 moves, 4\.10 s/);
    await page.mouse.click(x, y);
    await page.keyboard.press("Alt+PageDown");
    await page.keyboard.press("Alt+PageDown");
    await untilStatus(page, /2 moves, 3\.90 s/);
  }));

test("a mistake is reported with its reason and mended with one click; the last good run stays", () =>
  withLab(PROGRAM, async (open) => {
    const page = await open();
    await untilStatus(page, /3\.00 s/);
    await typeAtEnd(page, "arm.moveJJ(posJ(0deg, 30deg, 10mm, 0deg), time: lag)\n");
    await untilStatus(page, /1 mistake: the last good run is shown/);
    await page.locator(".is-stale .editor .stale").waitFor();
    assert.match(await clock(page).innerText(), /3\.00 s/);
    await page.getByRole("button", { name: /^Fix: .*moveJ/ }).click();
    await untilStatus(page, /3 moves, 5\.00 s/);
    assert.equal(await page.locator(".problem").count(), 0);
    assert.equal(await page.locator(".is-stale").count(), 0);
  }));

test("pointing at a line lights its stretch of the path, pointing at a block lights its line", () =>
  withLab(PROGRAM, async (open) => {
    const page = await open();
    await untilStatus(page, /3\.00 s/);
    await page.mouse.move(5, 5);
    const dark = await page.locator(".stage").screenshot();
    await lineOf(page, "-20deg").hover();
    await until(async () => !dark.equals(await page.locator(".stage").screenshot()), () => "the picture is the same");
    const bar = await page.locator(".bar").boundingBox();
    await page.mouse.move(bar.x + 76 + 0.2 * (bar.width - 100), bar.y + 30);
    await page.locator(".line-hovered", { hasText: "40deg" }).waitFor();
    assert.match(await page.locator(".bar-note").innerText(), /moveJ/);
  }));

// Where the pointer is over the path, on the view: [x, y] of the window.
async function onPath(page) {
  const box = await page.locator(".stage canvas").boundingBox();
  for (let y = 0.25; y < 0.9; y += 0.03) {
    for (let x = 0.1; x < 0.95; x += 0.02) {
      await page.mouse.move(box.x + x * box.width, box.y + y * box.height);
      if (await page.locator(".line-hovered").count()) return [box.x + x * box.width, box.y + y * box.height];
    }
  }
  throw new Error("the pointer is nowhere on the path");
}

test("pointing at the path lights its line and its instant, a click goes there; a click on an object selects its name", () =>
  withLab(`${PROGRAM}object block { shape: box(400mm, 400mm, 30mm); at: xyz(0mm, 0mm, -20mm) }\n`, async (open) => {
    const page = await open();
    await untilStatus(page, /3\.00 s/);
    await page.locator(".stage canvas").waitFor();
    await page.waitForTimeout(500);
    await page.mouse.move(5, 5);
    const bar = await page.locator(".bar").screenshot();
    const [x, y] = await onPath(page);
    await page.locator(".line-hovered", { hasText: "arm.moveJ" }).waitFor();
    await until(async () => !bar.equals(await page.locator(".bar").screenshot()), () => "the bar of time does not show the instant");
    await page.mouse.click(x, y);
    await until(async () => !/^3\.00/.test(await clock(page).innerText()), () => "the instant is not that of the path");
    await page.getByRole("toolbar", { name: "3D view" }).getByRole("button", { name: "Top" }).click();
    const view = await page.locator(".stage canvas").boundingBox();
    const isThere = async () => (await page.locator(".cm-lineNumbers .cm-activeLineGutter").innerText()) === "5";
    await page.waitForTimeout(500);
    for (let s = 0; s < 30 && !(await isThere()); s++) await page.mouse.click(view.x + (0.06 + 0.03 * (s % 10)) * view.width, view.y + (0.45 + 0.01 * s) * view.height);
    assert.ok(await isThere(), "no click has selected the object");
  }));

test("a name under the pointer has the value of the instant that is looked at", () =>
  withLab("var count = 1\nfn twice(count: int) -> int {\n    wait(0.5s)\n    return 2 * count\n}\nwait(1s)\ncount = twice(1)\nwait(1s)\n", async (open) => {
    const page = await open();
    await untilStatus(page, /2\.50 s/);
    const valueAt = async (share, wanted) => {
      const bar = await page.locator(".bar").boundingBox();
      await page.mouse.click(bar.x + 76 + share * (bar.width - 90), bar.y + 30);
      await page.getByRole("tab", { name: "Variables" }).click();
      await page.locator(".variables tr", { hasText: "count" }).last().locator(".value", { hasText: wanted }).waitFor();
      const { x, y } = await placeOf(page, "var count", "count");
      await page.mouse.move(x, y);
      await page.locator(".tip-value", { hasText: `= ${wanted}` }).waitFor();
    };
    await valueAt(0.2, "1");
    await valueAt(0.9, "2");
    await page.mouse.move(5, 5);
    await valueAt(0.5, "1"); // in the function, whose own one is not meant
  }));

test("the header has robots and world, the time bar play and speed; steps are beside the output of the program", () =>
  withLab('insertObj("cube")\nrobot arm = robots.scara()\narm.moveJ(posJ(10deg, 0deg, 0mm, 0deg), time: 1s)\n', async (open) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    assert.equal(await page.locator("header .file").innerText(), "program.rbt · arm · world: table");
    for (const label of ["Play", "To the start", "To the end"]) await page.locator("footer").getByRole("button", { name: label }).waitFor();
    await page.locator("footer").getByLabel("Speed").waitFor();
    assert.equal(await page.locator(".column.program .steps button").count(), 5);
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Record" }).click()]);
    const alone = await openPage(`file://${await saved(download)}`);
    await untilStatus(alone, /recording/);
    assert.equal(await alone.locator("header .file").innerText(), "program.rbt · arm · world: table");
    await alone.context().close();
  }));

test("a program without a block has sliders of joints and tool and plots of positions and speeds; columns are closed and stay so", () =>
  withLab(PROGRAM, async (open) => {
    const page = await open();
    await untilStatus(page, /3\.00 s/);
    for (const name of ["joints of arm", "hand of arm", "q of arm", "qd of arm"]) await page.locator(".element", { hasText: name }).first().waitFor();
    await page.getByRole("button", { name: "Column program" }).click();
    assert.equal(await page.locator(".column.program").isVisible(), false);
    await page.reload();
    await untilStatus(page, /3\.00 s/);
    assert.equal(await page.locator(".column.program").isVisible(), false);
    await page.getByRole("button", { name: "Column program" }).click();
    await page.locator(".column.program").waitFor();
  }));

test("the editor completes, says what stands under the pointer, helps with calls and lays out", () =>
  withLab(PROGRAM, async (open) => {
    const page = await open();
    await untilStatus(page, /3\.00 s/);
    await (await lineOf(page, "-20deg")).hover();
    const { x, y } = await placeOf(page, "let lag", "lag");
    await page.mouse.move(x, y);
    await page.locator(".tip-code", { hasText: "lag" }).waitFor();
    await page.mouse.move(5, 5);
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+End");
    await page.keyboard.type("arm.mov", { delay: 30 });
    await page.locator(".cm-tooltip-autocomplete li", { hasText: "moveJ" }).first().waitFor();
    await page.keyboard.press("Escape");
    await page.keyboard.type("eJ(posJ(0deg,0deg,10mm,0deg)", { delay: 20 });
    await page.locator(".tip-code", { hasText: "time: time?" }).waitFor();
    await page.keyboard.type(",time:1s", { delay: 5 });
    await untilStatus(page, /3 moves/);
    await page.keyboard.press("Escape");
    await page.keyboard.press("Shift+Alt+f");
    await lineOf(page, "posJ(0deg, 0deg, 10mm, 0deg), time: 1s").waitFor();
  }));

test("what is scrolled under a resting pointer is reported", () =>
  withLab(`robot arm = robots.scara()\n${Array.from({ length: 200 }, (_, k) => `let lag${k} = ${k} * 1mm\n`).join("")}wait(1s)\n`, async (open) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    const { x, y } = await placeOf(page, "let lag9 =", "lag9");
    await page.mouse.move(x, y);
    await page.locator(".tip-code", { hasText: /lag9\b/ }).waitFor();
    const height = await lineOf(page, "let lag9 =").evaluate((line) => line.getBoundingClientRect().height);
    await page.locator(".cm-scroller").evaluate((box, by) => box.scrollBy(0, by), 50 * height);
    await page.locator(".tip-code", { hasText: /lag\d\d+/ }).waitFor();
  }));

test("a run that fails says where and why, in the text, on the bar and in space", () =>
  withLab(PROGRAM, async (open) => {
    const page = await open();
    await untilStatus(page, /3\.00 s/);
    await typeAtEnd(page, "arm.moveL(xyz(5m, 0mm, 100mm), speed: 100mm/s)\n");
    await untilStatus(page, /failed at 3\.00 s/);
    await page.locator(".problem.error").waitFor();
    await page.locator(".line-failed", { hasText: "5m" }).waitFor();
    await page.locator(".label.warning").waitFor();
  }));

test("runs are kept: the one before is listed, and two are compared", () =>
  withLab(PROGRAM, async (open) => {
    const page = await open();
    await untilStatus(page, /3\.00 s/);
    await typeAtEnd(page, "arm.moveJ(posJ(90deg, -30deg, 80mm, 0deg), time: 1.5s)\n");
    await untilStatus(page, /4\.50 s/);
    await page.getByRole("tab", { name: /Runs/ }).click();
    await page.getByRole("button", { name: "Compare" }).first().click();
    await page.locator(".run .reason", { hasText: /part at t = 3\.00 s/ }).waitFor();
    // In plots the other one is dashed.
    const plot = page.locator(".element", { hasText: "q of arm" }).first();
    await plot.locator(".dashed", { hasText: "– – run 1" }).waitFor();
    assert.equal(await plot.locator(".u-legend .beside").count(), 4);
    assert.match(await status(page).innerText(), /4\.50 s/);
  }));
