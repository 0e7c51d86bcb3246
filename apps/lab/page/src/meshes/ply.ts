// PLY, as text and in both binary forms. Three reads the vertices; it omits faces with more than four corners, so faces are read here,
// and the counts in the header are checked.
//
// source  G. Turk, The PLY polygon file format, 1994.
import { Color, SRGBColorSpace, type BufferGeometry } from "three";
import { PLYLoader } from "three/examples/jsm/loaders/PLYLoader.js";
import { cutPolygon } from "./polygon.ts";
import { cornerOf, refuse, shown, type Corner, type Triangles } from "./triangles.ts";
import { numberOf, textOf } from "./words.ts";

const MOST_OF_LIST = 32_767;
const LONGEST_HEADER = 1 << 20; // bytes

// A type of PLY: its size in bytes, the value of 1 in a colour, and how a number is read.
interface Type {
  size: number;
  one: number;
  get: "getInt8" | "getUint8" | "getInt16" | "getUint16" | "getInt32" | "getUint32" | "getFloat32" | "getFloat64";
}
const TYPES: [string, Type][] = [
  ["char int8", { size: 1, one: 127, get: "getInt8" }],
  ["uchar uint8", { size: 1, one: 255, get: "getUint8" }],
  ["short int16", { size: 2, one: 32_767, get: "getInt16" }],
  ["ushort uint16", { size: 2, one: 65_535, get: "getUint16" }],
  ["int int32", { size: 4, one: 2 ** 31 - 1, get: "getInt32" }],
  ["uint uint32", { size: 4, one: 2 ** 32 - 1, get: "getUint32" }],
  ["float float32", { size: 4, one: 1, get: "getFloat32" }],
  ["double float64", { size: 8, one: 1, get: "getFloat64" }],
];
function typeOf(name: string): Type {
  return TYPES.find(([names]) => names.split(" ").includes(name))?.[1] ?? refuse(`its header names the type "${shown(name)}", which PLY has not`);
}

interface Property {
  words: string; // of its line in the header
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
  format: string;
  picture: string;
  length: number; // bytes
}

function headerOf(bytes: Uint8Array<ArrayBuffer>): Header {
  const text = new TextDecoder("latin1").decode(bytes.subarray(0, LONGEST_HEADER));
  const header: Header = { elements: [], format: "ascii", picture: "", length: 0 };
  const end = /^end_header[ \t\r]*\n/m.exec(text);
  const [first, ...lines] = text.slice(0, end?.index ?? text.lastIndexOf("\n") + 1).split("\n");
  if (first!.trim() !== "ply") refuse("it is no PLY file: it does not begin with `ply`");
  for (const line of lines) takeLine(header, line.trim().split(/\s+/));
  if (!end) refuse("it is cut off: `end_header` is missing");
  return { ...header, length: end.index + end[0].length };
}

function takeLine(header: Header, [kind = "", ...rest]: string[]): void {
  if (kind === "comment" && rest[0]?.toLowerCase() === "texturefile") header.picture = rest.slice(1).join(" ");
  if (["comment", "obj_info", ""].includes(kind)) return;
  if (kind === "format") header.format = /^(ascii|binary_(little|big)_endian)$/.exec(rest[0] ?? "")?.[0] ?? refuse(`its format "${shown(rest[0] ?? "")}" is none of PLY`);
  else if (kind === "element" && rest.length === 2) {
    if (!/^\d{1,15}$/.test(rest[1]!)) refuse(`its header says ${shown(rest[1]!)} elements "${shown(rest[0]!)}"`);
    header.elements.push({ name: rest[0]!, count: Number(rest[1]), properties: [] });
  } else if (kind === "property" && header.elements.length) header.elements.at(-1)!.properties.push(propertyOf(rest));
  else refuse(`its header has a line that begins with "${shown(kind)}"`);
}

function propertyOf(words: readonly string[]): Property {
  const isList = words.length === 4 && words[0] === "list";
  if (!isList && words.length !== 2) refuse("its header has a `property` that is none");
  const count = isList ? typeOf(words[1]!) : null;
  if (count?.one === 1) refuse("its header counts the elements of a list by broken numbers");
  return { words: words.join(" "), name: words.at(-1)!, type: typeOf(words.at(-2)!), count };
}

// The content after the header: the part for vertices, as three reads it, and the numbers after it one by one.
interface Body {
  vertices: ArrayBuffer | string;
  next(type: Type, where: () => string): number;
  left(): number; // numbers of a text that were not read
}

const tooFew = (element: Element, there: number): never => refuse(`its header says ${element.count} elements "${shown(element.name)}", but there are ${Math.floor(there)}`);

function binaryBody(bytes: Uint8Array<ArrayBuffer>, header: string, vertex: Element, isLittle: boolean): Body {
  const length = vertex.count * vertex.properties.reduce((sum, { type }) => sum + type.size, 0);
  if (length > bytes.length) tooFew(vertex, (vertex.count * bytes.length) / length);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  let at = length;
  const head = new TextEncoder().encode(header);
  const vertices = new Uint8Array(head.length + length);
  vertices.set(head);
  vertices.set(bytes.subarray(0, length), head.length);
  return {
    vertices: vertices.buffer,
    next({ size, get }, where) {
      if (at + size > bytes.length) refuse(`it is cut off in ${where()}`);
      at += size;
      return view[get](at - size, isLittle);
    },
    left: () => 0,
  };
}

