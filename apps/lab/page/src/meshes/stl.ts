// STL, as text and in binary form.
import { refuse, shown, type Corner, type Triangles } from "./triangles.ts";
import { linesOf, numberOf } from "./words.ts";

const HEADER = 84;
const TRIANGLE = 50;

// A binary file is one whose length is what its header says, whatever it begins with, and one that does not begin with `solid`.
export function readStl(bytes: Uint8Array<ArrayBuffer>, into: Triangles): void {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const isExact = bytes.length >= HEADER && bytes.length === HEADER + TRIANGLE * view.getUint32(80, true);
  const start = new TextDecoder("latin1").decode(bytes.subarray(0, HEADER));
  if (!isExact && /^(\xef\xbb\xbf)?\s*(solid|facet)(\s|$)/i.test(start) && !start.includes("\0")) readText(bytes, into);
  else readBinary(bytes, into);
}

// Words stand in any case, `end solid` may be two, names are the rest of their line, and lines that are unknown outside of facets
// are passed over. Zeros and the sign by which DOS ends files may stand behind the text.
function readText(bytes: Uint8Array<ArrayBuffer>, into: Triangles): void {
  let end = bytes.length;
  while (end > 0 && (bytes[end - 1]! <= 0x20 && /[\0\x1a\s]/.test(String.fromCharCode(bytes[end - 1]!)))) end--;
  const reader = new TextReader(into);
  let number = 0;
  linesOf(bytes.subarray(0, end), (line) => {
    for (const each of line.replace(/\r$/, "").split("\r")) reader.line(each, ++number);
  });
  reader.finish();
}

class TextReader {
  private readonly into: Triangles;
  private corners: Corner[] = [];
  private numbers: number[] | null = null; // of the vertex that is being read
  private normal = 0; // words of a normal that are still to come
  private inFacet = false;
  private isOpen = false;
  private isEnd = false; // the last word was `end`
  private unknown = ""; // why the last word is refused

  constructor(into: Triangles) {
    this.into = into;
  }

  line(line: string, number: number): void {
    for (const word of line.replace(/^\ufeff/, "").split(/\s+/)) {
      if (word && !(this.inFacet ? this.inside(word, number) : this.outside(word, number))) return;
    }
  }

  finish(): void {
    if (this.inFacet) refuse("it is cut off: `endfacet` is missing");
    if (this.isOpen) this.noteMissingEnd();
  }

  private noteMissingEnd(): void {
    this.into.note("`endsolid` is missing: it may be cut off");
  }

  private wordOf(word: string): string {
    const full = (this.isEnd ? "end" : "") + word.toLowerCase();
    this.isEnd = full === "end";
    return full;
  }

  // False: the rest of the line is passed over.
  private outside(word: string, number: number): boolean {
    switch (this.wordOf(word)) {
      case "end":
        return true;
      case "facet":
        this.inFacet = true;
        return true;
      case "solid":
        if (this.isOpen) this.noteMissingEnd();
        this.isOpen = true;
        return false;
      case "endsolid":
        this.isOpen = false;
        return false;
      default:
        this.into.note(`line ${number} begins with "${shown(word)}", which is not read`);
        return false;
    }
  }

  private inside(word: string, number: number): boolean {
    if (this.unknown) refuse(this.unknown);
    if (this.numbers) {
      this.numbers.push(numberOf(word, `line ${number}`));
      if (this.numbers.length < 3) return true;
      this.corners.push({ at: this.numbers });
      this.numbers = null;
      return true;
    }
    if (this.normal > 0) {
      this.normal--;
      return true;
    }
    switch (this.wordOf(word)) {
      case "normal":
        this.normal = 3;
        break;
      case "vertex":
        this.numbers = [];
        break;
      case "endfacet":
        this.endFacet(number);
        break;
      case "end": case "outer": case "loop": case "endloop":
        break;
      default:
        this.unknown = `line ${number} has "${shown(word)}" in a facet`; // or the half of a word, if the text ends here
    }
    return true;
  }

  private endFacet(number: number): void {
    if (this.corners.length !== 3) refuse(`the facet that ends in line ${number} has ${this.corners.length} corners; expected 3`);
    this.into.add(-1, this.corners as [Corner, Corner, Corner]);
    this.corners = [];
    this.inFacet = false;
  }
}

// Two bytes behind each triangle may have its colour, five bits for each of three. Whether they do is said by a bit, which Magics,
// whose files have a colour for the rest in the header, uses the other way round.
//
// source  A. Hiller, in Wikipedia, STL (file format), "Color"; Materialise, Magics.
function readBinary(bytes: Uint8Array<ArrayBuffer>, into: Triangles): void {
  if (bytes.length < HEADER) refuse(`it is cut off: it has ${bytes.length} bytes`);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = view.getUint32(80, true);
  const most = Math.floor((bytes.length - HEADER) / TRIANGLE);
  const start = new TextDecoder("latin1").decode(bytes.subarray(0, HEADER));
  if (/^[\s -~]*$/.test(start)) refuse(`it is no STL file: it begins with "${shown(start.trim().split(/\s/)[0]!)}"`);
  if (count !== most) refuse(`its header says ${count} triangles, but there are bytes for ${most}`);
  const extra = bytes.length - HEADER - count * TRIANGLE;
  if (extra > 0) into.note(`${extra} ${extra === 1 ? "byte" : "bytes"} behind its ${count} triangles ${extra === 1 ? "is" : "are"} not read`);
  const found = new TextDecoder("latin1").decode(bytes.subarray(0, 80)).indexOf("COLOR=");
  const rest = found >= 0 && found + 10 <= 80 ? [...bytes.subarray(found + 6, found + 10)].map((x) => x / 255) : null;
  const colorOf = (bits: number): number[] | undefined => {
    const own = [0, 5, 10].map((shift) => ((bits >> shift) & 31) / 31);
    if (rest) return bits & 0x8000 ? rest : [...own, 1];
    return bits & 0x8000 ? [...own.reverse(), 1] : undefined;
  };
  const colored = into.look({ name: "", color: [1, 1, 1, 1], picture: "" });
  for (let i = 0; i < count; i++) {
    const begin = HEADER + TRIANGLE * i;
    const color = colorOf(view.getUint16(begin + 48, true));
    const corners = [12, 24, 36].map((first): Corner => ({ at: [0, 4, 8].map((k) => view.getFloat32(begin + first + k, true)), color }));
    into.add(color ? colored : -1, corners as [Corner, Corner, Corner]);
  }
}
