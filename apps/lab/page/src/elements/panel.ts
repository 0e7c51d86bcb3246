// The column of a laboratory's elements, in their order.
import { el } from "../dom/dom.ts";
import type { ElementInfo, Value } from "../protocol/messages.ts";
import type { Intents } from "../store/intents.ts";
import type { Run } from "../store/run.ts";
import { inControl, shownRun, type State } from "../store/state.ts";
import type { Store } from "../store/store.ts";
import { cameraView } from "./camera_view.ts";
import { button, field, handSliders, jointSliders } from "./controls.ts";
import { figures } from "./figures.ts";
import { plot } from "./plot.ts";
import { runAgain } from "./run_again.ts";
import { image, noted, table, text, torques } from "./shown.ts";
import type { ElementView, Place } from "./view.ts";

// The elements of a run whose laboratory has sent none: sliders and plots of each robot.
export function elementsOf(run: Run): ElementInfo[] {
  if (run.elements.length) return run.elements;
  return run.robots.flatMap((robot) => [
    { kind: "sliders", name: `joints of ${robot.name}`, label: `Joints of ${robot.name}`, robot: robot.name },
    { kind: "plot", name: `q of ${robot.name}` },
    { kind: "plot", name: `qd of ${robot.name}` },
  ]);
}

function viewOf(place: Place, run: Run): ElementView | null {
  const { element } = place;
  switch (element.kind) {
    case "sliders":
      return element.axes?.length ? handSliders(place, run) : jointSliders(place, run);
    case "field":
      return field(place);
    case "button":
      return button(place);
    case "plot":
      return plot(place);
    case "table":
      return table(place);
    case "text":
      return text(place);
    case "image":
      return element.file ? image(place) : cameraView(place);
    case "torques":
      return torques(place, run);
    case "view":
      return cameraView(place);
    case "program": // shown in the editor
    case "trail": // shown in the 3D view, for all robots
      return null;
    default:
      return noted(element.label || element.name, `This page does not know elements of the kind "${element.kind}".`);
  }
}

// below  for the plots along the time bar.
// point  shows the row of the program in the editor. write: writes values of fields into the program and runs it.
export function elementPanel(host: HTMLElement, below: HTMLElement, store: Store, intents: Intents, point: (element: ElementInfo) => void, write: (fields: [ElementInfo, Value][]) => void): void {
  const again = runAgain(intents, write);
  let views: ElementView[] = [];
  let plots: HTMLElement[] = [];
  let built = "";
  const build = (run: Run) => {
    const elements = elementsOf(run);
    const { plotsBelow } = store.state;
    const key = JSON.stringify([plotsBelow, elements, run.robots.map((r) => [r.name, r.joints.map((j) => [j.unit, j.lower, j.upper])])]);
    if (key === built) return;
    built = key;
    for (const view of views) view.dispose?.();
    const all = elements.map((element, index) => [element, viewOf({ element, index, intents }, run)] as const);
    const shownElements = all.flatMap(([element, view]) => (view ? [element] : []));
    views = all.flatMap(([, view]) => (view ? [view] : []));
    views.push(figures());
    const quiet = elements.length ? [] : [el("p", { class: "quiet element" }, "This program has no robot and no laboratory.")];
    if (run.elements.length) views.forEach((view, i) => pointing(view.root, shownElements[i], point));
    plots = plotsBelow ? all.flatMap(([element, view]) => (view && element.kind === "plot" ? [view.root] : [])) : [];
    const roots = views.map((view) => view.root).filter((root) => !plots.includes(root));
    // Behind the last field, otherwise behind the last slider or button.
    const last = (kinds: readonly string[]) => all.findLast(([element, view]) => view && kinds.includes(element.kind))?.[1]?.root;
    const behind = last(["field"]) ?? last(["sliders", "button"]);
    if (behind) roots.splice(roots.indexOf(behind) + 1, 0, again.root);
    host.replaceChildren(...quiet, ...roots);
    below.replaceChildren(...plots);
    below.hidden = !plots.length;
  };
  const update = (state: State) => {
    const run = shownRun(state);
    if (!run?.described) return;
    build(run);
    const allowed = intents.live && inControl(state);
    for (const view of views) view.update(run, state, allowed);
    again.update(run, allowed);
  };
  store.watch((s) => [s.shown, shownRun(s)?.version, s.ghost, s.ghost === null ? 0 : s.runs.get(s.ghost)?.version, s.t, shownRun(s)?.values, shownRun(s)?.pictures, s.refusals, inControl(s), s.plotsBelow], update);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => update(store.state));
}

// A click on the name of a row shows its position in the program.
function pointing(root: HTMLElement, element: ElementInfo | undefined, point: (element: ElementInfo) => void): void {
  const title = root.querySelector("h2");
  if (!element || !title) return;
  title.classList.add("points");
  title.addEventListener("click", (event) => event.target === title && point(element));
}