function textBody(bytes: Uint8Array<ArrayBuffer>, header: string, vertex: Element): Body {
  const words = textOf(bytes).trim().split(/\s+/).filter((word) => word !== "");
  const width = vertex.properties.length;
  let at = width * vertex.count;
  if (at > words.length) tooFew(vertex, words.length / width);
  for (let i = 0; i < vertex.count; i++) {
    const where = `element ${i} "vertex"`;
    for (let k = 0; k < width; k++) numberOf(words[i * width + k], where);
  }
  return {
    vertices: header + words.slice(0, at).join(" "),
    next: (_type, where) => (at < words.length ? numberOf(words[at++], where()) : refuse(`it is cut off in ${where()}`)),
    left: () => words.length - at,
  };
}

function vertexCorners(data: ArrayBuffer | string, vertex: Element, hasPicture: boolean): Corner[] {
  const channels = (["red", "green", "blue", "alpha"] as const).map((name) => vertex.properties.find((each) => [name, name[0], `diffuse_${name}`].includes(each.name)));
  const named = hasPicture || !channels.slice(0, 3).every(Boolean) ? [] : channels.filter((each) => each !== undefined);
  const loader = new PLYLoader();
  // With three's own names, linear colours would be rounded to the type in the file.
  if (named.length) loader.setCustomPropertyNameMapping({ screen: named.map(({ name }) => name) });
  const geometry: BufferGeometry = loader.parse(data);
  if (geometry.getAttribute("position").count !== vertex.count) refuse("its vertices have no x, y and z");
  const colors = named.length ? geometry.getAttribute("screen") : null;
  const channel = (i: number, k: number) => colors!.getComponent(i, k) / named[k]!.type.one;
  return Array.from({ length: vertex.count }, (_, i): Corner => {
    const { at, normal, picture } = cornerOf(geometry, i);
    const color = colors ? [...new Color().setRGB(channel(i, 0), channel(i, 1), channel(i, 2), SRGBColorSpace).toArray(), named[3] ? channel(i, 3) : 1] : undefined;
    return { at, normal, picture: hasPicture ? picture : undefined, color };
  });
}

// The numbers of an element: those of each list, and one for each other property.
function rowOf({ name, properties }: Element, index: number, next: Body["next"]): number[][] {
  const where = () => `element ${index} "${shown(name)}"`;
  return properties.map(({ type, count }) => {
    const length = count ? next(count, where) : 1;
    if (!(Number.isInteger(length) && length >= 0 && length <= MOST_OF_LIST)) refuse(`${where()} has a list of ${length}; expected 0 to ${MOST_OF_LIST}`);
    return Array.from({ length }, () => next(type, where));
  });
}

export function readPly(bytes: Uint8Array<ArrayBuffer>, into: Triangles): void {
  const header = headerOf(bytes);
  const [vertex, ...others] = header.elements;
  const face = header.elements.find(({ name }) => name === "face");
  for (const { name, count, properties } of header.elements) if (count > 0 && properties.length === 0) refuse(`its elements "${shown(name)}" have no properties`);
  if (!face) refuse("it has no faces: clouds of points and strips are not read");
  if (vertex?.name !== "vertex" || vertex.properties.some(({ count }) => count)) refuse("it does not begin with its vertices, which have no lists");
  const list = face.properties.findIndex(({ name, count }) => count && /^vertex_ind/.test(name));
  if (face.count > 0 && list < 0) refuse("its faces have no `vertex_indices`");
  const described = `ply\nformat ${header.format} 1.0\nelement vertex ${vertex.count}\n${vertex.properties.map(({ words }) => `property ${words}\n`).join("")}end_header\n`;
  const behind = bytes.subarray(header.length);
  const body = header.format === "ascii" ? textBody(behind, described, vertex) : binaryBody(behind, described, vertex, header.format === "binary_little_endian");
  const corners = vertexCorners(body.vertices, vertex, header.picture !== "");
  const look = corners[0]?.picture || corners[0]?.color ? into.look({ name: "", color: [1, 1, 1, 1], picture: header.picture }) : -1;
  for (const element of others) {
    for (let i = 0; i < element.count; i++) {
      const row = rowOf(element, i, body.next);
      if (element !== face) continue;
      const polygon = row[list]!.map((k) => corners[k] ?? refuse(`element ${i} "face" names vertex ${k}, but there are ${vertex.count}`));
      for (const [a, b, c] of cutPolygon(polygon.map(({ at }) => at))) into.add(look, [polygon[a]!, polygon[b]!, polygon[c]!]);
    }
  }
  if (body.left() > 0) refuse(`${body.left()} numbers stand behind its elements`);
}
