// Values of fields, written into the rows of a laboratory.
import type { ElementInfo, Value } from "../protocol/messages.ts";
import { placeOfName } from "./names.ts";

export interface Change {
  from: number;
  to: number;
  insert: string;
}

// A value as a program has it; null: it cannot be written.
export function literal(element: ElementInfo, value: Value | undefined): string | null {
  if (typeof value === "boolean") return String(value);
  if (typeof value === "string") return JSON.stringify(value);
  if (typeof value !== "number" || !Number.isFinite(value)) return null;
  const number = +(value / (element.factor ?? 1)).toPrecision(10);
  return element.type === "int" ? String(Math.round(value)) : `${number}${element.unit ?? ""}`;
}

// The change of the text that gives a field this value at the start; null: its row is not in the text.
export function fieldChange(text: string, element: ElementInfo, value: Value | undefined): Change | null {
  const insert = literal(element, value);
  const name = placeOfName(text, element.name, "field");
  if (insert === null || name === null) return null;
  const open = /^\s*\(\s*/.exec(text.slice(name + element.name.length));
  if (!open) return null;
  const from = name + element.name.length + open[0].length;
  let depth = 0;
  let quoted = false;
  for (let to = from; to < text.length; to++) {
    const c = text[to]!;
    if (quoted && c === "\\") to++;
    else if (c === '"') quoted = !quoted;
    else if (quoted) continue;
    else if ("([{".includes(c)) depth++;
    else if (depth === 0 && (c === "," || c === ")")) return { from, to: from + text.slice(from, to).trimEnd().length, insert };
    else if (")]}".includes(c)) depth--;
  }
  return null;
}
