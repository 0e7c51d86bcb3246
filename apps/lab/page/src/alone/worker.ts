// The worker of a page without a server: the laboratory as WebAssembly (apps/lab/worker/worker.cpp). The script of the engine, which
// defines createArmlet, precedes this one.
import type { Incoming, Outgoing } from "../protocol/messages.ts";
import { unpacked } from "../protocol/packed.ts";
import { firstText, reopen, type Saved } from "./saved.ts";

interface Engine {
  HEAPU8: Uint8Array;
  _malloc(size: number): number;
  _free(address: number): void;
  _armlet_lab_open(bytes: number, size: number): number;
  _armlet_lab_receive(bytes: number, size: number): number;
  _armlet_lab_advance(): number;
  _armlet_lab_take(): number;
  _armlet_lab_bytes(): number;
  _armlet_lab_size(): number;
  _armlet_lab_fault(): number;
  cwrap(name: string, result: string, parameters: string[]): (...given: (string | number)[]) => number;
}
type Instantiate = (imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void) => object;
declare const createArmlet: (options: { instantiateWasm: Instantiate }) => Promise<Engine>;

const scope = globalThis as unknown as {
  onmessage: ((event: MessageEvent) => void) | null;
  postMessage(message: unknown, transfer?: Transferable[]): void;
};
const WORK = 12; // ms between two checks for messages of the page
const WARM = 600; // ms of programs that run only to make the browser compile the engine with optimisations

class Laboratory {
  private readonly engine: Engine;
  constructor(engine: Engine) {
    this.engine = engine;
  }

  private give(text: string, take: (bytes: number, size: number) => number): void {
    const bytes = new TextEncoder().encode(text);
    const address = this.engine._malloc(bytes.length || 1);
    this.engine.HEAPU8.set(bytes, address);
    const answer = take(address, bytes.length);
    this.engine._free(address);
    if (answer < 0) throw new Error(this.fault());
  }
  private fault(): string {
    const { HEAPU8 } = this.engine;
    const begin = this.engine._armlet_lab_fault();
    return new TextDecoder().decode(HEAPU8.slice(begin, HEAPU8.indexOf(0, begin)));
  }

  open(saved: Saved): void {
    this.give(JSON.stringify({ ...saved, text: firstText(saved), runs: [] }), this.engine._armlet_lab_open);
  }
  receive(message: string): void {
    this.give(message, this.engine._armlet_lab_receive);
  }
  // Whether there is more to do.
  advance(): boolean {
    const answer = this.engine._armlet_lab_advance();
    if (answer < 0) throw new Error(this.fault());
    return answer === 1;
  }
  // The next message for the page.
  take(): string | ArrayBuffer | null {
    const kind = this.engine._armlet_lab_take();
    if (kind < 0) throw new Error(this.fault());
    if (kind === 0) return null;
    const begin = this.engine._armlet_lab_bytes();
    const bytes = this.engine.HEAPU8.slice(begin, begin + this.engine._armlet_lab_size());
    return kind === 1 ? new TextDecoder().decode(bytes) : bytes.buffer;
  }
}

// Runs a program repeatedly without showing it: browsers optimise code that runs often, between two calls.
class WarmUp {
  private readonly engine: Engine;
  private readonly text: string;
  private session = -1;
  private left = WARM;
  constructor(engine: Engine, text: string) {
    this.engine = engine;
    this.text = text;
  }

  // Works for a few milliseconds. Returns whether there is more to do.
  advance(): boolean {
    if (this.left <= 0) return false;
    const begun = performance.now();
    const call = (name: string, parameters: string[], ...given: (string | number)[]) => this.engine.cwrap(`armlet_${name}`, "number", parameters)(...given);
    if (this.session < 0) {
      this.session = call("open", ["string", "string", "number", "number"], "scara", "", 1e7, 0);
      if (this.session < 0 || call("compile", ["number", "string", "string"], this.session, this.text, "program.rbt") !== 0) this.left = 0;
    } else if (call("run", ["number", "number", "number"], this.session, 0.25, 20_000) !== 2) this.close(call);
    this.left -= performance.now() - begun;
    if (this.left <= 0) this.close(call);
    return this.left > 0;
  }

  private close(call: (name: string, parameters: string[], ...given: number[]) => number): void {
    if (this.session >= 0) call("close", ["number"], this.session);
    this.session = -1;
  }
}

async function load(engine: string): Promise<Engine> {
  const module = new Response(unpacked(engine), { headers: { "Content-Type": "application/wasm" } });
  return new Promise((resolve, reject) => {
    createArmlet({
      instantiateWasm: (imports, done) => {
        WebAssembly.instantiateStreaming(module, imports).then((ready) => done(ready.instance, ready.module), reject);
        return {};
      },
    }).then(resolve, reject);
  });
}

async function start(parts: Record<string, string>): Promise<void> {
  const saved = JSON.parse(parts["armlet-laboratory"]!) as Saved;
  const engine = await load(parts["armlet-engine"]!);
  const laboratory = new Laboratory(engine);
  laboratory.open(saved);
  const others = await reopen(saved, {
    send: (message: Outgoing) => laboratory.receive(JSON.stringify(message)),
    settle: async () => {
      while (laboratory.advance());
      const told: Incoming[] = [];
      for (let message = laboratory.take(); message !== null; message = laboratory.take()) if (typeof message === "string") told.push(JSON.parse(message) as Incoming);
      return told;
    },
  });

  const warmUp = new WarmUp(engine, saved.text);
  const channel = new MessageChannel();
  let awaited = false;
  const goOn = () => {
    if (!awaited) channel.port2.postMessage(null);
    awaited = true;
  };
  const deliver = () => {
    for (let message = laboratory.take(); message !== null; message = laboratory.take()) {
      if (typeof message === "string") scope.postMessage(message);
      else scope.postMessage(message, [message]);
    }
  };
  // Messages of the page arrive between two of these.
  channel.port1.onmessage = () => {
    awaited = false;
    const until = performance.now() + WORK;
    let more = laboratory.advance();
    while (more && performance.now() < until) more = laboratory.advance();
    deliver();
    if (more || warmUp.advance()) goOn();
  };
  scope.onmessage = (event) => {
    laboratory.receive(event.data as string);
    deliver();
    goOn();
    if (!others.length) return;
    const runs = others.splice(0).join("; ");
    scope.postMessage(JSON.stringify({ type: "error", reason: "other", message: `This engine computes otherwise than the one that saved the laboratory: ${runs}. What is shown is what it computes here.` }));
  };
  scope.postMessage("ready");
}

// The first message brings the parts of the page.
scope.onmessage = (event) => void start(event.data as Record<string, string>).catch((error: unknown) => setTimeout(() => {
  throw error;
}));
