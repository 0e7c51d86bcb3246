// Three lines in each part of the page for new users, beside its contents. Once closed, they are not shown again.
import { el, remember, remembered } from "../dom/dom.ts";
import type { Store } from "../store/store.ts";
import type { ColumnName } from "./columns.ts";

type Lines = Record<ColumnName, string[]>;

const HINTS: Lines = {
  program: ["Change the program: it runs at once.", "Hold Alt and drag a number.", "Point at a line: its path lights up."],
  view: ["Drag to turn, wheel to zoom.", "Pull the ball at the hand.", "Point at the path: its line lights up."],
  elements: ["Drag a slider: the arm follows.", "Where it cannot, it says why.", "Click into a plot to go to that instant."],
};

// With fingers there are no Alt key, no wheel and nothing to point with.
const TOUCH_HINTS: Lines = {
  program: ["Change the program: it runs at once.", "Tap a number, then − or +.", "Tap a line: its path lights up."],
  view: ["Drag to turn; two fingers zoom and move.", "Pull the ball at the hand.", "Tap the path: you go to that instant."],
  elements: HINTS.elements,
};

const hasFingers = () => matchMedia("(pointer: coarse)").matches;

// places  of each hint: the element that gets it, and the child before which it stands; null: at the end.
export function hints(places: Record<ColumnName, [HTMLElement, HTMLElement | null]>, store: Store): void {
  const shown: HTMLElement[] = [];
  store.watch((s) => [s.welcome?.demo], (s) => {
    if (!s.welcome?.demo || shown.length) return;
    for (const name of Object.keys(HINTS) as ColumnName[]) {
      if (remembered(`hint.${name}`)) continue;
      const hint: HTMLElement = el("div", { class: "hint", role: "note" }, ...(hasFingers() ? TOUCH_HINTS : HINTS)[name].map((line) => el("p", {}, line)), el("button", { class: "tiny", onclick: () => {
        remember(`hint.${name}`, "closed");
        hint.remove();
      } }, "Got it"));
      shown.push(hint);
      const [host, before] = places[name];
      host.insertBefore(hint, before);
    }
  });
}
