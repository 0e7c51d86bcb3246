// Play, speed and the instant, at the left end of the time bar; steps, beside the panels of the program.
import { el, setText } from "../dom/dom.ts";
import { icon, type IconName } from "../dom/icons.ts";
import type { StepHow } from "../protocol/messages.ts";
import type { Intents } from "../store/intents.ts";
import { inControl, shownRun } from "../store/state.ts";
import type { Store } from "../store/store.ts";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10];

export function transport(host: HTMLElement, store: Store, intents: Intents): void {
  const play = el("button", { class: "icon", onclick: () => intents.play(), "aria-label": "Play" }, icon("play"));
  const start = el("button", { class: "icon", onclick: () => intents.goTo(0), "aria-label": "To the start", title: "To the start" }, icon("start"));
  const end = el("button", { class: "icon", onclick: () => intents.goTo(Infinity), "aria-label": "To the end", title: "To the end" }, icon("end"));
  const speed = el("select", { "aria-label": "Speed", onchange: () => store.change((s) => (s.speed = Number(speed.value))) });
  speed.append(...SPEEDS.map((x) => el("option", { value: x, selected: x === 1 }, `${x}×`)));
  const time = el("output", { class: "time", "aria-label": "Instant" });
  host.append(el("div", { class: "transport", role: "toolbar", "aria-label": "Play" }, start, play, end, speed, time));
  store.watch(
    (s) => [s.playing, s.t, s.shown, shownRun(s)?.version],
    (s) => {
      const run = shownRun(s);
      const label = s.playing ? "Pause" : "Play";
      if (play.getAttribute("aria-label") !== label || !play.firstChild) play.replaceChildren(icon(s.playing ? "pause" : "play"));
      play.setAttribute("aria-label", label);
      play.disabled = !run || run.tEnd <= 0;
      setText(time, `${s.t.toFixed(2)} / ${(run?.tEnd ?? 0).toFixed(2)} s${run?.state === "running" ? " …" : ""}`);
    },
  );
}

export function stepButtons(store: Store, intents: Intents): HTMLElement {
  const step = (how: StepHow & IconName, label: string) => el("button", { class: "icon", "aria-label": label, title: label, onclick: () => void intents.step(how) }, icon(how));
  const steps = [
    step("back", "Step back"), step("over", "Step over"), step("into", "Step into"), step("out", "Step out"),
    step("continue", "On to the next breakpoint"),
  ];
  store.watch((s) => [shownRun(s) === null, inControl(s)], (s) => {
    for (const button of steps) button.disabled = !shownRun(s) || !intents.live || !inControl(s);
  });
  return el("div", { class: "steps", role: "toolbar", "aria-label": "Steps" }, ...steps);
}
