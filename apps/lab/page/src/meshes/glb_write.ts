// Writes GLB files.
const NOTES = 0x45544f4e; // a chunk that other programs ignore (runtime/src/mesh/glb_format.hpp)

// A file with these parts. `notes`: lines about parts of the source that it lacks.
export function glbOf(json: object, binary: Uint8Array, notes: readonly string[] = []): ArrayBuffer {
  const encoded = (text: string) => new TextEncoder().encode(text);
  const chunks: [number, Uint8Array, number][] = [[0x4e4f534a, encoded(JSON.stringify(json)), 0x20], [0x004e4942, binary, 0]];
  if (notes.length) chunks.push([NOTES, encoded(notes.map((note) => `${note}\n`).join("")), 0x0a]);
  const padded = (bytes: Uint8Array) => 4 * Math.ceil(bytes.length / 4);
  const file = new ArrayBuffer(chunks.reduce((sum, [, content]) => sum + 8 + padded(content), 12));
  const [view, bytes] = [new DataView(file), new Uint8Array(file)];
  [0x46546c67, 2, file.byteLength].forEach((word, i) => view.setUint32(4 * i, word, true));
  let at = 12;
  for (const [kind, content, filling] of chunks) {
    view.setUint32(at, padded(content), true);
    view.setUint32(at + 4, kind, true);
    bytes.fill(filling, at + 8, at + 8 + padded(content));
    bytes.set(content, at + 8);
    at += 8 + padded(content);
  }
  return file;
}
