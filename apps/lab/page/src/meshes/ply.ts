// PLY, as text and in both binary forms.
//
// source  G. Turk, The PLY polygon file format, 1994.
import { cutPolygon } from "./polygon.ts";
import { refuse, shown, type Corner, type Triangles } from "./triangles.ts";
import { linesOf, numberOf } from "./words.ts";

const MOST_OF_LIST = 32_767;
const LONGEST_HEADER = 1 << 20; // bytes

// A type of PLY: how a number is read, its bytes, and what stands for 1 where it is a part of a colour.
interface Type {
  size: number;
  one: number;
  read(view: DataView, at: number, isLittle: boolean): number;
}
const TYPES: [string[], Type][] = [
  [["char", "int8"], { size: 1, one: 127, read: (view, at) => view.getInt8(at) }],
  [["uchar", "uint8"], { size: 1, one: 255, read: (view, at) => view.getUint8(at) }],
  [["short", "int16"], { size: 2, one: 32_767, read: (view, at, little) => view.getInt16(at, little) }],
  [["ushort", "uint16"], { size: 2, one: 65_535, read: (view, at, little) => view.getUint16(at, little) }],
  [["int", "int32"], { size: 4, one: 2 ** 31 - 1, read: (view, at, little) => view.getInt32(at, little) }],
  [["uint", "uint32"], { size: 4, one: 2 ** 32 - 1, read: (view, at, little) => view.getUint32(at, little) }],
  [["float", "float32"], { size: 4, one: 1, read: (view, at, little) => view.getFloat32(at, little) }],
  [["double", "float64"], { size: 8, one: 1, read: (view, at, little) => view.getFloat64(at, little) }],
];
function typeOf(name: string): Type {
  return TYPES.find(([names]) => names.includes(name))?.[1] ?? refuse(`its header names the type "${shown(name)}", which PLY has not`);
}

interface Property {
  name: string;
  type: Type;
  count: Type | null; // of a list
}
interface Element {
  name: string;
  count: number;
  properties: Property[];
}
interface Header {
  elements: Element[];
  format: "ascii" | "binary_little_endian" | "binary_big_endian";
  picture: string;
  length: number; // bytes
}

function headerOf(bytes: Uint8Array<ArrayBuffer>): Header {
  const text = new TextDecoder("latin1").decode(bytes.subarray(0, LONGEST_HEADER));
  const header: Header = { elements: [], format: "ascii", picture: "", length: 0 };
  let at = 0;
  for (let isFirst = true; ; isFirst = false) {
    const end = text.indexOf("\n", at);
    const words = text.slice(at, end < 0 ? text.length : end).trim().split(/\s+/);
    const [kind, ...rest] = words as [string, ...string[]];
    if (isFirst && (kind !== "ply" || rest.length)) refuse("it is no PLY file: it does not begin with `ply`");
    if (end < 0) refuse("it is cut off: `end_header` is missing");
    at = end + 1;
    if (kind === "end_header") return { ...header, length: at };
    if (kind === "comment" && rest[0]?.toLowerCase() === "texturefile") header.picture = rest.slice(1).join(" ");
    if (isFirst || ["comment", "obj_info", ""].includes(kind)) continue;
    if (kind === "format") header.format = formatOf(rest[0] ?? "");
    else if (kind === "element" && rest.length === 2) header.elements.push({ name: rest[0]!, count: countOf(rest[0]!, rest[1]!), properties: [] });
    else if (kind === "property" && header.elements.length) header.elements.at(-1)!.properties.push(propertyOf(rest));
    else refuse(`its header has a line that begins with "${shown(kind)}"`);
  }
}

function formatOf(word: string): Header["format"] {
  if (word === "ascii" || word === "binary_little_endian" || word === "binary_big_endian") return word;
  return refuse(`its format "${shown(word)}" is none of PLY`);
}

function countOf(name: string, word: string): number {
  return /^\d{1,15}$/.test(word) ? Number(word) : refuse(`its header says ${shown(word)} elements "${shown(name)}"`);
}

function propertyOf(words: readonly string[]): Property {
  if (words.length === 4 && words[0] === "list") {
    const count = typeOf(words[1]!);
    if (count.one === 1) refuse("its header counts the elements of a list by broken numbers");
    return { name: words[3]!, type: typeOf(words[2]!), count };
  }
  if (words.length !== 2) refuse("its header has a `property` that is none");
  return { name: words[1]!, type: typeOf(words[0]!), count: null };
}

// The elements one after the other: what each property has, a number or a list.
type Row = (number | number[])[];
type Take = (element: Element, row: Row, index: number) => void;

function checkedCount(count: number, element: Element, index: number): number {
  if (Number.isInteger(count) && count >= 0 && count <= MOST_OF_LIST) return count;
  return refuse(`element ${index} "${shown(element.name)}" has a list of ${count}; expected 0 to ${MOST_OF_LIST}`);
}

function rowOf(element: Element, index: number, next: (type: Type) => number): Row {
  return element.properties.map(({ type, count }) => {
    if (!count) return next(type);
    const list: number[] = [];
    for (let left = checkedCount(next(count), element, index); left > 0; left--) list.push(next(type));
    return list;
  });
}

