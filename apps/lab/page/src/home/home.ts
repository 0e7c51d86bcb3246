// Where this page's laboratory is: in the page as a recording, in a worker of the page, or behind a socket.
import type { Carry } from "./connection.ts";
import { overRecording, type Recording } from "./recording.ts";
import { overSocket, socketAddress } from "./socket.ts";
import { overWorker } from "./worker.ts";

export interface Home {
  carry: Carry;
  // Whether the laboratory can be asked; a recording cannot.
  live: boolean;
}

declare global {
  // Set by the script of an exported page that carries the engine.
  var armletWorker: (() => Worker) | undefined;
}

export function findHome(): Home {
  const recording = document.getElementById("armlet-recording");
  if (recording) return { carry: overRecording(JSON.parse(recording.textContent) as Recording), live: false };
  if (globalThis.armletWorker) return { carry: overWorker(globalThis.armletWorker()), live: true };
  return { carry: overSocket(socketAddress(location)), live: true };
}
