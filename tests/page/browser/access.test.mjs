// The page on a phone, from the keyboard, and for those who listen to it.
import assert from "node:assert/strict";
import test, { after } from "node:test";
import { clock, closeBrowser, ONE_MOVE, until, untilStatus, violations, withLab } from "../laboratory.mjs";

after(closeBrowser);

test("on a phone the parts are tabs, and nothing is wider than the screen", () =>
  withLab(null, async (open) => {
    const page = await open({ viewport: { width: 390, height: 780 }, hasTouch: true, isMobile: true });
    await untilStatus(page, /moves/);
    for (const [name, part] of [["Laboratory", ".column.side"], ["Program", ".cm-editor"], ["3D view", ".stage canvas"]]) {
      await page.getByRole("button", { name, exact: true }).tap();
      const box = await page.locator(part).boundingBox();
      assert.ok(box && box.width > 300 && box.height > 150, `${name} is ${JSON.stringify(box)}`);
    }
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
    assert.deepEqual(await violations(page), []);
  }));

test("a program that has not run yet says why in the view; a tap leads to its first mistake", () =>
  withLab("robot arm = robots.scara()\nlet far = 1m\narm.movL(xyz(far, 0mm, 0mm))\n", async (open) => {
    const page = await open({ viewport: { width: 390, height: 800 } });
    await untilStatus(page, /1 mistake/);
    const note = page.locator(".no-run");
    assert.match(await note.innerText(), /^The program has not run yet\. Line 3: there is nothing called `movL`$/);
    await note.click();
    await page.locator(".cm-activeLineGutter", { hasText: /^3$/ }).waitFor();
    await page.getByRole("button", { name: /^Fix: .*moveL/ }).click();
    await untilStatus(page, /failed/); // out of reach, but it has run
    assert.ok(!(await note.isVisible()));
  }));

test("everything is reached and worked from the keyboard", () =>
  withLab(`${ONE_MOVE}arm.moveJ(posJ(0deg, 60deg, 50mm, 0deg), time: 1s)\n`, async (open) => {
    const page = await open();
    await untilStatus(page, /3\.00 s/);
    await page.locator(".stage canvas").waitFor();
    const seen = new Set();
    for (let k = 0; k < 90; k++) {
      await page.keyboard.press("Tab");
      const name = await page.evaluate(() => {
        const focused = document.activeElement;
        return focused === document.body ? "" : `${focused.tagName} ${focused.getAttribute("aria-label") ?? focused.textContent.slice(0, 30)}`;
      });
      seen.add(name);
      if (name.startsWith("DIV Program")) await page.keyboard.press("Escape");
    }
    for (const wanted of [/^BUTTON Share/, /^DIV Program/, /^BUTTON Problems/, /^CANVAS 3D view/, /^INPUT q1, deg/, /^BUTTON Play/, /^DIV Time/, /^BUTTON Step over/]) {
      assert.ok([...seen].some((name) => wanted.test(name)), `${wanted} is not reached: ${[...seen].join(", ")}`);
    }
    await page.locator(".bar").focus();
    const time = async (pattern) => until(async () => pattern.test(await clock(page).innerText()), async () => `${await clock(page).innerText()} is not ${pattern}`);
    await page.keyboard.press("Home");
    await time(/^0\.00 /);
    await page.keyboard.press("Shift+ArrowRight");
    await time(/^2\.00 /);
    await page.keyboard.press("End");
    await time(/^3\.00 /);
    await page.keyboard.press("?");
    await page.getByRole("dialog", { name: "Keys" }).waitFor();
    await page.keyboard.press("Escape");
    await page.getByRole("dialog", { name: "Keys" }).waitFor({ state: "hidden" });
    await page.keyboard.press("/");
    await page.getByRole("dialog", { name: "Keys" }).waitFor();
    await page.keyboard.type("next break");
    assert.deepEqual(await page.locator(".help dt:visible").allInnerTexts(), ["F5"]);
    // A late event of the browser about the search before does not clear the present search.
    await page.evaluate(() => document.querySelector(".help").dispatchEvent(new Event("close")));
    assert.deepEqual(await page.locator(".help dt:visible").allInnerTexts(), ["F5"]);
    await page.keyboard.press("Escape");
    await page.keyboard.press("/");
    assert.ok((await page.locator(".help dt:visible").count()) > 10, "what was searched before is still searched");
    await page.keyboard.press("Escape");
    await page.getByRole("spinbutton", { name: "q1 in deg" }).focus();
    await page.keyboard.press("Control+a");
    await page.keyboard.type("25");
    await page.keyboard.press("Enter");
    await until(async () => (await page.getByRole("slider", { name: "q1, deg" }).inputValue()) === "25", () => "q1 is not 25");
  }));

for (const colorScheme of ["light", "dark"]) {
  test(`axe finds nothing to complain about, ${colorScheme}`, () =>
    withLab(null, async (open) => {
      const page = await open({ colorScheme });
      await untilStatus(page, /moves/);
      await page.getByRole("button", { name: "Got it" }).first().click();
      assert.deepEqual(await violations(page), []);
    }));
}

test("the hints of the first time go away for good", () =>
  withLab(null, async (open) => {
    const page = await open();
    await untilStatus(page, /moves/);
    assert.deepEqual(await page.locator(".hint").evaluateAll((all) => all.map((hint) => hint.querySelectorAll("p").length)), [3, 3, 3]);
    const buttons = page.getByRole("button", { name: "Got it" });
    while (await buttons.count()) await buttons.first().click();
    await page.reload();
    await untilStatus(page, /moves/);
    await page.locator(".stage canvas").waitFor();
    assert.equal(await page.locator(".hint").count(), 0);
  }));

test("without a 3D view everything else is there", () =>
  withLab(null, async (open) => {
    const page = await open({ before: (fresh) => fresh.addInitScript(() => {
      const context = HTMLCanvasElement.prototype.getContext;
      HTMLCanvasElement.prototype.getContext = function (kind, ...given) {
        return kind.startsWith("webgl") ? null : context.call(this, kind, ...given);
      };
    }) });
    await untilStatus(page, /moves/);
    await page.getByText(/There is no 3D view/).waitFor();
    assert.ok(await page.getByRole("slider").count() > 4);
    assert.ok(await page.locator(".bar").isVisible());
    page.problems = page.problems.filter((problem) => !/WebGL/.test(problem));
  }));

test("About names the software in the page and its engine, with licences", () =>
  withLab(ONE_MOVE, async (open) => {
    const page = await open();
    await page.getByRole("button", { name: "Keys and help" }).click();
    await page.getByRole("button", { name: "About", exact: true }).click();
    const about = page.getByRole("dialog", { name: "About" });
    for (const name of ["three 0.", "CodeMirror view", "KaTeX fonts", "DOMPurify", "marked", "uPlot", "ANTLR", "fmt", "Eigen", "CLI11", "musl", "OMPL"])
      assert.ok((await about.innerText()).includes(name), `About does not name ${name}`);
    await about.getByText("OFL-1.1", { exact: true }).last().click();
    await about.getByText(/The goals of the Open Font License/).waitFor();
    assert.deepEqual(await violations(page), []);
    await about.getByRole("button", { name: "Close" }).click();
    assert.equal(await about.isVisible(), false);
  }));
