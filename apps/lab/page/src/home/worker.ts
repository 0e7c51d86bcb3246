// A laboratory in a worker of this page. The worker says "ready" when messages can be sent to it;
// then it takes and gives text messages as strings and binary ones as buffers.
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
