// The page that is in control, and how the others take part.
import { el, remember, remembered, save } from "../dom/dom.ts";
import type { Intents } from "../store/intents.ts";
import { inControl, type State } from "../store/state.ts";

export function drawControl(host: HTMLElement, state: State, intents: Intents): void {
  const { holder, pages, wishes, names } = state.control;
  const me = state.welcome?.page;
  const others = pages.filter((page) => page !== me);
  const nameOf = (page: number) => names?.[String(page)] || `page ${page}`;
  host.hidden = me === undefined || !intents.live || (!others.length && holder === me);
  host.classList.toggle("urged", !inControl(state) && state.refusedKeys > 0);
  if (host.hidden) return;
  if (!inControl(state)) {
    const wished = me !== undefined && wishes.includes(me);
    const who = holder === null ? "Nobody is in control." : `You follow ${nameOf(holder)}.`;
    const why = state.refusedKeys ? " What you type is not taken: ask for control, or go on in a copy." : "";
    host.replaceChildren(...[
      el("span", { class: "quiet", role: "status" }, who + why),
      el("button", { onclick: () => intents.takeControl(), disabled: wished }, wished ? "Asked for control" : "Take control"),
      names && nameField(state, intents),
      el("button", { title: "Save the program as a file of your own", onclick: () => save(copyName(state), new Blob([state.text], { type: "text/plain" })) }, "Save a copy"),
    ].filter((each) => each !== null));
    return;
  }
  const list = others.map((page) => el("button", { class: wishes.includes(page) ? "wish" : "", onclick: () => intents.giveControl(page) }, `Hand over to ${names?.[String(page)] || page}${wishes.includes(page) ? " (asks)" : ""}`));
  host.replaceChildren(el("span", { class: "quiet" }, `You are ${nameOf(me!)}, in control.`), ...(names ? [nameField(state, intents)] : []), ...list.slice(0, 4));
}

// The field is one for the whole life of the page, so that what is being written in it stays.
let field: HTMLInputElement | null = null;
function nameField(state: State, intents: Intents): HTMLInputElement {
  field ??= el("input", { type: "text", class: "person", maxlength: 40, size: 12, placeholder: "Your name", "aria-label": "Your name, as others see it", onchange: () => {
    remember("name", field!.value.trim());
    intents.tellName(field!.value.trim());
  } });
  if (document.activeElement !== field) field.value = state.control.names?.[String(state.welcome?.page)] ?? remembered("name") ?? "";
  return field;
}

// The name of an earlier visit.
export function tellKnownName(intents: Intents): void {
  const name = remembered("name");
  if (name && !Object.values(intents.state.control.names ?? {}).includes(name)) intents.tellName(name);
}

function copyName(state: State): string {
  return `${(state.welcome?.file.split("/").at(-1) ?? "program.rbt").replace(/\.rbt$/, "")}-copy.rbt`;
}
