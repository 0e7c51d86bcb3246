// Meshes that a page reads by itself: STL, OBJ and PLY as GLB, and what is wrong with files of others.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import test from "node:test";
import { root, source } from "./modules.mjs";
import { partsOfGlb, trianglesOfGlb, twoColours } from "./small_glb.mjs";
import { body, obj, ply, plyText, stl, stlText, VOLUME } from "./small_meshes.mjs";

const { convert } = await source("meshes/convert.ts");
const { cutPolygon } = await source("meshes/polygon.ts");

const bytesOf = (content) => Uint8Array.from(typeof content === "string" ? Buffer.from(content) : content);
const made = (name, content, files = {}) => convert(name, bytesOf(content), new Map(Object.entries(files).map(([each, bytes]) => [each, bytesOf(bytes)])));

// Six times the volume is the sum of det [a b c] over all triangles (theorem of Gauss).
function volumeOf(glb) {
  let sum = 0;
  for (const { attributes: { POSITION }, corners } of partsOfGlb(glb).parts) {
    for (let i = 0; i < corners.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => POSITION[corners[i + k]]);
      sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  }
  return sum / 6;
}

// Whether each edge is gone along once in each direction.
function isClosed(glb) {
  const edges = new Map();
  for (const triangle of trianglesOfGlb(glb)) {
    const corners = triangle.split(", ");
    corners.forEach((from, k) => {
      const to = corners[(k + 1) % 3];
      const [key, step] = from < to ? [`${from} | ${to}`, 1] : [`${to} | ${from}`, -1];
      edges.set(key, (edges.get(key) ?? 0) + step);
    });
  }
  return [...edges.values()].every((count) => count === 0);
}

for (const [name, content] of [["a.obj", obj()], ["a.stl", stl()], ["a.STL", stlText()], ["a.ply", plyText()], ["b.ply", ply(true)], ["c.ply", ply(false)]]) {
  test(`${name}: the body is closed, has its volume and its 16 vertices, and every polygon two triangles fewer than corners`, () => {
    const glb = made(name, content);
    const { parts, json } = partsOfGlb(glb);
    assert.equal(parts.length, 1);
    assert.equal(parts[0].attributes.POSITION.length, body.points.length);
    assert.equal(parts[0].corners.length / 3, body.faces.reduce((sum, face) => sum + face.length - 2, 0));
    assert.ok(isClosed(glb));
    assert.ok(Math.abs(volumeOf(glb) - VOLUME) < 1e-9, "single precision rounds 0.3 by 1e-8"); // m^3
    assert.equal(parts[0].material, null, "the file says nothing of its colour");
    assert.equal(parts[0].attributes.NORMAL, undefined, "every triangle is flat");
    assert.deepEqual(json.accessors[0].max.map((x) => +x.toFixed(6)), [0.3, 0.2, 0.1]);
  });
}

test("the three forms of PLY, and the two of STL, are the same body", () => {
  assert.deepEqual(trianglesOfGlb(made("a.ply", ply(true))), trianglesOfGlb(made("a.ply", plyText())));
  assert.deepEqual(trianglesOfGlb(made("a.ply", ply(false))), trianglesOfGlb(made("a.ply", plyText())));
  assert.deepEqual(trianglesOfGlb(made("a.stl", stl())), trianglesOfGlb(made("a.stl", stlText())));
});

// The files on which the converter of the command is tested.
const written = JSON.parse(execFileSync("python3", [join(root, "tests/stl_files.py")], { encoding: "utf8" }));

for (const [name, content, count, note] of written.forms) {
  test(`STL as it is written: ${name}`, () => {
    const glb = made("a.stl", Buffer.from(content, "base64"));
    assert.equal(trianglesOfGlb(glb).length, count);
    assert.ok(Math.abs(volumeOf(glb) - count / 24_000) < 1e-10); // 1/6000 m^3 of four triangles
    assert.equal(Buffer.from(glb).includes(note ?? "not read"), note !== null);
  });
}

for (const [name, content, why] of written.refused) {
  test(`STL that is refused: ${name}`, () => {
    assert.throws(() => made("a.stl", Buffer.from(content, "base64")), (error) => error.message.includes(why) || assert.fail(error.stack));
  });
}

