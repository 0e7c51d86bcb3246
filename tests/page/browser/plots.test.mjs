// Plots, figures and matrices: values at the cursor, one cursor, large, names and units.
import assert from "node:assert/strict";
import test, { after } from "node:test";
import { ARM, closeBrowser, openPage, recordingFile, untilStatus, until, violations, withLab } from "../laboratory.mjs";

after(closeBrowser);

const LAB = `${ARM}lab plots {
    plot q(fn() => arm.joints(), label: "joint angles")
    plot qdd(fn() => arm.jointAccels(), label: "joint accelerations")
    table M(fn() => arm.massMatrix(arm.joints()))
}
arm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 2s)
`;
const legend = (page, name) => page.getByRole("group", { name, exact: true }).locator(".u-legend .u-series");
const textsOf = (series) => series.evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.innerText.replaceAll(/\s+/g, " ").trim()).join(" ")));
const texts = (page, name) => textsOf(legend(page, name));

test("plots name their joints, show values at the instant, and have one cursor", () =>
  withLab(LAB, async (open) => {
    const page = await open({ viewport: { width: 1440, height: 900 } });
    await untilStatus(page, /1 move, 2\.00 s/);
    await until(async () => (await texts(page, "joint accelerations")).length === 5, () => "no plot");
    const names = async (plot) => (await texts(page, plot)).map((text) => text.split(/[: ]/)[0]);
    assert.deepEqual(await names("joint angles"), ["t", "q1", "q2", "q3", "q4"]);
    assert.deepEqual(await names("joint accelerations"), ["t", "q1", "q2", "q3", "q4"]);
    await until(async () => /^t:? 2\.000 s$/.test((await texts(page, "joint angles"))[0]), async () => String(await texts(page, "joint angles")));
    assert.match((await texts(page, "joint angles"))[1], /^q1:? 40\.00 deg$/);
    assert.match((await texts(page, "joint angles"))[3], /^q3:? 50\.00 mm$/);
    // The cursor in the first plot is in the second one, too.
    const over = await page.getByRole("group", { name: "joint angles" }).locator(".u-over").boundingBox();
    await page.mouse.move(over.x + over.width / 2, over.y + over.height / 2);
    for (const plot of ["joint angles", "joint accelerations"])
      await until(async () => /^t:? (0\.9|1\.0)\d\d s$/.test((await texts(page, plot))[0]), async () => String(await texts(page, plot)));
    await page.mouse.move(5, 400);
    await until(async () => /^t:? 2\.000 s$/.test((await texts(page, "joint accelerations"))[0]), async () => String(await texts(page, "joint accelerations")));
  }));

test("a plot is shown large, and small again with Escape", () =>
  withLab(LAB, async (open) => {
    const page = await open({ viewport: { width: 1440, height: 900 } });
    await untilStatus(page, /2\.00 s/);
    const canvas = page.getByRole("group", { name: "joint angles" }).locator("canvas");
    const before = await canvas.boundingBox();
    await page.getByRole("button", { name: "Show joint angles large" }).click();
    await until(async () => (await canvas.boundingBox()).width > 900 && (await canvas.boundingBox()).height > 400, () => "it is not large");
    assert.deepEqual(await violations(page), []);
    await page.keyboard.press("Escape");
    await until(async () => Math.abs((await canvas.boundingBox()).width - before.width) < 3, () => "it is not small again");
  }));

test("a matrix fits into the column, with names of rows and columns", () =>
  withLab(LAB.replace("robots.scara()", "robots.puma560()").replace("posJ(40deg, 60deg, 50mm, 0deg)", "posJ(0deg, 45deg, -90deg, 0deg, 45deg, 0deg)").replace("2s", "4s"), async (open) => {
    const page = await open({ viewport: { width: 1440, height: 900 } });
    await untilStatus(page, /4\.00 s/);
    const table = page.getByRole("group", { name: "M", exact: true });
    await table.locator("tbody tr").nth(5).waitFor();
    const names = ["q1", "q2", "q3", "q4", "q5", "q6"];
    assert.deepEqual(await table.locator("thead th").allInnerTexts(), names);
    assert.deepEqual(await table.locator("tbody th").allInnerTexts(), names);
    for (const text of await table.locator("tbody td").allInnerTexts()) assert.match(text, /^(0|−?\d\.\d{3})$/);
    assert.equal(await table.locator(".scroll").evaluate((scroll) => scroll.scrollWidth <= scroll.clientWidth + 1), true);
  }));

