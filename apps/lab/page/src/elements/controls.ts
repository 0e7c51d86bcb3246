// Sliders, fields and buttons.
import { el, setText } from "../dom/dom.ts";
import { rollPitchYaw, shownUnit, written, type Shown } from "../numbers/units.ts";
import type { Coordinate } from "../protocol/messages.ts";
import type { Run } from "../store/run.ts";
import type { State } from "../store/state.ts";
import type { ElementView, Place } from "./view.ts";

let made = 0;

class Slider {
  readonly root: HTMLElement;
  readonly range: HTMLInputElement;
  readonly number: HTMLInputElement;
  readonly shown: Shown;
  private held = false;
  private told = NaN;
  private asks = false; // whether the laboratory has not answered yet

  // changed  gives the value to the laboratory; a refused one is not kept.
  constructor(name: string, unit: string, lower: number, upper: number, changed: () => unknown, shown: Shown = shownUnit(unit)) {
    this.shown = shown;
    const id = `slider${++made}`;
    const [low, high] = [lower * shown.factor, upper * shown.factor];
    const step = 10 ** -shown.digits;
    this.range = el("input", { type: "range", id, min: low, max: high, step, "aria-label": `${name}, ${shown.unit}` });
    this.number = el("input", { type: "number", step, "aria-label": `${name} in ${shown.unit}` });
    this.range.addEventListener("input", () => {
      this.held = true;
      this.number.value = Number(this.range.value).toFixed(shown.digits);
      changed();
    });
    this.range.addEventListener("change", () => (this.held = false));
    this.number.addEventListener("change", () => {
      this.range.value = this.number.value;
      this.asks = true;
      void Promise.resolve(changed()).then((taken) => {
        this.asks = false;
        if (taken === false || document.activeElement !== this.number) this.write(this.told);
      });
    });
    this.number.addEventListener("blur", () => this.asks || this.write(this.told));
    this.root = el("div", { class: name.length > 6 ? "slider named" : "slider" }, el("label", { for: id }, name), this.range, this.number, el("span", { class: "unit" }, shown.unit));
  }

  // The value in the field, which may be outside the slider's range; with all received digits until the user changes it.
  get value(): number {
    return this.number.value === written(this.told, this.shown) ? this.told : Number(this.number.value) / this.shown.factor;
  }

  show(si: number): void {
    this.told = si;
    if (!this.held && !this.asks && document.activeElement !== this.number) this.write(si);
  }

  private write(si: number): void {
    if (Number.isNaN(si)) return;
    const text = written(si, this.shown);
    if (this.number.value === text) return;
    this.number.value = text;
    this.range.value = text;
  }

  mark(warning: boolean): void {
    this.root.classList.toggle("at-limit", warning);
  }

  allow(allowed: boolean): void {
    this.range.disabled = !allowed;
    this.number.disabled = !allowed;
  }
}

function reasonLine(): HTMLElement {
  return el("p", { class: "reason", role: "status", "aria-live": "polite" });
}

function group(label: string, ...children: HTMLElement[]): HTMLElement {
  return el("div", { class: "element", role: "group", "aria-label": label }, el("h2", {}, label), ...children);
}

export function jointSliders(place: Place, run: Run): ElementView {
  const { element, intents } = place;
  const index = Math.max(0, run.robots.findIndex((r) => r.name === element.robot));
  const robot = run.robots[index];
  const reason = reasonLine();
  const sliders: Slider[] = [];
  const changed = () => robot && intents.giveInput(element.name, { joints: robot.name, values: sliders.map((s) => s.value) });
  robot?.joints.forEach((joint, i) => sliders.push(new Slider(joint.name ?? `q${i + 1}`, joint.unit, joint.lower, joint.upper, changed)));
  return {
    root: group(element.label || `Joints of ${robot?.name}`, ...sliders.map((s) => s.root), reason),
    update(now, state, allowed) {
      const q = now.qAt(index, state.t);
      sliders.forEach((slider, i) => {
        const joint = now.robots[index]?.joints[i];
        slider.allow(allowed);
        slider.show(q[i] ?? 0);
        const margin = joint ? 0.01 * (joint.upper - joint.lower) : 0;
        slider.mark(joint !== undefined && ((q[i] ?? 0) <= joint.lower + margin || (q[i] ?? 0) >= joint.upper - margin));
      });
      setText(reason, state.refusals.get(element.name) ?? "");
    },
  };
}

const UNITS: Record<string, string> = { x: "m", y: "m", z: "m" };

