// Meshes of other formats than GLB that are dropped onto the 3D view, with the files that they name.
import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import test, { after } from "node:test";
import { ARM, closeBrowser, dropFiles, pixelsLike, RED, SHORT_MOVE, until, untilStatus, withLab } from "../laboratory.mjs";
import { twoColours } from "../small_glb.mjs";

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
