// What the page says of variables, and what its fields do.
import assert from "node:assert/strict";
import test, { after } from "node:test";
import { ARM, closeBrowser, status, typeAtEnd, until, untilStatus, withLab } from "../laboratory.mjs";

after(closeBrowser);

test("variables are values: no functions, nothing that waits for its host", () =>
  withLab(`${ARM}fn rest(t: time) {\n    wait(t)\n}\nlet name = "hand"\nlet twice = fn(x: double) => 2 * x\nrest(1s)\nprint(name)\n`, async (open) => {
    const page = await open();
    await until(async () => /s$|mistake/.test(await status(page).innerText()), () => status(page).innerText());
    if (/mistake/.test(await status(page).innerText())) assert.fail(await page.locator(".problem").first().innerText());
    await page.getByRole("tab", { name: "Variables" }).click();
    const row = page.locator(".variables tr", { hasText: "name" });
    await row.filter({ hasText: "hand" }).waitFor();
    assert.equal(await row.count(), 1);
    const text = await page.locator("#panel-variables").innerText();
    assert.doesNotMatch(text, /twice|rest|host/);
  }));

const FIELDS = `robot arm = robots.scara()
lab bench {
    field load(2kg, range: [0kg, 5kg])
    field lag(1s, range: [0.5s, 3s])
}
arm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: bench.lag)
`;

test("a refused value does not stay in its field; the program runs with the values of the fields, and is reset", () =>
  withLab(FIELDS, async (open) => {
    const page = await open();
    await untilStatus(page, /1 move, 1\.00 s/);
    const load = page.getByRole("spinbutton", { name: /load in kg/ });
    await load.fill("99");
    await load.press("Enter");
    await page.locator(".element .reason", { hasText: /\S/ }).first().waitFor();
    await until(async () => Number(await load.inputValue()) === 2, async () => `the field shows ${await load.inputValue()}`);
    const values = page.getByRole("button", { name: "Run with these values" });
    const reset = page.getByRole("button", { name: "Reset" });
    assert.equal(await values.isDisabled(), true);
    assert.equal(await reset.isDisabled(), true);
    const lag = page.getByRole("spinbutton", { name: /lag in s/ });
    await lag.fill("2.5");
    await lag.press("Enter");
    await until(async () => !(await reset.isDisabled()), () => "there is nothing to reset");
    await reset.click();
    await until(async () => Number(await lag.inputValue()) === 1, async () => `the field shows ${await lag.inputValue()}`);
    await lag.fill("2.5");
    await lag.press("Enter");
    await until(async () => !(await values.isDisabled()), () => "the values are those of the start");
    await values.click();
    await untilStatus(page, /1 move, 2\.50 s/);
    await page.locator(".cm-line", { hasText: "field lag(2.5s, range: [0.5s, 3s])" }).waitFor();
    await page.locator(".cm-line", { hasText: "field load(2kg" }).waitFor();
    await typeAtEnd(page, "wait(1s)\n");
    await untilStatus(page, /1 move, 3\.50 s/);
  }));
