// A run as the messages that tell it, so that a page can show it again without a laboratory.
import type { Recording } from "../home/recording.ts";
import { CONTACT_ROWS, ELEMENT_ROWS, FORCE_ROWS, OBJECT_ROWS, ROBOT_ROWS, writeRows } from "../protocol/rows.ts";
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
  const names = [...run.objects.flatMap((object) => [object.file, object.texture]), ...run.robots.flatMap((robot) => (robot.pictures ?? []).map((each) => each.file))];
  return [...new Set(names.filter((name) => name !== undefined))];
}

// files  what filesOf names, in base64; those that could not be had are left out.
export function recordingOf(state: State, run: Run, files = new Map<string, string>()): Recording {
  const { welcome } = state;
  const id = run.id;
  const page = welcome?.page ?? 1;
  const head = { run: id, state: run.state, t_end: run.tEnd, label: run.label, parent: null, parts_at: null };
  const list = (type: string, items: unknown[]) => ({ type, run: id, first: 0, items });
  const { world, title, layout, robots, objects, elements } = run;
  return [
    { ...welcome, type: "welcome", page, text: state.text, text_version: state.textVersion, demo: false },
    { type: "control", holder: page, pages: [page], wishes: [] },
    { type: "diagnostics", text_version: state.textVersion, runs: true, items: state.diagnostics },
    { type: "runs", list: [head] },
    { ...head, type: "run", text_version: run.textVersion, inputs: run.inputs, hash: run.hash, error: run.error },
    ...[...files].map(([file, binary]) => ({ file, binary })),
    { type: "description", run: id, world, title, layout, robots, objects, elements },
    list("objects", run.events), list("moves", run.moves), list("ways", run.ways), list("statements", run.statements), list("notes", run.notes),
    ...[...run.figures].map(([index, figure]) => ({ type: "figures", run: id, index, ...figure })),
    { type: "elements", run: id, t: run.valuesAt, values: run.values },
    ...run.tracks.flatMap((rows, i) => (rows?.count ? [rowsMessage(id, ROBOT_ROWS, i, rows)] : [])),
    ...[...run.objectRows].map(([i, rows]) => rowsMessage(id, OBJECT_ROWS, i, rows)),
    ...[...run.elementRows].map(([i, rows]) => rowsMessage(id, ELEMENT_ROWS, i, rows)),
    ...[...run.forceRows].map(([i, rows]) => rowsMessage(id, FORCE_ROWS, i, rows)),
    ...[...run.contactRows].map(([i, rows]) => rowsMessage(id, CONTACT_ROWS, i, rows)),
    { type: "shown", run: id },
    ...(state.instant?.run === id ? [{ ...state.instant, to: null, cursor: true }] : []),
  ];
}