// Numbers of a fixed sequence between 0 and 1.
function sequence(seed) {
  let state = seed;
  return () => (state = (Math.imul(1664525, state) + 1013904223) >>> 0) / 2 ** 32;
}

test("a polygon is covered by its triangles: 500 of them, seen from all sides, with corners on straight edges", () => {
  const next = sequence(7);
  for (let round = 0; round < 500; round++) {
    // Around a point at rising angles no two edges cross.
    const count = 3 + Math.floor(next() * 14);
    let flat = Array.from({ length: count }, (_, k) => {
      const [angle, radius] = [(2 * Math.PI * (k + 0.8 * next())) / count, 0.2 + next()];
      return [radius * Math.cos(angle), radius * Math.sin(angle)];
    });
    flat = flat.flatMap((p, k) => (next() < 0.2 ? [p, p.map((x, i) => (x + flat[(k + 1) % count][i]) / 2)] : [p]));
    const [u, v] = [[next() - 0.5, next() - 0.5, next() - 0.5], [next() - 0.5, next() - 0.5, next() - 0.5]];
    const points = flat.map(([x, y]) => u.map((each, k) => x * each + y * v[k]));
    const areaOf = (all) => all.reduce((sum, p, k) => sum + p[0] * all[(k + 1) % all.length][1] - p[1] * all[(k + 1) % all.length][0], 0) / 2;
    const triangles = cutPolygon(points);
    assert.equal(triangles.length, flat.length - 2);
    const areas = triangles.map((three) => areaOf(three.map((k) => flat[k])));
    // Those of corners on an edge may have no area; none is reversed by more than rounding.
    assert.ok(areas.every((area) => area > -1e-12), `${round}: ${areas}`);
    assert.ok(Math.abs(areas.reduce((sum, area) => sum + area, 0) - areaOf(flat)) < 1e-12 * count);
  }
});

test("a polygon that crosses itself is cut too, and one of many corners soon", () => {
  assert.equal(cutPolygon([[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]]).length, 2);
  assert.equal(cutPolygon([[0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]]).length, 3);
  assert.deepEqual(cutPolygon([[0, 0, 0], [1, 0, 0]]), []);
  const round = Array.from({ length: 30_000 }, (_, k) => [Math.cos((2 * Math.PI * k) / 30_000), Math.sin((2 * Math.PI * k) / 30_000), 0]);
  assert.equal(cutPolygon(round).length, 29_998);
});

const PICTURE = twoColours([230, 10, 10], [10, 200, 10]);
const QUAD = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 2\n";

test("OBJ has its materials, its picture whatever its case, its normals and positions from below", () => {
  const glb = made("a.obj", `mtllib Sign.mtl\n${QUAD}usemtl red paint\nf -4 -3 \\\n-2\nusemtl sign\nf 1/1/1 2/2/1 3/3/1 4/4/-1\n`, {
    "sign.MTL": "newmtl red paint\nKd 1 0.5 0 # sRGB\nd 0.25\nnewmtl sign\nKd 0.1 0.1 0.1\nmap_Kd -s 1 1 1 -blendu on .\\textures\\Paint%201.PNG\n", "paint 1.png": PICTURE,
  });
  const { parts, json } = partsOfGlb(glb);
  const [plain, pictured] = parts;
  // 0.5 on a screen is 0.2140 (IEC 61966-2-1).
  assert.deepEqual(plain.material.pbrMetallicRoughness.baseColorFactor.map((x) => +x.toFixed(4)), [1, 0.214, 0, 0.25]);
  assert.equal(plain.material.alphaMode, "BLEND");
  assert.deepEqual(pictured.material.pbrMetallicRoughness.baseColorFactor, [1, 1, 1, 1]);
  assert.deepEqual(pictured.attributes.TEXCOORD_0, [[0, 1], [1, 1], [1, 0], [0, 0]], "v is from below there, and from above in glTF");
  assert.deepEqual(pictured.attributes.NORMAL, Array(4).fill([0, 0, 1]));
  const view = json.bufferViews[json.images[0].bufferView];
  const start = Buffer.from(glb).indexOf(PICTURE);
  assert.ok(start > 0 && view.byteLength === PICTURE.length, "its bytes are those of the file");
});

