// Plots over time: a click goes to that instant. All plots of the page have one cursor.
import uPlot from "uplot";
import { el, save, setText } from "../dom/dom.ts";
import { besideOf, csvOf, seriesOf, svgOf, type Series } from "../numbers/series.ts";
import type { ElementInfo } from "../protocol/messages.ts";
import type { Run } from "../store/run.ts";
import { rightMargin, spanOf } from "../timebar/lanes.ts";
import { color, colors, dataOf, enlarge, largeHeight, makeChart, type Below } from "./chart.ts";
import type { ElementView, Place } from "./view.ts";

// Why a plot has no line.
export function whyEmpty(element: ElementInfo, run: Run): string {
  const last = run.moves.reduce((line, move) => Math.max(line, move.span?.[2] ?? 0), 0);
  const block = element.span?.[0] ?? 0;
  if (run.state !== "running" && last > 0 && last < block) return `The moves stand above the lab block (line ${block}), and plots begin with it. Write the block above the moves.`;
  return run.state === "done" && run.tEnd <= 0 ? "No time passes in this run." : "Nothing to draw yet.";
}

export function plot(place: Place): ElementView {
  const { element, index, intents } = place;
  const label = element.label || element.name;
  const host = el("div", { class: "plot" });
  const now = el("div", { class: "plot-now" });
  const dashed = el("span", { class: "dashed", title: "Dashed lines are those of this run" });
  const empty = el("p", { class: "quiet" });
  let chart: uPlot | null = null;
  let below: Below | null = null;
  let series: Series = { t: new Float64Array(), columns: [] };
  let drawn = "";
  let shape = "";
  let instant = 0;
  let redraw = () => {};
  // The scales, and the memory for new values, are known only when the plot is drawn.
  const showInstant = (on: uPlot) => (now.style.transform = `translateX(${on.valToPos(instant, "x").toFixed(1)}px)`);
  const large = el("button", { class: "tiny", "aria-label": `Show ${label} large` }, "Large");
  const tools = el(
    "span", { class: "tools" }, large,
    el("button", { class: "tiny", onclick: () => save(`${label}.csv`, new Blob([csvOf(series)], { type: "text/csv" })), "aria-label": `Save ${label} as CSV` }, "CSV"),
    el("button", { class: "tiny", onclick: () => chart && savePicture(chart, label), "aria-label": `Save ${label} as PNG` }, "PNG"),
    el("button", { class: "tiny", onclick: () => save(`${label}.svg`, new Blob([svgOf(label, series, colors())], { type: "image/svg+xml" })), "aria-label": `Save ${label} as SVG` }, "SVG"),
  );
  const root = el("div", { class: "element plotted", role: "group", "aria-label": label }, el("h2", {}, label, dashed, tools), host, empty);
  enlarge(root, large, () => redraw());
  const draw = (run: Run, other: Run | null) => {
    series = seriesOf(element, index, run);
    const beside = other && besideOf(element, other);
    setText(dashed, beside ? `– – run ${other!.id}` : "");
    const some = series.t.length > 1;
    empty.hidden = some;
    host.hidden = !some;
    if (!some) return setText(empty, whyEmpty(element, run));
    const wide = root.classList.contains("wide");
    const height = wide ? largeHeight() : below ? 132 : 168;
    const nextShape = `${height} ${below?.right} ${[series, beside].map((each) => each?.columns.map((c) => c.label + c.unit).join()).join(";")} ${color("--grid")}`;
    if (chart && shape === nextShape) chart.setData(beside ? uPlot.join([dataOf(series), dataOf(beside)]) : dataOf(series));
    else {
      shape = nextShape;
      chart?.destroy();
      chart = makeChart({ series, beside, width: Math.max(200, host.clientWidth), height, below: wide ? null : below, sync: "time", rest: () => instant, clicked: (t) => intents.goTo(t), drawn: showInstant }, host);
      chart.over.append(now);
    }
    if (below && !wide) chart.setScale("x", { min: 0, max: below.span });
  };
  const observer = new ResizeObserver(() => host.clientWidth > 0 && chart && Math.abs(chart.width - host.clientWidth) > 1 && chart.setSize({ width: host.clientWidth, height: chart.height }));
  observer.observe(host);
  return {
    root,
    update(run, state) {
      const other = state.ghost === null || state.ghost === run.id ? null : (state.runs.get(state.ghost) ?? null);
      below = state.plotsBelow ? { span: spanOf(state), right: rightMargin(state) } : null;
      const key = `${run.id} ${run.version} ${other?.id} ${other?.version} ${color("--grid")} ${JSON.stringify(below)}`;
      const moved = instant !== state.t;
      instant = state.t;
      if (key !== drawn) draw(run, other);
      drawn = key;
      redraw = () => draw(run, other);
      if (!chart) return;
      showInstant(chart);
      if (moved) chart.setCursor({ left: chart.cursor.left ?? -10, top: chart.cursor.top ?? -10 }, true);
    },
    dispose() {
      observer.disconnect();
      chart?.destroy();
    },
  };
}

// The image of a chart has no background.
export function savePicture(chart: uPlot, label: string): void {
  const source = chart.ctx.canvas;
  const copy = el("canvas", { width: source.width, height: source.height });
  const context = copy.getContext("2d");
  if (!context) return;
  context.fillStyle = color("--ground");
  context.fillRect(0, 0, copy.width, copy.height);
  context.drawImage(source, 0, 0);
  copy.toBlob((blob) => blob && save(`${label}.png`, blob));
}
