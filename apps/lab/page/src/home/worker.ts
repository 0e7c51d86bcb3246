// A laboratory in a worker of this page. The worker sends "ready" when it accepts messages; text messages are strings, binary ones are
// buffers.
import type { Carry } from "./connection.ts";

export function overWorker(worker: Worker): Carry {
  return (listener) => {
    worker.onmessage = (event: MessageEvent<string | ArrayBuffer>) => {
      if (event.data === "ready") listener.opened();
      else listener.message(event.data);
    };
    worker.onerror = (event) => listener.closed(`The engine stopped: ${event.message}`);
    return { send: (text) => worker.postMessage(text) };
  };
}
