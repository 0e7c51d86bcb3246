// Two buttons beside the inputs of a laboratory: the program from its start with the values of the fields, and without any input.
import { el } from "../dom/dom.ts";
import type { ElementInfo, Value } from "../protocol/messages.ts";
import type { Intents } from "../store/intents.ts";
import type { Run } from "../store/run.ts";

export interface RunAgain {
  root: HTMLElement;
  update(run: Run, allowed: boolean): void;
}

// The fields with values that they do not have at the start of the run.
export function changedFields(run: Run): [ElementInfo, Value][] {
  return run.elements.flatMap((element): [ElementInfo, Value][] => {
    const value = element.kind === "field" ? run.values[element.name]?.value : undefined;
    return value === undefined || value === null || value === element.value ? [] : [[element, value]];
  });
}

// write  writes the values of fields into the program and runs it.
export function runAgain(intents: Intents, write: (fields: [ElementInfo, Value][]) => void): RunAgain {
  let fields: [ElementInfo, Value][] = [];
  const values = el("button", { title: "Write the values of the fields into the program, and run it from its start", onclick: () => write(fields) }, "Run with these values");
  const reset = el("button", { title: "Run the program from its start, as it is written", onclick: () => intents.runAgain() }, "Reset");
  const root = el("div", { class: "element run-again" }, values, reset);
  return {
    root,
    update(run, allowed) {
      fields = changedFields(run);
      values.hidden = !run.elements.some((element) => element.kind === "field");
      values.disabled = !allowed || !fields.length;
      reset.disabled = !allowed || !run.inputs.length;
      root.hidden = !intents.live;
    },
  };
}
