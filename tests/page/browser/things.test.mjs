// Things in the 3D view: meshes and pictures, how near they are, contact forces, frames, planned paths, files that are dropped.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test, { after } from "node:test";
import { ARM, closeBrowser, dropFiles, goTo, GREEN, openPage, pixelsLike, recordingFile, RED, SHORT_MOVE, shows, until, untilStatus, viewTool, withLab } from "../laboratory.mjs";
import { root } from "../modules.mjs";
import { boxGlb, twoColours } from "../small_glb.mjs";

after(closeBrowser);

const picture = twoColours([230, 10, 10], [10, 200, 10]);
const SIZE = [0.3, 0.1, 0.2]; // y up
const PROGRAM = `${ARM}object sign { shape: mesh("sign.glb"); at: xyz(-300mm, -400mm, 60mm) }
${SHORT_MOVE}`;

const label = (page, text) => page.locator(".labels .label", { hasText: text }).first();

test("a mesh is drawn with its picture, and is asked for with the token and once", () =>
  withLab(PROGRAM, async (open, lab) => {
    const page = await open();
    const asked = [];
    page.on("request", (request) => request.url().includes("/file?") && asked.push(request.url()));
    await untilStatus(page, /1\.00 s/);
    await shows(page, "red", RED, 300);
    await shows(page, "green", GREEN, 300);
    await page.locator(".cm-content").focus();
    await page.keyboard.press("Control+End");
    await page.keyboard.insertText("wait(1s)\n");
    await untilStatus(page, /2\.00 s/);
    await shows(page, "red", RED, 300);
    assert.ok(asked.length <= 1, asked.join());
    // Nobody gets it without the token, and a name that is none gives nothing.
    const description = await page.evaluate(() => performance.getEntriesByType("resource").map((each) => each.name).find((name) => name.includes("/file?")));
    const address = new URL(description);
    assert.equal((await fetch(address)).status, 200);
    assert.match((await fetch(address)).headers.get("cache-control"), /immutable/);
    assert.deepEqual(Buffer.from(await (await fetch(address)).arrayBuffer()), readFileSync(join(lab.folder, "sign.glb")));
    for (const [name, value] of [["token", "wrong"], ["name", "../../etc/passwd"], ["name", ""]]) {
      const other = new URL(address);
      other.searchParams.set(name, value);
      const answer = await fetch(other);
      assert.ok([403, 404].includes(answer.status), `${answer.status} for ${other}`);
      await answer.text();
    }
  }, { "sign.glb": boxGlb(SIZE, { picture }) }));

test("surfaces have gloss and pictures are sharpened as with a graphics processor", () =>
  withLab(PROGRAM, async (open) => {
    const page = await open({ before: (opened) => opened.addInitScript(() => {
      const ask = WebGL2RenderingContext.prototype.getParameter;
      WebGL2RenderingContext.prototype.getParameter = function (name) {
        return name === 0x9246 ? "A graphics processor" : ask.call(this, name); // the unmasked name of what draws
      };
    }) });
    await untilStatus(page, /1\.00 s/);
    await shows(page, "red", RED, 300);
    await shows(page, "green", GREEN, 300);
  }, { "sign.glb": boxGlb(SIZE, { picture }) }));

test("a mesh without materials has the colour of its object; links are drawn as their meshes", () =>
  withLab(`robot arm {
    joint revolute(a: 300mm, mesh: "link.glb")
    joint revolute(a: 200mm)
}
object sign { shape: mesh("sign.glb"); at: xyz(-300mm, -300mm, 60mm); color: "lime" }
arm.moveJ(posJ(30deg, 30deg), time: 1s)
`, async (open) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    await shows(page, "green", GREEN, 300);
    await shows(page, "red", RED, 300);
  }, { "sign.glb": boxGlb(SIZE), "link.glb": boxGlb([0.2, 0.2, 0.2], { picture: twoColours([230, 10, 10], [230, 10, 10]) }) }));

const showsRedAndGreen = (objects, files) =>
  withLab(`${objects}\n${ARM}${SHORT_MOVE}`, async (open) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    await shows(page, "red", RED, 300);
    await shows(page, "green", GREEN, 300);
  }, files);

