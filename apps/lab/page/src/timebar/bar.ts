// The time bar: lanes of blocks, ticks for events, other runs as thin lines.
import { el, setText } from "../dom/dom.ts";
import type { Intents } from "../store/intents.ts";
import type { Run } from "../store/run.ts";
import { isStale, shownRun, type State } from "../store/state.ts";
import type { Store } from "../store/store.ts";
import { LEFT, lanesOf, rightMargin, spanOf, type Block, type Lane } from "./lanes.ts";

const RULER = 18;
const OTHERS = 8; // runs drawn as thin lines
const ROOM = 16; // px for these lines, whatever their number: a new run does not move other parts of the page

interface Tick {
  t: number;
  text: string;
  kind: "event" | "advice" | "message";
}

// Events other than moves, in the order of time.
export function ticksOf(run: Run): Tick[] {
  const events = run.events
    .filter((event) => event.what !== "added" || event.t > 0)
    .map((event): Tick => ({ t: event.t, text: `${run.objects[event.object]?.name ?? ""} ${event.what}`, kind: "event" }));
  const notes = run.notes
    .filter((note) => note.kind !== "output")
    .map((note): Tick => ({ t: note.t, text: note.element ? `${note.element}: ${note.text}` : note.text, kind: note.kind === "message" ? "message" : "advice" }));
  const advice = run.advice.map((each): Tick => ({ t: each.t, text: each.message, kind: "advice" }));
  return [...events, ...notes, ...advice].sort((a, b) => a.t - b.t);
}

// The distance of marks on a ruler, so that about `room` of them fit into `span` seconds.
export function rulerStep(span: number, room: number): number {
  const raw = span / Math.max(1, room);
  const power = 10 ** Math.floor(Math.log10(raw));
  return [1, 2, 5, 10].map((m) => m * power).find((step) => step >= raw) ?? 10 * power;
}

export class TimeBar {
  private readonly host: HTMLElement;
  private readonly canvas = el("canvas");
  private readonly note = el("div", { class: "bar-note", hidden: true });
  private readonly bar: HTMLElement;
  private readonly store: Store;
  private readonly intents: Intents;
  private drag: number | null = null;
  // The drawing that does not depend on the instant, and the data it was computed from.
  private lanes: Lane[] = [];
  private ticks: Tick[] = [];
  private right = 0;
  private workedOutFrom: readonly unknown[] = [];

