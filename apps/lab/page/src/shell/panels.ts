// Below the editor: problems, output, variables and the list of runs.
import { el, setText } from "../dom/dom.ts";
import type { Editor } from "../editor/editor.ts";
import type { Diagnostic } from "../protocol/messages.ts";
import type { Intents } from "../store/intents.ts";
import { adviceOfRun, inControl, isStale, shownRun, type State } from "../store/state.ts";
import type { Store } from "../store/store.ts";
import { icon } from "../dom/icons.ts";
import { wrapsLines } from "../editor/wrapping.ts";
import { stepButtons } from "../timebar/transport.ts";

export interface Tab {
  name: string;
  title: string;
  content: HTMLElement;
}

// Tabs with their panels; arrow keys select the next one.
// beside  an element at the end of the line of tabs. chosen  called after each choice.
export function tabs(host: HTMLElement, list: Tab[], label: string, beside: HTMLElement, chosen: (name: string) => void = () => {}): { choose(name: string): void; count(name: string, n: number): void } {
  const buttons = new Map<string, HTMLButtonElement>();
  const counts = new Map<string, HTMLElement>();
  const choose = (name: string) => {
    for (const tab of list) {
      const on = tab.name === name;
      tab.content.hidden = !on;
      buttons.get(tab.name)!.setAttribute("aria-selected", String(on));
      buttons.get(tab.name)!.tabIndex = on ? 0 : -1;
    }
    chosen(name);
  };
  const bar = el("div", { class: "tabs", role: "tablist", "aria-label": label });
  list.forEach((tab, i) => {
    const count = el("span", { class: "count" });
    const id = `tab-${tab.name}`;
    const button = el("button", { role: "tab", id, "aria-controls": `panel-${tab.name}`, onclick: () => choose(tab.name) }, tab.title, count);
    button.addEventListener("keydown", (event) => {
      const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
      if (!step) return;
      const next = list[(i + step + list.length) % list.length]!.name;
      choose(next);
      buttons.get(next)!.focus();
      event.stopPropagation();
    });
    tab.content.setAttribute("role", "tabpanel");
    tab.content.setAttribute("aria-labelledby", id);
    tab.content.tabIndex = 0;
    tab.content.id = `panel-${tab.name}`;
    buttons.set(tab.name, button);
    counts.set(tab.name, count);
    bar.append(button);
  });
  host.append(el("div", { class: "tab-row" }, bar, beside), ...list.map((tab) => tab.content));
  choose(list[0]!.name);
  return { choose, count: (name, n) => setText(counts.get(name)!, n ? String(n) : "") };
}

// `when` is shown after the message: the instant to which it belongs.
function problem(d: Diagnostic, editor: Editor, allowed: boolean, when: HTMLElement | null = null): HTMLElement {
  const fix = d.fix;
  return el(
    "li", { class: `problem ${d.severity}` },
    el("button", { class: "link", onclick: () => d.span && editor.select(d.span) }, d.span ? `${d.span[0]}:${d.span[1] + 1}` : (d.file ?? ""), " ", d.message),
    el("span", { class: "code" }, d.code),
    when,
    d.why ? el("p", { class: "quiet" }, d.why) : null,
    fix?.edits.length && allowed ? el("button", { class: "fix", onclick: () => editor.apply(fix.edits) }, `Fix: ${fix.text}`) : null,
  );
}

export function editorPanels(host: HTMLElement, store: Store, intents: Intents, editor: Editor): void {
  const problems = el("ul", { class: "panel list" });
  const output = el("div", { class: "panel output" });
  const variables = el("div", { class: "panel" });
  const runs = el("ul", { class: "panel list runs" });
  let shownTab = "problems";
  // Without problems there is only the line of tabs.
  const flatten = () => host.classList.toggle("flat", shownTab === "problems" && !problems.childElementCount);
  const bar = tabs(host, [
    { name: "problems", title: "Problems", content: el("div", {}, problems) },
    { name: "output", title: "Output", content: output },
    { name: "variables", title: "Variables", content: variables },
    { name: "runs", title: "Runs", content: el("div", {}, runs) },
  ], "About the program", el("div", { class: "beside" }, wrapButton(editor), stepButtons(store, intents)), (name) => {
    shownTab = name;
    flatten();
  });
  const at = (t: number, times: number) => el("button", { class: "tiny", onclick: () => intents.goTo(t) }, `${t.toFixed(2)} s${times > 1 ? `, ${times} times` : ""}`);
  store.watch((s) => [s.diagnostics, shownRun(s)?.error, shownRun(s), shownRun(s)?.advice.length, isStale(s), inControl(s)], (s) => {
    const failure = shownRun(s)?.error;
    const all = failure ? [...s.diagnostics, failure] : s.diagnostics;
    const allowed = inControl(s) && intents.live;
    const items = [...all.map((d) => problem(d, editor, allowed)), ...adviceOfRun(s).map((d) => problem(d, editor, allowed, at(d.t, d.times)))];
    problems.replaceChildren(...items);
    flatten();
    bar.count("problems", items.length);
  });
  store.watch((s) => [s.shown, shownRun(s)?.version, s.t], (s) => drawOutput(output, s, intents, bar));
  store.watch((s) => [s.instant, s.shown], (s) => drawVariables(variables, s));
  store.watch((s) => [s.list, s.shown, s.ghost, s.comparison, inControl(s)], (s) => {
    drawRuns(runs, s, intents);
    bar.count("runs", s.list.length > 1 ? s.list.length : 0);
  });
}