test("an object of a plain shape has the picture that the program names; a part of a file has its colour", () =>
  showsRedAndGreen(`object card { shape: box(400mm, 300mm, 50mm); at: xyz(0mm, 300mm, 100mm); texture: "card.png" }
object sign { shape: mesh("sign.glb", part: "node 0"); at: xyz(0mm, -300mm, 100mm); color: "lime" }`,
    { "card.png": twoColours([230, 10, 10], [230, 10, 10]), "sign.glb": boxGlb(SIZE) }));

test("a part of a file has its picture", () =>
  showsRedAndGreen(`object sign { shape: mesh("sign.glb", part: "node 0"); at: xyz(0mm, -300mm, 100mm) }`,
    { "sign.glb": boxGlb(SIZE, { picture }) }));

test("broken pictures and pictures elsewhere are left out, nothing is asked for, and the page goes on", () =>
  withLab(`object a { shape: mesh("a.glb"); at: xyz(-300mm, 0mm, 100mm) }
object b { shape: mesh("b.glb"); at: xyz(0mm, 0mm, 100mm) }
object c { shape: mesh("c.glb"); at: xyz(300mm, 0mm, 100mm) }
object ok { shape: box(100mm, 100mm, 100mm); at: xyz(0mm, 400mm, 50mm); color: "lime" }
${ARM}${SHORT_MOVE}`, async (open) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    await shows(page, "green", GREEN, 200);
    await page.waitForTimeout(500);
  }, {
    "a.glb": boxGlb(SIZE, { picture: Buffer.from("no picture at all") }),
    "b.glb": boxGlb(SIZE, { picture, change: (json) => (json.images = [{ uri: "http://example.org/a.png" }, { uri: "file:///etc/passwd" }]) }),
    "c.glb": boxGlb(SIZE, { picture: picture.subarray(0, 60), change: (json) => {
      json.extensionsUsed = ["KHR_texture_transform"];
      json.materials[0].extensions = { KHR_materials_clearcoat: { clearcoatTexture: { index: 7 } } };
    } }),
  }));

const run = { run: 1, state: "done", t_end: 1, label: "", parent: null, parts_at: null };
const recorded = (objects, files) => [
  { type: "welcome", protocol: 1, page: 1, file: "a.rbt", text: "", text_version: 1 },
  { type: "control", holder: 1, pages: [1], wishes: [] },
  { ...run, type: "run", text_version: 1, inputs: [], hash: "", error: null },
  ...Object.entries(files).map(([file, bytes]) => ({ file, binary: bytes.toString("base64") })),
  { type: "description", run: 1, robots: [], objects: objects.map((object) => ({ mass: 0, color: "gray", span: null, ...object })), elements: [], title: "", layout: "columns" },
  { type: "objects", run: 1, first: 0, items: objects.map((_, object) => ({ t: 0, what: "added", object, robot: null })) },
  { type: "shown", run: 1 },
];

for (const [shape, size] of [["box", [0.4, 0.3, 0.1]], ["plane", [0.4, 0.3]], ["cylinder", [0.15, 0.3]], ["sphere", [0.2]]]) {
  test(`a picture lies on a ${shape}, in a recording too`, async () => {
    const page = await openPage(recordingFile(recorded([{ name: "card", shape, size, texture: "p", pose: [0, 0, 0.2, 1, 0, 0, 0] }], { p: picture })));
    await shows(page, "red", RED, 300);
    await shows(page, "green", GREEN, 300);
    if (shape === "box") {
      // On its top, and not on its sides: from the front hardly any of it is seen.
      const above = await pixelsLike(page, RED);
      await page.getByRole("button", { name: "Front", exact: true }).click();
      await until(async () => (await pixelsLike(page, RED)) < 0.3 * above, () => "the front of the box is red");
    }
    assert.deepEqual(page.problems, []);
    await page.context().close();
  });
}

