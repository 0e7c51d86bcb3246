// The contents of the time bar: a lane for each robot, task and signal, with blocks for statements and values.
import { seriesOf } from "../numbers/series.ts";
import type { Run } from "../store/run.ts";
import type { State } from "../store/state.ts";
import { shownRun } from "../store/state.ts";

export const LEFT = 76; // px: names of lanes; the axis of plots below the bar is there
const RIGHT = 14;

export interface Block {
  t0: number;
  t1: number;
  name: string; // shown in the block
  text: string; // shown under the pointer
  lines: [number, number] | null; // of the program
  low?: boolean; // a signal that is off
}
export interface Lane {
  kind: "robot" | "task" | "signal";
  name: string;
  title: string;
  height: number; // px
  blocks: Block[];
}

const PROGRAM = "the program";
const HEIGHTS = { robot: 24, task: 17, signal: 17 };

// "every on line 9", short enough for the name of a lane; the pointer shows the whole name.
function shortName(name: string): string {
  const found = /^(every|when|branch \d+ of parallel|lambda) on line (\d+)$/.exec(name);
  const text = found ? `${found[1]!.replace(/branch (\d+) of parallel/, "part $1")} :${found[2]}` : name.split(".").at(-1)!;
  return text.length > 11 ? `${text.slice(0, 10)}…` : text;
}

function robotLanes(run: Run): Lane[] {
  const lanes = run.robots.map((robot): Lane => ({ kind: "robot", name: robot.name.length > 10 ? `${robot.name.slice(0, 9)}…` : robot.name, title: robot.name, height: HEIGHTS.robot, blocks: [] }));
  for (const move of run.moves) {
    const name = /move\w*|[a-z]\w+/i.exec(move.text.replace(/^\S+ /, ""))?.[0] ?? move.text;
    lanes[move.robot]?.blocks.push({ t0: move.t0, t1: move.t1, name, text: move.text, lines: move.span && [move.span[0], move.span[2]] });
  }
  return lanes;
}

// `lines` are the lines of the text of the run; empty: the text is not known any more.
function stretchLanes(run: Run, lines: readonly string[]): Lane[] {
  const lanes = new Map<string, Lane>();
  for (const each of run.stretches) {
    const key = `${each.kind} ${each.name}`;
    const title = each.kind === "signal" ? `signal ${each.name}` : each.name || PROGRAM;
    const lane = lanes.get(key) ?? { kind: each.kind, name: each.name ? shortName(each.name) : "program", title, height: HEIGHTS[each.kind], blocks: [] };
    lanes.set(key, lane);
    const line = each.span?.[0] ?? null;
    const written = line === null ? "" : (lines[line - 1]?.trim() ?? "");
    const value = typeof each.value === "number" ? String(+each.value.toPrecision(4)) : each.value ? "on" : "off";
    const text = each.kind === "signal" ? `${title} is ${value}` : `${title}${line === null ? "" : `, line ${line}: ${written}`}`;
    const before = lane.blocks.at(-1);
    if (before?.text === text && before.t1 >= each.t0 - 1e-9) {
      before.t1 = each.t1; // a run that continued has sent it in two parts
      continue;
    }
    lane.blocks.push({
      t0: each.t0,
      t1: each.t1,
      name: each.kind === "signal" ? value : line === null ? "" : `${line}`,
      text,
      lines: each.span ? [each.span[0], each.span[2]] : null,
      low: each.kind === "signal" && (each.value === false || each.value === 0),
    });
  }
  // The program first, then in the order of their start; intervals arrive in the order of their end.
  const begin = (lane: Lane) => (lane.title === PROGRAM ? -1 : (lane.blocks[0]?.t0 ?? 0));
  const of = (kind: Lane["kind"]) => [...lanes.values()].filter((lane) => lane.kind === kind).sort((a, b) => begin(a) - begin(b) || (a.title < b.title ? -1 : 1));
  const tasks = of("task");
  return [...(tasks.length > 1 ? tasks : []), ...of("signal")]; // the program alone shows the same as the moves
}

export function lanesOf(run: Run | null, state: State): Lane[] {
  if (!run) return [{ kind: "robot", name: "", title: "", height: HEIGHTS.robot, blocks: [] }];
  const lanes = [...robotLanes(run), ...stretchLanes(run, run.textVersion === state.textVersion ? state.text.split("\n") : [])];
  return lanes.length ? lanes : [{ kind: "robot", name: "", title: "", height: HEIGHTS.robot, blocks: [] }];
}

// Space on the right: plots below the bar with two units have an axis there.
export function rightMargin(state: State): number {
  const run = shownRun(state);
  if (!state.plotsBelow || !run) return RIGHT;
  const plots = run.elements.map((element, i) => (element.kind === "plot" ? new Set(seriesOf(element, i, run).columns.map((c) => c.unit)).size : 0));
  return Math.max(...plots, 0) > 1 ? LEFT : RIGHT;
}

// The duration of the bar: that of the shown run, or of one beside it.
export function spanOf(state: State): number {
  const ghost = state.ghost === null ? undefined : state.runs.get(state.ghost);
  return Math.max(shownRun(state)?.tEnd ?? 0, ghost?.tEnd ?? 0) || 1;
}
