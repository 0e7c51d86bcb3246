// The file of the program: New, Share and Save, the mark of unsaved edits, and the question about a file that another program has changed.
import { el, setText } from "../dom/dom.ts";
import { fileName, isUnsaved } from "../store/document.ts";
import type { Intents } from "../store/intents.ts";
import { inControl } from "../store/state.ts";
import type { Store } from "../store/store.ts";
import { galleryDialog } from "./gallery.ts";
import { saveProgram, sharing } from "./share.ts";

export interface ProgramFileParts {
  buttons: HTMLElement[];
  question: HTMLElement;
  dialogs: HTMLElement[];
}

// load  puts a program into the editor, from where Undo brings the old one back.
// source, alone  see HeaderActions.
export function programFile(store: Store, intents: Intents, load: (text: string) => void, source: string, alone: boolean): ProgramFileParts {
  const gallery = galleryDialog(load);
  const { dialog, share } = sharing(intents, source, alone);
  const create = el("button", { onclick: gallery.open, hidden: !intents.live, title: "Begin with another program" }, "New");
  // A page without a file, or a recording, saves a copy.
  const save = () => (intents.live && store.state.document ? void intents.saveText() : saveProgram(store.state));
  const mark = el("span", { class: "unsaved", "aria-hidden": "true" }, "●");
  const button = el("button", { onclick: save }, mark, "Save");
  const question = el("div", { class: "offer", role: "alert", hidden: true });
  document.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || event.shiftKey || event.key.toLowerCase() !== "s") return;
    event.preventDefault();
    if (!event.repeat) save();
  });
  addEventListener("beforeunload", (event) => {
    if (intents.live && inControl(store.state) && isUnsaved(store.state)) event.preventDefault();
  });
  store.watch((s) => [isUnsaved(s), inControl(s), s.document, s.welcome], (s) => {
    const unsaved = isUnsaved(s);
    mark.hidden = !unsaved;
    button.title = unsaved ? `${fileName(s)} has unsaved edits (Ctrl S)` : s.document ? `${fileName(s)} is saved (Ctrl S)` : "Save a copy";
    button.disabled = intents.live && s.document !== null && !inControl(s);
    create.disabled = !inControl(s);
  });
  store.watch((s) => [s.document, s.postponed, inControl(s)], (s) => {
    question.hidden = !s.document?.changed || !inControl(s) || s.postponed === s.document.text;
  });
  const text = el("span", {});
  store.watch((s) => [s.welcome], (s) => setText(text, `${fileName(s)} was changed by another program.`));
  question.append(
    text,
    el("button", { onclick: () => store.state.document && load(store.state.document.text), title: "Undo brings your text back" }, "Load it"),
    el("button", { onclick: () => void intents.saveText(true), title: "The file gets the text of this page" }, "Replace it"),
    el("button", { onclick: () => store.change((s) => (s.postponed = s.document?.text ?? null)) }, "Later"),
  );
  return { buttons: [create, el("button", { onclick: share }, "Share"), button], question, dialogs: [gallery.dialog, dialog] };
}