test("what overlaps is reported and coloured at each instant; a switch shows how near things are", () =>
  withLab(`robot arm = robots.scara()
object post { shape: box(60mm, 60mm, 400mm); at: xyz(350mm, 250mm, 200mm); fixed: true }
arm.moveJ(posJ(0deg, 60deg, 0mm, 0deg), time: 1s)
arm.moveJ(posJ(20deg, 40deg, 0mm, 0deg), time: 2s)
`, async (open) => {
    const page = await open();
    await untilStatus(page, /3\.00 s/);
    await goTo(page, 0.99);
    await label(page, / is [\d.]+ mm deep in "post"/).waitFor();
    await goTo(page, 0.02);
    await until(async () => (await page.locator(".labels .label", { hasText: /mm/ }).count()) === 0, () => "something is told that is not so");
    await (await viewTool(page, "Clearance")).click();
    await goTo(page, 0.6);
    await label(page, /: [\d.]+ mm to/).waitFor();
    const before = await label(page, / mm to /).innerText();
    await goTo(page, 0.65);
    await until(async () => (await page.locator(".labels .label", { hasText: / mm to / }).count()) > 0 && (await label(page, / mm to /).innerText()) !== before, () => `it stays ${before}`);
  }));

test("a contact force is an arrow where it acts, and nowhere else", () =>
  withLab(`robot arm = robots.scara(tool: tcp(xyz(z: 100mm)))
object block { shape: box(200mm, 200mm, 100mm); at: xyz(300mm, 200mm, 50mm); fixed: true; stiffness: 20N/mm }
arm.moveJ(xyz(300mm, 200mm, 130mm), time: 1s)
let down = arm.moveL(xyz(300mm, 200mm, 80mm), speed: 20mm/s) until arm.force().z > 8N
wait(2s)
`, async (open) => {
    const page = await open();
    await untilStatus(page, /\d s$/);
    await label(page, /^[\d.]+ N$/).waitFor();
    await goTo(page, 0.05);
    await until(async () => (await page.locator(".labels .label", { hasText: /^[\d.]+ N$/ }).count()) === 0, () => "a force is shown where nothing is touched");
  }));

test("each point that is pressed is reported, and arms can be seen as the bodies that collide", () =>
  withLab(`robot arm = robots.scara(tool: parallelGripper(stroke: 60mm))
object block { shape: box(200mm, 200mm, 100mm); at: xyz(300mm, 200mm, 50mm); fixed: true; stiffness: 20N/mm }
arm.moveJ(xyz(300mm, 200mm, 130mm), time: 1s)
let down = arm.moveL(xyz(300mm, 200mm, 80mm), speed: 20mm/s) until arm.force().z > 8N
wait(2s)
`, async (open) => {
    const page = await open();
    await untilStatus(page, /\d s$/);
    await label(page, /^[\d.]+ N$/).waitFor();
    assert.equal(await page.locator(".labels .label", { hasText: /N on block/ }).count(), 0);
    await (await viewTool(page, "Clearance")).click();
    await label(page, /^[\d.]+ N on block$/).waitFor();
    await (await viewTool(page, "Clearance")).click();
    await page.locator(".labels .label", { hasText: /N on block/ }).first().waitFor({ state: "detached" });
    // What lies over the view is in these pictures: nothing there is pointed at.
    const shot = async () => {
      await page.mouse.move(2, 2);
      return page.locator(".stage canvas").screenshot();
    };
    let drawn = await shot();
    await until(async () => drawn.equals((drawn = await shot())), () => "the picture does not rest");
    const solids = await viewTool(page, "Solids");
    await solids.click();
    await until(async () => !(await shot()).equals(drawn), () => "nothing is drawn otherwise");
    await solids.click();
    await until(async () => (await shot()).equals(drawn), () => "it is not drawn as before");
  }));

