// GLB files made for tests: a box with a picture on each face, and what can be wrong with one.
import { smallPng } from "./small_png.mjs";

// A picture whose left half has one colour and whose right half another, [r, g, b].
export function twoColours(left, right, size = 16) {
  const data = new Uint8Array(3 * size * size);
  for (let i = 0; i < size * size; i++) data.set(i % size < size / 2 ? left : right, 3 * i);
  return smallPng(size, size, data);
}

// A gear that lies flat: of so many teeth, from one radius to another, m. `color`: red, green, blue, 0 to 1.
export function gearGlb(teeth, [inner, outer], height, color) {
  const ring = Array.from({ length: 4 * teeth }, (_, k) => {
    const radius = k % 4 < 2 ? outer : inner;
    const angle = (2 * Math.PI * (k + (k % 2 ? -0.2 : 0.2))) / (4 * teeth);
    return [radius * Math.cos(angle), -radius * Math.sin(angle)]; // y is up: seen from above counterclockwise
  });
  const positions = [];
  const add = (...points) => positions.push(...points.flat());
  const [low, high] = [-height / 2, height / 2];
  ring.forEach(([x, z], k) => {
    const [u, w] = ring[(k + 1) % ring.length];
    add([0, high, 0], [x, high, z], [u, high, w], [0, low, 0], [u, low, w], [x, low, z]);
    add([x, low, z], [u, low, w], [u, high, w], [x, low, z], [u, high, w], [x, high, z]);
  });
  const binary = Buffer.from(Float32Array.from(positions).buffer);
  return packed({
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, material: 0 }] }],
    materials: [{ pbrMetallicRoughness: { baseColorFactor: [...color, 1], metallicFactor: 0.2, roughnessFactor: 0.5 } }],
    buffers: [{ byteLength: binary.length }],
    bufferViews: [{ buffer: 0, byteLength: binary.length }],
    accessors: [{ bufferView: 0, componentType: 5126, count: positions.length / 3, type: "VEC3", min: [-outer, low, -outer], max: [outer, high, outer] }],
  }, binary);
}

function packed(json, binary) {
  const text = Buffer.from(JSON.stringify(json));
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, 0x20)]);
  const head = (...words) => Buffer.from(Uint32Array.from(words).buffer);
  return Buffer.concat([head(0x46546c67, 2, 28 + padded.length + binary.length, padded.length, 0x4e4f534a), padded, head(binary.length, 0x004e4942), binary]);
}

// Of these sizes in metres as glTF has them, y up. `picture`: bytes of a PNG; `change`: does something to the description.
export function boxGlb([x, y, z], { picture = null, change = () => {} } = {}) {
  const positions = [], uvs = [], corners = [];
  for (let axis = 0; axis < 3; axis++) {
    for (const side of [-1, 1]) {
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      const first = positions.length / 3;
      for (const [s, t] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) {
        const p = [0, 0, 0];
        p[axis] = side;
        p[u] = s;
        p[v] = t;
        positions.push(p[0] * x / 2, p[1] * y / 2, p[2] * z / 2);
        uvs.push((1 + s) / 2, (1 - t) / 2);
      }
      corners.push(...(side > 0 ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2]).map((k) => first + k));
    }
  }
  const parts = [Float32Array.from(positions), Float32Array.from(uvs), Uint16Array.from(corners)].map((array) => Buffer.from(array.buffer));
  if (picture) parts.push(Buffer.concat([picture, Buffer.alloc((4 - (picture.length % 4)) % 4)]));
  let offset = 0;
  const bufferViews = parts.map((part, i) => {
    const view = { buffer: 0, byteOffset: offset, byteLength: i === 3 ? picture.length : part.length };
    offset += part.length;
    return view;
  });
  const json = {
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, indices: 2, ...(picture ? { material: 0 } : {}) }] }],
    buffers: [{ byteLength: offset }],
    bufferViews,
    accessors: [
      { bufferView: 0, componentType: 5126, count: 24, type: "VEC3", min: [-x / 2, -y / 2, -z / 2], max: [x / 2, y / 2, z / 2] },
      { bufferView: 1, componentType: 5126, count: 24, type: "VEC2" },
      { bufferView: 2, componentType: 5123, count: 36, type: "SCALAR" },
    ],
    ...(picture ? {
      materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0 } }],
      textures: [{ source: 0 }],
      images: [{ bufferView: 3, mimeType: "image/png" }],
    } : {}),
  };
  change(json);
  return packed(json, Buffer.concat(parts));
}

// The parts of a GLB file: of each its attributes as lists of numbers, its corners, and its material.
export function partsOfGlb(file) {
  const bytes = Buffer.from(file);
  const length = bytes.readUInt32LE(12);
  const json = JSON.parse(bytes.subarray(20, 20 + length).toString());
  const binary = bytes.subarray(28 + length, 28 + length + bytes.readUInt32LE(20 + length));
  const widths = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };
  const listOf = (index) => {
    const { bufferView, componentType, count, type } = json.accessors[index];
    const from = binary.subarray(json.bufferViews[bufferView].byteOffset);
    const read = (i) => (componentType === 5126 ? from.readFloatLE(4 * i) : from.readUInt32LE(4 * i));
    const flat = Array.from({ length: count * widths[type] }, (_, i) => read(i));
    return widths[type] === 1 ? flat : Array.from({ length: count }, (_, i) => flat.slice(i * widths[type], (i + 1) * widths[type]));
  };
  const parts = json.meshes.flatMap((mesh) => mesh.primitives).map((part) => ({
    attributes: Object.fromEntries(Object.entries(part.attributes).map(([name, index]) => [name, listOf(index)])),
    corners: listOf(part.indices),
    material: part.material === undefined ? null : json.materials[part.material],
  }));
  let notes = "";
  for (let at = 12; at + 8 <= bytes.length; at += 8 + bytes.readUInt32LE(at)) {
    if (bytes.readUInt32LE(at + 4) === 0x45544f4e) notes = bytes.subarray(at + 8, at + 8 + bytes.readUInt32LE(at)).toString().trim();
  }
  return { json, parts, notes };
}

// All triangles of a GLB file as texts of their corners, each beginning with the first in order, sorted.
export function trianglesOfGlb(file) {
  return partsOfGlb(file).parts.flatMap(({ attributes: { POSITION }, corners }) => Array.from({ length: corners.length / 3 }, (_, i) => {
    const three = [0, 1, 2].map((k) => POSITION[corners[3 * i + k]].join(" "));
    const first = three.indexOf([...three].sort()[0]);
    return [0, 1, 2].map((k) => three[(first + k) % 3]).join(", ");
  })).sort();
}
