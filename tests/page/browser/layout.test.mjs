// Where the parts of the page are: their sizes, what covers what, and the same on a phone.
import assert from "node:assert/strict";
import test, { after } from "node:test";
import { ARM, closeBrowser, ONE_MOVE, status, typeAtEnd, until, untilStatus, withLab } from "../laboratory.mjs";
import { readPng } from "../small_png.mjs";

after(closeBrowser);

const LONG = `${ARM}arm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 1s) // ${"a remark of many words ".repeat(8)}\n`;
const SIZES = [[1024, 768], [1440, 900], [1920, 1080]];
const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

const box = (page, selector) => page.locator(selector).first().boundingBox();

async function drag(page, name, by) {
  const edge = await page.getByRole("separator", { name }).boundingBox();
  const [x, y] = [edge.x + edge.width / 2, edge.y + edge.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + by[0], y + by[1], { steps: 4 });
  await page.mouse.up();
}

test("edges between parts are dragged, moved with keys, remembered and restored", () =>
  withLab(ONE_MOVE, async (open) => {
    const page = await open({ viewport: { width: 1440, height: 900 } });
    await untilStatus(page, /1 move, 2\.00 s/);
    const widths = async () => Promise.all([".column.program", ".column.view", ".column.side"].map(async (each) => Math.round((await box(page, each)).width)));
    const before = await widths();
    await drag(page, "Width of the program", [120, 0]);
    const wider = await widths();
    assert.ok(Math.abs(wider[0] - before[0] - 120) <= 2 && Math.abs(wider[1] - before[1] + 120) <= 2 && wider[2] === before[2], `${before} became ${wider}`);
    await page.getByRole("separator", { name: "Width of the 3D view" }).focus();
    await page.keyboard.press("ArrowLeft");
    const moved = await widths();
    assert.ok(Math.abs(moved[2] - wider[2] - 24) <= 2 && moved[0] === wider[0], `${wider} became ${moved}`);
    await page.reload();
    await untilStatus(page, /1 move, 2\.00 s/);
    assert.deepEqual(await widths(), moved);
    await page.getByRole("separator", { name: "Width of the program" }).dblclick();
    await page.getByRole("separator", { name: "Width of the 3D view" }).dblclick();
    await page.getByRole("separator", { name: "Width of the program" }).dblclick();
    const restored = await widths();
    assert.ok(restored.every((each, i) => Math.abs(each - before[i]) <= 12), `${before} became ${restored}`);
    // No part can be dragged out of sight.
    await drag(page, "Width of the program", [-1000, 0]);
    assert.ok((await widths())[0] >= 150);
  }));

test("panels below the program have the height that they are dragged to", () =>
  withLab(ONE_MOVE, async (open) => {
    const page = await open();
    await untilStatus(page, /1 move, 2\.00 s/);
    await page.getByRole("tab", { name: "Variables" }).click();
    const before = (await box(page, ".below")).height;
    await drag(page, "Height of the program", [0, -100]);
    const after = (await box(page, ".below")).height;
    assert.ok(Math.abs(after - before - 100) < 8, `${before} became ${after}`);
    await page.reload();
    await untilStatus(page, /1 move, 2\.00 s/);
    await page.getByRole("tab", { name: "Variables" }).click();
    assert.ok(Math.abs((await box(page, ".below")).height - after) < 2);
  }));

test("long lines are wrapped, until they shall not be", () =>
  withLab(LONG, async (open) => {
    const page = await open({ viewport: { width: 1440, height: 900 } });
    await untilStatus(page, /1 move, 1\.00 s/);
    const sideways = () => page.locator(".cm-scroller").evaluate((scroller) => scroller.scrollWidth - scroller.clientWidth);
    assert.ok((await sideways()) <= 1);
    // The duration beside the line covers nothing of it.
    const [line, margin] = [await box(page, ".cm-line >> nth=1"), await box(page, ".gutter-margin span")];
    assert.ok(line.height > 30 && line.x + line.width <= margin.x + 1, JSON.stringify([line, margin]));
    await page.getByRole("button", { name: "Wrap long lines" }).click();
    assert.ok((await sideways()) > 100);
    await page.reload();
    await untilStatus(page, /1 move, 1\.00 s/);
    assert.ok((await sideways()) > 100);
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Alt+z");
    assert.ok((await sideways()) <= 1);
  }));

