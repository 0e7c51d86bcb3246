// What everybody does in the first minutes, as fast as people do it: with pauses between keys, and some to look.
import assert from "node:assert/strict";
import test, { after } from "node:test";
import { ARM, closeBrowser, lineOf, placeOf, status, until, untilClock, untilStatus, withLab } from "../laboratory.mjs";

after(closeBrowser);

const KEY = { delay: 70 }; // ms from key to key
const LOOKS = 600; // ms

const program = (page) => page.locator(".cm-content").evaluate((content) => [...content.querySelectorAll(".cm-line")].map((line) => line.textContent).join("\n"));
const popup = (page) => page.locator(".cm-tooltip-autocomplete li");
const currentLine = (page, text) => page.locator(".line-current").filter({ hasText: text });

async function typeAtEnd(page, text) {
  await page.locator(".cm-content").focus();
  await page.keyboard.press("Control+End");
  await page.keyboard.type(text, KEY);
  await page.waitForTimeout(LOOKS);
}

test("Enter behind a number with its unit ends the line and puts in nothing", () =>
  withLab("var a = 1\nvar m = 2\nwait(1s)\n", async (open) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    const written = ["let h = 85mm", "let k = 90deg", "let w = 200g", "let v = 100mm/s", "let x = 2m", "let t = 1.5s"];
    for (const line of written) {
      await typeAtEnd(page, line);
      await page.keyboard.press("Enter");
    }
    assert.equal(await program(page), `var a = 1\nvar m = 2\nwait(1s)\n${written.join("\n")}\n`);
  }));

test("Enter behind each kind of word ends the line and puts in nothing", () =>
  withLab(`${ARM}var a = 1\nvar metal = 2\nwait(1s)\n`, async (open) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    const written = ["let b = a", "let c = metal", 'let s = "wait"', "let on = true", "// a remark about mov", "let n = 12", "let w = 5 * a", "let z = a ^ 2", "let l = [a, 2]", "let q = arm.jointCount()"];
    for (const line of written) {
      await typeAtEnd(page, line);
      await page.keyboard.press("Escape"); // brackets and quotes are closed by themselves
      await page.keyboard.press("End");
      await page.keyboard.press("Enter");
    }
    assert.equal(await program(page), `${ARM}var a = 1\nvar metal = 2\nwait(1s)\n${written.join("\n")}\n`);
  }));

test("settings of the call come before other words, and the signature marks the setting at the cursor", () =>
  withLab(`${ARM}let p = xyz(300mm, 100mm, 100mm)\nwait(1s)\n`, async (open) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    await typeAtEnd(page, "arm.moveL(p, sp");
    await popup(page).first().waitFor();
    const offered = await popup(page).locator(".cm-completionLabel").allInnerTexts();
    assert.match(offered[0], /^speed/);
    await page.keyboard.press("Escape");
    await page.keyboard.type("eed: 100mm/s", KEY);
    await page.locator(".tip-code strong", { hasText: /^speed:/ }).waitFor();
    for (let k = 0; k < "speed: 100mm/s".length; k++) await page.keyboard.press("ArrowLeft");
    await page.waitForTimeout(LOOKS);
    await page.locator(".tip-code strong", { hasText: /^speed:/ }).waitFor();
  }));

test("a number that is pulled over many steps is one entry in the list of runs", () =>
  withLab(`${ARM}let lag = 2.0s\narm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: lag)\n`, async (open) => {
    const page = await open();
    await untilStatus(page, /1 move, 2\.00 s/);
    const { x, y } = await placeOf(page, "let lag", "2.0");
    await page.keyboard.down("Alt");
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let k = 1; k <= 24; k++) {
      await page.mouse.move(x + 4 * k, y);
      await page.waitForTimeout(60);
    }
    await page.mouse.up();
    await page.keyboard.up("Alt");
    await untilStatus(page, /1 move, 4\.40 s/);
    await page.getByRole("tab", { name: /Runs/ }).click();
    await until(async () => (await page.locator(".run").count()) === 2, async () => `${await page.locator(".run").count()} runs`);
    // Undo goes back to before.
    await page.locator(".cm-content").focus();
    for (let k = 0; k < 30 && !/2\.00 s/.test(await status(page).innerText()); k++) {
      await page.keyboard.press("Control+z");
      await page.waitForTimeout(250);
    }
    await untilStatus(page, /1 move, 2\.00 s/);
  }));

