// The page: header, three columns, the time bar; on a phone one column with tabs.
import { aboutDialog } from "../about/about.ts";
import { el, remember, remembered, setText } from "../dom/dom.ts";
import { Editor } from "../editor/editor.ts";
import { elementPanel } from "../elements/panel.ts";
import { findConverter } from "../home/converter.ts";
import type { Span } from "../protocol/messages.ts";
import { SceneView } from "../scene/scene.ts";
import { isUnsaved } from "../store/document.ts";
import type { Intents } from "../store/intents.ts";
import { inControl, isStale, shownRun } from "../store/state.ts";
import type { Store } from "../store/store.ts";
import { TimeBar } from "../timebar/bar.ts";
import { transport } from "../timebar/transport.ts";
import { COLUMNS, TITLES, type ColumnName } from "./columns.ts";
import { droppedFiles } from "./drop.ts";
import { emptyPage } from "./gallery.ts";
import { header } from "./header.ts";
import { hints } from "./hints.ts";
import { globalKeys, helpDialog } from "./keys.ts";
import { editorPanels } from "./panels.ts";
import { programFile } from "./program_file.ts";
import { sceneTools } from "./scene_tools.ts";
import { splitters } from "./splitters.ts";

// source, alone  see HeaderActions.
export function buildPage(root: HTMLElement, store: Store, intents: Intents, source: string, alone: boolean): void {
  const about = aboutDialog(() => store.state.welcome?.version ?? "");
  const { dialog: help, open } = helpDialog(about.open);
  const top = el("header", { class: "top" });
  const editorHost = el("div", { class: "editor" });
  const below = el("div", { class: "below" });
  const stage = el("div", { class: "stage" });
  const labels = el("div", { class: "labels", "aria-hidden": "true" });
  const over = el("div", { class: "over" });
  const elements = el("div", { class: "elements" });
  const columns: Record<ColumnName, HTMLElement> = {
    program: el("section", { class: "column program", "aria-label": TITLES.program }, editorHost, below),
    view: el("section", { class: "column view", "aria-label": TITLES.view }, el("div", { class: "stage-box" }, stage, labels), over),
    elements: el("section", { class: "column side", "aria-label": TITLES.elements }, elements),
  };
  const main = el("main", { class: "columns" }, columns.program, columns.view, columns.elements);
  const bottom = el("footer", { class: "bottom", "aria-label": "Time" });
  const message = el("div", { class: "message", role: "status", "aria-live": "polite", hidden: true });
  const { tabs, choose } = phoneTabs(main);
  const load = (text: string) => editor.load(text);
  const program = programFile(store, intents, load, source, alone);
  root.replaceChildren(top, main, bottom, tabs, message, help, about.dialog, ...program.dialogs);

  header(top, store, intents, { source, alone, program: program.buttons, help: open, toggle: (name) => toggle(columns[name], name), isOpen: (name) => !columns[name].classList.contains("closed") });
  top.append(program.question);
  const editor = new Editor(editorHost, store, intents);
  editorPanels(below, store, intents, editor);
  splitters(main, columns, below);
  const legend = el("div", { class: "legend", hidden: true });
  const version = () => shownRun(store.state)?.textVersion ?? null;
  const startView = () => {
    try {
      const scene = new SceneView(store, intents, {
        stage,
        labels,
        pickObject: (name, span) => editor.find(name, undefined, span, version()),
        topSpeed: (v) => drawLegend(legend, v),
        file: (name) => intents.file(name),
      });
      sceneTools(over, legend, scene, store, intents, editor);
      droppedFiles(stage, scene, store, intents, editor, findConverter());
    } catch (error) {
      // All other parts work without it.
      columns.view.append(el("p", { class: "quiet element no-view" }, `There is no 3D view: ${error instanceof Error ? error.message : String(error)}`));
    }
  };
  const along = el("div", { class: "along", hidden: true });
  elementPanel(elements, along, store, intents, ({ name, kind, span }) => editor.find(name, kind, span, version()), (fields) => editor.writeFields(fields));
  columns.view.append(noRun(store, (span) => {
    choose("program");
    editor.select(span);
  }));
  columns.view.append(emptyPage(store, intents, load));
  transport(bottom, store, intents);
  new TimeBar(bottom, store, intents);
  bottom.append(along);
  globalKeys(intents, open);
  hints({ program: [columns.program, below], view: [over, null], elements: [columns.elements, elements] }, store);
  for (const name of COLUMNS) if (remembered(`closed.${name}`) === "yes") columns[name].classList.add("closed");
  watchMessage(message, store);
  whenPainted(store, startView);
  store.watch((s) => [shownRun(s)?.layout, shownRun(s)?.title, isStale(s), inControl(s), isUnsaved(s), s.welcome], (s) => {
    const run = shownRun(s);
    root.dataset["layout"] = run?.layout || s.welcome?.layout || "columns";
    root.classList.toggle("is-stale", isStale(s));
    root.classList.toggle("follows", !inControl(s));
    document.title = `${isUnsaved(s) ? "● " : ""}${run?.title || s.welcome?.title || s.welcome?.file || "Armlet"} – laboratory`;
  });
}

// The start of the 3D view takes as long as all the rest: it begins when the rest has been painted with the first run, or after two
// seconds.
function whenPainted(store: Store, start: () => void): void {
  let done = false;
  const once = () => {
    if (done) return;
    done = true;
    requestAnimationFrame(() => setTimeout(start));
  };
  store.watch((s) => [shownRun(s)?.described], (s) => shownRun(s)?.described && once());
  setTimeout(once, 2000);
}

// In an empty view: the reason why there is nothing to show; a click shows the first mistake.
function noRun(store: Store, show: (span: Span) => void): HTMLElement {
  const first = () => store.state.diagnostics.find((d) => d.severity === "error");
  const note = el("button", { class: "no-run", hidden: true, onclick: () => first()?.span && show(first()!.span!) });
  store.watch((s) => [s.shown, s.diagnostics], (s) => {
    const error = first();
    note.hidden = s.shown !== null || !error;
    if (error) setText(note, `The program has not run yet. ${error.span ? `Line ${error.span[0]}: ` : ""}${error.message}`);
  });
  return note;
}

function toggle(column: HTMLElement, name: ColumnName): boolean {
  const closed = column.classList.toggle("closed");
  remember(`closed.${name}`, closed ? "yes" : "no");
  return !closed;
}

function phoneTabs(main: HTMLElement): { tabs: HTMLElement; choose: (name: ColumnName) => void } {
  const buttons = COLUMNS.map((name) => el("button", { onclick: () => choose(name) }, TITLES[name]));
  const choose = (name: ColumnName) => {
    main.dataset["tab"] = name;
    buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(COLUMNS[i] === name)));
  };
  choose("elements"); // with the 3D view above
  return { tabs: el("nav", { class: "phone", "aria-label": "Parts of the page" }, ...buttons), choose };
}

function drawLegend(legend: HTMLElement, top: number): void {
  legend.hidden = top <= 1e-6;
  legend.replaceChildren(el("span", {}, "0"), el("span", { class: "ramp" }), el("span", {}, `${top.toPrecision(2)} m/s`));
}

function watchMessage(message: HTMLElement, store: Store): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  store.watch((s) => [s.message, s.connection, s.connectionNote], (s) => {
    const lost = s.connection === "lost";
    setText(message, lost ? `The laboratory does not answer. Trying again … ${s.connectionNote}` : s.message);
    message.hidden = message.textContent === "";
    clearTimeout(timer);
    if (s.message && !lost) timer = setTimeout(() => store.change((state) => (state.message = "")), 6000);
  });
}