test("frames with names are where their objects are", () =>
  withLab(`robot arm = robots.scara()
object pallet { shape: box(300mm, 200mm, 20mm); at: xyz(300mm, 200mm, 10mm) }
frame corner { at: xyz(-150mm, -100mm, 10mm); on: pallet }
frame slot { at: xyz(60mm, 40mm); on: corner }
frame door { at: xyz(-300mm, 300mm, 0mm) }
arm.moveJ(posJ(30deg, 30deg, 0mm, 0deg), time: 1s)
pallet.setPose(xyz(0mm, -400mm, 10mm))
wait(1s)
`, async (open) => {
    const page = await open();
    await untilStatus(page, /2\.00 s/);
    for (const name of ["corner", "slot", "door"]) await label(page, name).waitFor();
    const late = await label(page, "slot").boundingBox();
    const door = await label(page, "door").boundingBox();
    await goTo(page, 0.2);
    await until(async () => {
      const early = await label(page, "slot").boundingBox();
      return early && Math.hypot(early.x - late.x, early.y - late.y) > 30;
    }, () => "the frame stays where the pallet is not");
    const still = await label(page, "door").boundingBox();
    assert.ok(Math.hypot(still.x - door.x, still.y - door.y) < 3);
  }));

test("a planned path is shown from when it was planned until it has been gone", () =>
  withLab(readFileSync(join(root, "examples/22_around_a_wall.rbt"), "utf8"), async (open) => {
    const page = await open();
    await untilStatus(page, /\d s$/);
    // 4.75 s: around the wall; 3.4 s: straight up; 9 s: along a path that was planned in the program.
    for (const [share, wanted] of [[0.42, true], [0.3, false], [0.8, true]]) {
      await goTo(page, share);
      await until(async () => ((await pixelsLike(page, [1, 12])) > 100) === wanted, () => `a way at ${share}: ${!wanted}`);
    }
  }));

test("a path that was planned before is shown while the program waits, and not when it has been followed", () =>
  withLab(`robot arm = robots.scara()
let go = arm.plan(to: posJ(60deg, -40deg, 0mm, 0deg), avoid: false)
wait(1s)
arm.follow(go)
wait(1s)
`, async (open) => {
    const page = await open();
    await untilStatus(page, /\d s$/);
    for (const [share, wanted] of [[0.1, true], [0.95, false]]) {
      await goTo(page, share);
      await until(async () => ((await pixelsLike(page, [1, 12])) > 100) === wanted, () => `a way at ${share}: ${!wanted}`);
    }
  }));

// ---- files that are dropped

const drop = (page, name, bytes, at) => dropFiles(page, { [name]: bytes }, at);
const program = (page) => page.locator(".cm-content").innerText();
const message = (page, text) => page.locator(".message", { hasText: text }).waitFor();

test("a file dropped onto the view is kept beside the program and becomes an object", () =>
  withLab(`${ARM}object block { shape: box(20mm, 20mm, 20mm); at: xyz(0mm, 400mm, 10mm) }\n${SHORT_MOVE}`, async (open, lab) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    await page.locator(".stage canvas").waitFor();
    const glb = boxGlb(SIZE, { picture });
    await drop(page, "../../evil/My sign!.glb", glb);
    await until(async () => /object my_?sign\w* \{ shape: mesh\("My-sign\.glb"\)/i.test(await program(page)), () => program(page));
    assert.deepEqual(readFileSync(join(lab.folder, "My-sign.glb")), glb);
    await shows(page, "red", RED, 200);
    // It stands on the floor, behind the objects that were there, and before the moves.
    assert.match(await program(page), /object block[^\n]*\n+object \w+ \{ shape: mesh\("My-sign\.glb"\); at: xyz\([^)]*, 50mm\) \}\n+arm\.moveJ/);
    // The same again is the same file; another one of the name does not replace it, nor does the target of a link.
    await drop(page, "My sign!.glb", glb, [0.3, 0.8]);
    await until(async () => (await program(page)).split("My-sign.glb").length === 3, () => program(page));
    symlinkSync("/nowhere", join(lab.folder, "My-sign-2.glb"));
    const other = boxGlb([0.1, 0.1, 0.1], { picture });
    await drop(page, "My-sign.glb", other, [0.7, 0.8]);
    await until(async () => (await program(page)).includes("My-sign-3.glb"), () => program(page));
    assert.deepEqual(readFileSync(join(lab.folder, "My-sign.glb")), glb);
    assert.deepEqual(readFileSync(join(lab.folder, "My-sign-3.glb")), other);
    // What is no mesh, and what is none of the formats, is refused.
    const before = await program(page);
    await drop(page, "a.glb", Buffer.from("nothing"));
    await message(page, /a\.glb/);
    await drop(page, "part.obj", Buffer.from("v 0 0 0\n"));
    await message(page, /part\.obj/);
    await drop(page, "huge.glb", 33 * 2 ** 20);
    await message(page, /33 MB/);
    assert.equal(await program(page), before);
    assert.deepEqual(readdirSync(lab.folder).sort(), ["My-sign-2.glb", "My-sign-3.glb", "My-sign.glb", "program.rbt"]);
    // A page that follows puts nothing there.
    const follower = await open();
    await untilStatus(follower, /1\.00 s/);
    await follower.locator(".stage canvas").waitFor();
    await drop(follower, "b.glb", glb);
    await message(follower, /control/);
    assert.ok(!readdirSync(lab.folder).includes("b.glb"));
  }));

