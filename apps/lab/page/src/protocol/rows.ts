// Binary messages: a head of six numbers of 32 bits, then rows of doubles.

const HEAD = 24;
export const ROBOT_ROWS = 1;
export const OBJECT_ROWS = 2;
export const ELEMENT_ROWS = 3;
export const FORCE_ROWS = 4;
export const CONTACT_ROWS = 5;
const FILE = 6;
export const DRAWING_ROWS = 7;

export interface RowBlock {
  kind: number;
  run: number;
  index: number;
  columns: number;
  first: number;
  count: number;
  rows: Float64Array;
}

// Reads one block; null if its length differs from the one in its head.
export function readRows(data: ArrayBuffer): RowBlock | null {
  if (data.byteLength < HEAD) return null;
  const head = new DataView(data);
  const word = (i: number) => head.getUint32(4 * i, true);
  const block = { kind: word(0), run: word(1), index: word(2), columns: word(3), count: word(4), first: word(5) };
  if (data.byteLength !== HEAD + 8 * block.columns * block.count) return null;
  return { ...block, rows: new Float64Array(data, HEAD, block.columns * block.count) };
}

// The bytes of a file and the number of the message that asked for it; null: it is another message.
export function readFile(data: ArrayBuffer): { to: number; bytes: ArrayBuffer } | null {
  if (data.byteLength < HEAD) return null;
  const head = new DataView(data);
  if (head.getUint32(0, true) !== FILE || head.getUint32(16, true) !== data.byteLength - HEAD) return null;
  return { to: head.getUint32(4, true), bytes: data.slice(HEAD) };
}

export function writeRows(block: RowBlock): ArrayBuffer {
  const data = new ArrayBuffer(HEAD + 8 * block.rows.length);
  const head = new DataView(data);
  const words = [block.kind, block.run, block.index, block.columns, block.count, block.first];
  words.forEach((n, i) => head.setUint32(4 * i, n, true));
  new Float64Array(data, HEAD).set(block.rows);
  return data;
}
