// Pictures of elements at the shown instant: the laboratory renders them on request, and only the page stores them, the last one of each
// element.
import type { PictureAnswer } from "../protocol/pictures.ts";
import type { Run, SeenPicture } from "./run.ts";
import { shownRun, type State } from "./state.ts";
import type { Store } from "./store.ts";

export type AskPicture = (element: string, run: number, t: number) => Promise<PictureAnswer>;

const keyOf = (run: Run, t: number) => `${run.id} ${run.inputs.length} ${t}`;

export class Pictures {
  private readonly store: Store;
  private readonly ask: AskPicture;
  private readonly wanted = new Map<string, number>(); // elements, and the number of views that show them
  private asking = false;
  private turn: string[] = []; // in the order of their last request

  constructor(store: Store, ask: AskPicture) {
    this.store = store;
    this.ask = ask;
    store.watch((s) => [s.shown, s.t, s.connection, shownRun(s)?.inputs, shownRun(s)?.described], () => void this.next());
  }

  // Shows the pictures of an element from now on, until the returned function is called.
  want(element: string): () => void {
    this.wanted.set(element, (this.wanted.get(element) ?? 0) + 1);
    if (!this.turn.includes(element)) this.turn.unshift(element);
    void this.next();
    return () => {
      const left = (this.wanted.get(element) ?? 1) - 1;
      if (left > 0) this.wanted.set(element, left);
      else {
        this.wanted.delete(element);
        this.turn = this.turn.filter((name) => name !== element);
      }
    };
  }

  // The element whose picture is from another instant and that was requested least recently.
  private due(state: State, run: Run): string | undefined {
    const now = keyOf(run, state.t);
    return this.turn.find((name) => run.elements.some((element) => element.name === name) && run.pictures.get(name)?.key !== now);
  }

  // One request at a time: the instant may change before the answer, and only the newest counts.
  private async next(): Promise<void> {
    const { state } = this.store;
    const run = shownRun(state);
    if (this.asking || !run?.described || state.connection !== "open") return;
    const element = this.due(state, run);
    if (element === undefined) return;
    this.asking = true;
    this.turn = [...this.turn.filter((name) => name !== element), element];
    const { t } = state;
    const key = keyOf(run, t);
    let seen: SeenPicture;
    try {
      seen = { key, t, picture: await this.ask(element, run.id, t), fault: "" };
    } catch (error) {
      seen = { key, t, picture: null, fault: error instanceof Error ? error.message : String(error) };
    }
    this.asking = false;
    this.store.change(() => {
      run.pictures = new Map(run.pictures).set(element, seen);
    });
    void this.next();
  }
}
