// Limits what GLTFLoader reads of a GLB file to shapes, materials and pictures in the file itself that browsers can show. Files come with
// programs of unknown origin.
import type { GLTFLoaderPlugin, GLTFParser } from "three/examples/jsm/loaders/GLTFLoader.js";
import { decoded, pictureOf } from "../meshes/picture.ts";

type Json = Record<string, unknown>;
const listOf = (json: Json, name: string) => (Array.isArray(json[name]) ? (json[name] as Json[]) : []);
const without = (json: Json, ...names: string[]) => names.forEach((name) => delete json[name]);

// throws  if the shapes are in another file.
export function onlyShapes(parser: GLTFParser): GLTFLoaderPlugin {
  const json = parser.json as Json;
  if (listOf(json, "buffers").some((buffer) => "uri" in buffer)) throw new Error("The shapes lie in another file.");
  without(json, "animations", "cameras", "skins", "extensions", "extensionsUsed", "extensionsRequired");
  for (const node of listOf(json, "nodes")) without(node, "extensions", "camera", "skin");
  for (const mesh of listOf(json, "meshes")) for (const part of listOf(mesh, "primitives")) without(part, "extensions");
  for (const other of [...listOf(json, "materials"), ...listOf(json, "textures")]) without(other, "extensions");
  return { name: "only-shapes", loadTexture: (index) => textureOf(parser, index) as Promise<never> };
}

// Null: its picture is in another file, broken or too large.
async function textureOf(parser: GLTFParser, index: number) {
  const json = parser.json as Json;
  const image = listOf(json, "images")[Number(listOf(json, "textures")[index]?.["source"])];
  if (!image || "uri" in image || typeof image["bufferView"] !== "number") return null;
  const bytes = new Uint8Array((await parser.getDependency("bufferView", image["bufferView"])) as ArrayBuffer);
  const bitmap = await decoded(bytes);
  if (!bitmap) return null;
  bitmap.close();
  image["mimeType"] = pictureOf(bytes)!.type;
  return parser.loadTexture(index);
}