test("faces above the first material of an OBJ have none, and parts of the file share their vertices", () => {
  const glb = made("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\no one\nf 1 2 3\nusemtl red\nf 2 4 3\no two\nf 1 3 4\nusemtl nobody\nf 1 4 2\n", { "a.mtl": "newmtl red\nKd 1 0 0\nTr 0.5\n" });
  const { parts } = partsOfGlb(glb);
  assert.deepEqual(parts.map(({ material, corners }) => [material?.name ?? null, corners.length]), [[null, 6], ["red", 6]]);
  assert.deepEqual(parts[1].material.pbrMetallicRoughness.baseColorFactor, [1, 0, 0, 0.5]);
});

test("a PLY may have more than vertices and faces, in each of its forms", () => {
  const head = (format) => `ply\nformat ${format} 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty float confidence\nproperty double z\nelement edge 1\nproperty int a\nproperty list uchar short b\nelement face 2\nproperty uchar red\nproperty list uint uint vertex_index\nend_header\n`;
  const points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.5]];
  const text = made("a.ply", `${head("ascii")}${points.map(([x, y, z]) => `${x} ${y} 0.9 ${z}\n`).join("")}7 2 1 -1\n255 3 0 1 2\n0 3 1 3 2\n`);
  const bytes = [];
  const put = (kind, size, ...values) => values.forEach((value) => { const at = Buffer.alloc(size); at[`write${kind}`](value); bytes.push(at); });
  for (const [x, y, z] of points) put("DoubleLE", 8, x, y), put("FloatLE", 4, 0.9), put("DoubleLE", 8, z);
  put("Int32LE", 4, 7), put("UInt8", 1, 2), put("Int16LE", 2, 1, -1);
  for (const face of [[0, 1, 2], [1, 3, 2]]) put("UInt8", 1, 255), put("UInt32LE", 4, 3, ...face);
  const binary = made("b.ply", Buffer.concat([Buffer.from(head("binary_little_endian")), ...bytes]));
  assert.deepEqual(trianglesOfGlb(text), ["0 0 0, 1 0 0, 0 1 0", "0 1 0, 1 0 0, 1 1 0.5"]);
  assert.deepEqual(trianglesOfGlb(binary), trianglesOfGlb(text));
});

test("what is missing beside a mesh is noted, and the mesh is there", () => {
  const { parts, notes } = partsOfGlb(made("a.obj", `mtllib a.mtl\nmtllib none.mtl\n${QUAD}usemtl sign\nf 1/1 2/2 3/3\n`, { "a.mtl": "newmtl sign\nmap_Kd nowhere.png\n" }));
  assert.equal(parts[0].corners.length, 3);
  assert.match(notes, /^the file "none\.mtl" cannot be read: there is no such file beside the mesh\nthe picture "nowhere\.png" is left out: there is no such file/);
});

test("colours of vertices and of triangles are linear in GLB", () => {
  const colorOf = (glb) => partsOfGlb(glb).parts[0].attributes.COLOR_0[0].map((x) => +x.toFixed(4));
  assert.deepEqual(colorOf(made("a.ply", plyText([255, 128, 0]))), [1, 0.2159, 0, 1]);
  assert.deepEqual(colorOf(made("a.obj", "v 0 0 0 1 0.5 0\nv 1 0 0 1 0.5 0\nv 0 1 0 1 0.5 0\nf 1 2 3\n")), [1, 0.214, 0, 1]);
  // Five bits each; which colour is first differs.
  const red = 31 << 10;
  assert.deepEqual(colorOf(made("a.stl", stl(() => 0x8000 | red))), [1, 0, 0, 1]);
  assert.deepEqual(colorOf(made("a.stl", stl(() => 31, "COLOR=\x00\x00\xff\xff"))), [1, 0, 0, 1]);
  assert.deepEqual(colorOf(made("a.stl", stl(() => 0x8000, "COLOR=\x00\x00\xff\xff"))), [0, 0, 1, 1]);
  assert.equal(partsOfGlb(made("a.stl", stl(() => red))).parts[0].attributes.COLOR_0, undefined);
});

