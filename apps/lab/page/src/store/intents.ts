// Actions of the user: changes of the state and messages to the laboratory.
import { Refused, type Connection } from "../home/connection.ts";
import type { Incoming, IncomingOf, Input, Pose, StepHow } from "../protocol/messages.ts";
import { toBase85 } from "../protocol/base85.ts";
import { fileName } from "./document.ts";
import { Pictures } from "./pictures.ts";
import type { Store } from "./store.ts";
import { inControl, shownRun, type State } from "./state.ts";

const PAUSE_IN_TYPING = 150; // ms without a key after which the text runs
const SHORT_RUN = 50; // ms: after such a run the first key runs at once
const CHECK_EVERY = 30; // ms, least time between two checks of a text that is being typed
const WHILE_PLAYING = 200; // ms between questions for variables
const WHILE_LOOKING = 60; // the same, while clearances are shown
const PIECE = 480_000; // bytes of a file in one message
const LONGEST_WAIT = 2000; // ms to wait for an answer to an input, before the next one is sent

export class Intents {
  readonly store: Store;
  private readonly connection: Connection;
  readonly live: boolean;
  readonly pictures: Pictures;
  private typing: ReturnType<typeof setTimeout> | undefined;
  private checking: ReturnType<typeof setTimeout> | undefined;
  private sentText: string | null = null;
  private checkedText: string | null = null;
  private checkedAt = -Infinity;
  private awaited: number | null = null; // the version of the text whose diagnostics have not arrived yet
  private wantsCheck = false;
  private sentAt = 0;
  private tookRun = Infinity; // ms from the text that was sent last to the end of its run
  private change = 0; // number of the change that the text belongs to
  private pulledPlace: number | null = null;
  private waitsForRun = false;
  private asking = false;
  private steps = 0;
  private askedFor = "";
  private moved = false; // the user went to an instant for which the laboratory has not been asked yet
  private visits = 0; // number of such visits
  private askedAt = 0;
  private input: { element: string; what: Input } | null = null;
  private givingInput = false;
  private lastInputs = "";
  private pulling = false;
  // Whether data of the instant is drawn while playing.
  looksClosely = false;
  private pullGoal: { robot: number; pose: Pose } | null = null;

  constructor(store: Store, connection: Connection, live: boolean) {
    this.store = store;
    this.connection = connection;
    this.live = live;
    this.pictures = new Pictures(store, (element, run, t) => (live ? connection.picture(element, run, t) : Promise.reject(new Error("A recording has no pictures of cameras."))));
  }

  get state(): State {
    return this.store.state;
  }

  // A message has arrived: actions that waited for it continue.
  heard(message: Incoming): void {
    if (message.type === "welcome") {
      this.sentText = message.text;
      this.awaited = null;
      this.waitsForRun = false;
      this.givingInput = false;
    }
    if (message.type === "text") this.sentText = this.checkedText = message.text;
    if (message.type === "run" && message.state !== "running" && message.text_version === this.state.textVersion && this.waitsForRun) this.tookRun = performance.now() - this.sentAt;
    const ended = (message.type === "run" && message.state !== "running") || (message.type === "diagnostics" && !message.runs);
    // A run that continues with an input, of whichever page, may have other values at the same instant.
    if (message.type === "run" && message.run === this.state.shown && message.state !== "running") {
      const key = `${message.run} ${message.inputs?.length ?? 0}`;
      if (key !== this.lastInputs) {
        this.lastInputs = key;
        this.askedFor = "";
        this.store.change((s) => (s.instant = null));
      }
    }
    if (message.type === "control" && this.state.text !== this.sentText) this.sendText();
    if (message.type === "diagnostics" && message.text_version >= (this.awaited ?? Infinity)) {
      this.awaited = null;
      if (this.wantsCheck) this.checkSoon();
    }
    if (ended) {
      this.waitsForRun = false;
      if (this.pulledText) this.sendText();
    }
    this.askForInstant();
  }

  private get pulledText(): boolean {
    return this.state.ghost !== null && this.state.text !== this.sentText;
  }

