// A laboratory that was recorded: what it said once, said again. It answers no questions.
import type { Carry } from "./connection.ts";

// Messages in their order: text as objects, binary ones as {"binary": base64}.
export type Recording = (Record<string, unknown> | { binary: string })[];

export function overRecording(recording: Recording): Carry {
  return (listener) => {
    queueMicrotask(() => {
      listener.opened();
      for (const message of recording) {
        if (typeof message["binary"] === "string") listener.message(bytes(message["binary"]).buffer);
        else listener.message(JSON.stringify(message));
      }
    });
    return { send: () => {} };
  };
}

function bytes(base64: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
}
