// Applies messages of the laboratory to the state.
import type * as M from "../protocol/messages.ts";
import type { Incoming, IncomingOf } from "../protocol/messages.ts";
import { CONTACT_ROWS, DRAWING_ROWS, ELEMENT_ROWS, FORCE_ROWS, OBJECT_ROWS, ROBOT_ROWS, type RowBlock } from "../protocol/rows.ts";
import { Rows, Track } from "./rows.ts";
import { grow, Run } from "./run.ts";
import { inControl, shownRun, type State } from "./state.ts";

const KEPT = 40; // runs whose records stay in the page; the laboratory has the others

type Handlers = { [T in Incoming["type"]]?: (state: State, message: IncomingOf<T>) => void };

const handlers: Handlers = {
  welcome(state, message) {
    state.welcome = message;
    state.connection = "open";
    state.document = null;
    if (state.text === "" || state.textVersion <= message.text_version) takeText(state, message.text, message.text_version);
    state.runs.clear();
    state.shown = null;
    state.announced = null;
    state.ghost = null;
    state.comparison = null;
  },
  control(state, message) {
    state.control = { holder: message.holder, pages: message.pages, wishes: message.wishes ?? [], names: message.names ?? null };
    if (inControl(state)) state.refusedKeys = 0;
  },
  text(state, message) {
    takeText(state, message.text, message.text_version);
  },
  document(state, { text, exists, changed }) {
    state.document = { text, exists, changed };
  },
  diagnostics(state, message) {
    state.diagnostics = message.items;
    state.diagnosedVersion = message.text_version;
  },
  run(state, message) {
    const run = runOf(state, message.run);
    const atEnd = run === shownRun(state) && !state.playing && isAtEnd(state, run);
    run.state = message.state;
    if (atEnd) state.t = message.t_end; // at the end of a run that continues, the shown instant follows it
    run.tEnd = message.t_end;
    run.textVersion = message.text_version;
    run.label = message.label ?? "";
    run.parent = message.parent ?? null;
    run.partsAt = message.parts_at ?? null;
    run.inputs = message.inputs ?? [];
    run.hash = message.hash ?? "";
    run.taken = message.pictures ?? 0;
    run.error = message.error ?? null;
    run.version++;
  },
  shown(state, message) {
    state.announced = message.run;
  },
  runs(state, message) {
    state.list = message.list;
  },
  description(state, message) {
    const run = runOf(state, message.run);
    run.world = message.world ?? "";
    run.robots = message.robots;
    run.objects = message.objects;
    run.cameras = message.cameras ?? [];
    run.elements = message.elements ?? [];
    run.title = message.title ?? "";
    run.layout = message.layout ?? "";
    run.described = true;
    run.version++;
  },
  moves: (state, message) => growList(state, "moves", message),
  ways: (state, message) => growList(state, "ways", message),
  stretches: (state, message) => growList(state, "stretches", message),
  statements: (state, message) => growList(state, "statements", message),
  objects: (state, message) => growList(state, "events", message),
  drawings: (state, message) => growList(state, "drawings", message),
  notes: (state, message) => growList(state, "notes", message),
  advice: (state, message) => growList(state, "advice", message),
  figures(state, message) {
    const run = runOf(state, message.run);
    run.figures.set(message.index, { title: message.title ?? "", svg: message.svg, ...(message.panels ? { panels: message.panels } : {}) });
    run.version++;
  },
  elements(state, message) {
    const run = runOf(state, message.run);
    run.values = { ...run.values, ...message.values };
    run.valuesAt = message.t;
  },
  looks(state, message) {
    let [instant, values]: [M.Look["instant"], M.Look["values"]] = [{}, {}];
    runOf(state, message.run).looks = message.items.map((item) => {
      [instant, values] = [{ ...instant, ...item.instant }, { ...values, ...item.values }];
      return { t: item.t, instant, values };
    });
  },
  instant(state, message) {
    state.instant = message;
    // An answer is for the instant at which it was requested; the page may be elsewhere now. Steps move the page anyway.
    if (message.cursor && !state.playing && typeof message.to !== "number") {
      state.t = message.t;
      state.followed++;
    }
  },
  breakpoints(state, message) {
    state.breakpoints = message.lines;
    if (message.known) state.breakable = message.known;
  },
  comparison(state, message) {
    state.comparison = message;
  },
  error(state, message) {
    state.message = message.message;
  },
};

