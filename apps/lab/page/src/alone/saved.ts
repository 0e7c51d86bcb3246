// An exported laboratory, as it is stored in a page: docs/lab-protocol.md, "exported".
import type { Incoming, Outgoing, RunMessage } from "../protocol/messages.ts";

export interface SavedRun {
  run: number;
  label: string;
  text: string;
  inputs: Record<string, unknown>[];
  state: string;
  hash: string;
}
export interface Saved {
  format: 1;
  version: string;
  robot: string;
  world: { name: string; text: string } | null;
  file: string;
  text: string;
  demo: boolean;
  files: Record<string, string>;
  runs: SavedRun[];
  shown: number;
}

// The laboratory into which a saved one is loaded; it already has the text of the first run.
export interface Reopened {
  send(message: Outgoing): void;
  // Lets the laboratory work until it is idle, and returns its messages.
  settle(): Promise<Incoming[]>;
}

// The text with which the laboratory begins.
export function firstText(saved: Saved): string {
  return saved.runs[0]?.text ?? saved.text;
}

interface Known {
  run: number;
  text: string;
  inputs: Record<string, unknown>[];
}

// Whether the inputs of `known` are the first inputs of `run`.
function isBeginning(known: Known, run: SavedRun): boolean {
  return known.text === run.text && known.inputs.length <= run.inputs.length && known.inputs.every((input, i) => JSON.stringify(input) === JSON.stringify(run.inputs[i]));
}

// Repeats the saved runs, each from the known run that is most similar to it, and shows the one that was shown. Returns the labels of the
// runs whose result differs from the saved one.
export async function reopen(saved: Saved, laboratory: Reopened): Promise<string[]> {
  const hashes = new Map<number, string>();
  let shown = 0;
  let version = 0;
  const say = async (message: Outgoing) => {
    laboratory.send(message);
    for (const told of await laboratory.settle()) {
      if (told.type === "shown") shown = told.run;
      if (told.type === "run") hashes.set(told.run, (told as RunMessage).hash ?? "");
    }
  };
  await say({ type: "hello", protocol: 1 });
  const others: string[] = [];
  const known: Known[] = [{ run: shown, text: firstText(saved), inputs: [] }];
  const numbers = new Map<number, number>();
  for (const run of saved.runs) {
    let base = known.filter((each) => isBeginning(each, run)).reduce<Known | undefined>((best, each) => (!best || each.inputs.length > best.inputs.length ? each : best), undefined);
    if (!base) {
      await say({ type: "text", text: run.text, version: ++version });
      known.push((base = { run: shown, text: run.text, inputs: [] }));
    } else if (base.run !== shown) await say({ type: "show", run: base.run });
    for (const input of run.inputs.slice(base.inputs.length)) await say({ type: "input", ...input } as Outgoing);
    known.push({ run: shown, text: run.text, inputs: run.inputs });
    numbers.set(run.run, shown);
    if (run.hash && run.hash !== hashes.get(shown)) others.push(run.label);
  }
  if (saved.text !== (saved.runs.at(-1)?.text ?? firstText(saved))) await say({ type: "text", text: saved.text, version: ++version });
  const wanted = numbers.get(saved.shown);
  if (wanted !== undefined && wanted !== shown) await say({ type: "show", run: wanted });
  return others;
}
