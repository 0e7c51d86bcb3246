// The window of a camera, and pictures computed by a program: the picture at the shown instant, with marks over it.
import { el, setText } from "../dom/dom.ts";
import type { Marks, PictureAnswer } from "../protocol/pictures.ts";
import type { Run } from "../store/run.ts";
import { farthest, marksText, waysOf, type Way } from "./marks.ts";
import type { ElementView, Place } from "./view.ts";

const MOST_LABELS = 40;
const JUMP = 0.1; // of the width: a longer step between two instants is a jump, not a path

type Attributes = Record<string, string | number>;
function svg(tag: string, attributes: Attributes, ...children: Node[]): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

const path = (points: readonly [number, number][]) => points.map(([x, y], i) => `${i ? "L" : "M"}${x.toFixed(2)} ${y.toFixed(2)}`).join("");

const cross = (x: number, y: number, r: number) => `M${x - r} ${y}h${2 * r}M${x} ${y - r}v${2 * r}`;
const ring = (x: number, y: number, r: number) => `M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0z`;
const square = (x: number, y: number, r: number) => `M${x - r} ${y - r}h${2 * r}v${2 * r}h${-2 * r}z`;

// A line with a dark outline, so that it is visible on every picture.
const rimmed = (kind: string, d: string) => [svg("path", { class: "rim", d }), svg("path", { class: kind, d })];

// Marks of one kind. `unit` is the size of a screen pixel in pixels of the picture.
function drawnMarks({ what, pixels }: Marks, unit: number): SVGElement[] {
  const all = (shape: (x: number, y: number) => string) => rimmed(`mark ${what}`, pixels.map(([x, y]) => shape(x, y)).join(""));
  if (what === "wanted") return all((x, y) => ring(x, y, 6 * unit) + cross(x, y, 2.5 * unit));
  if (what === "truth") return all((x, y) => cross(x, y, 5 * unit));
  if (what !== "feature") return all((x, y) => square(x, y, 3 * unit));
  return pixels.flatMap(([x, y], i): SVGElement[] => {
    const dot = svg("circle", { class: `mark ${what}`, cx: x, cy: y, r: 3.5 * unit });
    if (i >= MOST_LABELS) return [dot];
    return [dot, svg("text", { class: "mark-name", x: x + 6 * unit, y: y - 5 * unit, "font-size": 11 * unit }, document.createTextNode(String(i)))];
  });
}

// The whole path pale, its part in the past dark, and a small square at its start.
function drawnWay({ points, until }: Way, unit: number): SVGElement[] {
  const [first] = points;
  if (!first) return [];
  return [
    svg("path", { class: "way to-come", d: path(points) }),
    ...rimmed("way", path(points.slice(0, Math.max(1, until)))),
    svg("path", { class: "way-begin", d: square(first[0], first[1], 2.5 * unit) }),
  ];
}

export function cameraView({ element, index, intents }: Place): ElementView {
  const label = element.label || element.name;
  const canvas = el("canvas", { role: "img", "aria-label": label });
  const over = svg("svg", { "aria-hidden": "true" });
  const frame = el("div", { class: "camera-frame" }, canvas);
  frame.append(over);
  const note = el("p", { class: "quiet camera-note" });
  const why = el("p", { class: "reason" });
  const wide: HTMLButtonElement = el("button", {
    class: "tiny", "aria-pressed": "false", title: "Show this picture large", onclick: () => {
      const on = root.classList.toggle("wide");
      wide.setAttribute("aria-pressed", String(on));
      drawn = "";
      redraw();
    },
  }, "Large");
  const root = el("div", { class: "element camera", role: "group", "aria-label": label }, el("h2", {}, label, el("span", { class: "tools" }, wide)), frame, note, why);
  const leave = intents.pictures.want(element.name);
  let shown: PictureAnswer | null = null;
  let drawn = "";
  let redraw = () => {};

  const draw = (picture: PictureAnswer) => {
    if (canvas.width !== picture.width || canvas.height !== picture.height) {
      canvas.width = picture.width;
      canvas.height = picture.height;
      over.setAttribute("viewBox", `-0.5 -0.5 ${picture.width} ${picture.height}`);
    }
    canvas.getContext("2d", { willReadFrequently: true })!.putImageData(new ImageData(picture.rgba, picture.width, picture.height), 0, 0);
  };
  return {
    root,
    dispose: leave,
    update(run: Run, state) {
      redraw = () => this.update(run, state, true);
      const seen = run.pictures.get(element.name);
      frame.classList.toggle("empty", !seen?.picture && !shown);
      setText(why, seen?.fault || seen?.picture?.fault || "");
      if (!seen?.picture) {
        setText(note, seen?.fault ? "" : intents.live ? "Drawing …" : "A recording has no pictures of cameras.");
        return;
      }
      const { picture } = seen;
      if (picture !== shown) draw(picture);
      const rows = run.elementRows.get(index);
      const key = `${run.id} ${seen.key} ${rows?.count} ${state.t} ${frame.clientWidth}`;
      if (picture === shown && key === drawn) return;
      [shown, drawn] = [picture, key];
      const unit = picture.width / Math.max(1, frame.clientWidth);
      const ways = waysOf(rows, seen.t, JUMP * picture.width);
      over.replaceChildren(...ways.flatMap((way) => drawnWay(way, unit)), ...picture.marks.flatMap((marks) => drawnMarks(marks, unit)));
      const far = farthest(picture.marks);
      const told = [element.camera, `${picture.width} x ${picture.height}`, marksText(picture.marks), far === null ? "" : `largest error ${far.toFixed(1)} px`];
      setText(note, told.filter(Boolean).join(" · "));
      canvas.setAttribute("aria-label", `${label}: ${note.textContent}`);
    },
  };
}