export function handSliders(place: Place, run: Run): ElementView {
  const { element, intents } = place;
  const index = Math.max(0, run.robots.findIndex((r) => r.name === element.robot));
  const axes = element.axes ?? [];
  const reason = reasonLine();
  const sliders: Slider[] = [];
  const changed = () => intents.giveInput(element.name, { hand: element.name, values: sliders.map((s) => s.value) });
  for (const axis of axes) sliders.push(handSlider(axis, changed));
  return {
    root: group(element.label || `Hand of ${run.robots[index]?.name}`, ...sliders.map((s) => s.root), reason),
    update(now, state, allowed) {
      const told = now.values[element.name]?.value;
      const place = handAt(now, index, state.t, axes);
      sliders.forEach((slider, i) => {
        slider.allow(allowed);
        const own = place?.[axes[i]!.name];
        const value = Array.isArray(told) && now.valuesAt === state.t ? (told[i] as number) : own;
        if (value !== undefined) slider.show(value);
      });
      setText(reason, state.refusals.get(element.name) ?? "");
    },
  };
}

function handSlider(axis: Coordinate, changed: () => void): Slider {
  const unit = axis.unit ?? UNITS[axis.name] ?? "rad";
  const most = unit === "m" ? 1 : Math.PI;
  return new Slider(axis.name, unit, axis.lower ?? -most, axis.upper ?? most, changed);
}

// The tool pose; "roll" without the other two is the rotation about z.
function handAt(run: Run, index: number, t: number, axes: readonly Coordinate[]): Record<string, number> | null {
  const pose = run.toolAt(index, t);
  if (!pose) return null;
  const turns = rollPitchYaw(pose);
  const alone = !axes.some((axis) => axis.name === "pitch" || axis.name === "yaw");
  return { x: pose[0]!, y: pose[1]!, z: pose[2]!, ...turns, ...(alone ? { roll: turns.yaw } : {}) };
}

export function field(place: Place): ElementView {
  const { element, intents } = place;
  const reason = reasonLine();
  const label = element.label || element.name;
  if (typeof element.value === "number") return numberField(place, label, reason);
  const isChoice = typeof element.value === "boolean";
  const input = el("input", { type: isChoice ? "checkbox" : "text", "aria-label": label });
  input.addEventListener("change", () => void intents.giveInput(element.name, { set: element.name, value: isChoice ? input.checked : input.value }));
  return {
    root: el("div", { class: "element", role: "group", "aria-label": label }, el("label", { class: "field" }, label, input), reason),
    update(run, state, allowed) {
      input.disabled = !allowed;
      const value = run.values[element.name]?.value ?? element.value;
      if (document.activeElement !== input) {
        if (isChoice) input.checked = Boolean(value);
        else input.value = String(value ?? "");
      }
      setText(reason, state.refusals.get(element.name) ?? "");
    },
  };
}

function numberField(place: Place, label: string, reason: HTMLElement): ElementView {
  const { element, intents } = place;
  const factor = element.factor ?? 1;
  const [low, high] = element.range ?? [null, null];
  const start = element.value as number;
  const span = low !== null && high !== null ? (high - low) / factor : Math.abs(start) / factor;
  const shown: Shown = { unit: element.unit ?? "", factor: 1 / factor, digits: element.type === "int" ? 0 : Math.min(6, Math.max(0, 3 - Math.floor(Math.log10(span || 1)) - 1)) };
  const slider = new Slider(label, "", low ?? start - Math.abs(start || 1), high ?? start + Math.abs(start || 1), () => {
    return intents.giveInput(element.name, { set: element.name, value: slider.value });
  }, shown);
  return {
    root: el("div", { class: "element", role: "group", "aria-label": label }, slider.root, reason),
    update(run, state, allowed) {
      slider.allow(allowed);
      const value = run.values[element.name]?.value ?? element.value;
      if (typeof value === "number") slider.show(value);
      setText(reason, state.refusals.get(element.name) ?? "");
    },
  };
}

// Why the last use of a button before t has failed; empty: it has not.
function failureOf(run: Run, name: string, t: number): string {
  const pressed = run.inputs.findLast((input) => input["press"] === name && Number(input["t"]) <= t + 1e-9);
  const note = run.notes.findLast((each) => each.element === name && each.t <= t + 1e-9);
  return pressed && note && note.t >= Number(pressed["t"]) - 1e-9 ? note.text : "";
}

export function button(place: Place): ElementView {
  const { element, intents } = place;
  const reason = reasonLine();
  const press = el("button", { class: "press", onclick: () => void intents.giveInput(element.name, { press: element.name }) }, element.label || element.name);
  return {
    root: el("div", { class: "element", role: "group", "aria-label": element.label || element.name }, press, reason),
    update(run: Run, state: State, allowed: boolean) {
      press.disabled = !allowed;
      setText(reason, state.refusals.get(element.name) || failureOf(run, element.name, state.t));
    },
  };
}
