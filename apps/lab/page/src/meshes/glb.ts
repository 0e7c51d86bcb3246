// What a GLB file holds, made safe to be shown: nothing that it names elsewhere is asked for, and what no browser can show of it is
// left out. Files come with programs, from whoever wrote them.

const MOST_PIXELS = 64e6;
const MOST_SIDE = 8192;

type Json = { [name: string]: unknown };
const isList = (value: unknown): value is Json[] => Array.isArray(value) && value.every((each) => typeof each === "object" && each !== null);
const listOf = (json: Json, name: string): Json[] => (isList(json[name]) ? (json[name] as Json[]) : []);

// "image/png" or "image/jpeg", and the size that the picture says it has; null: it is neither.
export function pictureOf(bytes: Uint8Array): { type: string; width: number; height: number } | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length > 24 && view.getUint32(0) === 0x89504e47) return { type: "image/png", width: view.getUint32(16), height: view.getUint32(20) };
  if (bytes.length < 4 || view.getUint16(0) !== 0xffd8) return null;
  for (let at = 2; at + 9 < bytes.length; at += 2 + view.getUint16(at + 2)) {
    const kind = view.getUint16(at);
    if (kind < 0xffc0 || kind > 0xfffe) return null;
    const isFrame = kind <= 0xffcf && ![0xffc4, 0xffc8, 0xffcc].includes(kind);
    if (isFrame) return { type: "image/jpeg", height: view.getUint16(at + 5), width: view.getUint16(at + 7) };
  }
  return null;
}

// The picture, ready to be drawn, its first row below; null: it is broken, too large or none.
export async function decoded(bytes: Uint8Array<ArrayBuffer>): Promise<ImageBitmap | null> {
  const picture = pictureOf(bytes);
  if (!picture || Math.max(picture.width, picture.height) > MOST_SIDE || picture.width * picture.height > MOST_PIXELS) return null;
  try {
    return await createImageBitmap(new Blob([bytes], { type: picture.type }), { imageOrientation: "flipY", premultiplyAlpha: "none" });
  } catch {
    return null;
  }
}

interface Parts {
  json: Json;
  binary: Uint8Array<ArrayBuffer>;
}
const NOTES = 0x45544f4e; // a chunk that other programs pass over (runtime/src/mesh/glb_format.hpp)

function partsOf(file: ArrayBuffer): Parts {
  const view = new DataView(file);
  if (file.byteLength < 20 || view.getUint32(0, true) !== 0x46546c67 || view.getUint32(4, true) !== 2) throw new Error("This is no GLB file.");
  const end = Math.min(view.getUint32(8, true), file.byteLength);
  let json: Json | null = null;
  let binary = new Uint8Array(0);
  for (let at = 12; at + 8 <= end; ) {
    const length = view.getUint32(at, true);
    const kind = view.getUint32(at + 4, true);
    if (at + 8 + length > end) throw new Error("The file is cut off.");
    const chunk = new Uint8Array(file, at + 8, length);
    if (kind === 0x4e4f534a && !json) json = JSON.parse(new TextDecoder().decode(chunk)) as Json;
    if (kind === 0x004e4942 && !binary.length) binary = chunk;
    at += 8 + 4 * Math.ceil(length / 4);
  }
  if (!json || typeof json !== "object") throw new Error("The file has no description.");
  return { json, binary };
}

// A file of these parts. `notes`: lines that say what it lacks of what it was made from.
export function glbOf({ json, binary }: Parts, notes: readonly string[] = []): ArrayBuffer {
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

// Takes away what a material says of other textures than these, however deep it lies.
function withoutTextures(value: unknown, good: Set<unknown>, depth = 0): void {
  if (typeof value !== "object" || value === null || depth > 6) return;
  for (const [name, inner] of Object.entries(value)) {
    if (name.endsWith("Texture") && !good.has((inner as Json | null)?.["index"])) delete (value as Json)[name];
    else withoutTextures(inner, good, depth + 1);
  }
}

// The textures whose pictures can be shown: they are in the file, whole and not too large.
async function goodTextures({ json, binary }: Parts): Promise<Set<unknown>> {
  const views = listOf(json, "bufferViews");
  const images = await Promise.all(listOf(json, "images").map(async (image) => {
    const view = typeof image["bufferView"] === "number" && !("uri" in image) ? views[image["bufferView"]] : undefined;
    const begin = Number(view?.["byteOffset"] ?? 0);
    const bytes = view ? binary.slice(begin, begin + Number(view["byteLength"])) : new Uint8Array(0);
    const bitmap = await decoded(bytes);
    bitmap?.close();
    if (bitmap) image["mimeType"] = pictureOf(bytes)!.type;
    else delete image["uri"];
    return bitmap !== null;
  }));
  const good = new Set<unknown>();
  listOf(json, "textures").forEach((texture, i) => {
    delete texture["extensions"];
    if (images[Number(texture["source"])]) good.add(i);
  });
  return good;
}

// The file with nothing in it but shapes, materials and pictures that can be shown.
// throws  where it is no GLB file, or its geometry lies elsewhere.
export async function safeGlb(file: ArrayBuffer): Promise<{ file: ArrayBuffer; hasMaterials: boolean }> {
  const parts = partsOf(file);
  const { json } = parts;
  if (listOf(json, "buffers").some((buffer) => "uri" in buffer)) throw new Error("The shapes lie in another file.");
  const good = await goodTextures(parts);
  const materials = listOf(json, "materials");
  for (const material of materials) withoutTextures(material, good);
  for (const name of ["animations", "cameras", "skins", "extensions", "extensionsUsed", "extensionsRequired"]) delete json[name];
  for (const node of listOf(json, "nodes")) for (const name of ["extensions", "camera", "skin"]) delete node[name];
  for (const mesh of listOf(json, "meshes")) for (const part of listOf(mesh, "primitives")) delete part["extensions"];
  return { file: glbOf(parts), hasMaterials: materials.length > 0 };
}
