// Plots over time: drag to zoom, double click for the whole, click to go to that instant.
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { el, save, setText } from "../dom/dom.ts";
import { besideOf, csvOf, seriesOf, svgOf, type Series } from "../numbers/series.ts";
import type { Run } from "../store/run.ts";
import { LEFT, rightMargin, spanOf } from "../timebar/lanes.ts";
import type { ElementView, Place } from "./view.ts";

function colors(): string[] {
  const style = getComputedStyle(document.documentElement);
  return [0, 1, 2, 3, 4, 5, 6].map((i) => style.getPropertyValue(`--s${i}`).trim());
}

function color(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

// A plot below the time bar has the same scale; `right` px beside it stay free.
interface Below {
  span: number;
  right: number;
}

// beside  another run, drawn dashed in the same colours.
function options(series: Series, beside: Series | null, width: number, below: Below | null, clicked: (t: number) => void, drawn: (chart: uPlot) => void): uPlot.Options {
  const units = [...new Set(series.columns.map((c) => c.unit))];
  const lines = [...series.columns.map((c, k) => ({ c, k, of: {} })), ...(beside?.columns ?? []).map((c, k) => ({ c, k, of: { dash: [5, 4], class: "beside" } }))];
  const text = color("--quiet");
  const grid = { stroke: color("--grid"), width: 1 };
  const font = "11px system-ui, sans-serif";
  const palette = colors();
  const axis = (unit: string, i: number): uPlot.Axis => ({
    scale: unit || "y", side: i ? 1 : 3, stroke: text, font, size: below ? LEFT - 16 : 52, grid: i ? { show: false } : grid, ticks: grid, label: unit, labelSize: 16, labelFont: font, gap: 2,
  });
  return {
    width,
    height: below ? 132 : 168,
    ...(below ? { padding: [8, units.length > 1 ? below.right - LEFT : below.right, 0, 0] as uPlot.Padding } : {}),
    legend: { live: false },
    cursor: { drag: { x: true, y: false }, points: { size: 6 } },
    scales: { x: { time: false } },
    axes: [{ stroke: text, font, grid, ticks: grid, size: 28, values: (_u, ticks) => ticks.map((v) => `${+v.toPrecision(6)} s`) }, ...units.slice(0, 2).map(axis)],
    series: [
      { label: "t", value: (_u, v) => (v === null ? "" : `${v.toFixed(2)} s`) },
      ...lines.map(({ c, k, of }): uPlot.Series => ({
        label: c.label, scale: c.unit || "y", stroke: palette[k % palette.length]!, width: 1.5, points: { show: false }, ...of,
        value: (_u, v) => (v === null ? "–" : `${v.toFixed(2)} ${c.unit}`),
      })),
    ],
    hooks: {
      draw: [drawn],
      init: [(u) => u.over.addEventListener("click", () => {
        if (u.select.width < 2 && u.cursor.left !== undefined && u.cursor.left >= 0) clicked(u.posToVal(u.cursor.left, "x"));
      })],
    },
  };
}

export function plot(place: Place): ElementView {
  const { element, index, intents } = place;
  const label = element.label || element.name;
  const host = el("div", { class: "plot" });
  const now = el("div", { class: "plot-now" });
  const dashed = el("span", { class: "dashed", title: "Dashed lines are those of this run" });
  const empty = el("p", { class: "quiet" }, "Nothing to draw yet.");
  let chart: uPlot | null = null;
  let below: Below | null = null;
  let series: Series = { t: new Float64Array(), columns: [] };
  let drawn = "";
  let shape = "";
  let instant = 0;
  // The scales, and the memory for new values, are known only when the plot is drawn.
  const showInstant = (on: uPlot) => (now.style.transform = `translateX(${on.valToPos(instant, "x").toFixed(1)}px)`);
  const tools = el(
    "span", { class: "tools" },
    el("button", { class: "tiny", onclick: () => save(`${label}.csv`, new Blob([csvOf(series)], { type: "text/csv" })), "aria-label": `Save ${label} as CSV` }, "CSV"),
    el("button", { class: "tiny", onclick: () => chart && savePicture(chart, label), "aria-label": `Save ${label} as PNG` }, "PNG"),
    el("button", { class: "tiny", onclick: () => save(`${label}.svg`, new Blob([svgOf(label, series, colors())], { type: "image/svg+xml" })), "aria-label": `Save ${label} as SVG` }, "SVG"),
  );
  const draw = (run: Run, other: Run | null) => {
    series = seriesOf(element, index, run);
    const beside = other && besideOf(element, other);
    setText(dashed, beside ? `– – run ${other!.id}` : "");
    const some = series.t.length > 1;
    empty.hidden = some;
    host.hidden = !some;
    if (!some) return;
    const dataOf = ({ t, columns }: Series) => [t, ...columns.map((c) => c.values)] as unknown as uPlot.AlignedData;
    const data = beside ? uPlot.join([dataOf(series), dataOf(beside)]) : dataOf(series);
    const nextShape = `${below?.right} ${[series, beside].map((each) => each?.columns.map((c) => c.label + c.unit).join()).join(";")} ${color("--grid")}`;
    if (chart && shape === nextShape) chart.setData(data);
    else {
      shape = nextShape;
      chart?.destroy();
      chart = new uPlot(options(series, beside, Math.max(200, host.clientWidth), below, (t) => intents.goTo(t), showInstant), data, host);
      chart.over.append(now);
    }
    if (below) chart.setScale("x", { min: 0, max: below.span });
  };
  const observer = new ResizeObserver(() => host.clientWidth > 0 && chart && Math.abs(chart.width - host.clientWidth) > 1 && chart.setSize({ width: host.clientWidth, height: chart.height }));
  observer.observe(host);
  return {
    root: el("div", { class: "element", role: "group", "aria-label": label }, el("h2", {}, label, dashed, tools), host, empty),
    update(run, state) {
      const other = state.ghost === null || state.ghost === run.id ? null : (state.runs.get(state.ghost) ?? null);
      below = state.plotsBelow ? { span: spanOf(state), right: rightMargin(state) } : null;
      const key = `${run.id} ${run.version} ${other?.id} ${other?.version} ${color("--grid")} ${JSON.stringify(below)}`;
      if (key !== drawn) draw(run, other);
      drawn = key;
      instant = state.t;
      if (chart) showInstant(chart);
    },
    dispose() {
      observer.disconnect();
      chart?.destroy();
    },
  };
}

// The image of a chart has no background.
function savePicture(chart: uPlot, label: string): void {
  const source = chart.ctx.canvas;
  const copy = el("canvas", { width: source.width, height: source.height });
  const context = copy.getContext("2d");
  if (!context) return;
  context.fillStyle = color("--ground");
  context.fillRect(0, 0, copy.width, copy.height);
  context.drawImage(source, 0, 0);
  copy.toBlob((blob) => blob && save(`${label}.png`, blob));
}
