// The interface between an element of a laboratory and the panel that shows it.
import type { ElementInfo } from "../protocol/messages.ts";
import type { Intents } from "../store/intents.ts";
import type { Run } from "../store/run.ts";
import type { State } from "../store/state.ts";

export interface Place {
  element: ElementInfo;
  index: number; // in the description; blocks of rows contain it
  intents: Intents;
}

export interface ElementView {
  readonly root: HTMLElement;
  // Shows the element at the shown instant.
  update(run: Run, state: State, allowed: boolean): void;
  dispose?(): void;
}
