// Collects triangles of any origin, with checks of each number, and writes them as a GLB file, as the converter of the command does
// (apps/mesh/converter/scene_builder.cpp), for pages without a server.
import { Vector3, type BufferGeometry } from "three";
import { glbOf } from "./glb_write.ts";
import { pictureOf } from "./picture.ts";

const MOST_TRIANGLES = 1_000_000;
const FARTHEST = 1e4; // m
const MOST_SIDE = 8192; // pixels
const MOST_NOTES = 20;

// A fault of a file, as a sentence without a full stop.
export class Unusable extends Error {}
export function refuse(why: string): never {
  throw new Unusable(why);
}
export function checkCount(triangles: number): void {
  if (triangles > MOST_TRIANGLES) refuse(`it has more than ${MOST_TRIANGLES} triangles`);
}
// A word of a file in the form in which messages show it.
export const shown = (word: string): string => word.slice(0, 40).replace(/[^ -~\xa0-\u{10ffff}]/gu, "?");

// A corner of a triangle.
//
// at       units of the file, z up.
// normal   of any length; zero: computed from the triangle.
// picture  texture coordinates, 0 to 1 from the lower left corner of the picture, v up.
// color    red, green, blue, opacity; linear.
export interface Corner {
  at: readonly number[];
  normal?: readonly number[] | undefined;
  picture?: readonly number[] | undefined;
  color?: readonly number[] | undefined;
}

// A corner of a geometry that three has read.
export function cornerOf(geometry: BufferGeometry, index: number): Corner {
  const { position, normal, uv, color } = geometry.attributes;
  const of = (attribute: typeof position) => attribute && new Vector3().fromBufferAttribute(attribute, index).toArray();
  return { at: of(position)!, normal: of(normal), picture: uv && [uv.getX(index), uv.getY(index)], color: of(color) };
}

export interface Look {
  name: string;
  color: readonly number[]; // as that of a corner
  picture: string; // the name of a file; empty: none
}

// Companions of a mesh: the files that it names, by their own names.
export type Files = ReadonlyMap<string, Uint8Array<ArrayBuffer>>;

const clamped = (value: number | undefined, otherwise: number) => (value !== undefined && Number.isFinite(value) ? Math.min(1, Math.max(0, value)) : otherwise);
const clampedColor = (color: readonly number[]) => [0, 1, 2, 3].map((k) => clamped(color[k], k < 3 ? 0 : 1));

function direction(v: readonly number[] | undefined, otherwise: readonly number[]): readonly number[] {
  const length = v ? Math.hypot(v[0]!, v[1]!, v[2]!) : 0;
  return v && Number.isFinite(length) && length > 1e-12 ? v.map((x) => x / length) : otherwise;
}

// The file that a mesh refers to by a name: it is beside the mesh, in upper or lower case.
export function companion(files: Files, name: string): Uint8Array<ArrayBuffer> | null {
  const last = (path: string) => path.split(/[\\/]/).at(-1)!.toLowerCase();
  for (const wanted of [last(name), last(decoded(name))]) {
    for (const [known, bytes] of files) if (wanted === last(known) || wanted.endsWith(` ${last(known)}`)) return bytes; // options may precede it
  }
  return null;
}
function decoded(name: string): string {
  try {
    return decodeURIComponent(name);
  } catch {
    return name;
  }
}

// Vertices with the same numbers are stored once; they are found by their bits.
class Part {
  readonly look: number;
  readonly width: number;
  count = 0;
  corners = new Uint32Array(3 * 256);
  cornerCount = 0;
  private data: Float32Array<ArrayBuffer>;
  private bits: Uint32Array<ArrayBuffer>;
  private table = new Int32Array(1024).fill(-1);

  constructor(look: number, width: number) {
    this.look = look;
    this.width = width;
    this.data = new Float32Array(256 * width);
    this.bits = new Uint32Array(this.data.buffer);
  }

  add(numbers: readonly number[]): void {
    if (this.cornerCount === this.corners.length) {
      const more = new Uint32Array(2 * this.corners.length);
      more.set(this.corners);
      this.corners = more;
    }
    this.corners[this.cornerCount++] = this.vertex(numbers);
  }

  private vertex(numbers: readonly number[]): number {
    const { width } = this;
    if ((this.count + 1) * width > this.data.length) this.grow();
    const begin = this.count * width;
    for (let k = 0; k < width; k++) this.data[begin + k] = numbers[k]! + 0; // makes -0 and +0 equal
    const slot = this.slot(this.count);
    if (this.table[slot]! < 0) this.table[slot] = this.count++;
    return this.table[slot]!;
  }

