// The program and its file: it is saved, followed when another program changes it, and begun from a gallery.
import assert from "node:assert/strict";
import { existsSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import test, { after } from "node:test";
import { closeBrowser, lineOf, ONE_MOVE, openPage, status, typeAtEnd, until, untilStatus, withLab } from "../laboratory.mjs";

after(closeBrowser);

const MORE = "arm.moveJ(posJ(0deg, 60deg, 50mm, 0deg), time: 1s)\n";
const text = (lab) => readFileSync(join(lab.folder, "program.rbt"), "utf8");
const isMarked = async (page) => /^●/.test(await page.title()) && (await page.locator(".unsaved").isVisible());
const untilMarked = (page, wanted) => until(async () => (await isMarked(page)) === wanted, () => `the page ${wanted ? "does not mark" : "marks"} unsaved edits`);

test("Ctrl S writes the file; unsaved edits are marked until then", () =>
  withLab(ONE_MOVE, async (open, lab) => {
    const page = await open();
    await untilStatus(page, /2\.00 s/);
    await untilMarked(page, false);
    await typeAtEnd(page, MORE);
    await untilMarked(page, true);
    assert.match(await page.locator(".file").innerText(), /^program\.rbt \(edited\)/);
    assert.equal(text(lab), ONE_MOVE);
    await page.keyboard.press("Control+s");
    await untilMarked(page, false);
    assert.equal(text(lab), ONE_MOVE + MORE);
    // Back to the saved text by hand: there is nothing to save any more.
    await typeAtEnd(page, "// x");
    await untilMarked(page, true);
    for (let i = 0; i < 4; i++) await page.keyboard.press("Backspace");
    await untilMarked(page, false);
  }));

test("a page with unsaved edits warns before it is closed, a saved one does not", () =>
  withLab(ONE_MOVE, async (open) => {
    const page = await open();
    await untilStatus(page, /2\.00 s/);
    const asked = [];
    page.on("dialog", (dialog) => {
      asked.push(dialog.type());
      void dialog.accept();
    });
    await typeAtEnd(page, MORE);
    await untilMarked(page, true);
    await page.reload();
    assert.deepEqual(asked, ["beforeunload"]);
    await untilStatus(page, /2 moves, 3\.00 s/);
    await page.getByRole("button", { name: "Save", exact: true }).click();
    await untilMarked(page, false);
    await page.reload();
    await untilStatus(page, /2 moves, 3\.00 s/);
    assert.deepEqual(asked, ["beforeunload"]);
  }));

test("a change from outside appears on a page without edits; with edits the page asks", () =>
  withLab(ONE_MOVE, async (open, lab) => {
    const page = await open();
    await untilStatus(page, /1 move, 2\.00 s/);
    writeFileSync(join(lab.folder, "program.rbt"), ONE_MOVE + MORE);
    await untilStatus(page, /2 moves, 3\.00 s/);
    await untilMarked(page, false);
    const question = page.locator(".offer", { hasText: "was changed by another program" });
    assert.equal(await question.isVisible(), false);

    await typeAtEnd(page, "// mine\n");
    await untilMarked(page, true);
    writeFileSync(join(lab.folder, "program.rbt"), "// theirs\n");
    await question.waitFor();
    assert.match(await question.innerText(), /^program\.rbt was changed by another program\./);
    await question.getByRole("button", { name: "Later" }).click();
    await question.waitFor({ state: "hidden" });
    await page.keyboard.press("Control+s"); // asks again, and writes nothing
    await question.waitFor();
    assert.equal(text(lab), "// theirs\n");
    await question.getByRole("button", { name: "Load it" }).click();
    await question.waitFor({ state: "hidden" });
    await lineOf(page, "theirs").waitFor();
    await untilMarked(page, false);
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+z"); // what was typed is not lost
    await lineOf(page, "mine").waitFor();
    await untilMarked(page, true);

    writeFileSync(join(lab.folder, "program.rbt"), "// theirs again\n");
    await question.waitFor();
    await question.getByRole("button", { name: "Replace it" }).click();
    await question.waitFor({ state: "hidden" });
    await untilMarked(page, false);
    assert.equal(text(lab), `${ONE_MOVE}${MORE}// mine\n`);
  }));

test("what cannot be saved says why; a page that follows cannot save", () =>
  withLab(ONE_MOVE, async (open, lab) => {
    const page = await open();
    await untilStatus(page, /2\.00 s/);
    const other = await open();
    await untilStatus(other, /2\.00 s/);
    assert.equal(await other.getByRole("button", { name: "Save", exact: true }).isDisabled(), true);
    await typeAtEnd(page, MORE);
    await untilMarked(page, true);
    await other.keyboard.press("Control+s");
    await other.getByText("Another page is in control; take it first.").waitFor();
    assert.equal(text(lab), ONE_MOVE);
    rmSync(lab.folder, { recursive: true });
    await page.keyboard.press("Control+s");
    await page.getByText(/program\.rbt cannot be written: /).waitFor();
    assert.equal(await isMarked(page), true);
    assert.equal(existsSync(lab.folder), false);
  }));

test("a program that has no file yet begins from a template, and the first save makes the file", () =>
  withLab(null, async (open, lab) => {
    const page = await open();
    await untilStatus(page, /3 moves/);
    assert.equal(existsSync(join(lab.folder, "new.rbt")), false);
    await untilMarked(page, true);
    await page.keyboard.press("Control+s");
    await untilMarked(page, false);
    assert.match(readFileSync(join(lab.folder, "new.rbt"), "utf8"), /^\/\/ An arm/);
  }, {}, "new.rbt"));

const GALLERY = ["An arm", "Pick and place", "Kinematics", "Planners", "Dynamics", "Hand-over", "Eye in the hand"];

test("each program of the gallery runs at one click, without advice, and can be undone", () =>
  withLab(ONE_MOVE, async (open, lab) => {
    const page = await open();
    await untilStatus(page, /1 move, 2\.00 s/);
    for (const name of GALLERY) {
      await page.getByRole("button", { name: "New", exact: true }).click();
      await page.getByRole("dialog", { name: "New program" }).getByRole("button", { name }).click();
      await until(async () => /^\d+ moves?, /.test(await status(page).innerText()) && !/ 2\.00 s/.test(await status(page).innerText()), async () => `${name}: ${await status(page).innerText()}`);
      assert.equal(await status(page).getAttribute("data-kind"), "good", `${name}: ${await status(page).innerText()}`);
      await page.locator(".cm-content").focus();
      await page.keyboard.press("Control+z");
      await untilStatus(page, /^1 move, 2\.00 s/);
    }
    assert.equal(text(lab), ONE_MOVE);
  }));

test("an empty program offers the gallery in the view", () =>
  withLab("", async (open) => {
    const page = await open({ viewport: { width: 390, height: 780 } });
    const offered = page.getByRole("region", { name: "Programs to begin with" });
    await offered.waitFor();
    assert.deepEqual(await offered.locator("strong").allInnerTexts(), GALLERY);
    for (const card of await offered.getByRole("button").all()) assert.ok((await card.boundingBox()).height >= 44);
    await offered.getByRole("button", { name: "Kinematics" }).click();
    await offered.waitFor({ state: "hidden" });
    await untilStatus(page, /^2 moves, 5\.00 s/);
  }));

test("Share makes a file: no link with the token or an address of this computer", () =>
  withLab(ONE_MOVE, async (open, lab) => {
    const page = await open();
    await untilStatus(page, /2\.00 s/);
    await page.evaluate(() => {
      globalThis.copied = [];
      navigator.clipboard.writeText = async (copy) => void globalThis.copied.push(copy);
    });
    const token = lab.address.split("=")[1];
    const shared = async (name) => {
      await page.getByRole("button", { name: "Share" }).click();
      const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("dialog", { name: "Share" }).getByRole("button", { name }).click()]);
      const content = readFileSync(await download.path(), "utf8");
      assert.ok(!content.includes(token) && !content.includes("127.0.0.1:"), `${name} tells the address of the laboratory`);
      return [download.suggestedFilename(), content];
    };
    assert.deepEqual(await shared("The program"), ["program.rbt", ONE_MOVE]);
    const [name, content] = await shared("This run as a page");
    assert.equal(name, "program.html");
    assert.deepEqual(await page.evaluate(() => globalThis.copied), []);
    assert.equal(new URL(page.url()).hash, "");
    const recording = join(lab.folder, "shared.html");
    writeFileSync(recording, content);
    const other = await openPage(`file://${recording}`);
    await untilStatus(other, /^recording, 1 move, 2\.00 s/);
    await other.context().close();
  }));
