// The program and its run for others: as a file, or, from a public page, as a link.
import { el, save } from "../dom/dom.ts";
import { pageWithLaboratory, pageWithRecording } from "../home/source.ts";
import { baseName, fileName } from "../store/document.ts";
import type { Intents } from "../store/intents.ts";
import { base64, filesOf, looksOf, recordingOf, timesToLook } from "../store/recording.ts";
import { shownRun, type State } from "../store/state.ts";
import { textToHash } from "./link.ts";

// Whether other people can open the address of this page: it needs no secret and is not one of this computer.
export function isPublic(place: { protocol: string; hostname: string }, alone: boolean): boolean {
  return alone && /^https?:$/.test(place.protocol) && !/^(localhost|.*\.localhost|127\..*|0\.0\.0\.0|\[::1?\])$/.test(place.hostname);
}

export function saveProgram(state: State): void {
  save(fileName(state), new Blob([state.text], { type: "text/plain" }));
}

// The shown run as a page that needs no laboratory.
export async function record(state: State, intents: Intents, source: string): Promise<void> {
  const run = shownRun(state);
  if (!run) return;
  const files = new Map<string, string>();
  for (const name of filesOf(run)) {
    const bytes = await intents.file(name).catch(() => null);
    if (bytes) files.set(name, base64(bytes));
  }
  const instants = [];
  for (const t of timesToLook(run)) {
    const instant = await intents.look(run.id, t).catch(() => null);
    if (instant) instants.push({ ...instant, t });
  }
  save(`${baseName(state)}.html`, new Blob([pageWithRecording(source, recordingOf(state, run, files, looksOf(instants)))], { type: "text/html" }));
}

export async function handIn(intents: Intents, source: string): Promise<void> {
  const exported = await intents.answered<"exported">({ type: "export" });
  if (exported) save(`${baseName(intents.state)}.html`, new Blob([pageWithLaboratory(source, exported.laboratory)], { type: "text/html" }));
}

async function copyLink(intents: Intents): Promise<void> {
  const hash = await textToHash(intents.state.text);
  if (!hash) {
    intents.say("The program is too long for an address. Save it and send the file.");
    return;
  }
  history.replaceState(null, "", hash);
  try {
    await navigator.clipboard.writeText(location.href);
    intents.say("The address with the program is in the clipboard.");
  } catch {
    intents.say("The program is in the address of this page now.");
  }
}

// source, alone  see HeaderActions.
export function sharing(intents: Intents, source: string, alone: boolean): { dialog: HTMLDialogElement; share(): void } {
  const choice = (title: string, text: string, action: () => void) => el("button", { class: "card", onclick: () => {
    dialog.close();
    action();
  } }, el("strong", {}, title), el("span", { class: "quiet" }, text));
  const dialog: HTMLDialogElement = el(
    "dialog", { class: "help", "aria-label": "Share" },
    el("h2", {}, "Share as a file"),
    el("p", { class: "quiet" }, "Other people cannot open the address of this page. Send them a file."),
    el(
      "div", { class: "gallery" },
      choice("The program", "A text that armlet lab opens.", () => saveProgram(intents.state)),
      intents.live && choice("This run as a page", "Opens in any browser and shows the run; it cannot be changed there.", () => void record(intents.state, intents, source)),
      alone && choice("This laboratory as a page", "Opens in any browser, with the editor and all runs.", () => void handIn(intents, source)),
    ),
    el("div", { class: "row" }, el("button", { onclick: () => dialog.close() }, "Cancel")),
  );
  return { dialog, share: () => (isPublic(location, alone) ? void copyLink(intents) : dialog.showModal()) };
}
