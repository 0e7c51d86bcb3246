// Elements of a laboratory: shown from a recording, so that texts of any kind can be tried; moved on a laboratory that runs.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test, { after } from "node:test";
import { ARM, closeBrowser, openPage, recordingFile, saved, typeAtEnd, until, untilStatus, viewTool, violations, withLab } from "../laboratory.mjs";
import { twoColours } from "../small_glb.mjs";

after(closeBrowser);

const HOSTILE = `**Bold** and $q_1 = \\frac{\\pi}{2}$.

<img src="x" onerror="hacked = 1"><script>hacked = 2</script><a href="javascript:hacked = 3">link</a>
<svg onload="hacked = 4"></svg><iframe srcdoc="<script>parent.hacked = 5</script>"></iframe><form action="https://example.org"><button>send</button></form>

$$\\href{javascript:hacked=6}{x} + \\int_0^1 t^2\\,dt$$
`;
const NAME = '<img src=x onerror="hacked = 7">';

function recording() {
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const joint = { unit: "rad", lower: -2, upper: 2, max_speed: 1, T_before_joint: identity, T_joint_link: [...identity.slice(0, 12), 0.4, 0, 0.1, 1] };
  const tool = { kind: "none", stroke: 0, radius: 0, length: 0, T_flange_tool: identity };
  const shapes = [{ link: 1, kind: "capsule", role: "link", radius: 0.04, length: 0.4, T: identity }];
  const columns = 11;
  const rows = Array.from({ length: 101 }, (_, k) => [k / 50, k / 100, 0.5, 0, 0.4 * Math.cos(k / 100), 0.4 * Math.sin(k / 100), 0.1, 1, 0, 0, 0]);
  const binary = Buffer.alloc(24 + 8 * columns * rows.length);
  [1, 1, 0, columns, rows.length, 0].forEach((word, i) => binary.writeUInt32LE(word, 4 * i));
  rows.flat().forEach((value, i) => binary.writeDoubleLE(value, 24 + 8 * i));
  const svg = '<svg xmlns="http://www.w3.org/2000/svg" width="40" height="40"><script>parent.hacked = 8</script><circle r="9" cx="20" cy="20"/></svg>';
  const elements = [
    { kind: "text", name: "intro", text: HOSTILE },
    { kind: "table", name: "dh", label: NAME, header: ["a", NAME] },
    { kind: "plot", name: "q of arm", label: "Angles" },
    { kind: "image", name: "photo" },
    { kind: "button", name: "go", label: NAME },
    { kind: "weather", name: "rain" },
  ];
  return [
    { type: "welcome", protocol: 1, page: 1, file: NAME, text: `// ${NAME}\nlet a = 1\n`, text_version: 1, words: {} },
    { type: "control", holder: 1, pages: [1], wishes: [] },
    { type: "diagnostics", text_version: 1, runs: true, items: [{ severity: "advice", code: "W0701", message: NAME, span: [2, 0, 2, 3], why: NAME }] },
    { type: "run", run: 1, state: "done", t_end: 2, label: NAME, text_version: 1, inputs: [], hash: "", error: null },
    { type: "runs", list: [{ run: 1, state: "done", t_end: 2, label: NAME, parent: null, parts_at: null }] },
    { type: "description", run: 1, robots: [{ name: "arm", home: [0], joints: [joint], T_world_base: identity, tool, shapes }], objects: [], elements, title: NAME },
    { type: "shown", run: 1 },
    { type: "notes", run: 1, first: 0, items: [{ t: 1, kind: "output", text: NAME, span: null }] },
    { type: "figures", run: 1, index: 0, title: NAME, svg },
    { type: "elements", run: 1, t: 2, values: { dh: { value: [[1.5, NAME]] }, photo: { error: NAME } } },
    { binary: binary.toString("base64") },
  ];
}

