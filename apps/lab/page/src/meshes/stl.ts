// STL, as text and in binary form, read by three. Three ignores words that it does not know, so files are checked first.
import type { BufferGeometry } from "three";
import { STLLoader } from "three/examples/jsm/loaders/STLLoader.js";
import { cornerOf, refuse, shown, type Corner, type Triangles } from "./triangles.ts";
import { NUMBER, textOf } from "./words.ts";

const HEADER = 84;
const TRIANGLE = 50;

// A file is binary if its length is what its header says, whatever it begins with, or if it does not begin with `solid`.
export function readStl(bytes: Uint8Array<ArrayBuffer>, into: Triangles): void {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const isExact = bytes.length >= HEADER && bytes.length === HEADER + TRIANGLE * view.getUint32(80, true);
  const start = new TextDecoder("latin1").decode(bytes.subarray(0, HEADER));
  if (!isExact && /^(\xef\xbb\xbf)?\s*(solid|facet)(\s|$)/i.test(start) && !start.includes("\0")) readText(bytes, into);
  else readBinary(bytes, into);
}

// Triangles are flat, whatever normals the file gives. `alpha`: the opacity in files of Magics.
function parsed(file: string | ArrayBuffer): BufferGeometry & { alpha?: number } {
  return new STLLoader().parse(file).deleteAttribute("normal");
}

// After the text there may be zeros and the character that ends files of DOS.
function readText(bytes: Uint8Array<ArrayBuffer>, into: Triangles): void {
  const text = textOf(bytes.subarray(0, bytes.findLastIndex((byte) => byte > 0x20) + 1)).toLowerCase().replace(/\r\n?/g, "\n");
  const facets = facetsOf(text, into);
  if (!facets.length) return;
  const geometry = parsed(`solid \n${facets.join("\n")}\nendsolid`);
  for (let i = 0; i < geometry.getAttribute("position").count; i += 3) into.add(-1, cornersOf(geometry, i));
}

const VERTEX = `\\s+vertex${`\\s+${NUMBER.source}`.repeat(3)}`;
const FACET = new RegExp(`facet(?:\\s+normal(?:\\s+\\S+){3})?(?:\\s+outer)?(?:\\s+loop)?(${VERTEX.repeat(3)})(?:\\s+end\\s*loop)?\\s+end\\s*facet(?!\\S)`, "iy");

// The facets of a text as three reads them. Unknown lines outside of facets are ignored.
function facetsOf(text: string, into: Triangles): string[] {
  const facets: string[] = [];
  const missing = () => into.note("`endsolid` is missing: it may be cut off");
  const rest = /.*/y;
  const lineAt = lines(text);
  let isOpen = false;
  for (let at = text.search(/\S/); at >= 0 && at < text.length; ) {
    FACET.lastIndex = rest.lastIndex = at;
    const facet = FACET.exec(text);
    if (facet) facets.push(`facet normal 0 0 0 outer loop ${facet[1]} endloop endfacet`);
    const words = facet ? "" : rest.exec(text)![0];
    if (/^facet(\s|$)/.test(words)) refuse(faultOf(text.slice(at), lineAt(at)));
    if (/^solid(\s|$)/.test(words)) {
      if (isOpen) missing();
      isOpen = true;
    } else if (/^end\s*solid(\s|$)/.test(words)) isOpen = false;
    else if (words) into.note(`line ${lineAt(at)} begins with "${shown(words.split(/\s/)[0]!)}", which is not read`);
    const next = /\S/g;
    next.lastIndex = facet ? FACET.lastIndex : rest.lastIndex;
    at = next.exec(text)?.index ?? -1;
  }
  if (isOpen) missing();
  return facets;
}

// Returns the line of a position, from 1 on; positions must be ascending.
function lines(text: string): (at: number) => number {
  let [line, next] = [1, text.indexOf("\n")];
  return (at) => {
    for (; next >= 0 && next < at; next = text.indexOf("\n", next + 1)) line++;
    return line;
  };
}