  // The text was typed: it is checked, and runs after a pause, or at once if `now`.
  typeText(text: string, now = false): void {
    this.store.change((s) => {
      s.text = text;
      s.followed = 0;
      s.ghost = null;
      s.nearest = null;
    });
    const isFirst = this.typing === undefined;
    this.endTyping();
    if (isFirst || now) this.change++;
    this.pulledPlace = null;
    if (now) {
      this.sendText();
      return;
    }
    const runsNow = isFirst && !this.waitsForRun && this.tookRun < SHORT_RUN;
    this.typing = setTimeout(() => {
      this.typing = undefined;
      this.sendText();
    }, PAUSE_IN_TYPING);
    if (runsNow) return this.sendText(true, true);
    this.wantsCheck = true;
    this.checkSoon();
  }

  // The first key is checked at once. Of keys soon after it only the last is checked: one check at a time, after the answer to the one
  // before.
  private checkSoon(): void {
    if (this.checking !== undefined || this.awaited !== null) return;
    const wait = this.checkedAt + CHECK_EVERY - performance.now();
    if (wait <= 0) return this.sendText(false);
    this.checking = setTimeout(() => {
      this.checking = undefined;
      if (this.wantsCheck) this.checkSoon();
    }, wait);
  }

  private endTyping(): void {
    clearTimeout(this.typing);
    this.typing = undefined;
  }

  // A number in the text is dragged: the path before the change stays visible, and as many texts run as possible.
  // place  of the number: the runs of one number are one entry in the list.
  pullText(text: string, place: number): void {
    if (place !== this.pulledPlace) this.change++;
    this.pulledPlace = place;
    this.store.change((s) => {
      s.text = text;
      s.followed = 0;
      s.ghost ??= s.shown;
      s.nearest = null;
    });
    this.endTyping();
    if (!this.waitsForRun) this.sendText();
  }

  endPull(): void {
    if (this.state.text !== this.sentText) this.sendText();
  }

  // The program from its start, without the inputs of the shown run.
  runAgain(): void {
    this.change++;
    this.sentText = null;
    this.sendText();
  }

  clearGhost(): void {
    this.store.change((s) => (s.ghost = null));
  }

  // Sends the text of the editor to the laboratory; without `run` it is only checked.
  sendText(run = true, typesOn = false): void {
    if (run && !typesOn) this.endTyping();
    this.wantsCheck = false;
    if (!this.live || !inControl(this.state) || this.state.text === (run ? this.sentText : this.checkedText)) return;
    if (!run && this.state.text === this.sentText) return;
    this.checkedText = this.state.text;
    if (run) this.sentText = this.state.text;
    if (run) this.sentAt = performance.now();
    this.waitsForRun ||= run;
    const version = this.state.textVersion + 1;
    this.awaited = version;
    this.checkedAt = performance.now();
    this.store.change((s) => (s.textVersion = version));
    this.connection.send({ type: "text", text: this.state.text, version, ...(run ? { change: this.changeNumber() } : { run: false }) });
  }

  // Other pages count their own changes.
  private changeNumber(): number {
    return 10_000 * (this.state.welcome?.page ?? 0) + (this.change % 10_000);
  }

  // The name of the person at this page, as others see it.
  tellName(name: string): void {
    if (this.live) this.connection.send({ type: "name", name });
  }

  // Writes the program into its file. If another program has changed the file, this is done only with `replaces`; otherwise the page asks.
  async saveText(replaces = false): Promise<void> {
    this.sendText();
    try {
      await this.connection.ask<"saved">({ type: "save", replaces });
      this.say(`${fileName(this.state)} is saved.`);
    } catch (error) {
      if (!(error instanceof Refused)) return;
      if (error.answer.reason === "changed") this.store.change((s) => (s.postponed = null));
      else this.say(error.message);
    }
  }

  // The data of an instant, without showing that instant.
  look(run: number, t: number): Promise<IncomingOf<"instant">> {
    return this.connection.ask<"instant">({ type: "goto", t, run, looks: true }, true);
  }

  ask: Connection["ask"] = (message) => {
    if (!this.live) return Promise.reject(new Error("This is a recording."));
    this.sendText(false);
    return this.connection.ask(message);
  };

  // The bytes of a file that a description names.
  file(name: string): Promise<ArrayBuffer> {
    return this.connection.file(name);
  }

  // Saves a file beside the program; returns the name of the mesh there, empty for a companion of a mesh that comes later.
  async keepFile(name: string, bytes: Uint8Array): Promise<{ name: string; size: [number, number, number] }> {
    let kept: { name: string; size: [number, number, number] } = { name: "", size: [0, 0, 0] };
    for (let at = 0; at === 0 || at < bytes.length; at += PIECE) {
      const piece = toBase85(bytes.subarray(at, at + PIECE));
      kept = (await this.connection.ask<"kept">({ type: "keep", name, base85: piece, first: at === 0, last: at + PIECE >= bytes.length }));
    }
    return kept;
  }

