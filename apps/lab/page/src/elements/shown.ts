// Elements without inputs: tables, texts, images, and placeholders for elements shown elsewhere.
import { el, setText } from "../dom/dom.ts";
import { namesOf } from "../numbers/joints.ts";
import { fixed } from "../numbers/units.ts";
import { NEAR, type Run } from "../store/run.ts";
import { richText } from "./rich_text.ts";
import { shownTable } from "./table_value.ts";
import type { ElementView, Place } from "./view.ts";

export function table({ element }: Place): ElementView {
  const body = el("table");
  const label = element.label || element.name;
  let drawn = "";
  return {
    root: el("div", { class: "element", role: "group", "aria-label": label }, el("h2", {}, label), el("div", { class: "scroll", tabindex: 0, role: "group", "aria-label": `${label}, table` }, body)),
    update(run) {
      const value = run.values[element.name];
      const key = JSON.stringify(value ?? null);
      if (key === drawn) return;
      drawn = key;
      const { header, rows, named = false } = shownTable(value?.value, value?.units, element.header ?? [], run.robots.map(namesOf));
      body.classList.toggle("matrix", named);
      body.replaceChildren(
        ...(header.length ? [el("thead", {}, el("tr", {}, ...header.map((text) => (text ? el("th", { scope: "col" }, text) : el("td")))))] : []),
        el("tbody", {}, ...rows.map((row) => el("tr", {}, ...row.map((cell, k) => (named && k === 0 ? el("th", { scope: "row" }, cell) : el("td", {}, cell)))))),
      );
      if (!rows.length && value && !value.error) body.replaceChildren(el("caption", { class: "quiet" }, "Nothing is in it."));
      if (value?.error) body.replaceChildren(el("caption", { class: "reason" }, value.error));
    },
  };
}

// The torques of the motors of a robot, beside their limits: the numbers of the bars in the 3D view.
export function torques({ element }: Place, run: Run): ElementView {
  const index = Math.max(0, run.robots.findIndex((r) => r.name === element.robot));
  const label = element.label || element.name;
  const rows = (run.robots[index]?.joints ?? []).map((joint, k) => {
    const [gives, fill, share] = [el("td"), el("div", { class: "fill" }), el("td")];
    const unit = joint.unit === "m" ? "N" : "N m";
    const most = joint.max_force ? `at most ${+joint.max_force.toPrecision(4)} ${unit}` : null;
    return { fill, gives, share, root: el("tr", { title: most }, el("th", { scope: "row" }, joint.name ?? `joint ${k + 1}`), gives, el("td", {}, unit), el("td", { class: "share" }, fill), share) };
  });
  const note = el("p", { class: "quiet" }, "The masses of this robot are not known.");
  return {
    root: el("div", { class: "element torques", role: "group", "aria-label": label }, el("h2", {}, label), el("table", {}, el("tbody", {}, ...rows.map((row) => row.root))), note),
    update(now, state) {
      const forces = now.forcesAt(index, state.t);
      const shares = now.sharesAt(index, state.t);
      note.hidden = forces !== null;
      rows.forEach(({ gives, fill, share }, k) => {
        const part = shares[k] ?? null;
        setText(gives, forces ? fixed(forces[k]!, 2).replace("-", "−") : "–");
        setText(share, part === null ? "" : `${(100 * Math.abs(part)).toFixed(0)} %`);
        fill.style.width = `${100 * Math.min(1, Math.abs(part ?? 0))}%`;
        fill.classList.toggle("near", Math.abs(part ?? 0) >= NEAR);
      });
    },
  };
}

export function text({ element }: Place): ElementView {
  const root = el("div", { class: "element rich", role: "group", "aria-label": element.label || element.name });
  let drawn: string | null = null;
  return {
    root,
    update(run) {
      const value = run.values[element.name];
      const markdown = typeof value?.value === "string" ? value.value : (element.text ?? value?.error ?? "");
      if (markdown === drawn) return;
      drawn = markdown;
      root.replaceChildren(richText(markdown));
    },
  };
}

// A picture from a file beside the program.
export function image({ element, intents }: Place): ElementView {
  const label = element.label || element.name;
  const picture = el("img", { alt: label });
  const note = el("p", { class: "quiet" });
  let own = "";
  void intents.file(element.file ?? "").then(
    (bytes) => (picture.src = own = URL.createObjectURL(new Blob([bytes]))),
    () => setText(note, "The picture could not be had."),
  );
  return {
    root: el("div", { class: "element", role: "group", "aria-label": label }, el("h2", {}, label), picture, note),
    dispose: () => URL.revokeObjectURL(own),
    update: () => {},
  };
}

// An element of an unknown kind, or one that is shown elsewhere on the page.
export function noted(label: string, note: string): ElementView {
  return { root: el("div", { class: "element", role: "group", "aria-label": label }, el("h2", {}, label), el("p", { class: "quiet" }, note)), update: (_run: Run) => {} };
}