  constructor(host: HTMLElement, store: Store, intents: Intents) {
    this.host = host;
    this.store = store;
    this.intents = intents;
    this.bar = el("div", { class: "bar", role: "slider", tabindex: 0, "aria-label": "Time" }, this.canvas, this.note);
    host.append(this.bar);
    new ResizeObserver(() => this.draw(store.state)).observe(this.bar);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw(store.state));
    store.watch((s) => [s.shown, shownRun(s)?.version, s.t, s.hover, s.list, s.ghost, s.comparison, isStale(s), s.plotsBelow], (s) => this.draw(s));
    this.listen();
  }

  private get span(): number {
    return spanOf(this.store.state);
  }

  private x(t: number): number {
    return LEFT + (t / this.span) * (this.bar.clientWidth - LEFT - this.right);
  }

  private t(x: number): number {
    return Math.min(this.span, Math.max(0, ((x - LEFT) / Math.max(1, this.bar.clientWidth - LEFT - this.right)) * this.span));
  }

  private listen(): void {
    const at = (event: PointerEvent) => {
      const box = this.bar.getBoundingClientRect();
      return { x: event.clientX - box.left, y: event.clientY - box.top };
    };
    this.bar.addEventListener("pointerdown", (event) => {
      this.drag = event.pointerId;
      this.bar.setPointerCapture(event.pointerId);
      this.intents.play(false);
      this.intents.goTo(this.t(at(event).x));
    });
    this.bar.addEventListener("pointermove", (event) => {
      const { x, y } = at(event);
      if (this.drag === event.pointerId) this.intents.goTo(this.t(x));
      this.hover(x, y);
    });
    const end = (event: PointerEvent) => this.drag === event.pointerId && (this.drag = null);
    this.bar.addEventListener("pointerup", end);
    this.bar.addEventListener("pointercancel", end);
    this.bar.addEventListener("pointerleave", () => {
      this.note.hidden = true;
      this.store.change((s) => (s.hover = null));
    });
  }

  // Shows the text of the block or tick under the pointer, and highlights what belongs to it.
  private hover(x: number, y: number): void {
    const run = shownRun(this.store.state);
    if (!run) return;
    const t = this.t(x);
    const robot = this.laneAt(y);
    const lane = this.lanes[robot];
    const block = x >= LEFT ? lane?.blocks.find((each) => each.t0 <= t && t <= each.t1) : undefined;
    const tick = this.ticks.find((k) => Math.abs(this.x(k.t) - x) < 5);
    setText(this.note, tick ? `${tick.t.toFixed(2)} s  ${tick.text}` : block ? block.text : x < LEFT ? (lane?.title ?? "") : "");
    this.note.style.left = `${Math.min(Math.max(LEFT, x), this.bar.clientWidth - 200)}px`;
    this.note.hidden = this.note.textContent === "";
    const old = this.store.state.hover;
    const next = block ? { from: "bar" as const, robot, t, line: block.lines?.[0] ?? null } : null;
    if (next === old || (next && old?.from === "bar" && old.line === next.line && old.t === next.t)) return;
    this.store.change((s) => (s.hover = next));
  }

  // The index of the lane at y; the lanes of robots come first, with their numbers.
  private laneAt(y: number): number {
    let below = RULER;
    return this.lanes.findIndex((lane) => y >= below && y < (below += lane.height));
  }

  private workOut(run: Run | null, state: State): void {
    const from = [run, run?.version, state.textVersion, state.plotsBelow];
    if (from.every((each, i) => each === this.workedOutFrom[i])) return;
    this.workedOutFrom = from;
    this.lanes = lanesOf(run, state);
    this.ticks = run ? ticksOf(run) : [];
    this.right = rightMargin(state);
  }

  private draw(state: State): void {
    const run = shownRun(state);
    this.workOut(run, state);
    const bottom = this.lanes.reduce((y, lane) => y + lane.height, RULER);
    const others = run ? otherRuns(state, run) : [];
    const height = bottom + ROOM + 12;
    const width = this.bar.clientWidth;
    if (!width) return;
    const scale = Math.min(2, devicePixelRatio);
    if (this.canvas.width !== Math.round(width * scale) || this.canvas.height !== Math.round(height * scale)) {
      this.canvas.width = Math.round(width * scale);
      this.canvas.height = Math.round(height * scale);
      this.canvas.style.height = `${height}px`;
    }
    const c = this.canvas.getContext("2d");
    if (!c) return;
    c.setTransform(scale, 0, 0, scale, 0, 0);
    c.clearRect(0, 0, width, height);
    const style = getComputedStyle(this.host);
    const color = (name: string) => style.getPropertyValue(name).trim();
    this.drawRuler(c, color, height);
    if (run) {
      this.drawLanes(c, color, run, state);
      this.drawOthers(c, color, others, bottom + 4);
      this.drawTicks(c, color, run, bottom, state);
    }
    if (state.hover?.from === "path") {
      c.fillStyle = color("--accent");
      c.fillRect(this.x(state.hover.t) - 0.75, RULER - 4, 1.5, height - RULER);
    }
    this.drawNow(c, color, state.t, height);
    this.describe(run, state);
  }

  private drawRuler(c: CanvasRenderingContext2D, color: (name: string) => string, height: number): void {
    const width = this.bar.clientWidth;
    const step = rulerStep(this.span, (width - LEFT) / 90);
    const end = shownRun(this.store.state)?.tEnd ? this.span * 1.0001 : 0; // a run without duration has only the mark of its start
    c.font = "11px system-ui, sans-serif";
    c.textBaseline = "middle";
    for (let k = 0; k * step <= end; k++) {
      const x = Math.round(this.x(k * step)) + 0.5;
      c.strokeStyle = color("--grid");
      c.beginPath();
      c.moveTo(x, RULER - 3);
      c.lineTo(x, height);
      c.stroke();
      c.fillStyle = color("--quiet");
      c.textAlign = "center";
      c.fillText(`${+(k * step).toPrecision(6)} s`, Math.min(x, width - 16), 8);
    }
  }

  private drawLanes(c: CanvasRenderingContext2D, color: (name: string) => string, run: Run, state: State): void {
    const line = state.hover?.line ?? null;
    const [end, fill] = [this.x(run.tEnd), { robot: color("--block"), task: color("--task"), signal: color("--signal") }];
    const [quiet, ground, accent, onAccent, onBlock] = ["--quiet", "--lane", "--accent", "--on-accent", "--on-block"].map(color) as [string, string, string, string, string];
    let y = RULER + 2;
    for (const lane of this.lanes) {
      const high = lane.height - (lane.kind === "robot" ? 4 : 3);
      c.font = `${lane.kind === "robot" ? 11 : 10}px system-ui, sans-serif`;
      c.globalAlpha = 1;
      c.fillStyle = quiet;
      c.textAlign = "left";
      c.fillText(lane.name, 8, y + high / 2);
      c.fillStyle = ground;
      c.beginPath();
      c.roundRect(LEFT, y, end - LEFT, high, 4);
      c.fill();
      c.globalAlpha = isStale(state) ? 0.35 : 1;
      let drawn = -Infinity; // blocks that are too narrow to be distinguished are drawn as one
      for (const block of lane.blocks) {
        const [x0, x1] = [this.x(block.t0), this.x(block.t1)];
        if (x1 < drawn + 0.5) continue;
        drawn = x1;
        this.drawBlock(c, block, [x0, y, x1 - x0, high], line !== null && block.lines !== null && block.lines[0] <= line && line <= block.lines[1] ? [accent, onAccent] : [fill[lane.kind], onBlock]);
      }
      y += lane.height;
    }
    c.globalAlpha = 1;
  }

  private drawBlock(c: CanvasRenderingContext2D, block: Block, [x, y, width, high]: [number, number, number, number], [fill, text]: [string, string]): void {
    c.fillStyle = fill;
    c.beginPath();
    if (block.low) c.rect(x + 0.5, y + high - 2, Math.max(1, width - 1), 2);
    else c.roundRect(x + 0.5, y, Math.max(1, width - 1), high, Math.min(4, width / 2));
    c.fill();
    if (block.low || width < 14 || width <= c.measureText(block.name).width + 8) return;
    c.fillStyle = text;
    c.fillText(block.name, x + 5, y + high / 2 + 0.5);
  }

  private drawTicks(c: CanvasRenderingContext2D, color: (name: string) => string, run: Run, bottom: number, state: State): void {
    for (const tick of this.ticks) {
      const x = this.x(tick.t);
      c.fillStyle = tick.kind === "message" ? color("--error") : tick.kind === "advice" ? color("--s4") : color("--text");
      c.beginPath();
      c.moveTo(x - 3.5, RULER - 5);
      c.lineTo(x + 3.5, RULER - 5);
      c.lineTo(x, RULER + 1);
      c.fill();
    }
    if (run.error) {
      const x = this.x(run.error.t);
      c.strokeStyle = c.fillStyle = color("--error");
      c.lineWidth = 2;
      c.beginPath();
      c.moveTo(x, RULER);
      c.lineTo(x, bottom);
      c.stroke();
      c.beginPath();
      c.arc(x, RULER, 4, 0, 7);
      c.fill();
      c.lineWidth = 1;
    }
    const parts = state.comparison?.parts_at;
    if (typeof parts === "number" && state.comparison?.run === run.id) {
      const x = this.x(parts);
      c.setLineDash([3, 3]);
      c.strokeStyle = color("--warning");
      c.beginPath();
      c.moveTo(x, RULER);
      c.lineTo(x, bottom + 20);
      c.stroke();
      c.setLineDash([]);
    }
  }

  private drawOthers(c: CanvasRenderingContext2D, color: (name: string) => string, others: { t_end: number; lit: boolean }[], y: number): void {
    const step = Math.min(4, ROOM / others.length);
    others.forEach((other, i) => {
      c.fillStyle = other.lit ? color("--accent") : color("--thin");
      c.fillRect(LEFT, y + i * step, Math.max(1, this.x(Math.min(other.t_end, this.span)) - LEFT), step / 2);
    });
  }

  private drawNow(c: CanvasRenderingContext2D, color: (name: string) => string, t: number, height: number): void {
    const x = this.x(t);
    c.strokeStyle = c.fillStyle = color("--text");
    c.lineWidth = 1.5;
    c.beginPath();
    c.moveTo(x, RULER - 4);
    c.lineTo(x, height);
    c.stroke();
    c.beginPath();
    c.arc(x, height - 5, 4.5, 0, 7);
    c.fill();
    c.lineWidth = 1;
  }

  private describe(run: Run | null, state: State): void {
    const move = run?.moves.find((m) => m.t0 <= state.t && state.t <= m.t1);
    this.bar.setAttribute("aria-valuemin", "0");
    this.bar.setAttribute("aria-valuemax", (run?.tEnd ?? 0).toFixed(2));
    this.bar.setAttribute("aria-valuenow", state.t.toFixed(2));
    this.bar.setAttribute("aria-valuetext", `${state.t.toFixed(2)} of ${(run?.tEnd ?? 0).toFixed(2)} seconds${move ? `, ${move.text}` : ""}`);
  }
}

function otherRuns(state: State, run: Run): { t_end: number; lit: boolean }[] {
  return state.list
    .filter((head) => head.run !== run.id)
    .slice(-OTHERS)
    .map((head) => ({ t_end: head.t_end, lit: head.run === state.ghost }));
}
