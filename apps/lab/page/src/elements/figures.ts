// The figures of a program: plots where their lines run from left to right, otherwise pictures that can be enlarged.
import type uPlot from "uplot";
import { el, save } from "../dom/dom.ts";
import { isPlottable, seriesOfPanel } from "../numbers/figure.ts";
import { csvOf } from "../numbers/series.ts";
import type { RobotInfo } from "../protocol/messages.ts";
import type { Figure } from "../store/run.ts";
import { color, enlarge, largeHeight, makeChart } from "./chart.ts";
import type { ElementView } from "./view.ts";

interface FigureView {
  root: HTMLElement;
  draw(): void;
  dispose(): void;
}

function figure(of: Figure, robots: readonly RobotInfo[]): FigureView {
  const title = of.title || "Figure";
  const address = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(of.svg)}`;
  const panels = of.panels?.every(isPlottable) ? of.panels.map((panel) => ({ title: panel.title, series: seriesOfPanel(panel, robots) })) : [];
  const large = el("button", { class: "tiny", "aria-label": `Show ${title} large` }, "Large");
  const charts: uPlot[] = [];
  const hosts = panels.map(() => el("div", { class: "plot" }));
  const csv = el("button", { class: "tiny", hidden: !panels.length, "aria-label": `Save ${title} as CSV`, onclick: () => save(`${title}.csv`, new Blob([panels.map(({ series }) => csvOf(series)).join("\n")], { type: "text/csv" })) }, "CSV");
  const root = el(
    "div", { class: "figure plotted", role: "group", "aria-label": title },
    el("div", { class: "caption" }, title, el("span", { class: "tools" }, large, csv, el("a", { class: "tiny", href: address, download: `${title}.svg`, "aria-label": `Save ${title} as SVG` }, "SVG"))),
    ...(panels.length ? panels.flatMap((panel, i) => [panel.title && panels.length > 1 ? el("h3", {}, panel.title) : null, hosts[i]!]) : [el("img", { src: address, alt: title })]),
  );
  const draw = () => {
    for (const chart of charts.splice(0)) chart.destroy();
    const wide = root.classList.contains("wide");
    panels.forEach(({ series }, i) => {
      const height = wide ? largeHeight(panels.length) : panels.length > 1 ? 140 : 190;
      charts.push(makeChart({ series, width: Math.max(200, hosts[i]!.clientWidth), height, sync: `figure ${of.title}`, rest: () => series.t[series.t.length - 1] ?? 0 }, hosts[i]!));
    });
  };
  enlarge(root, large, draw);
  const observer = new ResizeObserver(() => charts.forEach((chart, i) => {
    const width = hosts[i]!.clientWidth;
    if (width > 0 && Math.abs(chart.width - width) > 1) chart.setSize({ width, height: chart.height });
  }));
  for (const host of hosts) observer.observe(host);
  const dispose = () => {
    observer.disconnect();
    for (const chart of charts) chart.destroy();
  };
  return { root, draw, dispose };
}

export function figures(): ElementView {
  const root = el("div", { class: "element figures", role: "group", "aria-label": "Figures" });
  let views: FigureView[] = [];
  let drawn = "";
  let shown = "";
  return {
    root,
    update(run) {
      root.hidden = run.figures.size === 0;
      const all = [...run.figures.values()];
      const key = `${run.id} ${color("--grid")} ${all.map((f) => f.svg.length).join()}`;
      if (key === drawn) return;
      drawn = key;
      const content = JSON.stringify([color("--grid"), all]);
      if (content === shown) return; // a figure that stays the same keeps its zoom
      shown = content;
      for (const view of views) view.dispose();
      views = all.map((each) => figure(each, run.robots));
      root.replaceChildren(el("h2", {}, "Figures"), ...views.map((view) => view.root));
      for (const view of views) view.draw();
    },
    dispose() {
      for (const view of views) view.dispose();
    },
  };
}
