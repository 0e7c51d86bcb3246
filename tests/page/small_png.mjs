// Pictures as PNG: read as browsers and this file write them, and written with at most 256 colours, a third as large as those of browsers.
import * as zlib from "node:zlib";

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

const checksum = zlib.crc32 ?? ((bytes) => { // Node 18 has none
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

// rgb  three bytes a pixel, row by row.
export function smallPng(width, height, rgb) {
  const counts = new Map();
  for (let i = 0; i < rgb.length; i += 3) {
    const key = (rgb[i] << 16) | (rgb[i + 1] << 8) | rgb[i + 2];
    counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  const colors = palette(counts);
  const indexOf = new Map(colors.flatMap(({ box }, i) => box.map(([r, g, b]) => [(r << 16) | (g << 8) | b, i])));
  const rows = Buffer.alloc((width + 1) * height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const i = 3 * (y * width + x);
      rows[y * (width + 1) + 1 + x] = indexOf.get((rgb[i] << 16) | (rgb[i + 1] << 8) | rgb[i + 2]);
    }
  }
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head.set([8, 3, 0, 0, 0], 8);
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]), chunk("IHDR", head), chunk("PLTE", Buffer.from(colors.flatMap(({ color }) => color))),
    chunk("IDAT", zlib.deflateSync(rows, { level: 9 })), chunk("IEND", Buffer.alloc(0)),
  ]);
}

function paeth(a, b, c) {
  const [pa, pb, pc] = [Math.abs(b - c), Math.abs(a - c), Math.abs(a + b - 2 * c)];
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

// The lines of a picture without their filters (PNG, third edition, 9.2).
function unfiltered(packed, height, stride, step) {
  const out = Buffer.alloc(height * stride);
  for (let y = 0; y < height; y++) {
    const filter = packed[y * (stride + 1)];
    for (let x = 0; x < stride; x++) {
      const at = y * stride + x;
      const a = x >= step ? out[at - step] : 0;
      const b = y > 0 ? out[at - stride] : 0;
      const c = x >= step && y > 0 ? out[at - stride - step] : 0;
      const guess = [0, a, b, (a + b) >> 1, filter === 4 ? paeth(a, b, c) : 0][filter];
      out[at] = packed[y * (stride + 1) + 1 + x] + guess;
    }
  }
  return out;
}

// {width, height, data: r, g, b of each pixel, row by row} of a picture with eight bits a colour that is not interlaced.
export function readPng(png) {
  const parts = { IDAT: [] };
  for (let at = 8; at < png.length; ) {
    const [size, type] = [png.readUInt32BE(at), png.toString("latin1", at + 4, at + 8)];
    const data = png.subarray(at + 8, at + 8 + size);
    type === "IDAT" ? parts.IDAT.push(data) : (parts[type] = data);
    at += 12 + size;
  }
  const [width, height, bits, kind, interlaced] = [parts.IHDR.readUInt32BE(0), parts.IHDR.readUInt32BE(4), parts.IHDR[8], parts.IHDR[9], parts.IHDR[12]];
  const step = { 2: 3, 3: 1, 6: 4 }[kind];
  if (bits !== 8 || interlaced || !step) throw new Error(`a PNG of kind ${kind} with ${bits} bits`);
  const given = unfiltered(zlib.inflateSync(Buffer.concat(parts.IDAT)), height, width * step, step);
  const data = Buffer.alloc(3 * width * height);
  for (let i = 0; i < width * height; i++) {
    for (let k = 0; k < 3; k++) data[3 * i + k] = kind === 3 ? parts.PLTE[3 * given[i] + k] : given[step * i + k];
  }
  return { width, height, data };
}