  goTo(t: number): void {
    this.moved = true;
    this.visits++;
    this.store.change((s) => {
      s.t = this.placeFor(t);
      s.followed++;
      s.nearest = null;
    });
    this.askForInstant();
  }

  play(on = !this.state.playing): void {
    const run = shownRun(this.state);
    if (on && (!run || run.tEnd <= 0)) return;
    this.store.change((s) => {
      s.playing = on;
      if (on) s.followed++;
      if (on && s.t >= (run?.tEnd ?? 0) - 1e-9) s.t = 0;
      if (!on) s.t = this.placeFor(s.t);
    });
    this.askForInstant();
  }

  // Advances the shown instant while playing, by `seconds` of the wall clock.
  advance(seconds: number): void {
    const { playing, t, speed } = this.state;
    const run = shownRun(this.state);
    if (!playing || !run) return;
    const next = Math.min(run.tEnd, t + speed * seconds);
    this.store.change((s) => {
      s.t = next;
      if (next >= run.tEnd) s.playing = false;
    });
    this.askForInstant();
  }

  // Goes to the next or previous instant at which a move begins or ends.
  stepMove(direction: 1 | -1): void {
    const stops = shownRun(this.state)?.stops() ?? [];
    const t = this.state.t;
    const next = direction > 0 ? stops.find((s) => s > t + 1e-9) : stops.findLast((s) => s < t - 1e-9);
    if (next !== undefined) this.goTo(next);
  }

  async step(how: StepHow): Promise<void> {
    this.store.change((s) => {
      s.playing = false;
      s.followed++;
    });
    // A step begins at the laboratory's cursor: first the cursor goes to the shown instant, if it is elsewhere.
    if (this.steps === 0 ? this.isElsewhere() : this.moved) void this.goThere();
    this.steps++; // until it is answered, no data of the old instant is requested
    const { visits } = this;
    const instant = await this.answered<"instant">({ type: "step", how });
    this.steps--;
    if (instant && visits === this.visits) {
      this.store.change((s) => (s.t = instant.t));
      this.askedFor = `${instant.run} ${instant.t}`;
    }
    this.askForInstant();
  }

  toggleBreakpoint(line: number): void {
    const lines = this.state.breakpoints;
    const next = lines.includes(line) ? lines.filter((l) => l !== line) : [...lines, line].sort((a, b) => a - b);
    if (!this.live) return;
    this.store.change((s) => (s.breakpoints = next));
    this.connection.send({ type: "breakpoints", lines: next });
  }

  // A slider was moved or a button pressed: while the laboratory is busy, only the last input is kept. False: it was refused.
  async giveInput(element: string, what: Input): Promise<boolean> {
    this.input = { element, what };
    if (this.givingInput || !this.live) return true;
    let taken = true;
    this.givingInput = true;
    while (this.input) {
      const { element: name, what: next } = this.input;
      this.input = null;
      const run = shownRun(this.state);
      const t = run && this.state.t < run.tEnd - 1e-9 ? { t: this.state.t } : {};
      try {
        await Promise.race([this.connection.ask({ type: "input", ...t, ...next }), after(LONGEST_WAIT)]);
        this.refuse(name, "");
        taken = true;
        this.showNearest(null);
        this.askedFor = ""; // the same instant of the same run has other values now
        this.store.change((s) => (s.instant = null));
        this.askForInstant();
      } catch (error) {
        const reason = error instanceof Error ? error.message : String(error);
        this.refuse(name, reason);
        taken = false;
        const answer = error instanceof Refused ? error.answer : null;
        this.showNearest(answer?.nearest ? { ...answer.nearest, robot: answer.robot ?? 0 } : null);
      }
    }
    this.givingInput = false;
    return taken;
  }

  refuse(element: string, reason: string): void {
    if ((this.state.refusals.get(element) ?? "") === reason) return;
    this.store.change((s) => {
      s.refusals = new Map(s.refusals);
      if (reason) s.refusals.set(element, reason);
      else s.refusals.delete(element);
    });
  }

  private showNearest(nearest: State["nearest"]): void {
    if (this.state.nearest !== nearest) this.store.change((s) => (s.nearest = nearest));
  }

