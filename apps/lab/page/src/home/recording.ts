// A recorded laboratory: it sends the recorded messages again, and answers no questions.
import type { Carry } from "./connection.ts";

// Messages in their order: text messages as objects, binary ones as {"binary": base64}; drawn files have their name in "file".
export type Recording = (Record<string, unknown> | { binary: string })[];

export function overRecording(recording: Recording): Carry {
  return (listener) => {
    const files = new Map<unknown, string>();
    queueMicrotask(() => {
      listener.opened();
      for (const message of recording) {
        if ("file" in message && typeof message["binary"] === "string") files.set(message.file, message["binary"]);
        else if (typeof message["binary"] === "string") listener.message(bytes(message["binary"]).buffer);
        else listener.message(JSON.stringify(message));
      }
    });
    return {
      send: () => {},
      file: async (name) => {
        const file = files.get(name);
        if (file === undefined) throw new Error("The recording does not have this file.");
        return bytes(file).buffer;
      },
    };
  };
}

function bytes(base64: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
}
