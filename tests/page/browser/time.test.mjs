// Going through a run in time: the bar, playing, statements.
import assert from "node:assert/strict";
import test, { after } from "node:test";
import { ARM, closeBrowser, ONE_MOVE, typeAtEnd, until, untilClock, untilStatus, withLab } from "../laboratory.mjs";
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

const TASKS = `robot left = robots.scara()
robot right = robots.scara(base: xyz(1500mm, 0mm, 0mm))
lab cell {
    plot speeds(fn() => left.jointSpeeds())
    plot hand(fn() => norm(left.tcpSpeed()[0:3]))
}
setSignal("lamp", true)
parallel {
    {
        left.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 2s)
        wait(2s)
    }
    right.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 1s)
}
`;

test("tasks and signals have lanes: what they did is reported, and the line lights up", () =>
  withLab(TASKS, async (open) => {
    const page = await open();
    await untilStatus(page, /2 moves, 4\.00 s/);
    const bar = await page.locator(".bar").boundingBox();
    const note = page.locator(".bar-note");
    const told = async (share, y, pattern) => {
      await page.mouse.move(bar.x + 76 + share * (bar.width - 90), bar.y + y);
      await until(async () => pattern.test(await note.innerText()), async () => `${await note.innerText()} is not ${pattern}`);
    };
    // Two robots, the program, two branches, a signal.
    const tasks = 18 + 2 * 24;
    await told(0.75, tasks + 8, /^the program, line 8: parallel/);
    await told(0.75, tasks + 17 + 8, /^branch 1 of parallel on line 8, line 11: wait\(2s\)$/);
    await page.locator(".line-hovered", { hasText: "wait(2s)" }).waitFor();
    await told(0.1, tasks + 34 + 8, /^branch 2 of parallel on line 8, line 13: right\.moveJ/);
    await told(0.9, tasks + 51 + 8, /^signal lamp is on$/);
    await page.mouse.move(bar.x + 20, bar.y + tasks + 17 + 8);
    await until(async () => (await note.innerText()) === "branch 1 of parallel on line 8", () => note.innerText());
    await page.getByRole("tab", { name: "Variables" }).click();
    await page.locator(".variables tr", { hasText: /lamp\s*signal\s*true/ }).waitFor();
  }));

test("plots lie below the bar along its time, and go back among the elements", () =>
  withLab(TASKS, async (open) => {
    const page = await open();
    await untilStatus(page, /2 moves, 4\.00 s/);
    await page.locator(".elements .u-over").nth(1).waitFor();
    const button = page.getByRole("button", { name: "Plots below the bar of time" });
    await button.click();
    await page.locator(".along .u-over").nth(1).waitFor();
    assert.equal(await page.locator(".elements .u-over").count(), 0);
    const bar = await page.locator(".bar").boundingBox();
    for (const over of await page.locator(".along .u-over").all()) {
      const box = await over.boundingBox();
      assert.ok(Math.abs(box.x - (bar.x + 76)) < 2, `it begins at ${box.x}, the bar at ${bar.x + 76}`);
      assert.ok(Math.abs(bar.x + bar.width - box.x - box.width - 76) < 2, `it ends at ${box.x + box.width} of ${bar.x + bar.width}`);
    }
    // Two seconds are at the same position in both.
    const box = await page.locator(".along .u-over").first().boundingBox();
    await page.mouse.click(box.x + 0.5 * box.width, box.y + 30);
    await untilClock(page, /^2\.0\d \/ 4\.00/);
    const now = await page.locator(".along .plot-now").first().boundingBox();
    assert.ok(Math.abs(now.x - (box.x + 0.5 * box.width)) < 3);
    await page.reload();
    await page.locator(".along .u-over").first().waitFor();
    await button.click();
    await page.locator(".elements .u-over").nth(1).waitFor();
    assert.equal(await page.locator(".along .u-over").count(), 0);
  }));

test("new runs move nothing on the page, however many there are", () =>
  withLab(ONE_MOVE, async (open) => {
    const page = await open();
    await untilStatus(page, /1 move, 2\.00 s/);
    await page.locator(".stage canvas").waitFor();
    const boxes = async () => JSON.stringify(await Promise.all([".bar", ".stage canvas"].map((each) => page.locator(each).boundingBox())));
    const before = await boxes();
    for (let k = 1; k <= 3; k++) {
      await typeAtEnd(page, "wait(1s)\n");
      await untilStatus(page, new RegExp(`${2 + k}\\.00 s`));
    }
    assert.equal(await boxes(), before);
  }));

test("playing goes from the start to the end and stops there", () =>
  withLab(ONE_MOVE, async (open) => {
    const page = await open();
    await untilStatus(page, /1 move, 2\.00 s/);
    await page.getByLabel("Speed").selectOption("2");
    await page.getByRole("button", { name: "Play" }).click();
    await page.getByRole("button", { name: "Pause" }).waitFor();
    await page.getByRole("button", { name: "Play" }).waitFor();
    await untilClock(page, /^2\.00 /);
  }));

test("play keeps to the clock at five frames per second", () =>
  withLab(`${ARM}arm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 20s)\n`, async (open) => {
    const page = await open({ before: (fresh) => fresh.addInitScript(() => {
      globalThis.requestAnimationFrame = (work) => setTimeout(() => work(performance.now()), 200);
    }) });
    await untilStatus(page, /1 move, 20\.00 s/);
    await page.getByRole("button", { name: "To the start" }).click();
    await untilClock(page, /^0\.00 /);
    const now = () => page.evaluate(() => [performance.now() / 1000, parseFloat(document.querySelector("output.time").textContent)]);
    await page.getByRole("button", { name: "Play" }).click();
    await until(async () => (await now())[1] > 0.5, () => "it does not play");
    const [wall, shown] = await now();
    await page.waitForTimeout(4000);
    const [later, then] = await now();
    const share = (then - shown) / (later - wall);
    assert.ok(share > 0.85 && share < 1.15, `${then - shown} s were shown in ${later - wall} s`);
  }));

test("steps go over, into and out of calls and back, breakpoints hold, variables follow", () =>
  withLab(STEPS, async (open) => stepThrough(await open())));