  // The tool of a robot is dragged to `pose`: gets the joint values, or the reason why there are none.
  async pullHand(robot: number, pose: Pose): Promise<void> {
    this.pullGoal = { robot, pose };
    if (this.pulling || !this.live) return;
    this.pulling = true;
    while (this.pullGoal) {
      const goal = this.pullGoal;
      this.pullGoal = null;
      const info = shownRun(this.state)?.robots[goal.robot];
      if (!info) break;
      const seed = this.state.pull?.q ?? shownRun(this.state)?.qAt(goal.robot, this.state.t);
      const answer = await this.answered<"inverse">({ type: "inverse", robot: info.name, pose: goal.pose, ...(seed ? { seed } : {}) });
      if (!answer) continue;
      const q = answer.ok ? (answer.q ?? null) : (answer.nearest?.q ?? null);
      this.store.change((s) => (s.pull = { robot: goal.robot, q, nearest: answer.nearest ?? null, reason: answer.ok ? "" : (answer.reason ?? "") }));
    }
    this.pulling = false;
  }

  endPullHand(): void {
    this.store.change((s) => (s.pull = null));
  }

  show(run: number): void {
    if (this.state.runs.get(run)?.described && !inControl(this.state)) this.store.change((s) => (s.shown = run));
    else if (this.live) this.connection.send({ type: "show", run });
  }

  async compare(run: number | null): Promise<void> {
    const shown = this.state.shown;
    this.store.change((s) => {
      s.comparison = null;
      s.ghost = run;
    });
    if (run === null || shown === null || !this.live) return;
    if (!this.state.runs.get(run)?.described) this.connection.send({ type: "fetch", run });
    await this.answered<"comparison">({ type: "compare", run: shown, with: run });
  }

  takeControl(): void {
    this.connection.send({ type: "take" });
  }

  giveControl(to?: number): void {
    this.connection.send(to === undefined ? { type: "give" } : { type: "give", to });
  }

  say(message: string): void {
    this.store.change((s) => (s.message = message));
  }

  // The answer, or null after the reason was shown.
  async answered<T extends Incoming["type"]>(message: Parameters<Connection["ask"]>[0]) {
    try {
      return await this.ask<T>(message);
    } catch (error) {
      if (error instanceof Refused) this.say(error.message);
      return null;
    }
  }

  // A recording answers no questions, but contains data of some instants.
  private showLook(): void {
    const run = shownRun(this.state);
    const look = run?.lookAt(this.state.t);
    if (!run || !look || (run.values === look.values && this.state.instant?.t === look.t)) return;
    this.store.change((s) => {
      s.instant = { ...look.instant, type: "instant", run: run.id, t: look.t } as IncomingOf<"instant">;
      run.values = look.values;
      run.valuesAt = look.t;
    });
  }

  // The instant of a recording with data that is nearest to t.
  private placeFor(t: number): number {
    const run = shownRun(this.state);
    const inside = Math.min(Math.max(0, t), run?.tEnd ?? 0);
    const [before, behind] = [run?.lookAt(inside), run?.looks.find((look) => look.t > inside)];
    if (this.live || !run || !before) return inside;
    return behind && behind.t - inside < inside - before.t ? behind.t : Math.min(before.t, run.tEnd);
  }

  // Requests variables and values of elements at the shown instant: one question at a time.
  private askForInstant(): void {
    const { shown, t, playing, connection, instant } = this.state;
    if (!this.live) this.showLook();
    if (!this.live || this.asking || this.steps > 0 || shown === null || connection !== "open" || !this.isElsewhere()) return;
    if (playing && Date.now() - this.askedAt < (this.looksClosely ? WHILE_LOOKING : WHILE_PLAYING)) return;
    // Several statements may be at one instant: going to it means after all of them.
    if (!this.moved && instant && instant.run === shown && Math.abs(instant.t - t) < 1e-9) return;
    this.asking = true;
    void this.goThere().finally(() => {
      this.asking = false;
      this.askForInstant();
    });
  }

  // Whether the laboratory has not been asked about the shown instant.
  private isElsewhere(): boolean {
    return this.moved || `${this.state.shown} ${this.state.t}` !== this.askedFor;
  }

  private async goThere(): Promise<void> {
    const { shown, t } = this.state;
    if (shown === null) return;
    this.moved = false;
    this.askedFor = `${shown} ${t}`;
    this.askedAt = Date.now();
    await this.connection.ask({ type: "goto", t, run: shown }).catch(() => {});
  }
}

function after(ms: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, ms));
}
