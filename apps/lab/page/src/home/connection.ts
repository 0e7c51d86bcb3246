// The connection to a laboratory, independent of the transport: numbers of messages, and answers to questions.
import type { Incoming, IncomingOf, Outgoing } from "../protocol/messages.ts";
import { keepKey, keptKey } from "./key.ts";
import { readPicture, type PictureAnswer } from "../protocol/pictures.ts";
import { readFile, readRows, type RowBlock } from "../protocol/rows.ts";

// A transport passes received messages to its listener.
export interface Listener {
  opened(): void;
  closed(note: string): void;
  message(data: string | ArrayBuffer): void;
}
export interface Transport {
  send(text: string): void;
  // The bytes of a file that a description names. If missing, the laboratory is asked for them.
  file?(name: string): Promise<ArrayBuffer>;
}
export type Carry = (listener: Listener) => Transport;

export interface Events {
  opened(): void;
  lost(note: string): void;
  message(message: Incoming): void;
  rows(block: RowBlock): void;
}

// The laboratory refused a request: `answer` has the reason.
export class Refused extends Error {
  readonly answer: IncomingOf<"error">;
  constructor(answer: IncomingOf<"error">) {
    super(answer.message);
    this.answer = answer;
  }
}

interface Waiting {
  isQuiet?: boolean;
  resolve(answer: Incoming): void;
  reject(reason: Error): void;
  take?(bytes: ArrayBuffer): void;
  takePicture?(picture: PictureAnswer): void;
}

export class Connection {
  private readonly transport: Transport;
  private readonly waiting = new Map<number, Waiting>();
  private seq = 0;

  constructor(carry: Carry, events: Events) {
    this.transport = carry({
      opened: () => {
        const key = keptKey();
        this.send({ type: "hello", protocol: 1, ...(key ? { key } : {}) });
        events.opened();
      },
      closed: (note) => {
        for (const question of this.waiting.values()) question.reject(new Error("The connection was lost."));
        this.waiting.clear();
        events.lost(note);
      },
      message: (data) => {
        if (typeof data === "string") this.take(JSON.parse(data) as Incoming, events);
        else {
          const file = readFile(data);
          const seen = file ? null : readPicture(data);
          const block = file || seen ? null : readRows(data);
          if (file) this.takeFile(file.to, file.bytes);
          if (seen) this.takePicture(seen.to, seen.picture);
          if (block) events.rows(block);
        }
      },
    });
  }

  // Returns the number of the message.
  send(message: Outgoing): number {
    const seq = ++this.seq;
    this.transport.send(JSON.stringify({ ...message, seq }));
    return seq;
  }

  // The answer; throws Refused if the laboratory answers with an error. A quiet answer is reported only to the caller.
  ask<T extends Incoming["type"]>(message: Outgoing, isQuiet = false): Promise<IncomingOf<T>> {
    return new Promise((resolve, reject) => {
      const seq = this.send(message);
      this.waiting.set(seq, { resolve: resolve as (answer: Incoming) => void, reject, isQuiet });
    });
  }

  // The bytes of a file that a description names.
  file(name: string): Promise<ArrayBuffer> {
    if (this.transport.file) return this.transport.file(name);
    return new Promise((resolve, reject) => {
      this.waiting.set(this.send({ type: "file", name }), { resolve: () => {}, reject, take: resolve });
    });
  }

  // The picture of an element at an instant.
  picture(element: string, run: number, t: number): Promise<PictureAnswer> {
    return new Promise((resolve, reject) => {
      this.waiting.set(this.send({ type: "picture", element, run, t }), { resolve: () => {}, reject, takePicture: resolve });
    });
  }

  private takePicture(to: number, picture: PictureAnswer): void {
    this.waiting.get(to)?.takePicture?.(picture);
    this.waiting.delete(to);
  }

  private takeFile(to: number, bytes: ArrayBuffer): void {
    this.waiting.get(to)?.take?.(bytes);
    this.waiting.delete(to);
  }

  private take(message: Incoming, events: Events): void {
    const question = typeof message.to === "number" ? this.waiting.get(message.to) : undefined;
    if (question) this.waiting.delete(message.to as number);
    if (question && message.type === "error") {
      question.reject(new Refused(message));
      return;
    }
    if (message.type === "welcome" && message.key) keepKey(message.key);
    if (!question?.isQuiet) events.message(message);
    question?.resolve(message);
  }
}
