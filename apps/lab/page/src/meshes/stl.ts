// STL, as text and in binary form.
import { refuse, shown, type Corner, type Triangles } from "./triangles.ts";
import { linesOf, numberOf } from "./words.ts";

const HEADER = 84;
const TRIANGLE = 50;

export function readStl(bytes: Uint8Array<ArrayBuffer>, into: Triangles): void {
  const start = new TextDecoder("latin1").decode(bytes.subarray(0, 1024));
  if (/^solid/i.test(start) && /facet/i.test(start)) readText(bytes, into);
  else readBinary(bytes, into);
}

function readText(bytes: Uint8Array<ArrayBuffer>, into: Triangles): void {
  let corners: Corner[] = [];
  let isEnded = false;
  linesOf(bytes, (line, number) => {
    const words = line.trim().split(/\s+/);
    switch (words[0]!.toLowerCase()) {
      case "vertex":
        corners.push({ at: [1, 2, 3].map((k) => numberOf(words[k], `line ${number}`)) });
        break;
      case "endfacet":
        if (corners.length !== 3) refuse(`the facet that ends in line ${number} has ${corners.length} corners; expected 3`);
        into.add(-1, corners as [Corner, Corner, Corner]);
        corners = [];
        break;
      case "endsolid":
        isEnded = true;
        break;
      case "solid": case "facet": case "outer": case "endloop": case "":
        break;
      default:
        refuse(`line ${number} begins with "${shown(words[0]!)}"`);
    }
  });
  if (!isEnded) refuse("it is cut off: `endsolid` is missing");
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
  if (count > most) refuse(`its header says ${count} triangles, but there are bytes for ${most}`);
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
