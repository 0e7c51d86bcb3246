// Drawings over the picture of a camera: marks, and paths of features; computed from values only, for tests without a browser.
import type { Marks } from "../protocol/pictures.ts";
import type { Rows } from "../store/rows.ts";

export interface Way {
  points: [number, number][];
  until: number; // number of points up to the shown instant
}

// The paths of features around the instant t, from the rows (t, x0, y0, x1, y1 ...) of a view. When a feature moves by more than `jump`
// px at once, a new path begins.
export function waysOf(rows: Rows | undefined, t: number, jump: number): Way[] {
  if (!rows?.count) return [];
  const features = (rows.columns - 1) >> 1;
  let until = 0;
  while (until < rows.count && rows.time(until) <= t + 1e-9) until++;
  return Array.from({ length: features }, (_, k) => {
    const at = (i: number): [number, number] => [rows.at(i, 1 + 2 * k), rows.at(i, 2 + 2 * k)];
    const jumps = (i: number) => Math.hypot(at(i)[0] - at(i - 1)[0], at(i)[1] - at(i - 1)[1]) > jump;
    let [begin, end] = [Math.max(0, until - 1), Math.max(1, until)];
    while (begin > 0 && !jumps(begin)) begin--;
    while (end < rows.count && !jumps(end)) end++;
    return { points: Array.from({ length: end - begin }, (_, i) => at(begin + i)), until: Math.max(0, until - begin) };
  });
}

const NAMES: Record<string, [string, string]> = { feature: ["feature", "features"], corner: ["corner", "corners"], truth: ["true corner", "true corners"], wanted: ["wanted", "wanted"] };

// "4 features, 4 wanted".
export function marksText(marks: readonly Marks[]): string {
  const counts = new Map<string, number>();
  for (const { what, pixels } of marks) counts.set(what, (counts.get(what) ?? 0) + pixels.length);
  const known = Object.keys(NAMES);
  return [...counts].sort(([a], [b]) => known.indexOf(a) - known.indexOf(b)).map(([what, count]) => `${count} ${(NAMES[what] ?? [what, what])[count === 1 ? 0 : 1]}`).join(", ");
}

// The error of features, px: the largest distance between a feature and the wanted point of the same number; null: they cannot be
// compared.
export function farthest(marks: readonly Marks[]): number | null {
  const features = marks.find((each) => each.what === "feature")?.pixels;
  const wanted = marks.find((each) => each.what === "wanted")?.pixels;
  if (!features || !wanted || features.length !== wanted.length) return null;
  return Math.max(...features.map(([x, y], i) => Math.hypot(x - wanted[i]![0], y - wanted[i]![1])));
}
