// The state of the program in a few words: red for mistakes and failures, amber for advice, green for a run without any.
import { adviceOfRun, comingRun, isStale, shownRun, type State } from "../store/state.ts";
import type { Run } from "../store/run.ts";

export type StatusKind = "quiet" | "error" | "advice" | "good";

const COLLISION = "W0711";

const counted = (n: number, one: string, many = `${one}s`) => `${n} ${n === 1 ? one : many}`;
const progressOf = (run: Run) => `${run.tEnd.toFixed(1)} s${run.taken ? `, ${counted(run.taken, "picture")}` : ""}`;

// "2 collisions, advice: 1"; each collision counts, other advice once for each statement. Empty: there is none.
export function adviceText(state: State): string {
  const all = adviceOfRun(state);
  const collisions = all.filter((each) => each.code === COLLISION).reduce((sum, each) => sum + each.times, 0);
  const others = all.filter((each) => each.code !== COLLISION).length + state.diagnostics.filter((each) => each.severity === "advice").length;
  return [collisions ? counted(collisions, "collision") : "", others ? `advice: ${others}` : ""].filter(Boolean).join(", ");
}

export function statusOf(state: State, live: boolean): [string, StatusKind] {
  const run = shownRun(state);
  const errors = state.diagnostics.filter((d) => d.severity === "error").length;
  if (state.connection === "connecting") return ["connecting …", "quiet"];
  if (state.connection === "lost") return ["connection lost", "error"];
  if (isStale(state)) return [`${counted(errors, "mistake")}${run ? ": the last good run is shown" : ""}`, "error"];
  if (!run) return ["", "quiet"];
  const coming = comingRun(state);
  if (coming?.taken) return [`running anew, ${progressOf(coming)}`, "quiet"];
  const line = run.statements.at(-1)?.[1];
  const advice = adviceText(state);
  if (run.state === "running") return [`running${line ? ` at line ${line}` : ""}, ${progressOf(run)}${advice ? `, ${advice}` : ""}`, advice ? "advice" : "quiet"];
  if (run.state === "failed") return [`failed at ${run.error?.t.toFixed(2) ?? run.tEnd.toFixed(2)} s`, "error"];
  if (run.state === "stopped") return [`${line ? `still running at line ${line}, ` : ""}stopped at ${run.tEnd.toFixed(2)} s`, "advice"];
  const number = run.moves.filter((move) => move.text).length; // a hand that was dragged is no move of the program
  const moves = number ? `${counted(number, "move")}, ` : "";
  return [`${live ? "" : "recording, "}${moves}${run.tEnd.toFixed(2)} s${advice ? `, ${advice}` : ""}`, advice ? "advice" : "good"];
}