// The mistake in the facet with which the text begins.
function faultOf(text: string, line: number): string {
  const end = /(?<!\S)end\s*facet(?!\S)/.exec(text);
  const facet = text.slice(0, end ? end.index + end[0].length : text.length);
  const lineAt = lines(facet);
  const words = [...facet.matchAll(/\S+/g)].map((found) => ({ word: found[0], line: line + lineAt(found.index) - 1 }));
  const isNumber = new RegExp(`^${NUMBER.source}$`, "i");
  const cut = end ? undefined : words.at(-1); // at the end of the text a word may be incomplete
  const known = /^(facet|normal|outer|loop|vertex|end|end(loop|facet))$/;
  for (let i = 0; i < words.length; i++) {
    const { word, line: here } = words[i]!;
    if (word === "normal") i += 3;
    else if (word === "vertex") {
      const wrong = words.slice(i + 1, i + 4).find((each) => !isNumber.test(each.word));
      if (wrong && wrong !== cut) return `line ${wrong.line} has "${shown(wrong.word)}" where a number should be`;
      i += 3;
    } else if (!known.test(word) && words[i] !== cut) return `line ${here} has "${shown(word)}" in a facet`;
  }
  if (!end) return "it is cut off: `endfacet` is missing";
  return `the facet that ends in line ${words.at(-1)!.line} has ${words.filter(({ word }) => word === "vertex").length} corners; expected 3`;
}

const cornersOf = (geometry: BufferGeometry, first: number) => [first, first + 1, first + 2].map((i) => cornerOf(geometry, i)) as [Corner, Corner, Corner];

// The two bytes after each triangle may have its colour, with five bits per component. One bit says whether they do; Magics, whose files
// have a default colour in the header, inverts this bit. Three reads the form of Magics.
//
// source  A. Hiller, in Wikipedia, STL (file format), "Color"; Materialise, Magics.
function readBinary(bytes: Uint8Array<ArrayBuffer>, into: Triangles): void {
  const file = bytes.slice();
  const view = new DataView(file.buffer);
  checkLength(file, into);
  const start = new TextDecoder("latin1").decode(file.subarray(0, 80));
  const isMagics = start.slice(0, 76).includes("COLOR=");
  const count = view.getUint32(80, true);
  const bits = Uint16Array.from({ length: count }, (_, i) => view.getUint16(HEADER + TRIANGLE * i + 48, true));
  if (!isMagics) {
    file.set(new TextEncoder().encode("COLOR="));
    bits.forEach((word, i) => view.setUint16(HEADER + TRIANGLE * i + 48, ((word >> 10) & 31) | (word & 0x3e0) | ((word & 31) << 10), true));
  }
  const geometry = parsed(file.buffer.slice(0, HEADER + TRIANGLE * count));
  const colored = into.look({ name: "", color: [1, 1, 1, 1], picture: "" });
  bits.forEach((word, i) => {
    const isMarked = (word & 0x8000) !== 0;
    const corners = cornersOf(geometry, 3 * i);
    for (const corner of corners) corner.color = isMagics || isMarked ? [...corner.color!.slice(0, 3), isMagics && isMarked ? geometry.alpha! : 1] : undefined;
    into.add(isMagics || isMarked ? colored : -1, corners);
  });
}

function checkLength(bytes: Uint8Array<ArrayBuffer>, into: Triangles): void {
  if (bytes.length < HEADER) refuse(`it is cut off: it has ${bytes.length} bytes`);
  const start = new TextDecoder("latin1").decode(bytes.subarray(0, HEADER));
  if (/^[\s -~]*$/.test(start)) refuse(`it is no STL file: it begins with "${shown(start.trim().split(/\s/)[0]!)}"`);
  const count = new DataView(bytes.buffer).getUint32(80, true);
  const most = Math.floor((bytes.length - HEADER) / TRIANGLE);
  if (count !== most) refuse(`its header says ${count} triangles, but there are bytes for ${most}`);
  const extra = bytes.length - HEADER - count * TRIANGLE;
  if (extra > 0) into.note(`${extra} ${extra === 1 ? "byte" : "bytes"} behind its ${count} triangles ${extra === 1 ? "is" : "are"} not read`);
}
