// The path of a tool in a run: a line of constant width on the screen, coloured by speed.
import { Box3, Color, Group, Vector2, Vector3, type Camera } from "three";
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import type { Track } from "../store/rows.ts";
import { speedColor, type Palette } from "./palette.ts";
import { neededPoints } from "./simplify.ts";
import type { Stroke } from "./vector_picture.ts";

const MOST_POINTS = 6000;
// The tolerance of a drawn line, as a fraction of the extent of the path, and of its colour, as a fraction of the top speed.
const AWAY = 2e-4;
const PALER = 0.04;

function extentOf(points: readonly (readonly number[])[]): number {
  const box = new Box3().setFromPoints(points.map(([x = 0, y = 0, z = 0]) => new Vector3(x, y, z)));
  return box.getSize(new Vector3()).length();
}

// Straight parts are drawn as one line: without a graphics processor every point of a line takes time.
function drawn(places: readonly number[][], speeds: readonly number[], top: number): number[] {
  const tolerance = AWAY * extentOf(places);
  return neededPoints(places.map((place, i) => [...place, ((speeds[i] ?? 0) / top) * (tolerance / PALER)]), tolerance);
}

function lineOf(positions: number[], colors: number[] | null, options: { color?: string; width: number; opacity: number; top?: boolean }): Line2 {
  const geometry = new LineGeometry();
  geometry.setPositions(positions);
  if (colors) geometry.setColors(colors);
  const material = new LineMaterial({
    linewidth: options.width,
    vertexColors: colors !== null,
    transparent: true,
    opacity: options.opacity,
    depthTest: !options.top,
    depthWrite: false,
    toneMapped: false,
  });
  if (options.color) material.color.set(options.color);
  const line = new Line2(geometry, material);
  line.frustumCulled = false;
  line.renderOrder = options.top ? 3 : 1;
  return line;
}

export class PathView {
  readonly group = new Group();
  // Rows of the track that are points of the line.
  private points: number[] = [];
  private track: Track | null = null;
  private lines: Line2[] = [];
  private highlight: Line2 | null = null;
  topSpeed = 0;

  draw(track: Track, palette: Palette, kind: "shown" | "ghost" | "stale", topSpeed: number): void {
    this.clear();
    this.track = track;
    const step = Math.max(1, Math.ceil(track.count / MOST_POINTS));
    let last = new Vector3(Infinity, 0, 0);
    const speeds: number[] = [];
    this.topSpeed = 0;
    for (let i = 0; i < track.count; i += step) {
      const point = new Vector3(...track.tool(i));
      if (point.distanceToSquared(last) < 1e-10) continue;
      this.points.push(i);
      speeds.push(track.toolSpeed(i));
      this.topSpeed = Math.max(this.topSpeed, speeds.at(-1)!);
      last = point;
    }
    if (this.points.length < 2) return;
    const top = Math.max(topSpeed, this.topSpeed, 1e-9);
    const places = this.points.map((i) => track.tool(i));
    const kept = drawn(places, kind === "shown" ? speeds : [], top);
    const positions = kept.flatMap((k) => places[k]!);
    if (kind === "shown") {
      const color = new Color();
      const colors = kept.flatMap((k) => speedColor(palette, speeds[k]! / top, color).toArray());
      this.add(lineOf(positions, colors, { width: 3, opacity: 1 }));
      this.add(lineOf(positions, colors, { width: 3, opacity: 0.22, top: true }));
    } else {
      this.add(lineOf(positions, null, { color: palette.gridMajor, width: kind === "ghost" ? 2 : 3, opacity: kind === "ghost" ? 0.75 : 0.5 }));
    }
  }

  // Highlights the path from t0 to t1; nothing if t0 > t1.
  light(ranges: [number, number][], palette: Palette): void {
    if (this.highlight) this.remove(this.highlight);
    this.highlight = null;
    const track = this.track;
    if (!track || !ranges.length) return;
    const positions: number[] = [];
    for (const [t0, t1] of ranges) {
      const from = track.indexAt(t0);
      const to = Math.min(track.count - 1, track.indexAt(t1) + 1);
      const places = Array.from({ length: to - from + 1 }, (_, k) => track.tool(from + k));
      for (const k of drawn(places, [], 1)) positions.push(...places[k]!);
    }
    if (positions.length < 6) return;
    this.highlight = lineOf(positions, null, { color: palette.accent, width: 8, opacity: 0.55, top: true });
    this.group.add(this.highlight);
  }

  // The time at which the path is nearest to a point on the screen (pixels), if it is close to it.
  timeAt(x: number, y: number, width: number, height: number, camera: Camera, within: number): number | null {
    const track = this.track;
    if (!track) return null;
    const at = new Vector2(x, y);
    const seen = (i: number) => {
      const p = new Vector3(...track.tool(i)).project(camera);
      return new Vector2(((p.x + 1) / 2) * width, ((1 - p.y) / 2) * height);
    };
    let best: number | null = null;
    let nearest = within;
    for (let k = 0; k + 1 < this.points.length; k++) {
      const [i, j] = [this.points[k]!, this.points[k + 1]!];
      const [a, b] = [seen(i), seen(j)];
      const along = b.clone().sub(a);
      const s = Math.min(1, Math.max(0, at.clone().sub(a).dot(along) / Math.max(1e-9, along.lengthSq())));
      const distance = a.addScaledVector(along, s).distanceTo(at);
      if (distance < nearest) {
        nearest = distance;
        best = track.time(i) + s * (track.time(j) - track.time(i));
      }
    }
    return best;
  }

  // The path as lines of one colour each.
  strokes(palette: Palette, width: number): Stroke[] {
    const track = this.track;
    if (!track) return [];
    const strokes: Stroke[] = [];
    for (let k = 0; k + 1 < this.points.length; k++) {
      const [i, j] = [this.points[k]!, this.points[k + 1]!];
      const level = Math.round((20 * track.toolSpeed(i)) / Math.max(1e-9, this.topSpeed)) / 20;
      const color = `#${speedColor(palette, level).getHexString()}`;
      const last = strokes.at(-1);
      if (last?.color === color) last.points.push(new Vector3(...track.tool(j)));
      else strokes.push({ points: [new Vector3(...track.tool(i)), new Vector3(...track.tool(j))], color, width });
    }
    return strokes;
  }

  ends(): Vector3[] {
    return this.track ? this.points.filter((_, k) => k % 20 === 0).map((i) => new Vector3(...this.track!.tool(i))) : [];
  }

  clear(): void {
    for (const line of this.lines) this.remove(line);
    if (this.highlight) this.remove(this.highlight);
    this.lines = [];
    this.points = [];
    this.highlight = null;
    this.track = null;
  }

  private add(line: Line2): void {
    this.lines.push(line);
    this.group.add(line);
  }

  private remove(line: Line2): void {
    line.geometry.dispose();
    line.material.dispose();
    line.removeFromParent();
  }
}
