// Title, robots and world, the state of the program, sharing, and the visible columns; below, the page that has control.
import { el, remember, remembered, setText } from "../dom/dom.ts";
import { icon } from "../dom/icons.ts";
import { fileName, isUnsaved } from "../store/document.ts";
import type { Intents } from "../store/intents.ts";
import { comingRun, isStale, shownRun } from "../store/state.ts";
import type { Store } from "../store/store.ts";
import type { ColumnName } from "./columns.ts";
import { drawControl, tellKnownName } from "./control.ts";
import { hashToText } from "./link.ts";
import { handIn, record } from "./share.ts";
import { statusOf } from "./status.ts";

export interface HeaderActions {
  // The HTML of the page before anything was shown in it, and whether its laboratory is in it.
  source: string;
  alone: boolean;
  program: HTMLElement[]; // buttons for the program and its file
  help(): void;
  toggle(name: ColumnName): boolean;
  isOpen(name: ColumnName): boolean;
}

export function header(host: HTMLElement, store: Store, intents: Intents, actions: HeaderActions): void {
  const title = el("h1", {});
  const file = el("span", { class: "file quiet" });
  const status = el("span", { class: "status", role: "status" });
  const control = el("div", { class: "control", hidden: true });
  const offer = el("div", { class: "offer", hidden: true });
  const toggles = (["program", "view", "elements"] as const).map((name, i) => {
    const button: HTMLButtonElement = el("button", {
      class: "icon toggle", "aria-label": `Column ${["program", "3D view", "laboratory"][i]}`, "aria-pressed": "true",
      onclick: () => button.setAttribute("aria-pressed", String(actions.toggle(name))),
    }, icon((["left", "middle", "right"] as const)[i]!));
    queueMicrotask(() => button.setAttribute("aria-pressed", String(actions.isOpen(name))));
    return button;
  });
  const below = (on: boolean) => {
    store.change((s) => (s.plotsBelow = on));
    plots.setAttribute("aria-pressed", String(on));
    remember("plotsBelow", on ? "yes" : "no");
  };
  const plots: HTMLButtonElement = el("button", {
    class: "icon toggle desk", "aria-label": "Plots below the bar of time", title: "Plots below the bar of time", "aria-pressed": "false", onclick: () => below(!store.state.plotsBelow),
  }, icon("below"));
  if (remembered("plotsBelow") === "yes") below(true);
  const row = el("div", { class: "row" }, title, file, status);
  row.append(
    el("span", { class: "gap" }),
    ...actions.program,
    el("button", { class: "desk", hidden: !intents.live, onclick: () => void record(store.state, intents, actions.source), title: "Save this run as a page that needs no laboratory" }, "Record"),
    el("button", { hidden: !actions.alone, onclick: () => void handIn(intents, actions.source), title: "Save this laboratory with the program and all runs as a new file" }, "Hand in"),
    el("span", { class: "toggles", role: "group", "aria-label": "Columns" }, ...toggles, plots),
    el("button", { class: "icon desk", "aria-label": "Keys and help", onclick: actions.help }, "?"),
  );
  host.append(row, offer, control);
  store.watch((s) => [s.welcome, shownRun(s)?.title, shownRun(s)?.robots, shownRun(s)?.world, isUnsaved(s)], (s) => {
    setText(title, shownRun(s)?.title || s.welcome?.title || "Laboratory");
    const robots = shownRun(s)?.robots.map((robot) => robot.name).join(", ");
    const world = shownRun(s)?.world;
    const told = [s.welcome && `${fileName(s)}${isUnsaved(s) ? " (edited)" : ""}`, robots, world && `world: ${world}`].filter(Boolean).join(" · ");
    setText(file, told);
    file.title = told;
  });
  store.watch((s) => [s.connection, shownRun(s), shownRun(s)?.version, comingRun(s)?.version, isStale(s), s.diagnostics], (s) => {
    const [text, kind] = statusOf(s, intents.live);
    setText(status, text);
    status.dataset["kind"] = kind;
  });
  store.watch((s) => [s.control, s.welcome, s.refusedKeys], (s) => drawControl(control, s, intents));
  store.watch((s) => [s.welcome, s.control.names !== null], (s) => s.welcome && s.control.names && tellKnownName(intents));
  void offerLink(offer, intents);
  addEventListener("hashchange", () => void offerLink(offer, intents));
}

// A program in the address of the page is not run until the user confirms it.
async function offerLink(host: HTMLElement, intents: Intents): Promise<void> {
  const text = await hashToText(location.hash);
  const isNew = text !== null && text !== intents.state.text;
  host.hidden = !isNew;
  if (!isNew) return;
  const done = () => {
    host.hidden = true;
    history.replaceState(null, "", location.pathname + location.search);
  };
  const open = () => {
    intents.store.change((s) => {
      s.text = text;
      s.textFrom++;
    });
    intents.typeText(text, true);
    done();
  };
  host.replaceChildren("This address carries a program.", el("button", { onclick: open }, "Open it"), el("button", { onclick: done }, "Leave it"));
}