// Unknown messages are ignored: a newer laboratory may send more kinds.
export function receive(state: State, message: Incoming): void {
  const handler = handlers[message.type] as ((state: State, message: Incoming) => void) | undefined;
  handler?.(state, message);
  showAnnounced(state);
}

export function receiveRows(state: State, block: RowBlock): void {
  const run = runOf(state, block.run);
  if (block.kind === ROBOT_ROWS && block.columns >= 8 && (block.columns - 8) % 3 === 0) {
    (run.tracks[block.index] ??= new Track((block.columns - 8) / 3)).add(block);
  } else if (block.kind === OBJECT_ROWS && block.columns === 8) {
    rowsIn(run.objectRows, block).add(block);
  } else if (block.kind === ELEMENT_ROWS && block.columns >= 2) {
    rowsIn(run.elementRows, block).add(block);
  } else if (block.kind === FORCE_ROWS && block.columns >= 2) {
    rowsIn(run.forceRows, block).add(block);
  } else if (block.kind === CONTACT_ROWS && block.columns === 7) {
    rowsIn(run.contactRows, block).add(block);
  } else if (block.kind === DRAWING_ROWS) {
    run.drawingRows.add(block);
  }
  run.version++;
  showAnnounced(state);
}

function rowsIn(map: Map<number, Rows>, block: RowBlock): Rows {
  let rows = map.get(block.index);
  if (!rows || rows.columns !== block.columns) map.set(block.index, (rows = new Rows(block.columns)));
  return rows;
}

function takeText(state: State, text: string, version: number): void {
  state.textVersion = Math.max(version, state.textVersion);
  if (text === state.text) return;
  state.text = text;
  state.textFrom++;
}

export function runOf(state: State, id: number): Run {
  let run = state.runs.get(id);
  if (!run) {
    state.runs.set(id, (run = new Run(id)));
    forgetOld(state);
  }
  return run;
}

function forgetOld(state: State): void {
  for (const id of state.runs.keys()) {
    if (state.runs.size <= KEPT) return;
    if (id !== state.shown && id !== state.announced && id !== state.ghost) state.runs.delete(id);
  }
}

function growList<T>(state: State, name: "moves" | "ways" | "stretches" | "statements" | "events" | "drawings" | "notes" | "advice", message: { run: number; first: number; items: T[] }): void {
  const run = runOf(state, message.run);
  grow(run[name] as T[], message.first, message.items);
  run.version++;
}

function isAtEnd(state: State, run: Run): boolean {
  return state.t >= run.tEnd - 1e-9 && (run.tEnd > 0 || run.followsEnd);
}

// A new run is shown when it has ended or has reached the shown instant: until then the run before it stays, so that the view does not
// flicker. If the end was shown, the end stays shown.
function showAnnounced(state: State): void {
  if (state.announced === null) return;
  const next = state.runs.get(state.announced);
  const now = shownRun(state);
  if (!next || !next.described) return;
  const ended = next.state !== "running";
  const atEnd = now === null || isAtEnd(state, now);
  if (next === now) return;
  if (now && !ended && (atEnd || next.tEnd < state.t)) return;
  if (now && next.parent !== now.id) state.comparison = null;
  state.shown = next.id;
  next.followsEnd = atEnd;
  state.instant = null;
  state.t = atEnd ? next.tEnd : Math.min(state.t, next.tEnd);
}
