// The data of a plot: columns over time, from the rows of an element or the track of a robot; and as files.
import type { ElementInfo } from "../protocol/messages.ts";
import type { Run } from "../store/run.ts";
import { jointNames } from "./joints.ts";
import { shownUnit } from "./units.ts";

export interface Column {
  label: string;
  unit: string;
  values: ArrayLike<number | null | undefined>;
  right?: boolean; // on the right axis, in a figure
  points?: boolean; // without a line
}
// `t` holds the values of the axis below; they are times in s unless `below` says something else.
export interface Series {
  t: ArrayLike<number>;
  columns: Column[];
  below?: { label: string; unit: string; log: boolean };
  log?: boolean; // the other axes
}

const DERIVATIVES = ["q", "qd", "qdd"];

// "q of arm" and similar plots use the robot's track.
export function trackPlot(element: ElementInfo, run: Run): { robot: number; derivative: number } | null {
  const match = /^(q|qd|qdd) of (.+)$/.exec(element.name);
  const robot = match ? run.robots.findIndex((r) => r.name === match[2]) : -1;
  return robot < 0 ? null : { robot, derivative: DERIVATIVES.indexOf(match![1]!) };
}

// The same data of another run with which this one is compared; null: there is none.
export function besideOf(element: ElementInfo, run: Run): Series | null {
  const index = run.elements.findIndex((each) => each.kind === element.kind && each.name === element.name);
  if (index < 0 && !trackPlot(element, run)) return null;
  const series = seriesOf(run.elements[index] ?? element, index, run);
  return series.t.length > 1 ? series : null;
}

export function seriesOf(element: ElementInfo, index: number, run: Run): Series {
  const own = trackPlot(element, run);
  if (own) return trackSeries(run, own.robot, own.derivative);
  const rows = run.elementRows.get(index);
  if (!rows?.count) return { t: new Float64Array(), columns: [] };
  const title = element.label || element.name;
  const names = element.labels ?? jointNames(element.units, rows.columns - 1, run.robots, [title, element.name]) ?? [];
  const columns: Column[] = [];
  for (let k = 1; k < rows.columns; k++) {
    const shown = shownUnit(element.units?.[k - 1]);
    const label = names[k - 1] ?? (rows.columns === 2 ? title : `${title} ${k}`);
    columns.push({ label, unit: shown.unit, values: rows.column(k).map((v) => v * shown.factor) });
  }
  return { t: rows.column(0), columns };
}

function trackSeries(run: Run, robot: number, derivative: number): Series {
  const track = run.tracks[robot];
  const info = run.robots[robot];
  if (!track || !info) return { t: new Float64Array(), columns: [] };
  const per = ["", "/s", "/s²"][derivative]!;
  const columns = info.joints.map((joint, k): Column => {
    const shown = shownUnit(joint.unit, per);
    return { label: `${DERIVATIVES[derivative]}${k + 1}`, unit: shown.unit, values: track.column(1 + derivative * track.joints + k).map((v) => v * shown.factor) };
  });
  return { t: track.column(0), columns };
}

const withUnit = (label: string, unit: string) => `${label}${unit ? ` [${unit}]` : ""}`;

export function csvOf({ t, columns, below }: Series): string {
  const quoted = (text: string) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const lines = [[withUnit(below ? below.label || "x" : "t", below ? below.unit : "s"), ...columns.map((c) => withUnit(c.label, c.unit))].map(quoted).join(",")];
  for (let i = 0; i < t.length; i++) lines.push([t[i], ...columns.map((c) => c.values[i] ?? "")].join(","));
  return `${lines.join("\n")}\n`;
}

const escaped = (text: string) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

// A plot as a drawing: one panel for each unit, one below the other.
export function svgOf(title: string, { t, columns }: Series, colors: readonly string[]): string {
  const units = [...new Set(columns.map((c) => c.unit))];
  const [width, high, left, top] = [640, 240, 64, 32];
  const [t0, t1] = [t[0] ?? 0, t[t.length - 1] || 1];
  const parts = units.map((unit, u) => {
    const mine = columns.filter((c) => c.unit === unit);
    const all = mine.flatMap((c) => Array.from(c.values).filter((v) => typeof v === "number"));
    const low = all.reduce((a, b) => Math.min(a, b), Infinity);
    const span = all.reduce((a, b) => Math.max(a, b), -Infinity) - low || 1;
    const y0 = top + u * (high + 64);
    const x = (v: number) => left + ((v - t0) / (t1 - t0 || 1)) * (width - left - 16);
    const y = (v: number) => y0 + high - ((v - low) / span) * high;
    const lines = mine.map((c) => {
      const points = Array.from(t, (v, i) => `${x(v).toFixed(2)},${y(c.values[i] ?? NaN).toFixed(2)}`).filter((point) => !point.includes("NaN")).join(" ");
      return `<polyline fill="none" stroke="${colors[columns.indexOf(c) % colors.length]}" stroke-width="1.5" points="${points}"/>`;
    });
    const texts = [0, 0.5, 1].map((s) => `<text x="${left - 6}" y="${y(low + s * span) + 4}" text-anchor="end">${(low + s * span).toPrecision(4)}</text>`);
    const times = [0, 0.5, 1].map((s) => `<text x="${x(t0 + s * (t1 - t0))}" y="${y0 + high + 16}" text-anchor="middle">${(t0 + s * (t1 - t0)).toPrecision(4)} s</text>`);
    const names = mine.map((c, i) => `<text x="${left + 8 + 64 * i}" y="${y0 + 14}" fill="${colors[columns.indexOf(c) % colors.length]}">${escaped(c.label)}</text>`);
    return `<rect x="${left}" y="${y0}" width="${width - left - 16}" height="${high}" fill="none" stroke="#999"/>${lines.join("")}${texts.join("")}${times.join("")}${names.join("")}<text x="${left}" y="${y0 - 6}">${escaped(unit)}</text>`;
  });
  const height = top + units.length * (high + 64);
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" font-family="sans-serif" font-size="11" fill="#333"><title>${escaped(title)}</title>${parts.join("")}</svg>\n`;
}
