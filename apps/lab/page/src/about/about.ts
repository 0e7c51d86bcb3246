// The About dialog: Armlet, and software by others with licences and copyrights (notices.json, made by tools/check_notices.py).
import { el } from "../dom/dom.ts";
import notices from "./notices.json";

type Part = {
  name: string; version?: string; licence: string; copyright: string[]; home: string; source?: string; in: string[]; loaded?: string[]; texts: string[]; note?: string;
};
const parts: Part[] = notices.parts;
const places: Record<string, string> = notices.places;
const texts: Record<string, string> = notices.texts;

const link = (address: string) => el("a", { href: address, target: "_blank", rel: "noreferrer" }, address);

function entry(part: Part): HTMLElement {
  return el("li", {}, el("b", {}, `${part.name} ${part.version ?? ""}`.trim()), ` · ${part.licence} · `, link(part.home),
    ...part.copyright.map((line) => el("div", { class: "quiet" }, `Copyright © ${line}`)),
    part.source ? el("div", { class: "quiet" }, "Sources: ", link(part.source)) : null,
    part.note ? el("div", { class: "quiet" }, part.note) : null);
}

const list = (title: string, of: Part[]) => (of.length ? [el("h3", {}, title), el("ul", {}, ...of.map(entry))] : []);

// The content is made when the dialog is opened for the first time.
export function aboutDialog(version: () => string): { dialog: HTMLDialogElement; open(): void } {
  const dialog: HTMLDialogElement = el("dialog", { class: "help about", "aria-label": "About" });
  const fill = () => dialog.replaceChildren(
    el("h2", {}, `Armlet ${version()}`.trim()),
    el("p", {}, "A language for robot arms, under the MIT licence. Copyright © The Armlet authors. It contains software of others:"),
    ...["page", "engine", "command", "planner", "converter"].flatMap((place) => list(`In ${places[place]}`, parts.filter((part) => part.in.includes(place)))),
    ...list("Libraries of the system that the command, the planners, the converter or programs of hosts load", parts.filter((part) => !part.in.length)),
    el("h3", {}, "Texts of the licences of what the page and its engine contain"),
    ...Object.entries(texts).map(([name, text]) => el("details", {}, el("summary", {}, name), el("pre", {}, text))),
    el("p", { class: "quiet" }, "armlet --notices prints these and those of the command."),
    el("button", { onclick: () => dialog.close() }, "Close"),
  );
  return { dialog, open: () => {
    if (dialog.open) return;
    fill();
    dialog.showModal();
  } };
}
