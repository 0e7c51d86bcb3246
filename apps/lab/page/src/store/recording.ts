// A run as messages, with which a page can show it again without a laboratory.
import type { Recording } from "../home/recording.ts";
import { CONTACT_ROWS, DRAWING_ROWS, ELEMENT_ROWS, FORCE_ROWS, OBJECT_ROWS, ROBOT_ROWS, writeRows } from "../protocol/rows.ts";
import type { InstantMessage, Look } from "../protocol/messages.ts";
import type { Rows } from "./rows.ts";
import type { Run } from "./run.ts";
import type { State } from "./state.ts";

export function base64(data: ArrayBuffer): string {
  const bytes = new Uint8Array(data);
  const parts: string[] = [];
  for (let i = 0; i < bytes.length; i += 0x8000) parts.push(String.fromCharCode(...bytes.subarray(i, i + 0x8000)));
  return btoa(parts.join(""));
}

function rowsMessage(run: number, kind: number, index: number, rows: Rows): { binary: string } {
  const values = rows.values.slice(0, rows.count * rows.columns);
  return { binary: base64(writeRows({ kind, run, index, columns: rows.columns, first: 0, count: rows.count, rows: values })) };
}

// The files that are drawn in a run.
export function filesOf(run: Run): string[] {
  const names = [...run.elements.map((element) => element.file), ...run.objects.flatMap((object) => [object.file, object.texture]), ...run.robots.flatMap((robot) => (robot.pictures ?? []).map((each) => each.file))];
  return [...new Set(names.filter((name) => name !== undefined))];
}

const EVEN = 240; // number of instants at equal intervals in a recording
const MOST = 600; // including the start and end of moves

export function timesToLook(run: Run): number[] {
  const even = Array.from({ length: EVEN + 1 }, (_, i) => (run.tEnd * i) / EVEN);
  return [...new Set([...even, ...run.stops().slice(0, MOST - EVEN)])].sort((a, b) => a - b);
}

// The members of an object that differ from those at the instant before.
function changes<T extends object>(now: T, before: Partial<T>): Partial<T> {
  const names = (Object.keys(now) as (keyof T)[]).filter((name) => JSON.stringify(now[name]) !== JSON.stringify(before[name]));
  return Object.fromEntries(names.map((name) => [name, now[name]])) as Partial<T>;
}

// The data of some instants, each without what is equal to the one before.
export function looksOf(instants: readonly InstantMessage[]): Look[] {
  let [before, known]: [Look["instant"], Look["values"]] = [{}, {}];
  return instants.map(({ type: _type, run: _run, t, cursor: _cursor, values = {}, ...instant }) => {
    const look = { t, instant: changes(instant, before), values: changes(values, known) as Look["values"] };
    [before, known] = [instant, values];
    return look;
  });
}

// files  the files of filesOf, in base64; files that could not be loaded are left out.
export function recordingOf(state: State, run: Run, files = new Map<string, string>(), looks: Look[] = run.looks): Recording {
  const { welcome } = state;
  const id = run.id;
  const page = welcome?.page ?? 1;
  const head = { run: id, state: run.state, t_end: run.tEnd, label: run.label, parent: null, parts_at: null };
  const list = (type: string, items: unknown[]) => ({ type, run: id, first: 0, items });
  const { world, title, layout, robots, objects, cameras, elements } = run;
  return [
    { ...welcome, type: "welcome", page, text: state.text, text_version: state.textVersion, demo: false },
    { type: "control", holder: page, pages: [page], wishes: [] },
    { type: "diagnostics", text_version: state.textVersion, runs: true, items: state.diagnostics },
    { type: "runs", list: [head] },
    { ...head, type: "run", text_version: run.textVersion, inputs: run.inputs, hash: run.hash, error: run.error },
    ...[...files].map(([file, binary]) => ({ file, binary })),
    { type: "description", run: id, world, title, layout, robots, objects, cameras, elements },
    list("objects", run.events), list("drawings", run.drawings), list("moves", run.moves), list("ways", run.ways), list("stretches", run.stretches), list("statements", run.statements), list("notes", run.notes), list("advice", run.advice),
    ...[...run.figures].map(([index, figure]) => ({ type: "figures", run: id, index, ...figure })),
    { type: "elements", run: id, t: run.valuesAt, values: run.values },
    ...run.tracks.flatMap((rows, i) => (rows?.count ? [rowsMessage(id, ROBOT_ROWS, i, rows)] : [])),
    ...[...run.objectRows].map(([i, rows]) => rowsMessage(id, OBJECT_ROWS, i, rows)),
    ...[...run.elementRows].map(([i, rows]) => rowsMessage(id, ELEMENT_ROWS, i, rows)),
    ...[...run.forceRows].map(([i, rows]) => rowsMessage(id, FORCE_ROWS, i, rows)),
    ...[...run.contactRows].map(([i, rows]) => rowsMessage(id, CONTACT_ROWS, i, rows)),
    ...(run.drawingRows.count ? [rowsMessage(id, DRAWING_ROWS, 0, run.drawingRows)] : []),
    { type: "shown", run: id },
    ...(looks.length ? [{ type: "looks", run: id, items: looks }] : []),
    ...(state.instant?.run === id ? [{ ...state.instant, to: null, cursor: true }] : []),
  ];
}
