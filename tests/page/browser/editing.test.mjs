// The program is changed, and what follows from it is seen at once.
import assert from "node:assert/strict";
import test, { after } from "node:test";
import { clock, closeBrowser, lineOf, placeOf, status, typeAtEnd, until, untilStatus, withLab } from "../laboratory.mjs";

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

test("a mistake is told with its reason and mended with one click; the last good run stays", () =>
  withLab(PROGRAM, async (open) => {
    const page = await open();
    await untilStatus(page, /3\.00 s/);
    await typeAtEnd(page, "arm.moveJJ(posJ(0deg, 30deg, 10mm, 0deg), time: lag)\n");
    await untilStatus(page, /1 mistake: the last good run is shown/);
    assert.match(await clock(page).innerText(), /3\.00 s/);
    await page.getByRole("button", { name: /^Fix: .*moveJ/ }).click();
    await untilStatus(page, /3 moves, 5\.00 s/);
    assert.equal(await page.locator(".problem").count(), 0);
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

test("what is scrolled under a resting pointer is told", () =>
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
    assert.match(await status(page).innerText(), /4\.50 s/);
  }));
