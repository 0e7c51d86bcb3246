// OBJ with its materials (MTL).
//
// source  Wavefront, Advanced Visualizer manual, appendix B1, as in P. Bourke, Object files (.obj).
import { cutPolygon } from "./polygon.ts";
import { companion, refuse, shown, type Corner, type Look, type Triangles } from "./triangles.ts";
import { linesOf, numberOf } from "./words.ts";

const MOST_CORNERS = 32_767;

// Lines whose last sign is \ go on in the next one.
function statementsOf(bytes: Uint8Array<ArrayBuffer>, take: (words: string[], line: number) => void): void {
  let begun = "";
  linesOf(bytes, (line, number) => {
    const text = begun + line.replace(/\r$/, "");
    begun = text.endsWith("\\") ? `${text.slice(0, -1)} ` : "";
    if (begun.length > 1e6) refuse(`the statement that ends in line ${number} has more than a million signs`);
    if (!begun) take(text.replace(/#.*/, "").trim().split(/\s+/), number);
  });
}

// Materials by their names.
function readMaterials(bytes: Uint8Array<ArrayBuffer>, looks: Map<string, Look>): void {
  let look: Look | null = null;
  statementsOf(bytes, (words, line) => {
    const [kind, ...rest] = words;
    const number = (k: number) => numberOf(rest[k], `line ${line} of its materials`);
    if (kind === "newmtl") looks.set(rest.join(" "), (look = { name: rest.join(" "), color: [0.6, 0.6, 0.6, 1], picture: "" }));
    if (!look) return;
    const [r, g, b, a] = look.color as [number, number, number, number];
    if (kind === "Kd" && rest[0] !== "spectral" && rest[0] !== "xyz") look.color = [number(0), number(rest.length > 1 ? 1 : 0), number(rest.length > 2 ? 2 : 0), a];
    if (kind === "d") look.color = [r, g, b, number(rest.length - 1)];
    if (kind === "Tr") look.color = [r, g, b, 1 - number(0)];
    if (kind === "map_Kd") look.picture = pictureName(rest);
  });
}

// Options stand before the name, each with a number of values.
const OPTIONS: Record<string, number> = { "-blendu": 1, "-blendv": 1, "-boost": 1, "-bm": 1, "-cc": 1, "-clamp": 1, "-imfchan": 1, "-mm": 2, "-texres": 1, "-type": 1 };
function pictureName(words: readonly string[]): string {
  let at = 0;
  while (words[at]?.startsWith("-")) {
    const option = words[at++]!;
    if (option in OPTIONS) at += OPTIONS[option]!;
    else while (at < words.length - 1 && !Number.isNaN(Number(words[at]))) at++; // -o, -s, -t: one to three numbers
  }
  return words.slice(at).join(" ");
}

export function readObj(bytes: Uint8Array<ArrayBuffer>, into: Triangles): void {
  const vertices: number[][] = [];
  const colors: number[][] = []; // of vertices; empty: none
  const pictures: number[][] = [];
  const normals: number[][] = [];
  const looks = new Map<string, Look>();
  let look = -1;
  let paint: Look | undefined;
  // The element that a corner names: from 1 on, or from -1 on backwards, of what stands above it.
  const named = (list: number[][], kind: string, word: string | undefined): number => {
    const index = Number(word);
    const at = index < 0 ? list.length + index : index - 1;
    if (!Number.isInteger(index) || !(at >= 0 && at < list.length)) refuse(`a face names ${kind} ${shown(word ?? "")}, but there are ${list.length} above it`);
    return at;
  };
  const cornerOf = (word: string): Corner => {
    const [v, vt, vn] = word.split("/");
    const at = named(vertices, "v", v);
    const color = colors[at]!;
    return {
      at: vertices[at]!,
      picture: vt ? pictures[named(pictures, "vt", vt)] : undefined,
      normal: vn ? normals[named(normals, "vn", vn)] : undefined,
      color: color.length && !paint?.picture ? color : undefined,
    };
  };
  statementsOf(bytes, (words, line) => {
    const [kind, ...rest] = words;
    const number = (k: number) => numberOf(rest[k], `line ${line}`);
    switch (kind) {
      case "v": {
        // Behind x, y and z there may be w, or a colour.
        vertices.push([number(0), number(1), number(2)]);
        colors.push(rest.length >= 6 ? [number(rest.length - 3), number(rest.length - 2), number(rest.length - 1), 1] : []);
        break;
      }
      case "vt":
        pictures.push([number(0), rest.length > 1 ? number(1) : 0]);
        break;
      case "vn":
        normals.push([number(0), number(1), number(2)]);
        break;
      case "mtllib": {
        // One name, which may have blanks in it, or several.
        for (const name of companion(into.files, rest.join(" ")) ? [rest.join(" ")] : rest) {
          const library = companion(into.files, name);
          if (library) readMaterials(library, looks);
          else into.note(`the file "${shown(name)}" cannot be read: there is no such file beside the mesh`);
        }
        break;
      }
      case "usemtl":
        paint = looks.get(rest.join(" "));
        // A picture is shown as it is: what a colour beside it would do differs from program to program.
        look = paint ? into.look(paint.picture ? { ...paint, color: [1, 1, 1, paint.color[3]!] } : paint) : -1;
        break;
      case "f": case "fo": {
        if (rest.length > MOST_CORNERS) refuse(`line ${line} has a face of ${rest.length} corners, but the limit is ${MOST_CORNERS}`);
        const corners = rest.map(cornerOf);
        const isColored = corners.length > 0 && corners.every((corner) => corner.color);
        const own = isColored ? into.look({ name: paint?.name ?? "", color: [1, 1, 1, paint?.color[3] ?? 1], picture: "" }) : look;
        for (const [a, b, c] of cutPolygon(corners.map((corner) => corner.at))) into.add(own, [corners[a]!, corners[b]!, corners[c]!]);
        break;
      }
    }
  });
}
