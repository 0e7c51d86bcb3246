// Values of a program as tables.
import type { Value } from "../protocol/messages.ts";

// A number with as many digits as one reads in a table, anything else as it is.
export function cellText(cell: Value | undefined): string {
  if (cell === null || cell === undefined) return "–";
  if (Array.isArray(cell)) return `[${cell.map(cellText).join(", ")}]`;
  if (typeof cell === "object") return Object.entries(cell).map(([name, value]) => `${name} ${cellText(value)}`).join(", ");
  if (typeof cell !== "number") return String(cell);
  const text = Math.abs(cell) < 5e-7 ? "0" : Number.isInteger(cell) && Math.abs(cell) < 1e6 ? String(cell) : String(+cell.toPrecision(5));
  return text.replace("-", "−");
}

const isRecord = (value: Value | undefined): value is { [name: string]: Value } => typeof value === "object" && value !== null && !Array.isArray(value);

// What a program gives for a table: rows, records with their names as header, or one row of values.
export function tableOf(value: Value | undefined): { header: string[]; rows: Value[][] } {
  if (isRecord(value)) {
    const columns = Object.entries(value);
    if (!columns.length || !columns.every(([, column]) => Array.isArray(column))) return { header: [], rows: columns };
    const length = Math.max(...columns.map(([, column]) => (column as Value[]).length));
    return { header: columns.map(([name]) => name), rows: Array.from({ length }, (_, i) => columns.map(([, column]) => (column as Value[])[i] ?? null)) };
  }
  if (!Array.isArray(value)) return { header: [], rows: value === undefined || value === null ? [] : [[value]] };
  const first = value[0];
  if (isRecord(first)) {
    const header = Object.keys(first);
    return { header, rows: value.map((row) => header.map((name) => (isRecord(row) ? (row[name] ?? null) : null))) };
  }
  return { header: [], rows: Array.isArray(first) ? value.map((row) => (Array.isArray(row) ? row : [row])) : value.length ? [value] : [] };
}
