// What the page knows: plain data. Views are functions of it.
import type * as M from "../protocol/messages.ts";
import type { Run } from "./run.ts";

export type Hover = { from: "text"; line: number } | { from: "path" | "bar"; robot: number; t: number; line: number | null } | null;

// The hand of a robot being pulled, or why it stops there.
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
  control: { holder: number | null; pages: number[]; wishes: number[] };
  // The program: what the editor has and what the laboratory has.
  text: string;
  textVersion: number;
  // Set when the text comes from elsewhere than the editor, which then takes it.
  textFrom: number;
  diagnostics: M.Diagnostic[];
  diagnosedVersion: number;
  runs: Map<number, Run>;
  list: M.RunHead[];
  shown: number | null;
  announced: number | null;
  // The run before the one that is shown, while a number is pulled.
  ghost: number | null;
  comparison: M.Comparison | null;
  t: number;
  playing: boolean;
  speed: number;
  // Counts how often somebody went to an instant or a statement since the text was changed last. Above 0 the current line is kept in view.
  followed: number;
  hover: Hover;
  pull: Pull | null;
  instant: M.InstantMessage | null;
  breakpoints: number[];
  breakable: number[];
  // Why an input was refused, by the name of the element.
  refusals: Map<string, string>;
  // What comes nearest to the last refused wish for the hand; null: the last one was taken.
  nearest: (M.Nearest & { robot: number }) | null;
  message: string;
  // Whether plots stand below the bar of time, along it.
  plotsBelow: boolean;
}

export function initialState(): State {
  return {
    connection: "connecting",
    connectionNote: "",
    welcome: null,
    control: { holder: null, pages: [], wishes: [] },
    text: "",
    textVersion: 0,
    textFrom: 0,
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
    plotsBelow: false,
  };
}

export function shownRun(state: State): Run | null {
  return state.shown === null ? null : (state.runs.get(state.shown) ?? null);
}

// The run that takes the place of the shown one when it has come as far; null: there is none.
export function comingRun(state: State): Run | null {
  const run = state.announced === null || state.announced === state.shown ? null : (state.runs.get(state.announced) ?? null);
  return run?.state === "running" ? run : null;
}

export function inControl(state: State): boolean {
  return state.welcome !== null && state.control.holder === state.welcome.page;
}

// Whether the text as it is now does not run, so that what is shown belongs to an older one.
export function isStale(state: State): boolean {
  return state.diagnosedVersion >= 0 && state.diagnostics.some((d) => d.severity === "error");
}

// Advice of the shown run, each of a place and a text once: `t` is when it came first, `times` how often it came. None while an
// older text is shown.
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

// The line on which the program is: that of the instant the laboratory told, or that of the record.
export function currentLine(state: State): number | null {
  const { instant, t } = state;
  if (instant && instant.run === state.shown && Math.abs(instant.t - t) < 1e-9 && instant.line) return instant.line;
  return shownRun(state)?.lineAt(t) ?? null;
}
