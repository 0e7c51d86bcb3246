// The only object that changes the state, and the functions called after changes.
import { initialState, type State } from "./state.ts";

export type Select = (state: State) => readonly unknown[];

interface Watcher {
  select: Select;
  last: readonly unknown[] | null;
  render: (state: State) => void;
}

export class Store {
  readonly state: State = initialState();
  private watchers: Watcher[] = [];
  private scheduled = false;
  private readonly schedule: (work: () => void) => void;

  // `schedule` calls back soon: at the next frame in a browser, at once in tests.
  constructor(schedule: (work: () => void) => void) {
    this.schedule = schedule;
  }

  change(edit: (state: State) => void): void {
    edit(this.state);
    if (this.scheduled) return;
    this.scheduled = true;
    this.schedule(() => {
      this.scheduled = false;
      this.render();
    });
  }

  // Calls `render` after changes of any value that `select` returns, and once at the start.
  watch(select: Select, render: (state: State) => void): void {
    this.watchers.push({ select, last: null, render });
    this.change(() => {});
  }

  private render(): void {
    for (const watcher of this.watchers) {
      const now = watcher.select(this.state);
      const last = watcher.last;
      if (last && now.length === last.length && now.every((value, i) => Object.is(value, last[i]))) continue;
      watcher.last = now;
      watcher.render(this.state);
    }
  }
}
