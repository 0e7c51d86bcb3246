// The editor of the program.
import { closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import { defaultKeymap, history, historyKeymap, indentWithTab, isolateHistory } from "@codemirror/commands";
import { bracketMatching, indentOnInput, indentUnit } from "@codemirror/language";
import { forEachDiagnostic, lintGutter, lintKeymap, setDiagnostics, type Action, type Diagnostic as LintDiagnostic } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { Compartment, EditorState, Transaction, type Annotation, type StateEffect } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLineGutter, highlightSpecialChars, keymap, lineNumbers } from "@codemirror/view";
import { fixed } from "../numbers/units.ts";
import type { Diagnostic, Edit, ElementInfo, Span, Value } from "../protocol/messages.ts";
import type { Intents } from "../store/intents.ts";
import type { Run } from "../store/run.ts";
import { adviceOfRun, currentLine, inControl, isStale, shownRun, type State } from "../store/state.ts";
import type { Store } from "../store/store.ts";
import { fieldChange } from "./fields.ts";
import { asking, positionOf, rangeOf, takeFirst } from "./ask.ts";
import { language } from "./language.ts";
import { marking, setMarks } from "./marks.ts";
import { placeOfName } from "./names.ts";
import { behindStatement, wantsValue } from "./placing.ts";
import { numberPulling } from "./pull.ts";
import { wrapLines, wrapping, wrapsLines } from "./wrapping.ts";

export class Editor {
  readonly view: EditorView;
  private readonly intents: Intents;
  private readonly highlighting = new Compartment();
  private readonly writing = new Compartment();
  private taking = false;
  private showed: { line: number | null; followed: number } = { line: null, followed: 0 };

  constructor(host: HTMLElement, store: Store, intents: Intents) {
    this.intents = intents;
    const pulling = numberPulling((text, place) => intents.pullText(text, place), () => intents.endPull());
    const hover = (line: number | null) => {
      const now = store.state.hover;
      if (line === null ? now === null : now?.from === "text" && now.line === line) return;
      store.change((s) => (s.hover = line === null ? null : { from: "text", line }));
    };
    this.view = new EditorView({
      parent: host,
      state: EditorState.create({
        extensions: [
          // Before the extensions that send questions about the text.
          EditorView.updateListener.of((update) => {
            if (!update.docChanged || this.taking) return;
            if (!update.transactions.some((t) => t.isUserEvent("input.pull"))) intents.typeText(update.state.doc.toString());
          }),
          marking((line) => intents.toggleBreakpoint(line), hover),
          lineNumbers(), highlightActiveLineGutter(), highlightSpecialChars(), history(), drawSelection(), indentOnInput(), bracketMatching(),
          closeBrackets(), highlightSelectionMatches(), lintGutter(), EditorState.tabSize.of(4), indentUnit.of("    "),
          pulling, asking(intents), wrapping(),
          EditorView.domEventHandlers({ keydown: (event) => this.refuseKey(event) }),
          keymap.of([
            { key: "Tab", run: takeFirst },
            { key: "Shift-Alt-f", run: () => (void this.format(), true) },
            { key: "Alt-z", run: () => (this.wrap(!wrapsLines()), true) },
            { key: "F12", run: () => (void this.goToDefinition(), true) },
            { key: "F9", run: (view) => (intents.toggleBreakpoint(positionOf(view.state.doc, view.state.selection.main.head)[0]), true) },
          ]),
          keymap.of([...closeBracketsKeymap, ...completionKeymap, ...lintKeymap, ...searchKeymap, ...historyKeymap, ...defaultKeymap, indentWithTab]),
          this.highlighting.of(language()),
          this.writing.of(EditorState.readOnly.of(true)),
          EditorView.contentAttributes.of({ "aria-label": "Program", spellcheck: "false", autocapitalize: "off", tabindex: "0" }),
        ],
      }),
    });
    this.keepCursorInView();
    store.watch((s) => [s.welcome], (s) => this.view.dispatch({ effects: this.highlighting.reconfigure(language(s.welcome?.words)) }));
    store.watch((s) => [s.textFrom], (s) => this.take(s.text));
    store.watch((s) => [inControl(s), intents.live], (s) => this.view.dispatch({ effects: this.writing.reconfigure(EditorState.readOnly.of(!inControl(s) || !intents.live)) }));
    store.watch((s) => [s.diagnostics, shownRun(s)?.error, shownRun(s), shownRun(s)?.advice.length, isStale(s)], (s) => this.diagnose(s));
    store.watch(
      (s) => [s.breakpoints, currentLine(s), hoveredLine(s), shownRun(s), shownRun(s)?.version, isStale(s), s.followed],
      (s) => this.mark(s),
    );
  }

