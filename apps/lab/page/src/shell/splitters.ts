// Edges between parts of the page that can be moved, by dragging or with the arrow keys. A double click restores the default.
import { el, remember, remembered } from "../dom/dom.ts";

export interface Edge {
  label: string;
  axis: "x" | "y";
  class: string;
  // Moves the edge to where the first part has this size, px, as far as both keep the least size.
  move(size: number): void;
  // The sizes of the two parts, px.
  sizes(): [number, number];
  reset(): void;
}

const STEP = 24; // px for an arrow key
const LEAST = 200; // px of a column
const LEAST_HEIGHT = 80;

function edge({ label, axis, class: name, move, sizes, reset }: Edge): HTMLElement {
  const at = (event: PointerEvent) => (axis === "x" ? event.clientX : event.clientY);
  let start: { at: number; size: number } | null = null;
  const element = el("div", { class: `edge ${axis} ${name}`, role: "separator", tabindex: 0, "aria-label": label, "aria-orientation": axis === "x" ? "vertical" : "horizontal", "aria-valuenow": 50, title: `${label}: drag; double click restores it` });
  const tell = () => {
    const [a, b] = sizes();
    if (a + b > 0) element.setAttribute("aria-valuenow", String(Math.round((100 * a) / (a + b))));
  };
  element.addEventListener("pointerdown", (event) => {
    start = { at: at(event), size: sizes()[0] };
    element.setPointerCapture(event.pointerId);
    event.preventDefault();
  });
  element.addEventListener("pointermove", (event) => {
    if (!start) return;
    move(start.size + at(event) - start.at);
    tell();
  });
  const end = () => (start = null);
  element.addEventListener("pointerup", end);
  element.addEventListener("pointercancel", end);
  element.addEventListener("dblclick", () => {
    reset();
    tell();
  });
  element.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: -STEP, ArrowUp: -STEP, ArrowRight: STEP, ArrowDown: STEP }[event.key];
    if (!step || (axis === "x") !== /Left|Right/.test(event.key)) return;
    event.preventDefault();
    event.stopPropagation();
    move(sizes()[0] + step);
    tell();
  });
  element.addEventListener("focus", tell);
  return element;
}

const clamp = (value: number, low: number, high: number) => Math.max(low, Math.min(high, value));

// Sizes of parts in shares ("fr") that a style sheet reads from variables of `host`.
class Shares {
  private readonly host: HTMLElement;
  private readonly key: string;
  private readonly defaults: Record<string, number>;
  private now: Record<string, number>;

  constructor(host: HTMLElement, key: string, defaults: Record<string, number>) {
    this.host = host;
    this.key = key;
    this.defaults = defaults;
    this.now = { ...defaults };
    const kept = remembered(key)?.split(" ").map(Number) ?? [];
    if (kept.length === Object.keys(defaults).length && kept.every((each) => each > 0 && Number.isFinite(each))) {
      Object.keys(defaults).forEach((name, i) => (this.now[name] = kept[i]!));
      this.apply();
    }
  }

  between(first: string, second: string, parts: [HTMLElement, HTMLElement], about: { label: string; axis: "x" | "y"; class: string }): HTMLElement {
    const sizes = (): [number, number] => parts.map((part) => (about.axis === "x" ? part.offsetWidth : part.offsetHeight)) as [number, number];
    const set = (share: number) => {
      const both = this.now[first]! + this.now[second]!;
      this.now[first] = both * share;
      this.now[second] = both * (1 - share);
      this.apply();
      remember(this.key, Object.values(this.now).map((each) => each.toFixed(3)).join(" "));
    };
    return edge({
      ...about,
      sizes,
      move: (size) => {
        const [a, b] = sizes();
        const least = Math.min(about.axis === "x" ? LEAST : LEAST_HEIGHT, (a + b) / 2);
        if (a + b > 0) set(clamp(size, least, a + b - least) / (a + b));
      },
      reset: () => set(this.defaults[first]! / (this.defaults[first]! + this.defaults[second]!)),
    });
  }

  private apply(): void {
    for (const [name, share] of Object.entries(this.now)) this.host.style.setProperty(`--${name}`, `${share}fr`);
  }
}

interface Columns {
  program: HTMLElement;
  view: HTMLElement;
  elements: HTMLElement;
}

// The edges between the columns, between 3D view and elements of a laboratory in two rows, and above the panels of the editor.
export function splitters(main: HTMLElement, columns: Columns, below: HTMLElement): void {
  const { program, view, elements } = columns;
  const widths = new Shares(main, "widths", { program: 37, view: 40, side: 24 });
  const heights = new Shares(main, "heights", { upper: 55, lower: 45 });
  program.append(widths.between("program", "view", [program, view], { label: "Width of the program", axis: "x", class: "at-end" }));
  elements.prepend(
    widths.between("view", "side", [view, elements], { label: "Width of the 3D view", axis: "x", class: "at-start" }),
    heights.between("upper", "lower", [view, elements], { label: "Height of the 3D view", axis: "y", class: "at-top" }),
  );
  below.prepend(panelEdge(program, below));
}

// Panels are as high as their contents, up to a third of the column, until the user chooses a height.
function panelEdge(column: HTMLElement, below: HTMLElement): HTMLElement {
  const set = (share: number | null) => {
    if (share === null) below.style.removeProperty("--panels");
    else below.style.setProperty("--panels", `${(100 * share).toFixed(1)}%`);
    remember("panels", share === null ? "" : String(share));
  };
  const kept = Number(remembered("panels"));
  if (kept > 0 && kept < 1) set(kept);
  return edge({
    label: "Height of the program", axis: "y", class: "at-top",
    sizes: () => [column.offsetHeight - below.offsetHeight, below.offsetHeight],
    move: (size) => set(1 - clamp(size, LEAST_HEIGHT, column.offsetHeight - 60) / column.offsetHeight),
    reset: () => set(null),
  });
}
