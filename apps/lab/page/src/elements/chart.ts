// One chart of uPlot: drag to zoom, double click for the whole; the legend has the values at the cursor, and without one those at the shown
// instant or at the end.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { alignedRanges, type Range } from "../numbers/axes.ts";
import type { Column, Series } from "../numbers/series.ts";
import { fixed } from "../numbers/units.ts";
import { LEFT } from "../timebar/lanes.ts";

export function color(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

export function colors(): string[] {
  return [0, 1, 2, 3, 4, 5, 6].map((i) => color(`--s${i}`));
}

// A plot below the time bar has the same scale; `right` px beside it stay free.
export interface Below {
  span: number;
  right: number;
}

// beside   another run, drawn dashed in the same colours.
// sync     charts with the same word have one cursor and one zoom.
// rest     the x at which the legend has its values while there is no cursor.
export interface ChartOptions {
  series: Series;
  beside?: Series | null;
  width: number;
  height: number;
  below?: Below | null;
  sync: string;
  rest(): number;
  clicked?(x: number): void;
  drawn?(chart: uPlot): void;
}

const scaleOf = (column: Column) => `${column.right ? "right " : ""}${column.unit || "y"}`;

// Writes values with their unit, with four digits of the largest of them.
function valueWriter(all: readonly ArrayLike<number | null | undefined>[], unit: string): (v: number | null | undefined) => string {
  let largest = 0;
  for (const values of all) for (let i = 0; i < values.length; i++) largest = Math.max(largest, Math.abs(values[i] ?? 0) || 0);
  const size = largest > 0 && Number.isFinite(largest) ? Math.floor(Math.log10(largest)) : 0;
  const plain = (v: number) => (size < 7 && size > -5 ? fixed(v, Math.min(6, Math.max(0, 3 - size))) : v === 0 ? "0" : v.toExponential(3));
  return (v) => (typeof v === "number" ? `${plain(v).replace("-", "−")}${unit ? ` ${unit}` : ""}` : "–");
}

// The extents of the shown lines of each scale within the visible part.
function extentsOf(chart: uPlot, scales: readonly string[]): (Range | null)[] {
  const [first, last] = chart.series[0]?.idxs ?? [0, chart.data[0].length - 1];
  return scales.map((scale) => {
    let extent: Range | null = null;
    chart.series.forEach((series, k) => {
      if (k === 0 || series.scale !== scale || series.show === false) return;
      const values = chart.data[k]!;
      for (let i = first; i <= last; i++) {
        const v = values[i];
        if (typeof v === "number" && Number.isFinite(v)) extent = extent ? [Math.min(extent[0], v), Math.max(extent[1], v)] : [v, v];
      }
    });
    return extent;
  });
}

// The point with a value that is next to the one at the cursor.
function nearest(chart: uPlot, series: number, index: number): number {
  const values = chart.data[series]!;
  for (let away = 0; away < values.length; away++) {
    if (typeof values[index - away] === "number") return index - away;
    if (typeof values[index + away] === "number") return index + away;
  }
  return index;
}

function options(given: ChartOptions): uPlot.Options {
  const { series, beside, below } = given;
  const writers = new Map(series.columns.map(({ unit }) => [unit, valueWriter(series.columns.filter((c) => c.unit === unit).map((c) => c.values), unit)]));
  const line = (c: Column, k: number, of: Partial<uPlot.Series>) => ({ c, k, of, write: writers.get(c.unit) ?? valueWriter([c.values], c.unit) });
  const lines = [...series.columns.map((c, k) => line(c, k, {})), ...(beside?.columns ?? []).map((c, k) => line(c, k, { dash: [5, 4], class: "beside" }))];
  const scales = [...new Set(series.columns.toSorted((a, b) => Number(a.right ?? false) - Number(b.right ?? false)).map(scaleOf))];
  const sides = scales.slice(0, 2);
  const unitOf = (scale: string) => series.columns.find((c) => scaleOf(c) === scale)!.unit;
  const text = color("--quiet");
  const grid = { stroke: color("--grid"), width: 1 };
  const font = "11px system-ui, sans-serif";
  const palette = colors();
  const axis = (scale: string, i: number): uPlot.Axis => ({
    scale, side: i ? 1 : 3, stroke: text, font, size: below ? LEFT - 16 : 52, grid: i ? { show: false } : grid, ticks: grid, label: unitOf(scale), labelSize: 16, labelFont: font, gap: 2,
  });
  const x = series.below;
  const isTime = !x || x.unit === "s";
  const writeX = valueWriter([series.t], isTime ? "s" : x.unit);
  const aligned = (scale: string): uPlot.Scale => ({ range: (chart) => alignedRanges(extentsOf(chart, sides))[sides.indexOf(scale)]! });
  const rest = (chart: uPlot) => {
    if (chart.cursor.left === undefined || chart.cursor.left < 0) chart.setLegend({ idxs: chart.series.map((_s, k) => (k ? nearest(chart, k, chart.valToIdx(given.rest())) : chart.valToIdx(given.rest()))) }, false);
  };
  return {
    width: given.width,
    height: given.height,
    ...(below ? { padding: [8, sides.length > 1 ? below.right - LEFT : below.right, 0, 0] as uPlot.Padding } : {}),
    legend: { live: true },
    cursor: { drag: { x: true, y: false }, points: { size: 6 }, sync: { key: given.sync, scales: ["x", null] }, dataIdx: (chart, k, index) => (k ? nearest(chart, k, index) : index) },
    scales: {
      x: { time: false, ...(x?.log ? { distr: 3 as const } : {}) },
      ...Object.fromEntries(scales.map((scale) => [scale, series.log ? { distr: 3 as const } : sides.length > 1 && sides.includes(scale) ? aligned(scale) : {}])),
    },
    axes: [{ stroke: text, font, grid, ticks: grid, size: x?.label && !isTime ? 42 : 28, ...(isTime ? { values: (_u: uPlot, ticks: number[]) => ticks.map((v) => `${+v.toPrecision(6)} s`) } : { label: [x.label, x.unit && `[${x.unit}]`].filter(Boolean).join(" "), labelSize: 16, labelFont: font }) }, ...sides.map(axis)],
    series: [
      { label: isTime ? "t" : x.label || "x", value: (_u, v) => writeX(v) },
      ...lines.map(({ c, k, of, write }): uPlot.Series => ({
        label: c.label, scale: scaleOf(c), stroke: palette[k % palette.length]!, width: 1.5, points: { show: c.points ?? false, size: 5 },
        ...(c.points ? { paths: () => null } : {}), ...of,
        value: (_u, v) => write(v),
      })),
    ],
    hooks: {
      draw: [(chart) => given.drawn?.(chart), rest],
      setCursor: [rest],
      init: [(u) => u.over.addEventListener("click", () => {
        if (u.select.width < 2 && u.cursor.left !== undefined && u.cursor.left >= 0) given.clicked?.(u.posToVal(u.cursor.left, "x"));
      })],
    },
  };
}

export function dataOf({ t, columns }: Series): uPlot.AlignedData {
  return [t, ...columns.map((c) => c.values)] as unknown as uPlot.AlignedData;
}

export function makeChart(given: ChartOptions, host: HTMLElement): uPlot {
  const data = given.beside ? uPlot.join([dataOf(given.series), dataOf(given.beside)]) : dataOf(given.series);
  return new uPlot(options(given), data, host);
}

// Shows an element large, over the page, and small again; Escape makes it small.
export function enlarge(root: HTMLElement, button: HTMLButtonElement, redraw: () => void): void {
  const set = (on: boolean) => {
    root.classList.toggle("wide", on);
    button.setAttribute("aria-pressed", String(on));
    redraw();
  };
  button.setAttribute("aria-pressed", "false");
  button.addEventListener("click", () => set(!root.classList.contains("wide")));
  root.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !root.classList.contains("wide")) return;
    event.stopPropagation();
    set(false);
  });
}

export const largeHeight = (parts = 1): number => Math.max(140, Math.round((0.68 * innerHeight) / parts));