  // The slot of the vertex in the hash table, or a free one.
  private slot(vertex: number): number {
    const { bits, width, table } = this;
    const mask = table.length - 1;
    let hash = 0x811c9dc5;
    for (let k = 0; k < width; k++) {
      hash = Math.imul(hash ^ bits[vertex * width + k]!, 0x9e3779b1);
      hash ^= hash >>> 15;
    }
    for (let at = hash & mask; ; at = (at + 1) & mask) {
      const known = table[at]!;
      if (known < 0) return at;
      let k = 0;
      while (k < width && bits[known * width + k] === bits[vertex * width + k]) k++;
      if (k === width) return at;
    }
  }

  private grow(): void {
    const data = new Float32Array(2 * this.data.length);
    data.set(this.data);
    this.data = data;
    this.bits = new Uint32Array(data.buffer);
    this.table = new Int32Array(2 * this.table.length).fill(-1);
    for (let i = 0; i < this.count; i++) this.table[this.slot(i)] = i;
  }

  // Columns of all vertices, one after the other.
  columns(first: number, width: number): Float32Array<ArrayBuffer> {
    const out = new Float32Array(this.count * width);
    for (let i = 0; i < this.count; i++) for (let k = 0; k < width; k++) out[i * width + k] = this.data[i * this.width + first + k]!;
    return out;
  }
}

interface Kind {
  part: Part;
  columns: [string, number][]; // names and widths of the attributes of its vertices
}

export class Triangles {
  readonly files: Files;
  private readonly parts = new Map<string, Kind>();
  private readonly looks = new Map<string, number>();
  private readonly materials: Record<string, unknown>[] = [];
  private readonly pictures = new Map<string, number>();
  private readonly images: { name: string; type: string; bytes: Uint8Array<ArrayBuffer> }[] = [];
  private readonly notes: string[] = [];
  private count = 0;

  constructor(files: Files) {
    this.files = files;
  }

  // Adds a note about a part that the result lacks, for the program that uses it.
  note(text: string): void {
    if (this.notes.length < MOST_NOTES && !this.notes.includes(text)) this.notes.push(text);
  }

  // The index of a material; equal materials have the same index.
  look({ name, color, picture }: Look): number {
    const texture = picture ? this.picture(picture) : -1;
    const factor = clampedColor(color);
    const key = JSON.stringify([name, factor, texture]);
    let index = this.looks.get(key);
    if (index === undefined) {
      this.looks.set(key, (index = this.materials.length));
      this.materials.push({
        name,
        pbrMetallicRoughness: { baseColorFactor: factor, metallicFactor: 0, roughnessFactor: 0.6, ...(texture < 0 ? {} : { baseColorTexture: { index: texture } }) },
        ...(factor[3]! < 1 ? { alphaMode: "BLEND" } : {}),
      });
    }
    return index;
  }

  private picture(name: string): number {
    let index = this.pictures.get(name);
    if (index !== undefined) return index;
    index = -1;
    const bytes = companion(this.files, name);
    const picture = bytes && pictureOf(bytes);
    if (!bytes) this.note(`the picture "${shown(name)}" is left out: there is no such file beside the mesh`);
    else if (!picture) this.note(`the picture "${shown(name)}" is left out: it is no PNG and no JPEG`);
    else if (!(Math.min(picture.width, picture.height) > 0 && Math.max(picture.width, picture.height) <= MOST_SIDE)) {
      refuse(`the picture "${shown(name)}" says it has ${picture.width} x ${picture.height} pixels; expected 1 to ${MOST_SIDE} in each direction`);
    } else index = this.images.push({ name: shown(name), type: picture.type, bytes }) - 1;
    this.pictures.set(name, index);
    return index;
  }

  // look  -1: the file gives no colour.
  add(look: number, corners: readonly [Corner, Corner, Corner]): void {
    checkCount(++this.count);
    for (const { at } of corners) {
      for (const x of at) {
        if (!Number.isFinite(x)) refuse("a coordinate of a vertex is no number");
        if (Math.abs(x) > FARTHEST) refuse(`a vertex lies at ${x.toPrecision(3)} m; expected 10 km at most`);
      }
    }
    const has = (name: "normal" | "picture" | "color") => corners.every((corner) => corner[name]);
    const [normals, pictured, colored] = [has("normal"), has("picture"), has("color")];
    const { part } = this.kind(look, normals, pictured, colored);
    const face = normals ? faceOf(corners) : [];
    for (const corner of corners) {
      const numbers = [...corner.at];
      if (normals) numbers.push(...direction(corner.normal, face));
      if (pictured) {
        const [u, v] = corner.picture!;
        if (!(Math.abs(u!) < 1e6 && Math.abs(v!) < 1e6)) refuse("a position on a picture is no number");
        numbers.push(u!, 1 - v!);
      }
      if (colored) numbers.push(...clampedColor(corner.color!));
      part.add(numbers);
    }
  }