  // Inserts a position at the cursor where a value is written there, otherwise a move to it behind the current statement.
  insertPosition(position: string, robot: string): void {
    const { state } = this.view;
    if (state.readOnly) return;
    const text = state.doc.toString();
    if (wantsValue(text, state.selection.main.from)) {
      this.view.dispatch(state.replaceSelection(position), { userEvent: "input.paste", scrollIntoView: true });
    } else {
      const { at, indent } = behindStatement(text, currentLine(this.intents.state));
      const move = `${indent}${robot}.moveJ(${position})`;
      const insert = at > 0 && text[at - 1] !== "\n" ? `\n${move}\n` : `${move}\n`;
      this.view.dispatch({ changes: { from: at, insert }, selection: { anchor: at + insert.length - 1 }, effects: EditorView.scrollIntoView(at, { y: "center" }), userEvent: "input.paste" });
    }
    this.view.focus();
  }

  // Called when lines begin or cease to be wrapped.
  wrapped: (on: boolean) => void = () => {};

  wrap(on: boolean): void {
    wrapLines(this.view, on);
    this.wrapped(on);
  }

  // Says why a typed key has no effect: another page is in control of the program, or it is a recording.
  private refuseKey(event: KeyboardEvent): boolean {
    if (!this.view.state.readOnly || event.ctrlKey || event.metaKey || event.altKey) return false;
    if (event.key.length > 1 && !["Enter", "Backspace", "Delete"].includes(event.key)) return false;
    if (this.intents.live) this.intents.store.change((s) => s.refusedKeys++);
    else this.intents.say("This is a recording: its program cannot be changed.");
    return false;
  }

  // When the panels below grow, the line that is being written stays visible.
  private keepCursorInView(): void {
    const { scrollDOM } = this.view;
    let before = scrollDOM.clientHeight;
    new ResizeObserver(() => {
      const [was, now] = [before, scrollDOM.clientHeight];
      before = now;
      if (now >= was || !this.view.hasFocus) return;
      const { head } = this.view.state.selection.main;
      const at = this.view.coordsAtPos(head);
      const top = scrollDOM.getBoundingClientRect().top;
      if (at && at.top >= top - 1 && at.top <= top + was) this.view.dispatch({ effects: EditorView.scrollIntoView(head, { y: "nearest" }) });
    }).observe(scrollDOM);
  }

  // Inserts lines at `at`, the start of a line or the end of the text, shows them and runs the program.
  insertLines(at: number, text: string): void {
    if (this.view.state.readOnly) return;
    this.view.dispatch({ changes: { from: at, insert: text }, selection: { anchor: at + text.length }, effects: EditorView.scrollIntoView(at, { y: "center" }), userEvent: "input.paste" });
    this.intents.typeText(this.view.state.doc.toString(), true);
  }

  // Replaces the program, for example by one of the gallery. Undo brings the old one back.
  load(text: string): void {
    if (this.view.state.readOnly) return;
    const { length } = this.view.state.doc;
    this.view.dispatch({ changes: { from: 0, to: length, insert: text }, selection: { anchor: 0 }, userEvent: "input.load", scrollIntoView: true, annotations: isolateHistory.of("full") });
    this.intents.typeText(this.view.state.doc.toString(), true);
  }

  select(span: Span): void {
    const { from, to } = rangeOf(this.view.state.doc, span);
    this.view.dispatch({ selection: { anchor: from, head: to }, effects: EditorView.scrollIntoView(from, { y: "center" }) });
    this.view.focus();
  }

  // Selects the first position at which the program names an object, a robot or a row of its laboratory: its declaration, or a
  // text, or any other use. `kind` is the word before the name of a row.
  // span, version  where the laboratory found it, and in which text; the name is searched for near that span.
  find(name: string, kind = "object|robot", span: Span | null = null, version: number | null = null): void {
    const { doc } = this.view.state;
    const told = span && version === this.intents.state.textVersion ? rangeOf(doc, span) : { from: 0, to: doc.length };
    const found = placeOfName(doc.sliceString(told.from, told.to), name, kind);
    if (found === null) return;
    const at = told.from + found;
    this.view.dispatch({ selection: { anchor: at, head: at + name.length }, effects: EditorView.scrollIntoView(at, { y: "center" }) });
  }

  apply(edits: readonly Edit[]): void {
    const { doc } = this.view.state;
    const changes = edits.map((edit) => ({ ...rangeOf(doc, edit.span), insert: edit.text }));
    this.view.dispatch({ changes, userEvent: "input.fix" });
    this.intents.typeText(this.view.state.doc.toString(), true);
  }

  // Gives fields other values at the start, and runs the program.
  writeFields(fields: readonly [ElementInfo, Value][]): void {
    if (this.view.state.readOnly) return;
    const text = this.view.state.doc.toString();
    const changes = fields.flatMap(([element, value]) => fieldChange(text, element, value) ?? []);
    if (changes.length < fields.length) this.intents.say("The row of a field is not in this text: its value is not written.");
    if (!changes.length) return;
    this.view.dispatch({ changes, userEvent: "input.fields" });
    this.intents.typeText(this.view.state.doc.toString(), true);
  }