test("a saved recording shows everything from a disk, and runs nothing of a program's texts", async () => {
  const page = await openPage(recordingFile(recording()));
  await untilStatus(page, /recording, 2\.00 s/);
  await page.locator(".rich strong", { hasText: "Bold" }).waitFor();
  assert.ok((await page.locator(".rich .katex").count()) >= 2);
  await page.locator(".elements td", { hasText: NAME }).waitFor();
  await page.locator(".plot canvas").waitFor();
  await page.getByText('does not know elements of the kind "weather"').waitFor();
  for (const name of ["Output", "Runs", "Problems"]) await page.getByRole("tab", { name }).click();
  await page.locator(".figures img").waitFor();
  await page.waitForTimeout(300);
  assert.equal(await page.evaluate(() => globalThis.hacked), undefined);
  assert.equal(await page.locator("main iframe, main form, .rich script, a[href^='javascript']").count(), 0);
  await page.evaluate(() => {
    const image = document.createElement("img");
    image.setAttribute("onerror", "hacked = 9");
    image.src = "data:image/png;base64,none";
    document.body.append(image);
  });
  await until(async () => page.problems.some((problem) => /Content Security Policy/.test(problem)), () => "the page's policy lets scripts of attributes run");
  assert.equal(await page.evaluate(() => globalThis.hacked), undefined);
  assert.deepEqual(page.problems.filter((problem) => !/Content Security Policy/.test(problem)), []);
  await page.context().close();
});

test("a plot is saved as CSV, PNG and SVG, the view as PNG; a click goes to its instant", async () => {
  const page = await openPage(recordingFile(recording()));
  await untilStatus(page, /recording/);
  await page.locator(".plot canvas").waitFor();
  const savedAs = async (name) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name }).click()]);
    const chunks = [];
    for await (const chunk of await download.createReadStream()) chunks.push(chunk);
    return Buffer.concat(chunks);
  };
  const csv = String(await savedAs("Save Angles as CSV")).trim().split("\n");
  assert.equal(csv[0], "t [s],q1 [deg]");
  assert.equal(csv.length, 102);
  assert.ok(Math.abs(Number(csv[101].split(",")[1]) - 180 / Math.PI) < 1e-9);
  assert.match(String(await savedAs("Save Angles as SVG")), /<polyline/);
  const isPng = (data) => data.subarray(1, 4).toString() === "PNG" && data.length > 1000;
  assert.ok(isPng(await savedAs("Save Angles as PNG")));
  await viewTool(page, "PNG");
  assert.ok(isPng(await savedAs(/^PNG$/)));
  const over = await page.locator(".plot .u-over").boundingBox();
  await page.mouse.click(over.x + over.width / 2, over.y + over.height / 2);
  await until(async () => /^(0\.9|1\.0)/.test(await page.locator("output.time").innerText()), () => "the instant is not in the middle");
  assert.deepEqual(await violations(page), []);
  await page.context().close();
});

const LAB = `robot arm = robots.scara()
object cube { shape: box(40mm, 40mm, 40mm); at: xyz(400mm, 120mm, 180mm); mass: 200g }
fn pick() { arm.moveJ(above(poseOf(cube), 80mm), time: 1s) }
arm.moveJ(posJ(10deg, 60deg, 50mm, 0deg), time: 1s)

lab scaraLab {
    title: "SCARA laboratory"
    text intro("Reach is $r = a_1 + a_2$.")
    sliders joints(of: arm)
    sliders hand(of: arm, as: "x y z roll")
    field clearance(80mm, range: [20mm, 200mm])
    button pickIt("Pick up", fn() { pick() })
    plot angles(fn() => arm.joints())
}
`;

test("a slider moves the arm; where it cannot, the reason stands at the slider", () =>
  withLab(LAB, async (open) => {
    const page = await open();
    await page.getByRole("heading", { name: "SCARA laboratory" }).waitFor();
    await page.locator(".rich .katex").waitFor();
    const hand = page.locator("output.where");
    const before = await hand.innerText();
    const q1 = page.getByRole("slider", { name: /^q1/ });
    await q1.focus();
    await page.keyboard.press("ArrowRight");
    await until(async () => (await hand.innerText()) !== before, () => "the hand has not moved");
    const x = page.getByRole("spinbutton", { name: "x in mm" });
    await x.fill("5000");
    await x.press("Enter");
    await page.locator(".element .reason", { hasText: /reach/ }).waitFor();
    await page.getByRole("button", { name: "Pick up" }).click();
    await untilStatus(page, /2 moves/);
  }));

