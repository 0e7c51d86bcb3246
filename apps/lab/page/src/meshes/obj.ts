// OBJ with its materials (MTL), read by three. Three ignores statements that it does not know and splits polygons as if they were convex;
// so it gets checked statements, with polygons already split into triangles.
//
// source  Wavefront, Advanced Visualizer manual, appendix B1, as in P. Bourke, Object files (.obj).
import { Color, SRGBColorSpace, type Mesh } from "three";
import { MTLLoader, type MaterialInfo } from "three/examples/jsm/loaders/MTLLoader.js";
import { OBJLoader } from "three/examples/jsm/loaders/OBJLoader.js";
import { cutPolygon } from "./polygon.ts";
import { checkCount, companion, cornerOf, refuse, shown, type Corner, type Look, type Triangles } from "./triangles.ts";
import { numberOf, textOf } from "./words.ts";

const MOST_CORNERS = 32_767;

// The words of each statement, and the number of its last line: a line that ends with \ continues in the next one.
function* statementsOf(bytes: Uint8Array<ArrayBuffer>): Generator<[string[], number]> {
  const lines = textOf(bytes).split(/\r?\n/);
  for (let i = 0; i < lines.length; i++) {
    const parts: string[] = [];
    while (lines[i]!.endsWith("\\") && i + 1 < lines.length) parts.push(lines[i++]!.slice(0, -1));
    yield [[...parts, lines[i]!].join(" ").replace(/#.*/, "").trim().split(/\s+/), i + 1];
  }
}

// The materials of a library by their names.
function materialsOf(bytes: Uint8Array<ArrayBuffer>): [string, Look][] {
  const lines: string[] = [];
  for (const [words, line] of statementsOf(bytes)) {
    const isColor = /^kd$/i.test(words[0]!);
    if (isColor && /^(spectral|xyz)$/.test(words[1] ?? "")) continue;
    if (isColor && words.length === 2) words.push(words[1]!, words[1]!); // the same for red, green and blue
    if (isColor) for (let k = 1; k <= 3; k++) numberOf(words[k], `line ${line} of its materials`);
    if (/^(d|tr)$/i.test(words[0]!)) numberOf(words.at(-1), `line ${line} of its materials`);
    lines.push(words.join(" "));
  }
  const infos = new MTLLoader().parse(lines.join("\n"), "").materialsInfo as Record<string, MaterialInfo>;
  return Object.entries(infos).map(([name, info]) => [name, lookOf(name, info)]);
}

// A picture is shown unchanged: programs differ in how they combine a colour with it.
function lookOf(name: string, { kd = [0.6, 0.6, 0.6], d, tr, map_kd: picture = "" }: MaterialInfo): Look {
  const last = (value: unknown) => Number(String(value).split(" ").at(-1));
  const opacity = d !== undefined ? last(d) : tr !== undefined ? 1 - last(tr) : 1;
  const [r, g, b] = kd as [number, number, number];
  return { name, color: [...(picture ? [1, 1, 1] : new Color().setRGB(r, g, b, SRGBColorSpace).toArray()), opacity], picture };
}

// An OBJ file while it is checked.
class Statements {
  readonly looks: (Look | null)[] = [null]; // used by faces, by their indices; null: the file gives no colours
  private readonly into: Triangles;
  private readonly materials = new Map<string, Look>();
  private readonly points: number[][] = [];
  private readonly colors: number[][] = []; // of points with a colour
  private readonly pictures: number[][] = [];
  private readonly normals: number[][] = [];
  private readonly faces = ["usemtl 0"];
  private count = 0; // triangles

  constructor(into: Triangles) {
    this.into = into;
  }

  take([kind, ...rest]: string[], line: number): void {
    const number = (k: number) => numberOf(rest[k], `line ${line}`);
    if (kind === "v") {
      // After x, y and z there may be w, or a colour.
      this.points.push([0, 1, 2].map(number));
      if (rest.length >= 6) this.colors.push([-3, -2, -1].map((k) => number(rest.length + k)));
    } else if (kind === "vt") this.pictures.push([number(0), rest.length > 1 ? number(1) : 0]);
    else if (kind === "vn") this.normals.push([0, 1, 2].map(number));
    else if (kind === "mtllib") this.library(rest);
    else if (kind === "usemtl") {
      const look = this.materials.get(rest.join(" ")) ?? null;
      if (!this.looks.includes(look)) this.looks.push(look);
      this.faces.push(`usemtl ${this.looks.indexOf(look)}`);
    } else if (kind === "f" || kind === "fo") {
      if (rest.length > MOST_CORNERS) refuse(`line ${line} has a face of ${rest.length} corners, but the limit is ${MOST_CORNERS}`);
      this.face(rest);
    }
  }

  // One name, which may contain blanks, or several.
  private library(words: string[]): void {
    for (const name of companion(this.into.files, words.join(" ")) ? [words.join(" ")] : words) {
      const library = companion(this.into.files, name);
      if (library) for (const [material, look] of materialsOf(library)) this.materials.set(material, look);
      else this.into.note(`the file "${shown(name)}" cannot be read: there is no such file beside the mesh`);
    }
  }

  private face(words: string[]): void {
    const lists = [["v", this.points], ["vt", this.pictures], ["vn", this.normals]] as const;
    const corners = words.map((word) => word.split("/").slice(0, 3).map((index, k) => (index || k === 0 ? named(lists[k]![0], lists[k]![1].length, index) : "")));
    const points = corners.map(([at]) => this.points[Number(at) - 1]!);
    const triangles = cutPolygon(points);
    checkCount((this.count += triangles.length));
    for (const three of triangles) this.faces.push(`f ${three.map((k) => corners[k]!.join("/")).join(" ")}`);
  }

  get hasNormals(): boolean {
    return this.normals.length > 0;
  }

  // The text for three: lists first, because faces refer to their elements from 1 on.
  text(): string {
    const hasColors = this.colors.length === this.points.length;
    const points = this.points.map((point, i) => `v ${[...point, ...(hasColors ? this.colors[i]! : [])].join(" ")}`);
    return [...points, ...this.pictures.map((at) => `vt ${at.join(" ")}`), ...this.normals.map((at) => `vn ${at.join(" ")}`), ...this.faces].join("\n");
  }
}

// The index of the element that a corner refers to: from 1 on, or from -1 backwards, in the lines above it.
function named(kind: string, length: number, word: string): string {
  const index = Number(word);
  const at = index < 0 ? length + index + 1 : index;
  if (!Number.isInteger(index) || !(at >= 1 && at <= length)) refuse(`a face names ${kind} ${shown(word)}, but there are ${length} above it`);
  return String(at);
}

export function readObj(bytes: Uint8Array<ArrayBuffer>, into: Triangles): void {
  const statements = new Statements(into);
  for (const [words, line] of statementsOf(bytes)) statements.take(words, line);
  for (const mesh of new OBJLoader().parse(statements.text()).children as Mesh[]) {
    if (!("isMesh" in mesh)) continue; // points without faces
    const { geometry } = mesh;
    if (!statements.hasNormals) geometry.deleteAttribute("normal"); // three has computed them from the triangles
    const materials = [mesh.material].flat();
    const groups = geometry.groups.length ? geometry.groups : [{ start: 0, count: geometry.getAttribute("position").count, materialIndex: 0 }];
    for (const { start, count, materialIndex = 0 } of groups) {
      const look = statements.looks[Number(materials[materialIndex]!.name)] ?? null;
      const isColored = geometry.hasAttribute("color") && !look?.picture;
      const number = isColored ? into.look({ name: look?.name ?? "", color: [1, 1, 1, look?.color[3] ?? 1], picture: "" }) : look ? into.look(look) : -1;
      const corner = (i: number): Corner => {
        const { at, normal, picture, color } = cornerOf(geometry, i);
        return { at, normal, picture: look?.picture ? picture : undefined, color: isColored ? color : undefined };
      };
      for (let i = start; i < start + count; i += 3) into.add(number, [corner(i), corner(i + 1), corner(i + 2)]);
    }
  }
}