  async format(): Promise<void> {
    const answer = await this.intents.ask<"formatted">({ type: "format" }).catch(() => null);
    if (!answer) return;
    if (answer.text === null) this.intents.say("The program has mistakes: it can be laid out when they are mended.");
    else this.replaceAll(answer.text, [Transaction.userEvent.of("input.format")]);
  }

  async goToDefinition(): Promise<void> {
    const at = positionOf(this.view.state.doc, this.view.state.selection.main.head);
    const answer = await this.intents.ask<"definition">({ type: "definition", at }).catch(() => null);
    if (answer?.span) this.select(answer.span);
  }

  // Replaces only the differences, so that the cursor stays at its position.
  private replaceAll(text: string, annotations: readonly Annotation<unknown>[]): void {
    const old = this.view.state.doc.toString();
    let from = 0;
    while (from < old.length && from < text.length && old[from] === text[from]) from++;
    let end = 0;
    while (end < old.length - from && end < text.length - from && old.at(-1 - end) === text.at(-1 - end)) end++;
    if (from + end === old.length && old.length === text.length) return;
    this.view.dispatch({ changes: { from, to: old.length - end, insert: text.slice(from, text.length - end) }, annotations });
  }

  // A loaded text, or one written on another page, is not part of the undo history of this user.
  private take(text: string): void {
    this.taking = true;
    this.replaceAll(text, [Transaction.userEvent.of("input.take"), Transaction.addToHistory.of(false)]);
    this.taking = false;
  }

  private diagnose(state: State): void {
    const { doc } = this.view.state;
    const failure = shownRun(state)?.error;
    const all = [...state.diagnostics, ...(failure && !isStale(state) ? [failure] : []), ...adviceOfRun(state)];
    const list = all.filter((d) => d.span).map((d) => this.lintOf(d, rangeOf(doc, d.span!)));
    if (!this.shows(list)) this.view.dispatch(setDiagnostics(this.view.state, list));
  }

  // Whether exactly these are shown already: setting them again would close their opened details. Corrections are for one text.
  private shows(list: readonly LintDiagnostic[]): boolean {
    const key = (d: LintDiagnostic, from: number, to: number) => (d.actions?.length ? null : JSON.stringify([from, to, d.severity, d.message, d.source]));
    const shown: (string | null)[] = [];
    forEachDiagnostic(this.view.state, (d, from, to) => shown.push(key(d, from, to)));
    const next = list.map((d) => key(d, d.from, d.to)).sort();
    shown.sort();
    return shown.length === next.length && next.every((each, i) => each !== null && each === shown[i]);
  }

  private lintOf(d: Diagnostic, range: { from: number; to: number }): LintDiagnostic {
    const actions: Action[] = d.fix?.edits.length ? [{ name: d.fix.text, apply: () => this.apply(d.fix!.edits) }] : [];
    const message = d.why ? `${d.message}\n${d.why}` : d.message;
    return { ...range, severity: d.severity === "error" ? "error" : "warning", message, source: d.code, actions };
  }

  private mark(state: State): void {
    const run = shownRun(state);
    const value = {
      breakpoints: state.breakpoints,
      current: currentLine(state),
      hovered: hoveredLine(state),
      failed: isStale(state) ? null : (run?.error?.span?.[0] ?? null),
      margin: run ? marginOf(run) : [],
      stale: isStale(state),
    };
    this.view.dispatch({ effects: [setMarks.of(value), ...this.showing(value.current, state.followed)] });
  }

  // Scrolls to the current line if the user went there; not while the text is being edited, which makes new runs with other lines.
  private showing(line: number | null, followed: number): StateEffect<unknown>[] {
    const { doc } = this.view.state;
    const isNew = followed > 0 && (line !== this.showed.line || followed !== this.showed.followed);
    this.showed = { line, followed };
    return isNew && line !== null && line <= doc.lines ? [EditorView.scrollIntoView(doc.line(line).from, { y: "nearest", yMargin: 2 * this.view.defaultLineHeight })] : [];
  }
}

function hoveredLine(state: State): number | null {
  return state.hover && state.hover.from !== "text" ? state.hover.line : null;
}

// For each line with moves: their total duration, shown at the end of the last one.
export function marginOf(run: Run): [number, string, string][] {
  const lines = new Map<number, { time: number; number: number; text: string; end: string }>();
  for (const move of run.moves) {
    if (!move.span) continue;
    const line = move.span[0];
    const entry = lines.get(line) ?? { time: 0, number: 0 };
    lines.set(line, { time: entry.time + move.t1 - move.t0, number: entry.number + 1, text: move.text, end: endOf(run, move.robot, move.t1) });
  }
  return [...lines].map(([line, { time, number, text, end }]) => {
    const seconds = `${time.toFixed(2)} s`;
    return [line, number > 1 ? `${number}× ${seconds}` : seconds, `${number > 1 ? `${number} moves, ${seconds} together` : text}${end}`];
  });
}

function endOf(run: Run, robot: number, t: number): string {
  const pose = run.toolAt(robot, t);
  return pose ? `, to ${pose.slice(0, 3).map((v) => fixed(1000 * v, 1)).join(", ")} mm` : "";
}
