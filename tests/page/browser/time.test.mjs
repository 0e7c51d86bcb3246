// Going through a run in time: the bar, playing, statements.
import assert from "node:assert/strict";
import test, { after } from "node:test";
import { clock, closeBrowser, until, untilStatus, withLab } from "../laboratory.mjs";

after(closeBrowser);

const hand = (page) => page.locator("output.where");
const current = (page) => page.locator(".line-current");
async function untilClock(page, pattern) {
  await until(async () => pattern.test(await clock(page).innerText()), async () => `the clock reads ${await clock(page).innerText()}, not ${pattern}`);
}

test("the pick and place of the demonstration is gone through, back to its start and on to its end", () =>
  withLab(null, async (open) => {
    const page = await open();
    await untilStatus(page, /\d moves, /);
    const end = await hand(page).innerText();
    await page.getByRole("button", { name: "To the start" }).click();
    await untilClock(page, /^0\.00 /);
    const bar = await page.locator(".bar").boundingBox();
    await page.mouse.move(bar.x + 76, bar.y + 40);
    await page.mouse.down();
    await page.mouse.move(bar.x + 0.5 * bar.width, bar.y + 40, { steps: 6 });
    await page.mouse.up();
    await until(async () => (await hand(page).innerText()) !== end, () => "the hand has not moved");
    await page.getByRole("tab", { name: "Variables" }).click();
    await page.locator(".variables .name").first().waitFor();
    await page.getByRole("button", { name: "To the end" }).click();
    await until(async () => (await hand(page).innerText()) === end, () => "the hand is not back");
  }));

test("playing goes from the start to the end and stops there", () =>
  withLab("robot arm = robots.scara()\narm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 2s)\n", async (open) => {
    const page = await open();
    await untilStatus(page, /1 move, 2\.00 s/);
    await page.getByLabel("Speed").selectOption("2");
    await page.getByRole("button", { name: "Play" }).click();
    await page.getByRole("button", { name: "Pause" }).waitFor();
    await page.getByRole("button", { name: "Play" }).waitFor();
    await untilClock(page, /^2\.00 /);
  }));

const STEPS = `robot arm = robots.scara()
fn go(a: angle) {
    arm.moveJ(posJ(a, 60deg, 50mm, 0deg), time: 1s)
}
var n = 1
go(10deg)
n = 2
go(20deg)
n = 3
`;

test("steps go over, into and out of calls and back, breakpoints hold", () =>
  withLab(STEPS, async (open) => {
    const page = await open();
    await untilStatus(page, /2 moves, 2\.00 s/);
    await page.getByRole("tab", { name: "Variables" }).click();
    await page.getByRole("button", { name: "To the start" }).click();
    const line = async (text) => current(page).filter({ hasText: text }).waitFor();
    await page.locator(".gutter-breakpoints .cm-gutterElement").nth(7).click();
    await page.locator(".breakpoint:visible").first().waitFor();
    await page.keyboard.press("F5");
    await line("n = 2");
    await untilClock(page, /^1\.00 /);
    await page.keyboard.press("F10");
    await line("go(20deg)");
    await page.keyboard.press("F11");
    await line("arm.moveJ");
    await page.locator(".variables tr", { hasText: /^a/ }).filter({ hasText: "20 deg" }).waitFor();
    await page.keyboard.press("Shift+F11");
    await line("n = 3");
    await page.keyboard.press("Shift+F10");
    await line("arm.moveJ");
    assert.match(await clock(page).innerText(), /^1\.00 /);
  }));