test("the panels are one line high while there are no problems; what is being written stays visible when they grow", () =>
  withLab(`${ARM}${"wait(0.1s)\n".repeat(60)}`, async (open) => {
    const page = await open();
    await untilStatus(page, /6\.00 s/);
    const flat = (await box(page, ".below")).height;
    assert.ok(flat <= 40, `${flat} px`);
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+End");
    await page.keyboard.type("nothing()\nnever()\n", { delay: 40 });
    await untilStatus(page, /2 mistakes/);
    await page.waitForTimeout(300);
    assert.ok((await box(page, ".below")).height > flat + 20);
    const [cursor, editor] = [await box(page, ".cm-cursor-primary"), await box(page, ".cm-scroller")];
    assert.ok(cursor.y >= editor.y && cursor.y + cursor.height <= editor.y + editor.height + 2, "the cursor is out of view");
  }));

test("play stays where it is, whatever the status says", () =>
  withLab(ONE_MOVE, async (open) => {
    for (const [width, height] of SIZES) {
      const page = await open({ viewport: { width, height } });
      await untilStatus(page, /1 move/);
      const place = () => box(page, 'footer button[aria-label="Play"]');
      const before = await place();
      assert.ok(before.x < 120, `play is at x = ${before.x}`);
      await page.evaluate(() => (document.querySelector(".status").textContent = "a status of very many words ".repeat(6)));
      assert.deepEqual(await place(), before);
      await page.context().close();
    }
  }));

// Buttons, fields and labels whose middle belongs to something else; without those that are scrolled out of view.
const covered = (page) => page.evaluate(() => {
  const inside = (element) => {
    const own = element.getBoundingClientRect();
    if (own.width === 0 || own.bottom > innerHeight || own.right > innerWidth || own.top < 0 || own.left < 0) return false;
    for (let up = element.parentElement; up; up = up.parentElement) {
      if (getComputedStyle(up).overflow === "visible") continue;
      const clip = up.getBoundingClientRect();
      if (own.top < clip.top - 1 || own.bottom > clip.bottom + 1 || own.left < clip.left - 1 || own.right > clip.right + 1) return false;
    }
    return true;
  };
  const all = [...document.querySelectorAll("button:not(.face), select, input, output, .hint, .reason, .status")].filter((each) => each.checkVisibility() && inside(each));
  return all.flatMap((each) => {
    const own = each.getBoundingClientRect();
    const found = document.elementFromPoint(own.x + own.width / 2, own.y + own.height / 2);
    return found && (each.contains(found) || found.contains(each)) ? [] : [`${each.outerHTML.slice(0, 80)} is covered by ${found?.outerHTML.slice(0, 80)}`];
  });
});

// Pairs of things over the 3D view that overlap.
const overlapping = (page) => page.evaluate(() => {
  const all = [...document.querySelectorAll(".over button:not(.face), .over select, .over output, .over .legend, .view-cube, .over .hint, .over .reason")].filter((each) => each.checkVisibility());
  const boxes = all.map((each) => [each, each.getBoundingClientRect()]).filter(([, own]) => own.width > 0);
  return boxes.flatMap(([a, p], i) => boxes.slice(i + 1).flatMap(([b, q]) =>
    !a.contains(b) && p.left < q.right - 1 && q.left < p.right - 1 && p.top < q.bottom - 1 && q.top < p.bottom - 1 ? [`${a.outerHTML.slice(0, 70)} and ${b.outerHTML.slice(0, 70)}`] : []));
});

const TWO = `robot left = robots.scara()
robot right = robots.scara(base: xyz(1500mm, 0mm, 0mm))
left.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 1s)
right.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 1s)
lab cell {
    sliders joints(of: left)
    torques load(of: left)
}
`;

test("nothing is drawn over anything else, with all tools open, on screens of four sizes", async () => {
  for (const text of [TWO, null]) {
    await withLab(text, async (open) => {
      for (const options of [...SIZES.map(([width, height]) => ({ viewport: { width, height } })), PHONE]) {
        const page = await open(options);
        await untilStatus(page, /moves/);
        await page.locator(".scene-tools").waitFor();
        const more = page.getByRole("button", { name: "More tools" });
        if (await more.isVisible()) await more.click();
        await page.waitForTimeout(300);
        assert.deepEqual(await overlapping(page), [], JSON.stringify(options));
        assert.deepEqual(await covered(page), [], JSON.stringify(options));
        await page.context().close();
      }
    });
  }
});