test("the view and the program stay usable while the window changes its size", () =>
  withLab(`${ARM}arm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 2s)\n`, async (open) => {
    const page = await open();
    await untilStatus(page, /1 move, 2\.00 s/);
    for (const [width, height] of [[1440, 900], [390, 844], [1920, 1080], [1024, 700]]) {
      await page.setViewportSize({ width, height });
      await page.waitForTimeout(LOOKS);
      let canvas = null;
      await until(async () => {
        canvas = await page.locator(".stage canvas").boundingBox();
        return canvas.width > 180 && canvas.height > 150 && canvas.x >= 0 && canvas.x + canvas.width <= width && canvas.y + canvas.height <= height;
      }, () => `${width}: ${JSON.stringify(canvas)}`);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true);
    }
    await typeAtEnd(page, "arm.moveJ(posJ(0deg, 60deg, 50mm, 0deg), time: 1s)");
    await untilStatus(page, /2 moves, 3\.00 s/);
  }));

test("behind a number only units are offered", () =>
  withLab("var metal = 1\nwait(1s)\n", async (open) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    await typeAtEnd(page, "let h = 85m");
    await popup(page).filter({ hasText: /^mm\s*length$/ }).waitFor(); // with what it measures
    const offered = await popup(page).allInnerTexts();
    for (const name of ["metal", "max", "moveJ", "matrix"]) assert.ok(!offered.some((text) => text.startsWith(name)), `${name} is offered`);
  }));

test("a completion is taken by Enter when it was chosen, and by Tab", () =>
  withLab(`${ARM}wait(1s)\n`, async (open) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    await typeAtEnd(page, "arm.moveJ");
    await popup(page).first().waitFor();
    await page.keyboard.press("Enter");
    await page.keyboard.type("arm.homeP", KEY); // no such name
    await page.waitForTimeout(LOOKS);
    await page.keyboard.press("Enter");
    await page.keyboard.type("arm.mov", KEY);
    await popup(page).first().waitFor();
    await page.waitForTimeout(LOOKS);
    const [first, second] = (await popup(page).locator(".cm-completionLabel").allInnerTexts()).slice(0, 2);
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Enter");
    assert.ok((await program(page)).endsWith(`\narm.moveJ\narm.homeP\narm.${second}`), await program(page));
    await page.keyboard.press("Enter");
    await page.keyboard.type("arm.mov", KEY);
    await popup(page).first().waitFor();
    await page.waitForTimeout(LOOKS);
    await page.keyboard.press("Tab");
    assert.ok((await program(page)).endsWith(`\narm.${second}\narm.${first}`), await program(page));
  }));

test("a text that was loaded cannot be undone; what was written can", () =>
  withLab(null, async (open) => {
    const page = await open();
    await untilStatus(page, /\d moves, /);
    const [before, run] = [await program(page), await status(page).innerText()];
    const { x, y } = await placeOf(page, "robot", "robot");
    await page.mouse.click(x, y);
    await page.waitForTimeout(LOOKS);
    await page.keyboard.press("Control+z");
    await page.waitForTimeout(LOOKS);
    assert.equal(await program(page), before);
    await typeAtEnd(page, "wait(1s)");
    assert.notEqual(await program(page), before);
    await page.keyboard.press("Control+z");
    await page.waitForTimeout(LOOKS);
    await page.keyboard.press("Control+z");
    await page.waitForTimeout(LOOKS);
    assert.equal(await program(page), before);
    await untilStatus(page, new RegExp(`^${run.replaceAll(".", "\\.")}$`));
  }));

const WALL = `${ARM}object wall { shape: box(20mm, 800mm, 600mm); at: xyz(250mm, 0mm, 300mm) }
arm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 1s)
arm.moveJ(posJ(-40deg, 60deg, 50mm, 0deg), time: 1s)
`;

test("advice of a run stands among the problems, at its line, on the time bar and in the status", () =>
  withLab(WALL, async (open) => {
    const page = await open();
    await untilStatus(page, /^2 moves, 2\.00 s, 2 collisions$/);
    assert.equal(await status(page).getAttribute("data-kind"), "advice");
    const items = page.locator(".problem.advice");
    assert.equal(await items.filter({ hasText: "W0711" }).count(), 2);
    assert.match(await items.first().innerText(), /^3:5 .*collide/);
    await lineOf(page, "40deg, 60deg").locator(".cm-lintRange-warning").waitFor();
    await lineOf(page, "-40deg").locator(".cm-lintRange-warning").waitFor();
    const bar = await page.locator(".bar").boundingBox();
    for (let x = 70; x < bar.width - 20 && !/collide/.test(await page.locator(".bar-note").innerText()); x += 3) await page.mouse.move(bar.x + x, bar.y + 12);
    assert.match(await page.locator(".bar-note").innerText(), /collide/);
    await items.nth(1).getByRole("button", { name: /^\d\.\d\d s$/ }).click();
    await untilClock(page, /^(1|2)\.00 /);
    // Once the wall is gone, so is the advice.
    await lineOf(page, "object wall").click();
    await page.keyboard.press("Control+Shift+K"); // the line, wrapped or not
    await untilStatus(page, /^2 moves, 2\.00 s$/);
    assert.equal(await items.count(), 0);
    assert.equal(await status(page).getAttribute("data-kind"), "good");
  }));

