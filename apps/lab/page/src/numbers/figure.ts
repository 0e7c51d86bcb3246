// The panels of a figure as data for plots.
import type { FigurePanel, RobotInfo } from "../protocol/messages.ts";
import { jointNames } from "./joints.ts";
import type { Column, Series } from "./series.ts";
import { shownUnit } from "./units.ts";

const isSorted = (x: readonly (number | null)[]) => x.every((v, i) => v !== null && (i === 0 || v >= x[i - 1]!));

// Whether a plot can show the panel: all lines run from left to right. A map, lengths over lengths, is drawn to scale and stays a picture.
export function isPlottable(panel: FigurePanel): boolean {
  const isMap = panel.x.unit === "m" && panel.y.unit === "m";
  return !isMap && panel.series.length > 0 && panel.series.every(({ x, kind }) => x.length > 0 && isSorted(x) && (kind === "line" || kind === "points"));
}

// All series over one list of x. Where a series has no value at an x there is `undefined`, and the line goes on; where its value is no
// number there is null, and the line has a gap.
function joined(series: FigurePanel["series"]): { x: number[]; values: (number | null | undefined)[][] } {
  const first = series[0]!.x as number[];
  if (series.every(({ x }) => x.length === first.length && x.every((v, i) => v === first[i]))) return { x: first, values: series.map(({ y }) => y) };
  // A step has two values at one x: the second one counts as a little later.
  const step = 1e-9 * (Math.max(...series.map(({ x }) => Math.abs(x.at(-1)!))) || 1);
  const own = series.map(({ x }) => {
    const out: number[] = [];
    for (const v of x as number[]) out.push(out.length && v <= out.at(-1)! ? out.at(-1)! + step : v);
    return out;
  });
  const x = [...new Set(own.flat())].sort((a, b) => a - b);
  const place = new Map(x.map((v, i) => [v, i]));
  const values = series.map(({ y }, k) => {
    const column = new Array<number | null | undefined>(x.length).fill(undefined);
    own[k]!.forEach((v, i) => (column[place.get(v)!] = y[i]));
    return column;
  });
  return { x, values };
}

// robots  of the run, whose joints may be what lines without a name are about.
export function seriesOfPanel(panel: FigurePanel, robots: readonly RobotInfo[] = []): Series {
  const { x, values } = joined(panel.series);
  const below = shownUnit(panel.x.unit);
  const units = panel.series.map((each) => (each.right ? panel.right : panel.y).unit);
  const names = jointNames(units, units.length, robots, [panel.title]) ?? [];
  const columns = panel.series.map((each, k): Column => {
    const axis = each.right ? panel.right : panel.y;
    const shown = shownUnit(axis.unit);
    return {
      label: each.label || names[k] || (panel.series.length > 1 ? `line ${k + 1}` : axis.label || panel.title || "y"),
      unit: shown.unit,
      values: values[k]!.map((v) => (typeof v === "number" ? v * shown.factor : v)),
      right: each.right,
      points: each.kind === "points",
    };
  });
  return { t: x.map((v) => v * below.factor), columns, below: { label: panel.x.label, unit: below.unit, log: panel.x.log }, log: panel.y.log };
}