test("on a phone the 3D view is above the sliders, targets are large, and hints are for fingers", () =>
  withLab(null, async (open) => {
    const page = await open(PHONE);
    await untilStatus(page, /moves/);
    await page.locator(".stage canvas").waitFor();
    const hints = await page.locator(".hint").allInnerTexts();
    assert.equal(hints.length, 3);
    for (const hint of hints) assert.doesNotMatch(hint, /Alt|wheel|Point at/);
    const [view, slider] = [await box(page, ".stage canvas"), await box(page, ".slider")];
    assert.ok(view.height > 150 && view.y + view.height <= slider.y, JSON.stringify([view, slider]));
    const small = () => page.evaluate(() => [...document.querySelectorAll("button, select, input")].filter((each) => each.checkVisibility()).flatMap((each) => {
      const { width, height } = each.getBoundingClientRect();
      return height < 43.5 || (width < 43.5 && !each.classList.contains("link")) ? [`${each.outerHTML.slice(0, 90)}: ${width} x ${height}`] : [];
    }));
    for (const part of ["Laboratory", "3D view", "Program"]) {
      await page.locator("nav.phone").getByRole("button", { name: part }).tap();
      await page.waitForTimeout(200);
      assert.deepEqual(await small(), [], part);
    }
    // A number is changed with buttons beside it.
    await page.locator(".cm-line", { hasText: "moveJ(home, time: 1.5s)" }).evaluate((line) => line.scrollIntoView({ block: "center" }));
    const there = await page.locator(".cm-line", { hasText: "moveJ(home, time: 1.5s)" }).evaluate((line) => {
      const walker = document.createTreeWalker(line, NodeFilter.SHOW_TEXT);
      for (let node = walker.nextNode(); node; node = walker.nextNode()) {
        const at = node.data.indexOf("1.5");
        if (at < 0) continue;
        const range = document.createRange();
        range.setStart(node, at);
        range.setEnd(node, at + 3);
        const own = range.getBoundingClientRect();
        return [own.x + own.width / 2, own.y + own.height / 2];
      }
    });
    await page.touchscreen.tap(...there);
    await page.getByRole("button", { name: "More", exact: true }).tap();
    await page.locator(".cm-line", { hasText: "moveJ(home, time: 1.6s)" }).waitFor();
    await untilStatus(page, /9\.84 s/);
  }));

test("a program that begins with a mistake has a floor, and the cube of views stands upright", () =>
  withLab("robot arm = robots.nothing()\n", async (open) => {
    const page = await open();
    await untilStatus(page, /1 mistake/);
    assert.equal(await status(page).getAttribute("data-kind"), "error");
    await page.locator(".stage canvas").waitFor();
    await page.waitForTimeout(500);
    const turned = await page.locator(".view-cube .cube").evaluate((cube) => getComputedStyle(cube).transform);
    assert.match(turned, /^matrix3d/);
    const { data } = readPng(await page.locator(".stage canvas").screenshot());
    const found = new Set();
    for (let i = 0; i < data.length; i += 3) found.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
    assert.ok(found.size > 40, `${found.size} colours: there is no floor`);
  }));

test("a position is inserted as a move behind the current statement, or as a value where one is written", () =>
  withLab(`// A remark.\n${ONE_MOVE}fn rest(t: time) {\n    wait(t)\n}\nrest(0.5s)\n`, async (open) => {
    const page = await open();
    await untilStatus(page, /1 move, 2\.50 s/);
    const program = () => page.locator(".cm-content").evaluate((content) => [...content.querySelectorAll(".cm-line")].map((line) => line.textContent).join("\n"));
    const bar = await page.locator(".bar").boundingBox();
    await page.mouse.click(bar.x + 76 + 0.4 * (bar.width - 90), bar.y + 30);
    await page.locator(".line-current", { hasText: "time: 2s" }).waitFor();
    await page.getByRole("button", { name: "Insert posJ" }).click();
    await until(async () => /time: 2s\)\narm\.moveJ\(posJ\([^)]*\)\)\nfn rest/.test(await program()), program);
    await untilStatus(page, /2 moves/);
    await page.getByRole("button", { name: "To the end" }).click();
    await page.getByRole("button", { name: "Insert posC" }).click();
    await until(async () => /wait\(t\)\n {4}arm\.moveJ\(pose\([^)]*\)\)\n}/.test(await program()), program);
    await untilStatus(page, /3 moves/);
    await typeAtEnd(page, "\narm.moveL(");
    await page.getByRole("button", { name: "Insert posC" }).click();
    await until(async () => /\narm\.moveL\(pose\([^)]*\)/.test(await program()), program);
    assert.ok((await program()).startsWith("// A remark.\nrobot arm"));
  }));