// ---- in one file

const engine = join(root, "build/wasm/laboratory.html");
let skip = false;
try {
  readFileSync(engine);
} catch {
  skip = "there is no engine for pages: ./dev wasm";
}

async function inFolder(files, work) {
  const folder = mkdtempSync(join(tmpdir(), "armlet-things-"));
  try {
    for (const [name, bytes] of Object.entries(files)) writeFileSync(join(folder, name), bytes);
    await work(folder, (...given) => execFileSync(process.env.ARMLET_COMMAND, given, { cwd: folder, stdio: ["ignore", "pipe", "pipe"] }).toString());
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
const opened = async (file, work) => {
  const page = await openPage(`file://${file}`, { acceptDownloads: true });
  await work(page);
  assert.deepEqual(page.problems, []);
  await page.context().close();
};

test("a page that was recorded by the command has the meshes", () =>
  inFolder({ "a.rbt": PROGRAM, "sign.glb": boxGlb(SIZE, { picture }) }, async (folder, armlet) => {
    armlet("lab", "a.rbt", "--record", "a.html");
    await opened(join(folder, "a.html"), async (page) => {
      await untilStatus(page, /recording/);
      await shows(page, "red", RED, 300);
      await drop(page, "b.glb", boxGlb(SIZE));
      await message(page, /recording/);
    });
  }));

test("one file has its meshes in it, takes others, and is saved and recorded with them", { skip }, () =>
  inFolder({ "a.rbt": `${PROGRAM}`, "sign.glb": boxGlb(SIZE, { picture }) }, async (folder, armlet) => {
    armlet("lab", "a.rbt", "--export", "a.html", "--engine", engine);
    rmSync(join(folder, "sign.glb"));
    const hash = JSON.parse(/id="armlet-laboratory">([^<]*)</.exec(readFileSync(join(folder, "a.html"), "utf8"))[1]).runs[0].hash;
    const keep = async (page, button, name) => {
      const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: button }).click()]);
      await download.saveAs(join(folder, name));
    };
    await opened(join(folder, "a.html"), async (page) => {
      await untilStatus(page, /1 move, 1\.00 s/);
      assert.ok(!(await page.locator(".message").isVisible()), "the hash is that of the command");
      await shows(page, "red", RED, 300);
      await drop(page, "lamp.glb", boxGlb([0.1, 0.3, 0.1], { picture: twoColours([10, 200, 10], [10, 200, 10]) }), [0.7, 0.7]);
      await until(async () => (await program(page)).includes('mesh("lamp.glb")'), () => program(page));
      await untilStatus(page, /1 move, 1\.00 s/);
      await shows(page, "green", GREEN, 900);
      await keep(page, "Hand in", "handed.html");
      await keep(page, "Record", "recorded.html");
    });
    assert.match(hash, /^[0-9a-f]{16}$/);
    for (const name of ["handed.html", "recorded.html"]) {
      await opened(join(folder, name), async (page) => {
        await untilStatus(page, /1 move, 1\.00 s/);
        await shows(page, "red", RED, 300);
        await shows(page, "green", GREEN, 900);
      });
    }
  }));