const HEAD = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
const THREE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
const counted = Buffer.alloc(134, " ");
counted.writeUInt32LE(0x7fffffff, 80);
const noNumber = Buffer.alloc(134, 0xff);
noNumber.writeUInt32LE(1, 80);
for (const [name, content, why] of [
  ["index.obj", `${THREE}f 1 2 9\n`, /^a face names v 9, but there are 3 above it$/],
  ["below.obj", `${THREE}f -1 -2 -9\n`, /^a face names v -9, but/],
  ["zero.obj", `${THREE}f 0 1 2\n`, /^a face names v 0, but/],
  ["none.obj", `${THREE}f 1 2 x\n`, /^a face names v x, but/],
  ["picture.obj", `${THREE}f 1/7 2/1 3/1\n`, /^a face names vt 7, but there are 1 above it$/],
  ["nan.obj", `${THREE.replace("v 1", "v nan")}f 1 2 3\n`, /^line 2 has "nan" where a number should be$/],
  ["far.obj", `${THREE.replace("v 1", "v 1e30")}f 1 2 3\n`, /^a vertex lies at 1\.00e\+30 m; expected 10 km at most$/],
  ["endless.obj", `${THREE.replace("v 1", "v 1e999")}f 1 2 3\n`, /^a coordinate of a vertex is no number$/],
  ["bytes.obj", "v 0 0 0\0", /^it is no text: it has a byte of 0$/],
  ["empty.obj", "", /^there are no triangles in it$/],
  ["long.obj", "v 0 0 0 \\\n".repeat(200_000), /^there are no triangles in it$/],
  ["polygon.obj", `${THREE}f${" 1 2 3".repeat(11_000)}\n`, /^line 5 has a face of 33000 corners, but the limit is 32767$/],
  ["wide.obj", `mtllib w.mtl\nusemtl a\n${THREE}f 1 2 3\n`, /^the picture "w\.png" says it has 9000 x 1 pixels; expected 1 to 8192 in each direction$/],
  ["count.stl", counted, /^its header says 2147483647 triangles, but there are bytes for 1$/],
  ["short.stl", "abc", /^it is cut off: it has 3 bytes$/],
  ["nan.stl", noNumber, /^a coordinate of a vertex is no number$/],
  ["cut.stl", stlText().subarray(0, -27), /^it is cut off: `endfacet` is missing$/],
  ["corners.stl", "solid\nfacet\nvertex 0 0 0\nendfacet\nendsolid\n", /^the facet that ends in line 4 has 1 corners; expected 3$/],
  ["word.stl", "solid\nfacet\nvertex 0 x 0\nendfacet\nendsolid\n", /^line 3 has "x" where a number should be$/],
  ["other.stl", "solid\nfacet\n<script>\nendsolid\n", /^line 3 has "<script>" in a facet$/],
  ["none.ply", "plyx\n", /^it is no PLY file: it does not begin with `ply`$/],
  ["head.ply", "ply\nformat ascii 1.0\n", /^it is cut off: `end_header` is missing$/],
  ["format.ply", "ply\nformat binary_middle 1.0\n", /^its format "binary_middle" is none of PLY$/],
  ["type.ply", "ply\nelement vertex 1\nproperty quad x\n", /^its header names the type "quad", which PLY has not$/],
  ["count.ply", ply().toString("latin1").replace("element vertex 16", "element vertex 2000000000"), /^(its header says|it is cut off in element)/],
  ["size.ply", "ply\nelement vertex 1e9\n", /^its header says 1e9 elements "vertex"$/],
  ["bare.ply", "ply\nformat ascii 1.0\nelement vertex 5\nend_header\n", /^its elements "vertex" have no properties$/],
  ["cloud.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n", /^it has no faces/],
  ["broken.ply", HEAD.replace("uchar", "float"), /^its header counts the elements of a list by broken numbers$/],
  ["index.ply", `${HEAD}0 0 0\n1 0 0\n0 1 0\n3 0 1 99\n`, /^element 0 "face" names vertex 99, but there are 3$/],
  ["half.ply", `${HEAD}0 0 0\n1 0 0\n0 1 0\n3 0 1 0.5\n`, /^element 0 "face" names vertex 0\.5, but there are 3$/],
  ["order.ply", "ply\nformat ascii 1.0\nelement face 0\nproperty list uchar int vertex_indices\nelement vertex 0\nproperty float x\nend_header\n", /^it does not begin with its vertices, which have no lists$/],
  ["list.ply", `${HEAD}0 0 0\n1 0 0\n0 1 0\n40000 0 1 2\n`, /^element 0 "face" has a list of 40000; expected 0 to 32767$/],
  ["line.ply", `${HEAD}0 0 0\n1 0\n0 1 0\n3 0 1 2\n`, /^2 numbers stand behind its elements$/],
  ["more.ply", `${HEAD}0 0 0 7\n1 0 0\n0 1 0\n3 0 1 2\n`, /^4 numbers stand behind its elements$/],
  ["word.ply", `${HEAD}0 0 0\n1 0.0x 0\n0 1 0\n3 0 1 2\n`, /^element 1 "vertex" has "0\.0x" where a number should be$/],
  ["end.ply", `${HEAD}0 0 0\n1 0 0\n`, /^its header says 3 elements "vertex", but there are 2$/],
]) {
  test(`what is wrong is reported: ${name}`, () => {
    const wide = twoColours([0, 0, 0], [0, 0, 0], 2);
    wide.writeUInt32BE(9000, 16);
    wide.writeUInt32BE(1, 20);
    assert.throws(() => made(name, typeof content === "string" ? Buffer.from(content, "latin1") : content, { "w.mtl": "newmtl a\nmap_Kd w.png\n", "w.png": wide }), (error) => why.test(error.message) || assert.fail(error.stack));
  });
}