test("a plot whose moves stand above the lab block says so", () =>
  withLab(`${ARM}arm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 2s)\nlab late {\n    plot q(fn() => arm.joints(), label: "joint angles")\n}\n`, async (open) => {
    const page = await open();
    await untilStatus(page, /1 move, 2\.00 s/);
    await page.getByText("The moves stand above the lab block (line 4), and plots begin with it. Write the block above the moves.").waitFor();
  }));

const FIGURES = `${ARM}let points = [posJ(0deg, 0deg, 0mm, 0deg), posJ(90deg, 60deg, 100mm, 45deg)]
figure("one joint")
for (name in ["Cubic", "Trap"]) { plot(trajectory(name, points, time: 2s, robot: arm), joint: 1, label: name) }
figure("map")
plot([0mm, 100mm, 0mm], [0mm, 50mm, 100mm])
arm.moveJ(points[1])
`;

test("a figure is a plot with values at the cursor, large on demand; a map is a picture", () =>
  withLab(FIGURES, async (open) => {
    const page = await open({ viewport: { width: 1440, height: 900 } });
    await untilStatus(page, /1 move/);
    const figure = page.getByRole("group", { name: "one joint" });
    await until(async () => (await figure.locator("canvas").count()) === 3, () => "there are not three panels");
    const panels = figure.locator(".u-legend");
    const panel = (k) => textsOf(panels.nth(k).locator(".u-series"));
    assert.match((await panel(0)).join("; "), /^t:? 2\.000 s; Cubic:? 90\.00 deg; Trap:? 90\.00 deg$/);
    await figure.locator(".u-over").first().scrollIntoViewIfNeeded();
    const over = await figure.locator(".u-over").first().boundingBox();
    await page.mouse.move(over.x + over.width / 2, over.y + over.height / 2);
    // Half of the way in the middle of the time, with the largest speed of a cubic, 1.5 times the mean.
    await until(async () => /Cubic:? 4[45]\.\d+ deg/.test((await panel(0)).join()), async () => String(await panel(0)));
    await until(async () => /Cubic:? 67\.[45]\d deg\/s/.test((await panel(1)).join()), async () => String(await panel(1)));
    await page.getByRole("button", { name: "Show one joint large" }).click();
    await until(async () => (await figure.locator("canvas").first().boundingBox()).width > 900, () => "it is not large");
    await page.keyboard.press("Escape");
    const map = page.getByRole("group", { name: "map" });
    assert.equal(await map.locator("canvas").count(), 0);
    await page.getByRole("button", { name: "Show map large" }).click();
    await until(async () => (await map.locator("img").boundingBox()).width > 900, () => "the picture is not large");
    assert.deepEqual(await violations(page), []);
  }));

test("a recording keeps the values of its figures", async () => {
  const axis = (unit) => ({ label: "", unit, log: false });
  const series = [{ kind: "line", label: "a", right: false, x: [0, 1, 2], y: [0, 1, 2] }];
  const page = await openPage(recordingFile([
    { type: "welcome", protocol: 1, page: 1, file: "x.rbt", text: "", text_version: 0 },
    { type: "run", run: 1, state: "done", t_end: 2, text_version: 0, inputs: [] },
    { type: "description", run: 1, robots: [], objects: [], elements: [] },
    { type: "figures", run: 1, index: 0, title: "kept", svg: "<svg xmlns='http://www.w3.org/2000/svg'/>", panels: [{ title: "", x: axis("s"), y: axis("rad"), right: axis(""), series }] },
    { type: "shown", run: 1 },
  ]));
  await page.getByRole("group", { name: "kept" }).locator("canvas").waitFor();
  assert.deepEqual(page.problems, []);
  await page.context().close();
});
