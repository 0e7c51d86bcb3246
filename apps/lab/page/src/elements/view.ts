// What every element of a laboratory is for the panel that shows it.
import type { ElementInfo } from "../protocol/messages.ts";
import type { Intents } from "../store/intents.ts";
import type { Run } from "../store/run.ts";
import type { State } from "../store/state.ts";

export interface Place {
  element: ElementInfo;
  index: number; // in the description: rows of values name it
  intents: Intents;
}

export interface ElementView {
  readonly root: HTMLElement;
  // Shows the element as it is at the instant that is looked at.
  update(run: Run, state: State, allowed: boolean): void;
  dispose?(): void;
}