  private kind(look: number, normals: boolean, pictured: boolean, colored: boolean): Kind {
    const key = `${look} ${normals} ${pictured} ${colored}`;
    let kind = this.parts.get(key);
    if (!kind) {
      const columns: [string, number][] = [["POSITION", 3]];
      if (normals) columns.push(["NORMAL", 3]);
      if (pictured) columns.push(["TEXCOORD_0", 2]);
      if (colored) columns.push(["COLOR_0", 4]);
      kind = { part: new Part(look, columns.reduce((sum, [, width]) => sum + width, 0)), columns };
      this.parts.set(key, kind);
    }
    return kind;
  }

  // A GLB file. If the source has no normals, it has none: then every triangle is flat.
  finish(name: string): ArrayBuffer {
    if (this.count === 0) refuse("there are no triangles in it");
    const views: Record<string, unknown>[] = [];
    const accessors: Record<string, unknown>[] = [];
    const pieces: Uint8Array<ArrayBuffer>[] = [];
    let length = 0;
    const view = (bytes: Uint8Array<ArrayBuffer>, target?: number) => {
      views.push({ buffer: 0, byteOffset: length, byteLength: bytes.length, ...(target ? { target } : {}) });
      const padded = new Uint8Array(4 * Math.ceil(bytes.length / 4));
      padded.set(bytes);
      pieces.push(padded);
      length += padded.length;
      return views.length - 1;
    };
    const accessor = (numbers: Float32Array<ArrayBuffer> | Uint32Array<ArrayBuffer>, type: string, target: number, more: object = {}) =>
      accessors.push({ bufferView: view(new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength), target), componentType: numbers instanceof Float32Array ? 5126 : 5125, count: numbers.length / WIDTHS[type]!, type, ...more }) - 1;
    const primitives = [...this.parts.values()].map(({ part, columns }) => {
      let first = 0;
      const attributes = columns.map(([attribute, width]) => {
        const numbers = part.columns(first, width);
        first += width;
        return [attribute, accessor(numbers, width === 2 ? "VEC2" : width === 3 ? "VEC3" : "VEC4", 34962, attribute === "POSITION" ? bounds(numbers) : {})];
      });
      return { attributes: Object.fromEntries(attributes), indices: accessor(part.corners.slice(0, part.cornerCount), "SCALAR", 34963), ...(part.look < 0 ? {} : { material: part.look }) };
    });
    const images = this.images.map(({ name: file, type, bytes }) => ({ name: file, mimeType: type, bufferView: view(bytes) }));
    const half = Math.SQRT1_2; // rotates z up to y up, as in glTF
    const json = {
      asset: { version: "2.0", generator: "armlet" },
      scene: 0,
      scenes: [{ nodes: [0] }],
      nodes: [{ name: shown(name), rotation: [-half, 0, 0, half], mesh: 0 }],
      meshes: [{ primitives }],
      ...(this.materials.length ? { materials: this.materials } : {}),
      accessors,
      ...(images.length ? { images, textures: images.map((_, source) => ({ source })) } : {}),
      bufferViews: views,
      buffers: [{ byteLength: length }],
    };
    const binary = new Uint8Array(length);
    let at = 0;
    for (const piece of pieces) {
      binary.set(piece, at);
      at += piece.length;
    }
    return glbOf(json, binary, this.notes);
  }
}

const WIDTHS: Record<string, number> = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

function bounds(numbers: Float32Array): { min: number[]; max: number[] } {
  const [min, max] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  for (let i = 0; i < numbers.length; i++) {
    min[i % 3] = Math.min(min[i % 3]!, numbers[i]!);
    max[i % 3] = Math.max(max[i % 3]!, numbers[i]!);
  }
  return { min, max };
}

function faceOf([a, b, c]: readonly [Corner, Corner, Corner]): readonly number[] {
  const [u, v] = [b, c].map(({ at }) => at.map((x, k) => x - a.at[k]!)) as [number[], number[]];
  return direction([u[1]! * v[2]! - u[2]! * v[1]!, u[2]! * v[0]! - u[0]! * v[2]!, u[0]! * v[1]! - u[1]! * v[0]!], [0, 0, 1]);
}
