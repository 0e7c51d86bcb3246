// The laboratory of this page: a recording in the page, a worker of the page, or behind a socket.
import type { Carry } from "./connection.ts";
import { overRecording, type Recording } from "./recording.ts";
import { overSocket, socketAddress } from "./socket.ts";
import { overWorker } from "./worker.ts";

export interface Home {
  carry: Carry;
  // Whether the laboratory answers questions; a recording does not.
  live: boolean;
  // Whether it is in this page; then the page can be saved with all its runs.
  alone: boolean;
}

// A saved page contains its data as scripts that browsers do not run, because of their types: #armlet-recording (JSON: the messages),
// or #armlet-worker (the source of the worker) with further texts in elements of the class armlet-part, which the worker gets by their
// ids.
export function findHome(): Home {
  const recording = document.getElementById("armlet-recording");
  if (recording) return { carry: overRecording(JSON.parse(recording.textContent) as Recording), live: false, alone: false };
  const worker = document.getElementById("armlet-worker");
  if (worker) return { carry: overWorker(startWorker(worker.textContent)), live: true, alone: true };
  return { carry: overSocket(socketAddress(location)), live: true, alone: false };
}

function startWorker(code: string): Worker {
  const worker = new Worker(URL.createObjectURL(new Blob([code], { type: "text/javascript" })));
  const parts = [...document.querySelectorAll("script.armlet-part")];
  worker.postMessage(Object.fromEntries(parts.map((part) => [part.id, part.textContent])));
  for (const part of parts) part.remove();
  return worker;
}