test("what a button could not do stands at it, and in the output, at its time", () =>
  withLab(`${LAB}arm.moveJ(posJ(50deg, 60deg, 50mm, 0deg), time: 2s)\n`, async (open) => {
    const page = await open();
    await untilStatus(page, /2 moves, 3\.00 s/);
    const bar = await page.locator(".bar").boundingBox();
    await page.mouse.click(bar.x + 0.7 * bar.width, bar.y + 30);
    await page.getByRole("button", { name: "Pick up" }).click();
    const reason = page.locator(".element", { hasText: "Pick up" }).locator(".reason");
    await until(async () => /already moving/.test(await reason.innerText()), () => reason.innerText());
    await page.getByRole("tab", { name: /Output/ }).click();
    const note = page.locator(".note", { hasText: "already moving" });
    const panel = await page.locator(".output").boundingBox();
    const box = await note.boundingBox();
    assert.ok(box.x >= panel.x && box.x + box.width <= panel.x + panel.width + 1, "the note is where the output is");
    await page.getByRole("button", { name: "To the start" }).click();
    await until(async () => (await reason.innerText()) === "", () => "it is told before it has happened");
  }));

test("a slider moves its own joint and no other, a table has its units", () =>
  withLab(`robot arm = robots.scara()
lab cell {
    sliders joints(of: arm)
    table here(fn() => [arm.joints()], header: ["a", "b", "c", "d"])
}
arm.moveJ(posJ(10deg, 60.123deg, 50.0456mm, 0deg), time: 1s)
`, async (open) => {
    const page = await open();
    await untilStatus(page, /1 move, 1\.00 s/);
    const cells = () => page.locator(".elements td").allInnerTexts();
    await until(async () => (await cells()).join() === "10,60.123,50.046,0", async () => (await cells()).join());
    assert.deepEqual(await page.locator(".elements thead th").allInnerTexts(), ["a [deg]", "b [deg]", "c [mm]", "d [deg]"]);
    await page.getByRole("slider", { name: /^q1/ }).focus();
    await page.keyboard.press("ArrowRight");
    await until(async () => (await cells()).join() === "10.1,60.123,50.046,0", async () => (await cells()).join());
  }));

test("a run is recorded as a page that shows it from a disk", () =>
  withLab(null, async (open) => {
    const page = await open();
    await untilStatus(page, /moves/);
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Record" }).click()]);
    const file = await saved(download);
    const status = (await page.locator(".status").innerText()).trim();
    const alone = await openPage(`file://${file}`);
    await untilStatus(alone, /recording, /);
    assert.equal((await alone.locator(".status").innerText()).replace("recording, ", "").trim(), status);
    assert.equal(await alone.locator("output.where").innerText(), await page.locator("output.where").innerText());
    assert.deepEqual(alone.problems, []);
    await alone.context().close();
  }));

test("speeds and torques of joints are plotted in their units, each on its own axis", () =>
  withLab(`robot arm = robots.scara()
robot puma = robots.puma560(base: xyz(2m, 0mm, 0mm))
struct Now { w: double[]; tau: double }
lab cell {
    plot speeds(fn() => arm.jointSpeeds())
    plot tau(fn() => puma.torques())
    table now(fn() => [Now(arm.jointSpeeds(), puma.torques()[1])])
}
arm.moveJ(posJ(90deg, 0deg, 100mm, 0deg), time: 1s)
`, async (open) => {
    const page = await open({ acceptDownloads: true });
    await untilStatus(page, /1\.00 s/);
    const head = async (name) => {
      const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: `Save ${name} as CSV` }).click()]);
      return readFileSync(await download.path(), "utf8").split("\n");
    };
    await page.locator(".u-over").nth(1).waitFor();
    const speeds = await head("speeds");
    assert.equal(speeds[0], "t [s],q1 [deg/s],q2 [deg/s],q3 [mm/s],q4 [deg/s]");
    // 90 degrees and 100 mm in a second.
    const most = (k) => Math.max(...speeds.slice(1, -1).map((line) => Number(line.split(",")[k])));
    assert.ok(most(1) > 90 && most(1) < 400, `${most(1)} deg/s`);
    assert.ok(Math.abs(most(3) / most(1) - 100 / 90) < 1e-3, `${most(3)} mm/s`);
    assert.match((await head("tau"))[0], /^t \[s\],q1 \[N m\]/);
    const table = page.locator(".element", { hasText: "now" });
    await table.locator("th", { hasText: "tau [N m]" }).waitFor();
    await table.locator("td", { hasText: /^\[0 deg\/s, 0 deg\/s, 0 mm\/s, 0 deg\/s\]$/ }).waitFor();
  }));

