// Meshes of other formats than GLB that are dropped onto the 3D view, with the files that they name.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import test, { after } from "node:test";
import { gzipSync } from "node:zlib";
import { ARM, closeBrowser, dropFiles, openPage, pixelsLike, RED, SHORT_MOVE, until, untilStatus, withLab } from "../laboratory.mjs";
import { root, source } from "../modules.mjs";
import { trianglesOfGlb, twoColours } from "../small_glb.mjs";
import { obj, ply, plyText, stl, stlText } from "../small_meshes.mjs";

after(closeBrowser);

// A box of 300 x 200 x 400 mm, z up, every face with the whole picture.
const OBJ = `mtllib sign.mtl
${[0, 1].map((z) => [[0, 0], [0.3, 0], [0.3, 0.2], [0, 0.2]].map(([x, y]) => `v ${x} ${y} ${0.4 * z}`).join("\n")).join("\n")}
vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1
usemtl paint
${[[4, 3, 2, 1], [5, 6, 7, 8], [1, 2, 6, 5], [2, 3, 7, 6], [3, 4, 8, 7], [4, 1, 5, 8]].map((face) => `f ${face.map((v, k) => `${v}/${k + 1}`).join(" ")}`).join("\n")}
`;
const FILES = {
  "sign.obj": Buffer.from(OBJ),
  "sign.mtl": Buffer.from("newmtl paint\nKd 1 1 1\nmap_Kd .\\PAINT.PNG\n"),
  "paint.png": twoColours([230, 10, 10], [230, 10, 10]),
};

const converter = join(dirname(process.env.ARMLET_COMMAND ?? ""), "armlet-mesh");

test("a mesh with material and picture becomes a GLB beside the program", { skip: existsSync(converter) ? false : "there is no converter" }, () =>
  withLab(`${ARM}${SHORT_MOVE}`, async (open, lab) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    await page.locator(".stage canvas").waitFor();
    await dropFiles(page, FILES);
    const program = () => page.locator(".cm-content").innerText();
    // It stands on the floor: its frame is in the middle.
    await until(async () => /object sign\w* \{ shape: mesh\("sign\.glb"\); at: xyz\([^)]*, 200mm\) \}/.test(await program()), program);
    assert.equal(readFileSync(join(lab.folder, "sign.glb")).subarray(0, 4).toString(), "glTF");
    assert.deepEqual(readdirSync(lab.folder).sort(), ["program.rbt", "sign.glb"]);
    await until(async () => (await pixelsLike(page, RED)) > 200, () => "the picture is not seen");
    await dropFiles(page, { "broken.wrl": Buffer.from("#VRML V2.0 utf8\nInline { url \"/etc/passwd\" }\n") });
    await page.locator(".message", { hasText: /broken\.wrl.*Inline/ }).waitFor();
    assert.deepEqual(readdirSync(lab.folder).sort(), ["program.rbt", "sign.glb"]);
  }));

test("a part that was drawn in millimetres is offered in millimetres", { skip: existsSync(converter) ? false : "there is no converter" }, () =>
  withLab(`${ARM}${SHORT_MOVE}`, async (open) => {
    const page = await open();
    await untilStatus(page, /1\.00 s/);
    await page.locator(".stage canvas").waitFor();
    const millimetres = OBJ.replace(/^v (.*)$/gm, (_, numbers) => `v ${numbers.split(" ").map((each) => 150 * Number(each)).join(" ")}`); // 60 mm high
    const drop = () => dropFiles(page, { "part.obj": Buffer.from(millimetres.replace(/^(mtllib|usemtl).*$/gm, "")) });
    const question = page.getByRole("dialog", { name: "Unit of lengths" });
    const program = () => page.locator(".cm-content").innerText();
    await drop();
    await question.getByText("part.obj would be 60 m large.").waitFor();
    await question.getByRole("button", { name: "Leave it out" }).click();
    assert.doesNotMatch(await program(), /mesh/);
    await drop();
    await question.getByRole("button", { name: "Millimetres: 60 mm" }).click();
    await until(async () => /object part \{ shape: mesh\("part\.glb", scale: 0\.001\); at: xyz\([^)]*, 30mm\) \}/.test(await program()), program);
    await untilStatus(page, /^1 move, 1\.00 s/);
  }));