test("advice that comes in every round of a loop is one problem that says how often", () =>
  withLab(`${ARM}for (i in [1, 2, 3, 4]) {
    arm.setJoints(posJ(0deg, 0deg, 0mm, 0deg))
    with (limits: "warn") { arm.moveJ(posJ(40deg, 60deg, 0mm, 0deg), time: 0.2s) }
}
`, async (open) => {
    const page = await open();
    await untilStatus(page, /4 moves, 0\.80 s, advice: 1/);
    await page.locator(".problem.advice", { hasText: /4 times/ }).waitFor();
  }));

const STEPS = `${ARM}let lag = 1.5s
wait(2s)
wait(lag)
wait(1s)
`;

test("a step goes on from where the page is: from the start after going to the start", () =>
  withLab(STEPS, async (open) => {
    const page = await open();
    await untilStatus(page, /4\.50 s/);
    await page.getByRole("tab", { name: "Variables" }).click();
    const keys = (name) => () => page.keyboard.press(name);
    const clicks = (name) => () => page.getByRole("button", { name, exact: true }).click();
    const now = async (pattern, line) => {
      await page.waitForTimeout(LOOKS);
      await untilClock(page, pattern);
      await currentLine(page, line).waitFor();
    };
    await page.locator("h1").click();
    for (const [start, over] of [[keys("Home"), keys("ArrowRight")], [clicks("To the start"), clicks("Step over")], [keys("Home"), clicks("Step over")]]) {
      for (let round = 0; round < 2; round++) {
        await start();
        await now(/^0\.00 /, "wait(2s)");
        await over();
        await now(/^2\.00 /, "wait(lag)");
        await over();
        await now(/^3\.50 /, "wait(1s)");
      }
    }
    // Without a pause, too; arrows on a button would be those of its bar.
    await page.locator("h1").click();
    await page.keyboard.press("Home");
    for (const key of ["ArrowRight", "ArrowRight", "Home", "ArrowRight"]) await page.keyboard.press(key);
    await currentLine(page, "wait(lag)").waitFor();
    await untilClock(page, /^2\.00 /);
    await page.locator(".variables tr", { hasText: "lag" }).filter({ hasText: "1.5 s" }).waitFor();
  }));

const LONG = `${ARM}${Array.from({ length: 38 }, (_, k) => `wait(${k + 1} * 0.01s)\n`).join("")}`;

test("the current line is scrolled into view by steps, the time bar and playing, and by nothing else", () =>
  withLab(LONG, async (open) => {
    const page = await open();
    await untilStatus(page, /7\.41 s/);
    await page.locator("h1").click();
    const inView = async () => {
      await until(async () => {
        const line = page.locator(".line-current");
        if ((await line.count()) !== 1) return false;
        const [box, editor] = [await line.boundingBox(), await page.locator(".cm-scroller").boundingBox()];
        return box !== null && box.y >= editor.y && box.y + box.height <= editor.y + editor.height + 1;
      }, async () => "the current line is not in view");
    };
    await page.keyboard.press("Home");
    await page.waitForTimeout(LOOKS);
    for (let k = 0; k < 38; k++) {
      await page.keyboard.press("ArrowRight");
      await page.waitForTimeout(120);
      if (k % 6 === 5) await inView();
    }
    await inView();
    const bar = await page.locator(".bar").boundingBox();
    for (const share of [0.02, 0.97, 0.4]) {
      await page.mouse.click(bar.x + 76 + share * (bar.width - 90), bar.y + 30);
      await page.waitForTimeout(LOOKS);
      await inView();
    }
    // Who writes at the start stays there, whatever the new run does.
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+Home");
    await page.keyboard.type("// a\n", KEY);
    await untilStatus(page, /7\.41 s/);
    await page.waitForTimeout(LOOKS);
    const scrolled = await page.locator(".cm-scroller").evaluate((box) => box.scrollTop);
    assert.ok(scrolled < 15, `scrolled by ${scrolled}`);
  }));