test("a picture beside the program is an element, and is part of a recording", () =>
  withLab(`lab cell { image photo("cell.png", label: "The cell") }\nwait(1s)\n`, async (open) => {
    const page = await open({ acceptDownloads: true });
    await untilStatus(page, /1\.00 s/);
    const width = (of) => of.locator('img[alt="The cell"]').evaluate((image) => image.naturalWidth);
    await until(async () => (await width(page)) > 0, () => "it is not shown");
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Record" }).click()]);
    const recorded = await openPage(`file://${await saved(download)}`);
    await until(async () => (await width(recorded)) > 0, () => "it is not in the recording");
    assert.deepEqual(recorded.problems, []);
    await recorded.context().close();
  }, { "cell.png": twoColours([230, 10, 10], [10, 200, 10]) }));

const ARM_MOVED = `${ARM}arm.moveJ(posJ(10deg, 60deg, 50mm, 0deg), time: 1s)\n`;

test("the tools over the view stand in one line in a narrow view, and those that are on stay", () =>
  withLab(ARM_MOVED, async (open) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    const tools = page.locator(".scene-tools");
    await tools.waitFor();
    assert.ok((await tools.boundingBox()).height < 32, "one line");
    assert.ok(!(await tools.getByRole("button", { name: "Frames" }).isVisible()));
    await (await viewTool(page, "Frames")).click();
    await page.getByRole("button", { name: "More tools" }).click();
    assert.ok(await tools.getByRole("button", { name: "Frames" }).isVisible());
    assert.ok(!(await tools.getByRole("button", { name: "PNG" }).isVisible()));
    await page.setViewportSize({ width: 1700, height: 800 });
    assert.ok(await tools.getByRole("button", { name: "PNG" }).isVisible());
    assert.ok((await tools.boundingBox()).height < 32, "one line in a wide view, too");
  }));

test("the tool is pulled in the view: the arm follows, and says why where it cannot", () =>
  withLab(ARM_MOVED, async (open) => {
    const page = await open();
    await untilStatus(page, /1 move, 1\.00 s/);
    await (await viewTool(page, "Frames")).click();
    const label = page.locator(".label", { hasText: /^tool$/ });
    await label.waitFor();
    const before = await page.locator("output.where").innerText();
    // The label is put at the tool by the next picture; then the ball is beside it.
    let box = null;
    await until(async () => {
      const last = box;
      await page.waitForTimeout(200);
      box = await label.boundingBox();
      return last !== null && box.x === last.x && box.y === last.y && (await label.evaluate((element) => element.style.transform !== ""));
    }, () => "the label does not rest");
    const [x, y] = [box.x - 6, box.y + 8];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 400, y - 300, { steps: 4 });
    await page.locator(".hand .reason", { hasText: /reach|stops/ }).waitFor();
    await page.mouse.move(x - 20, y - 5, { steps: 3 });
    await until(async () => (await page.locator(".hand .reason").innerText()) === "", () => "the reason stays");
    await page.mouse.up();
    await until(async () => (await page.locator("output.where").innerText()) !== before, () => "the arm does not follow");
    await page.getByRole("button", { name: "Insert posJ" }).click();
    await page.locator(".cm-line", { hasText: /^arm\.moveJ\(posJ\(.*deg\)\)/ }).waitFor();
    await page.getByRole("button", { name: "Insert posC" }).click();
    await page.locator(".cm-line", { hasText: /^arm\.moveJ\(pose\(x: .*mm, .*yaw: .*deg\)\)/ }).waitFor();
  }));

