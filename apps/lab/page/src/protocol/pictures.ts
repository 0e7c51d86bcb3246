// Binary messages with a picture: a head of six numbers of 32 bits, the pixels row by row, and its marks as JSON.
const HEAD = 24;
const PICTURE = 8;

// Points in a picture, x first: detected features and corners, true corners of an object, and goals of features.
export interface Marks {
  what: string; // "feature", "corner", "truth" or "wanted"
  object: string;
  pixels: [number, number][];
}

// fault  why there are no features, although they were requested.
export interface PictureAnswer {
  width: number;
  height: number;
  rgba: Uint8ClampedArray<ArrayBuffer>;
  marks: Marks[];
  fault: string;
}

// The picture and the number of the message that asked for it; null: it is another message.
export function readPicture(data: ArrayBuffer): { to: number; picture: PictureAnswer } | null {
  if (data.byteLength < HEAD) return null;
  const head = new DataView(data);
  const word = (i: number) => head.getUint32(4 * i, true);
  const [kind, to, channels, width, height, size] = [word(0), word(1), word(2), word(3), word(4), word(5)];
  if (kind !== PICTURE || (channels !== 1 && channels !== 3)) return null;
  const count = width * height;
  if (data.byteLength !== HEAD + channels * count + size) return null;
  const pixels = new Uint8Array(data, HEAD, channels * count);
  const rgba = new Uint8ClampedArray(4 * count);
  const [green, blue] = channels === 3 ? [1, 2] : [0, 0];
  for (let i = 0, from = 0, into = 0; i < count; i++, from += channels, into += 4) {
    rgba[into] = pixels[from]!;
    rgba[into + 1] = pixels[from + green]!;
    rgba[into + 2] = pixels[from + blue]!;
    rgba[into + 3] = 255;
  }
  const told = JSON.parse(new TextDecoder().decode(new Uint8Array(data, HEAD + channels * count, size))) as { marks?: Marks[]; fault?: string };
  return { to, picture: { width, height, rgba, marks: told.marks ?? [], fault: told.fault ?? "" } };
}
