// The state of the page: plain data. Views are functions of it.
import type * as M from "../protocol/messages.ts";
import type { Run } from "./run.ts";

export type Hover = { from: "text"; line: number } | { from: "path" | "bar"; robot: number; t: number; line: number | null } | null;

// The dragged tool of a robot, or the reason why it stops.
export interface Pull {
  robot: number;
  q: number[] | null;
  nearest: M.Nearest | null;
  reason: string;
}

export interface State {
  connection: "connecting" | "open" | "lost";
  connectionNote: string;
  welcome: M.Welcome | null;
  // names: of the people, by the number of the page; null: the laboratory knows none.
  control: { holder: number | null; pages: number[]; wishes: number[]; names: Record<string, string> | null };
  // The program: the text of the editor and the text of the laboratory.
  text: string;
  textVersion: number;
  // Increased when the text comes from elsewhere than the editor, which then takes it.
  textFrom: number;
  // The file of the program as the laboratory knows it, and whether another program changed it while there were unsaved edits; null: there
  // is none that could be written.
  document: { text: string; exists: boolean; changed: boolean } | null;
  // The text of the file for which the user put the question off.
  postponed: string | null;
  diagnostics: M.Diagnostic[];
  diagnosedVersion: number;
  runs: Map<number, Run>;
  list: M.RunHead[];
  shown: number | null;
  announced: number | null;
  // The run before the shown one, while a number is dragged.
  ghost: number | null;
  comparison: M.Comparison | null;
  t: number;
  playing: boolean;
  speed: number;
  // The number of times that the user went to an instant or a statement since the last change of the text. Above 0 the current line is
  // kept in view.
  followed: number;
  hover: Hover;
  pull: Pull | null;
  instant: M.InstantMessage | null;
  breakpoints: number[];
  breakable: number[];
  // Why an input was refused, by the name of the element.
  refusals: Map<string, string>;
  // The pose nearest to the last refused goal of the tool; null: the last one was accepted.
  nearest: (M.Nearest & { robot: number }) | null;
  message: string;
  // The number of keys that were typed into the program while another page was in control.
  refusedKeys: number;
  // Whether plots are shown below the time bar, with its scale.
  plotsBelow: boolean;
}

export function initialState(): State {
  return {
    connection: "connecting",
    connectionNote: "",
    welcome: null,
    control: { holder: null, pages: [], wishes: [], names: null },
    text: "",
    textVersion: 0,
    textFrom: 0,
    document: null,
    postponed: null,
    diagnostics: [],
    diagnosedVersion: -1,
    runs: new Map(),
    list: [],
    shown: null,
    announced: null,
    ghost: null,
    comparison: null,
    t: 0,
    playing: false,
    speed: 1,
    followed: 0,
    hover: null,
    pull: null,
    instant: null,
    breakpoints: [],
    breakable: [],
    refusals: new Map(),
    nearest: null,
    message: "",
    refusedKeys: 0,
    plotsBelow: false,
  };
}

export function shownRun(state: State): Run | null {
  return state.shown === null ? null : (state.runs.get(state.shown) ?? null);
}

// The run that replaces the shown one when it has reached the shown instant; null: there is none.
export function comingRun(state: State): Run | null {
  const run = state.announced === null || state.announced === state.shown ? null : (state.runs.get(state.announced) ?? null);
  return run?.state === "running" ? run : null;
}

export function inControl(state: State): boolean {
  return state.welcome !== null && state.control.holder === state.welcome.page;
}

// Whether the present text does not run, so that the shown run belongs to an older text.
export function isStale(state: State): boolean {
  return state.diagnosedVersion >= 0 && state.diagnostics.some((d) => d.severity === "error");
}

// Advice of the shown run, one entry for each statement and text: `t` is its first time, `times` the number of times. None while an older
// text is shown.
export function adviceOfRun(state: State): (M.RunAdvice & { times: number })[] {
  const once = new Map<string, M.RunAdvice & { times: number }>();
  for (const each of isStale(state) ? [] : (shownRun(state)?.advice ?? [])) {
    const key = JSON.stringify([each.code, each.span, each.file, each.message]);
    const known = once.get(key);
    if (known) known.times++;
    else once.set(key, { ...each, times: 1 });
  }
  return [...once.values()];
}

// The line of the program: at the instant that the laboratory has sent, or from the record.
export function currentLine(state: State): number | null {
  const { instant, t } = state;
  if (instant && instant.run === state.shown && Math.abs(instant.t - t) < 1e-9 && instant.line) return instant.line;
  return shownRun(state)?.lineAt(t) ?? null;
}