test("the view is saved as a drawing, without what is hidden", () =>
  withLab("robot arm = robots.scara()\nobject near { shape: box(200mm, 20mm, 200mm); at: xyz(300mm, -500mm, 100mm); color: \"red\" }\nobject behind { shape: box(20mm, 20mm, 20mm); at: xyz(300mm, -450mm, 100mm); color: \"lime\" }\nwait(1s)\n", async (open) => {
    const page = await open({ acceptDownloads: true });
    await untilStatus(page, /1\.00 s/);
    await page.getByRole("toolbar", { name: "3D view" }).getByRole("button", { name: "Front" }).click();
    const tool = await viewTool(page, "SVG");
    const [download] = await Promise.all([page.waitForEvent("download"), tool.click()]);
    const svg = readFileSync(await download.path(), "utf8");
    const colors = new Set([...svg.matchAll(/<path [^>]*fill="(#\w+)"/g)].map((found) => found[1]));
    assert.ok([...colors].some((color) => /^#[89a-f][0-9a-f]0000$/.test(color)), "the red box is there");
    assert.ok(![...colors].some((color) => /^#00[0-9a-f]{2}00$/.test(color)), "what is behind it is not");
    assert.ok(!/NaN/.test(svg) && svg.length < 2e6, `${svg.length} bytes`);
  }));

test("the run is saved as a film of the view", () =>
  withLab("robot arm = robots.scara()\narm.moveJ(posJ(40deg, 60deg, 50mm, 0deg), time: 1s)\n", async (open) => {
    const page = await open({ acceptDownloads: true });
    await untilStatus(page, /1 move, 1\.00 s/);
    const tool = await viewTool(page, "Video");
    const [download] = await Promise.all([page.waitForEvent("download"), tool.click()]);
    assert.equal(download.suggestedFilename(), "view.webm");
    const film = readFileSync(await download.path());
    assert.deepEqual([...film.subarray(0, 4)], [0x1a, 0x45, 0xdf, 0xa3]);
    assert.ok(film.length > 2000, `${film.length} bytes`);
    await page.getByRole("button", { name: "Video", exact: true }).waitFor();
  }));

test("a tool slider that is pulled too far shows where the arm comes nearest, as does a goal out of reach", () =>
  withLab("robot arm = robots.scara()\nlab cell {\n    sliders hand(of: arm, as: \"x y z roll\")\n}\n", async (open) => {
    const page = await open();
    await untilStatus(page, /0\.00 s/);
    await page.getByRole("spinbutton", { name: /^x in mm/ }).fill("900");
    await page.keyboard.press("Enter");
    await page.locator(".label.warning", { hasText: /^\d+ mm too far$/ }).waitFor();
    await typeAtEnd(page, "arm.moveL(xyz(5m, 0mm, 100mm), speed: 100mm/s)\n");
    await untilStatus(page, /failed/);
    await page.locator(".label.warning", { hasText: /out of reach.*: \d+ mm too far$/ }).waitFor();
  }));

const LOADED = `robot arm = robots.puma560(tool: parallelGripper(stroke: 60mm))
fn reach() { arm.moveJ(posJ(0deg, 10deg, -80deg, 0deg, 0deg, 0deg), time: 4s); arm.setPayload(loads.mass); arm.setLink(3, friction: [loads.rub]) }
lab loads {
    field mass(0kg, range: [0kg, 8kg])
    field rub(0.001, range: [0.0, 0.01])
    button go("Reach", reach)
    torques bars(of: arm)
    table M(fn() => arm.massMatrix())
}
wait(1s)
`;

test("bars and a table show what motors give; a load and friction set at the page change the run", () =>
  withLab(LOADED, async (open) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    const rows = page.locator(".torques tr");
    assert.equal(await rows.count(), 6);
    const joint2 = async () => Number((await rows.nth(1).locator("td").first().innerText()).replace("−", "-"));
    const pressed = page.getByRole("button", { name: "Torques" });
    await until(async () => (await pressed.getAttribute("aria-pressed")) === "true", () => "the bars are not there from the start");
    await page.getByRole("button", { name: "Reach", exact: true }).click();
    await untilStatus(page, /5\.00 s/);
    const bare = await joint2();
    await page.getByRole("spinbutton", { name: /^mass/ }).fill("8");
    await page.keyboard.press("Enter");
    await page.getByRole("button", { name: "Reach", exact: true }).click();
    await untilStatus(page, /\d\.\d\d s/);
    // 8 kg at the tool, more than half a metre in front of joint 2.
    await until(async () => Math.abs(await joint2()) > Math.abs(bare) + 8 * 9.81 * 0.5, async () => `${bare} N m, and ${await joint2()} with the load`);
    await page.locator(".label", { hasText: /joint 2: \d+ %/ }).waitFor();
    // The bars are part of the picture of the view.
    const shot = () => page.locator(".stage canvas").screenshot();
    const withBars = await shot();
    await pressed.click();
    await until(async () => !(await shot()).equals(withBars), () => "the picture is the same without bars");
    assert.equal(await page.locator(".label", { hasText: "joint 2" }).count(), 0);
    // A row's title leads to where the program says it.
    await page.locator(".element h2", { hasText: "bars" }).click();
    await page.locator(".cm-activeLineGutter", { hasText: /^7$/ }).waitFor();
    assert.deepEqual(await violations(page), []);
  }));