test("files that are made to hold up a reader are refused as soon as others", () => {
  const many = 200_000;
  assert.throws(() => made("a.stl", `solid\nfacet\n${"vertex 0 0 0\n".repeat(many)}`), /it is cut off: `endfacet` is missing$/);
  assert.throws(() => made("a.stl", `solid\n${"x\n".repeat(many)}`), /there are no triangles in it$/);
  assert.throws(() => made("a.stl", `solid\nfacet${" ".repeat(many)}vertex`), /it is cut off/);
  assert.throws(() => made("a.ply", `ply\n${"comment\n".repeat(many)}`), /`end_header` is missing$/);
  assert.throws(() => made("a.ply", `${HEAD.replace("vertex 3", "vertex 100000000")}0 0 0\n`), /its header says 100000000 elements "vertex", but there are 1$/);
  assert.throws(() => made("a.ply", `${HEAD.replace("face 1", "face 100000000")}0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n`), /it is cut off in element 1 "face"$/);
});

test("more triangles than a program takes are refused", () => {
  const face = "f 1 2 3\n";
  assert.throws(() => made("many.obj", `${THREE}${face.repeat(1_000_001)}`), /it has more than 1000000 triangles$/);
});

test("whatever is cut off or changed of a file, it is read or refused with a reason", () => {
  const next = sequence(42);
  let refused = 0;
  for (const [name, content] of [["a.obj", obj(`mtllib a.mtl\n`)], ["a.stl", stl()], ["b.stl", stlText()], ["a.ply", plyText([1, 2, 3])], ["b.ply", ply()], ["c.ply", ply(false)]]) {
    for (let round = 0; round < 300; round++) {
      const bytes = bytesOf(content).slice(0, round % 3 ? undefined : Math.floor(next() * content.length));
      for (let k = 0; k < (round % 3) * 2; k++) bytes[Math.floor(next() * bytes.length)] = Math.floor(next() * 256);
      try {
        assert.equal(new DataView(convert(name, bytes, new Map([["a.mtl", bytes]]))).getUint32(0, true), 0x46546c67);
      } catch (error) {
        assert.ok(error.constructor.name === "Unusable", `${name}, ${round}: ${error.stack}`);
        refused++;
      }
    }
  }
  assert.ok(refused > 500, `${refused}`);
});
