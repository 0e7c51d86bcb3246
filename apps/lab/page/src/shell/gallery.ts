// Programs to begin with (apps/lab/gallery): in a menu, and in the view while the program is empty.
import list from "../../../gallery/list.json";
import { el } from "../dom/dom.ts";
import type { Intents } from "../store/intents.ts";
import { inControl } from "../store/state.ts";
import type { Store } from "../store/store.ts";

const texts = import.meta.glob<string>("../../../gallery/*.rbt", { query: "?raw", import: "default", eager: true });

function cards(open: (text: string) => void): HTMLElement {
  return el("div", { class: "gallery" }, ...list.map(({ file, title, text }) => el("button", { class: "card", onclick: () => open(texts[`../../../gallery/${file}`]!) }, el("strong", {}, title), el("span", { class: "quiet" }, text))));
}

// load  puts a program into the editor, from where Undo brings the old one back.
export function galleryDialog(load: (text: string) => void): { dialog: HTMLDialogElement; open(): void } {
  const take = (text: string) => {
    dialog.close();
    load(text);
  };
  const dialog: HTMLDialogElement = el(
    "dialog", { class: "help", "aria-label": "New program" },
    el("h2", {}, "New program"),
    el("p", { class: "quiet" }, "It replaces the text of the editor; Ctrl Z brings that back. The file stays as it is until you save."),
    cards(take),
    el("div", { class: "row" }, el("button", { onclick: () => take("") }, "Empty"), el("button", { onclick: () => dialog.close() }, "Cancel")),
  );
  return { dialog, open: () => dialog.showModal() };
}

// Shown while the program is empty.
export function emptyPage(store: Store, intents: Intents, load: (text: string) => void): HTMLElement {
  const host = el("section", { class: "empty-page", hidden: true, "aria-label": "Programs to begin with" }, el("h2", {}, "Begin with a program"), cards(load));
  store.watch((s) => [s.text.trim() === "", s.welcome, inControl(s)], (s) => {
    host.hidden = s.text.trim() !== "" || s.welcome === null || !inControl(s) || !intents.live;
  });
  return host;
}