function eachBinary(header: Header, bytes: Uint8Array<ArrayBuffer>, take: Take): void {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const isLittle = header.format === "binary_little_endian";
  let at = header.length;
  for (const element of header.elements) {
    for (let i = 0; i < element.count; i++) {
      if (at >= bytes.length) refuse(`its header says ${element.count} elements "${shown(element.name)}", but there are ${i}`);
      const row = rowOf(element, i, (type) => {
        if (at + type.size > bytes.length) refuse(`it is cut off in element ${i} "${shown(element.name)}"`);
        at += type.size;
        return type.read(view, at - type.size, isLittle);
      });
      take(element, row, i);
    }
  }
}

function eachText(header: Header, bytes: Uint8Array<ArrayBuffer>, take: Take): void {
  let [which, index] = [0, 0];
  const now = () => {
    while (header.elements[which] && index >= header.elements[which]!.count) [which, index] = [which + 1, 0];
    return header.elements[which];
  };
  linesOf(bytes.subarray(header.length), (line) => {
    const words = line.trim().split(/\s+/);
    const element = words[0] === "" ? undefined : now();
    if (!element) return;
    const where = `element ${index} "${shown(element.name)}"`;
    let at = 0;
    const row = rowOf(element, index, () => (at < words.length ? numberOf(words[at++], where) : refuse(`it is cut off in ${where}`)));
    if (at !== words.length) refuse(`${where} has ${words.length} numbers; expected ${at}`);
    take(element, row, index++);
  });
  const missing = now();
  if (missing) refuse(`its header says ${missing.count} elements "${shown(missing.name)}", but there are ${index}`);
}

// Where the properties of an element stand; null where one of them is missing.
function placesOf({ properties }: Element, ...names: string[][]): number[] | null {
  const places = names.map((each) => properties.findIndex((property) => !property.count && each.includes(property.name)));
  return places.some((place) => place < 0) ? null : places;
}

class Vertices {
  readonly all: Corner[] = [];
  private readonly at: number[];
  private readonly normal: number[] | null;
  private readonly picture: number[] | null;
  private readonly color: number[] | null;
  private readonly ones: number[];

  constructor(element: Element, hasPicture: boolean) {
    this.at = placesOf(element, ["x"], ["y"], ["z"]) ?? refuse("its vertices have no x, y and z");
    this.normal = placesOf(element, ["nx"], ["ny"], ["nz"]);
    this.picture = hasPicture ? placesOf(element, ["s", "u", "texture_u"], ["t", "v", "texture_v"]) : null;
    const names = [["red", "r", "diffuse_red"], ["green", "g", "diffuse_green"], ["blue", "b", "diffuse_blue"]];
    this.color = hasPicture ? null : (placesOf(element, ...names, ["alpha", "a", "diffuse_alpha"]) ?? placesOf(element, ...names));
    this.ones = element.properties.map((property) => property.type.one);
  }

  add(row: Row): void {
    const of = (places: number[]) => places.map((place) => row[place] as number);
    this.all.push({
      at: of(this.at),
      normal: this.normal ? of(this.normal) : undefined,
      picture: this.picture ? of(this.picture) : undefined,
      color: this.color ? this.color.map((place) => (row[place] as number) / this.ones[place]!) : undefined,
    });
  }
}

export function readPly(bytes: Uint8Array<ArrayBuffer>, into: Triangles): void {
  const header = headerOf(bytes);
  for (const { name, count, properties } of header.elements) {
    // Without properties an element has no bytes, and any number of them is there.
    if (count > 0 && properties.length === 0) refuse(`its elements "${shown(name)}" have no properties`);
  }
  const vertex = header.elements.find((element) => element.name === "vertex") ?? refuse("it has no vertices");
  const face = header.elements.find((element) => element.name === "face") ?? refuse("it has no faces: clouds of points and strips are not read");
  const list = face.properties.findIndex(({ name, count }) => count && /^vertex_ind/.test(name));
  if (face.count > 0 && list < 0) refuse("its faces have no `vertex_indices`");
  if (header.elements.indexOf(face) < header.elements.indexOf(vertex)) refuse("its faces stand before its vertices");
  const vertices = new Vertices(vertex, header.picture !== "");
  const sample = () => vertices.all[0];
  let look: number | null = null;
  (header.format === "ascii" ? eachText : eachBinary)(header, bytes, (element, row, index) => {
    if (element === vertex) return vertices.add(row);
    if (element !== face) return;
    const corners = (row[list] as number[]).map((i) => vertices.all[i] ?? refuse(`element ${index} "face" names vertex ${i}, but there are ${vertex.count}`));
    look ??= sample()?.picture || sample()?.color ? into.look({ name: "", color: [1, 1, 1, 1], picture: header.picture }) : -1;
    for (const [a, b, c] of cutPolygon(corners.map((corner) => corner.at))) into.add(look, [corners[a]!, corners[b]!, corners[c]!]);
  });
}
