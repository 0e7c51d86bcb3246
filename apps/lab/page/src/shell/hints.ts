// Three lines in each part of the page for new users. Once closed, they are not shown again.
import { el, remember, remembered } from "../dom/dom.ts";
import type { Store } from "../store/store.ts";
import type { ColumnName } from "./columns.ts";

const HINTS: Record<ColumnName, string[]> = {
  program: ["Change the program: it runs at once.", "Hold Alt and drag a number.", "Point at a line: its path lights up."],
  view: ["Drag to turn, wheel to zoom.", "Pull the ball at the hand.", "Point at the path: its line lights up."],
  elements: ["Drag a slider: the arm follows.", "Where it cannot, it says why.", "Click into a plot to go to that instant."],
};

export function hints(columns: Record<ColumnName, HTMLElement>, store: Store): void {
  const shown: HTMLElement[] = [];
  store.watch((s) => [s.welcome?.demo], (s) => {
    if (!s.welcome?.demo || shown.length) return;
    for (const name of Object.keys(HINTS) as ColumnName[]) {
      if (remembered(`hint.${name}`)) continue;
      const hint: HTMLElement = el("div", { class: "hint", role: "note" }, ...HINTS[name].map((line) => el("p", {}, line)), el("button", { class: "tiny", onclick: () => {
        remember(`hint.${name}`, "closed");
        hint.remove();
      } }, "Got it"));
      shown.push(hint);
      columns[name].append(hint);
    }
  });
}
