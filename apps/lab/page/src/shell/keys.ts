// Keys of the whole page, outside of text fields; the help lists them.
import { el } from "../dom/dom.ts";
import type { Intents } from "../store/intents.ts";
import { inControl } from "../store/state.ts";

export const KEYS: [string, string][] = [
  ["Space", "play or pause"],
  ["← →", "one statement back or on"],
  ["Shift ← →", "one move back or on"],
  ["Home, End", "start or end of the run"],
  ["Alt and drag a number", "pull it: the run follows"],
  ["Alt and wheel, Alt Page Up or Down", "the same from the wheel or the keyboard; with Shift ten times as far"],
  ["Ctrl S", "save the program"],
  ["F9", "breakpoint on or off"],
  ["F10, F11, Shift F11, Shift F10", "step over, into, out, back"],
  ["F5", "on to the next breakpoint"],
  ["F12", "where a name is declared"],
  ["Shift Alt F", "lay the program out"],
  ["Alt Z", "wrap long lines, or not"],
  ["Ctrl Space", "what can be written here"],
  ["1 to 6 in the 3D view", "iso, front, side, top, hand, fit"],
  ["Escape, then Tab", "leave the editor"],
  ["? or /", "this help, and a search in it"],
];

function isWriting(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && (target.closest(".cm-editor, input, select, textarea") !== null || target.isContentEditable);
}

function statement(intents: Intents, direction: 1 | -1): void {
  if (intents.live && inControl(intents.state)) void intents.step(direction > 0 ? "over" : "back");
  else intents.stepMove(direction);
}

export function globalKeys(intents: Intents, help: () => void): void {
  const steps: Record<string, () => void> = {
    F10: () => void intents.step("over"),
    F11: () => void intents.step("into"),
    "Shift-F11": () => void intents.step("out"),
    "Shift-F10": () => void intents.step("back"),
    F5: () => void intents.step("continue"),
  };
  const others: Record<string, () => void> = {
    " ": () => intents.play(),
    ArrowLeft: () => statement(intents, -1),
    ArrowRight: () => statement(intents, 1),
    "Shift-ArrowLeft": () => intents.stepMove(-1),
    "Shift-ArrowRight": () => intents.stepMove(1),
    Home: () => intents.goTo(0),
    End: () => intents.goTo(Infinity),
    "?": help,
    "/": help,
  };
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    const key = (event.shiftKey && event.key.length > 1 ? "Shift-" : "") + event.key;
    const onButton = event.target instanceof HTMLElement && event.target.closest("button, [role=tab], a, summary, dialog, canvas") !== null;
    const action = steps[key] ?? (isWriting(event.target) || (onButton && (key === " " || key.includes("Arrow"))) ? undefined : others[key]);
    if (!action) return;
    event.preventDefault();
    action();
  });
}

// Shows the parts of the help with the searched words. The last search is cleared when the help opens, not when it closes: browsers
// report the closing of a dialog late, possibly during the next search.
export function helpDialog(about: () => void): { dialog: HTMLDialogElement; open(): void } {
  const rows = KEYS.map(([key, what]) => el("div", {}, el("dt", {}, key), el("dd", {}, what)));
  const none = el("p", { class: "quiet", role: "status" });
  const search: HTMLInputElement = el("input", { type: "text", "aria-label": "Search the help", placeholder: "Search", oninput: () => find() });
  const find = () => {
    const words = search.value.toLowerCase().split(/\s+/);
    rows.forEach((row, i) => (row.hidden = !words.every((word) => KEYS[i]!.join(" ").toLowerCase().includes(word))));
    none.textContent = rows.every((row) => row.hidden) ? "Nothing in the help has these words." : "";
  };
  const dialog: HTMLDialogElement = el(
    "dialog", { class: "help", "aria-label": "Keys" },
    el("h2", {}, "Keys and gestures"),
    search,
    el("dl", {}, ...rows),
    none,
    el("div", { class: "row" }, el("button", { onclick: () => dialog.close() }, "Close"), el("button", { onclick: about }, "About")),
  );
  const open = () => {
    if (dialog.open) return;
    search.value = "";
    find();
    dialog.showModal();
  };
  return { dialog, open };
}