async function inFolder(files, work) {
  const folder = mkdtempSync(join(tmpdir(), "armlet-dropped-"));
  try {
    for (const [name, bytes] of Object.entries(files)) writeFileSync(join(folder, name), bytes);
    await work(folder, (...given) => execFileSync(process.env.ARMLET_COMMAND, given, { cwd: folder, stdio: "pipe" }));
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

// Triangles by their corners, however the polygons around them are cut.
const cornersOf = (glb) => [...new Set(trianglesOfGlb(glb).flatMap((triangle) => triangle.split(", ")))].sort();

test("what a page converts by itself is what the command converts", { skip: existsSync(converter) ? false : "there is no converter" }, async () => {
  const { convert } = await source("meshes/convert.ts");
  const files = { "a.stl": stl(), "b.stl": stlText(), "c.ply": ply(), "d.ply": ply(false), "e.ply": plyText([255, 128, 0]), "f.obj": obj(), ...FILES };
  await inFolder(files, (folder, armlet) => {
    for (const name of Object.keys(files).filter((each) => /stl|ply|obj/.test(each))) {
      armlet("mesh", "convert", name, "out.glb");
      const [theirs, ours] = [readFileSync(join(folder, "out.glb")), convert(name, Uint8Array.from(files[name]), new Map(Object.entries(files).map(([each, bytes]) => [each, Uint8Array.from(bytes)])))];
      assert.deepEqual(cornersOf(ours), cornersOf(theirs), name);
      assert.equal(trianglesOfGlb(ours).length, trianglesOfGlb(theirs).length, name);
      if (/stl/.test(name)) assert.deepEqual(trianglesOfGlb(ours), trianglesOfGlb(theirs), name);
    }
  });
});

// What a page that reads meshes itself does with files, good and bad ones.
async function takesMeshes(page) {
  const program = () => page.locator(".cm-content").innerText();
  const told = (text) => page.locator(".message", { hasText: text }).waitFor();
  const has = (pattern) => until(async () => pattern.test(await program()), program);
  await untilStatus(page, /1 move, 1\.00 s/);
  await page.locator(".stage canvas").waitFor();
  await dropFiles(page, FILES);
  await has(/object sign\w* \{ shape: mesh\("sign\.glb"\); at: xyz\([^)]*, 200mm\) \}/);
  await until(async () => (await pixelsLike(page, RED)) > 200, () => "the picture is not seen");
  await dropFiles(page, { "part.STL": stl() }, [0.3, 0.8]);
  await has(/mesh\("part\.glb"\); at: xyz\([^)]*, 50mm\)/);
  await dropFiles(page, { "shape.ply": ply() }, [0.7, 0.8]);
  await has(/mesh\("shape\.glb"\)/);
  await untilStatus(page, /1 move, 1\.00 s/);
  const before = await program();
  await dropFiles(page, { "cut.stl": stl().subarray(0, 200) });
  await told(/cut\.stl: its header says 28 triangles, but there are bytes for 2\./);
  await dropFiles(page, { "index.obj": Buffer.from("v 0 0 0\nf 1 2 3\n") });
  await told(/index\.obj: a face names v 2, but there are 1 above it\./);
  await dropFiles(page, { "arm.dae": Buffer.from("<COLLADA/>") });
  await told(/arm\.dae: .*armlet mesh convert arm\.dae arm\.glb/);
  await dropFiles(page, { "huge.stl": 33 * 2 ** 20 });
  await told(/33 MB/);
  assert.equal(await program(), before);
  await untilStatus(page, /1 move, 1\.00 s/);
}

test("a page with a converter of its own takes STL, OBJ and PLY, and refuses what is broken", async () => {
  const { toBase85 } = await source("protocol/base85.ts");
  const packed = toBase85(gzipSync(readFileSync(join(root, "apps/lab/page/dist/converter.js"))));
  // As a page in one file carries it; one that is served may start no workers.
  const before = (page) => page.addInitScript((text) => addEventListener("DOMContentLoaded", () => {
    document.body.append(Object.assign(document.createElement("script"), { type: "text/plain", id: "armlet-converter", textContent: text }));
  }), packed);
  await withLab(`${ARM}${SHORT_MOVE}`, async (open, lab) => {
    const page = await open({ before, bypassCSP: true });
    await takesMeshes(page);
    assert.deepEqual(readdirSync(lab.folder).sort(), ["part.glb", "program.rbt", "shape.glb", "sign.glb"]);
    // One that holds up its reader is given up; the page goes on.
    await page.evaluate(() => {
      globalThis.setTimeout = ((original) => (work, wait, ...more) => original(work, wait === 20_000 ? 300 : wait, ...more))(globalThis.setTimeout);
    });
    const corners = Array.from({ length: 200_000 }, (_, k) => `v ${Math.cos(k * 2.4)} ${Math.sin(k * 2.4)} ${k % 7}\n`).join("");
    await dropFiles(page, { "slow.obj": Buffer.from(`${corners}f ${Array.from({ length: 200_000 }, (_, k) => k + 1).join(" ")}\n`) });
    await page.locator(".message", { hasText: /slow\.obj: it was not read after 20 s\./ }).waitFor();
    await untilStatus(page, /1 move, 1\.00 s/);
  });
});

const engine = join(root, "build/wasm/laboratory.html");

test("a laboratory in one file takes STL, OBJ and PLY, and is saved with them", { skip: existsSync(engine) ? false : "there is no engine for pages: ./dev wasm" }, () =>
  inFolder({ "a.rbt": `${ARM}${SHORT_MOVE}` }, async (folder, armlet) => {
    armlet("lab", "a.rbt", "--export", "a.html", "--engine", engine);
    const page = await openPage(`file://${join(folder, "a.html")}`, { acceptDownloads: true });
    await takesMeshes(page);
    const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Hand in" }).click()]);
    await download.saveAs(join(folder, "handed.html"));
    assert.deepEqual(page.problems, []);
    await page.context().close();
    // What was saved has the meshes, and takes more.
    const again = await openPage(`file://${join(folder, "handed.html")}`);
    await untilStatus(again, /1 move, 1\.00 s/);
    await until(async () => (await pixelsLike(again, RED)) > 200, () => "the picture is not seen");
    await dropFiles(again, { "more.ply": plyText() }, [0.3, 0.6]);
    await until(async () => /mesh\("more\.glb"\)/.test(await again.locator(".cm-content").innerText()), () => "it is not taken");
    assert.deepEqual(again.problems, []);
    await again.context().close();
  }));
