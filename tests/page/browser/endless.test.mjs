// Programs that do not end, and moves to where the robot is: what the page says of them.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { join } from "node:path";
import test, { after } from "node:test";
import { ARM, closeBrowser, status, untilStatus, withLab } from "../laboratory.mjs";

after(closeBrowser);

test("a program that never ends keeps its robot, and the status names its line while it runs", () =>
  withLab(`${ARM}arm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 1s)\nvar k = 0\nwhile (true) {\n    k += 1\n}\n`, async (open) => {
    const page = await open();
    await untilStatus(page, /^running at line [45], 1\.0 s/);
    assert.ok((await page.locator(".slider").count()) >= 4);
    assert.match(await page.locator("output.where").innerText(), /arm at/);
    // It is stopped by the next text.
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+End");
    for (let line = 0; line < 4; line++) await page.keyboard.press("Shift+ArrowUp");
    await page.keyboard.press("Delete");
    await untilStatus(page, /^1 move, 1\.00 s$/);
  }));

test("the page counts moves as the command does, also those to where the robot is", () =>
  withLab(`${ARM}arm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 1s)\narm.moveJ(posJ(40deg, 60deg, 50mm, 0deg))\narm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 1s)\narm.moveJ(posJ(0deg, 60deg, 50mm, 0deg), time: 1s)\n`, async (open, lab) => {
    const said = spawnSync(process.env.ARMLET_COMMAND, ["run", join(lab.folder, "program.rbt")], { encoding: "utf8" }).stderr;
    const moves = /, (\d+) moves/.exec(said)[1];
    assert.equal(moves, "4");
    const page = await open();
    await untilStatus(page, /^4 moves, 3\.00 s$/);
    assert.equal(await status(page).getAttribute("data-kind"), "good");
    assert.match(await page.locator(".gutter-margin").innerText(), /0\.00 s/);
  }));
