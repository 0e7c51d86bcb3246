// Going through a run in time: the bar, playing, statements.
import assert from "node:assert/strict";
import test, { after } from "node:test";
import { closeBrowser, until, untilClock, untilStatus, withLab } from "../laboratory.mjs";
import { STEPS, stepThrough } from "../stepping.mjs";

after(closeBrowser);

const hand = (page) => page.locator("output.where");

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
    // What happened besides moves is a tick.
    for (let x = 100; x < bar.width - 20 && !/attached/.test(await page.locator(".bar-note").innerText()); x += 4) await page.mouse.move(bar.x + x, bar.y + 12);
    assert.match(await page.locator(".bar-note").innerText(), /^\d+\.\d\d s\s+cube attached$/);
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

test("steps go over, into and out of calls and back, breakpoints hold, variables follow", () =>
  withLab(STEPS, async (open) => stepThrough(await open())));