function wrapButton(editor: Editor): HTMLElement {
  const button: HTMLButtonElement = el("button", { class: "icon", "aria-label": "Wrap long lines", title: "Wrap long lines (Alt Z)", "aria-pressed": String(wrapsLines()), onclick: () => editor.wrap(!wrapsLines()) }, icon("wrap"));
  editor.wrapped = (on) => button.setAttribute("aria-pressed", String(on));
  return button;
}

let drawnOutput = "";
function drawOutput(host: HTMLElement, state: State, intents: Intents, bar: { count(name: string, n: number): void }): void {
  const run = shownRun(state);
  const notes = run?.notes ?? [];
  const key = `${run?.id} ${notes.length}`;
  if (key !== drawnOutput) {
    drawnOutput = key;
    host.replaceChildren(...notes.slice(-1000).map((note) => el("button", { class: `note of-${note.kind}`, onclick: () => intents.goTo(note.t) }, el("span", { class: "quiet" }, note.t.toFixed(2)), `${note.element ? `${note.element}: ` : ""}${note.text}`.replace(/\n$/, ""))));
    if (!notes.length) host.append(el("p", { class: "quiet" }, "Nothing was printed."));
    bar.count("output", notes.length);
  }
  const shown = notes.slice(-1000);
  [...host.children].forEach((child, i) => child.classList.toggle("later", (shown[i]?.t ?? 0) > state.t + 1e-9));
}

function drawVariables(host: HTMLElement, state: State): void {
  const instant = state.instant?.run === state.shown ? state.instant : null;
  // Functions have no value to look at.
  const variables = (instant?.variables ?? []).filter((v) => !v.type.startsWith("fn"));
  if (!instant || !variables.length) {
    host.replaceChildren(el("p", { class: "quiet" }, "No variables at this instant."));
    return;
  }
  const scopes = [...new Set(variables.map((v) => v.scope))].sort((a, b) => b - a);
  const calls = instant.tasks?.[0]?.calls ?? [];
  const rows = scopes.flatMap((scope) => [
    ...(scopes.length > 1 ? [el("tr", {}, el("th", { colspan: 3, scope: "rowgroup" }, scope === 0 ? "program" : (calls[scope - 1] ?? `call ${scope}`)))] : []),
    ...variables.filter((v) => v.scope === scope).map((v) => el("tr", {}, el("td", { class: "name" }, v.name), el("td", { class: "type" }, v.type), el("td", { class: "value" }, v.value ?? "–"))),
  ]);
  const tasks = (instant.tasks ?? []).filter((task) => task.waits && !/its host$/.test(task.waits)).map((task) => el("p", { class: "quiet" }, `${task.name || "the program"} ${/^waits/.test(task.waits!) ? "" : "waits for "}${task.waits}`));
  const signals = (instant.signals ?? []).map(({ name, value }) => el("tr", {}, el("td", { class: "name" }, name), el("td", { class: "type" }, "signal"), el("td", { class: "value" }, String(value))));
  host.replaceChildren(el("table", { class: "variables" }, el("tbody", {}, ...rows, ...signals)), ...tasks);
}

function drawRuns(host: HTMLElement, state: State, intents: Intents): void {
  const items = state.list.toReversed().map((head) => {
    const shown = head.run === state.shown;
    const compared = head.run === state.ghost;
    return el(
      "li", { class: shown ? "run shown" : "run" },
      el("button", { class: "link", onclick: () => intents.show(head.run), "aria-current": shown ? "true" : null }, `${head.run}`, " ", head.label || head.state),
      el("span", { class: "quiet" }, `${head.t_end.toFixed(2)} s`),
      shown || !intents.live ? null : el("button", { class: "tiny", "aria-pressed": String(compared), onclick: () => void intents.compare(compared ? null : head.run) }, compared ? "Beside" : "Compare"),
      compared ? el("p", { class: "reason" }, comparisonText(state)) : null,
    );
  });
  host.replaceChildren(...(items.length ? items : [el("li", { class: "quiet" }, "No runs yet.")]));
}

export function comparisonText(state: State): string {
  const c = state.comparison;
  if (!c) return "";
  if (c.same) return "Both runs are the same.";
  const at = typeof c.parts_at === "number" ? `at t = ${c.parts_at.toFixed(2)} s` : "from the start";
  return `They part ${at}${c.line ? `, line ${c.line}` : ""}.`;
}
