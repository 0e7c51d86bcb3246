// Values of a program as tables.
import { shownUnit } from "../numbers/units.ts";
import type { Units, Value } from "../protocol/messages.ts";

export interface Table {
  header: string[];
  rows: Value[][];
}

// A number with as many digits as a table shows, any other value as it is.
export function cellText(cell: Value | undefined, factor = 1): string {
  if (cell === null || cell === undefined) return "–";
  if (Array.isArray(cell)) return `[${cell.map((each) => cellText(each, factor)).join(", ")}]`;
  if (typeof cell === "object") return Object.entries(cell).map(([name, value]) => `${name} ${cellText(value, factor)}`).join(", ");
  if (typeof cell !== "number") return String(cell);
  const number = cell * factor;
  const text = Math.abs(number) < 5e-7 ? "0" : Number.isInteger(number) && Math.abs(number) < 1e6 ? String(number) : String(+number.toPrecision(5));
  return text.replace("-", "−");
}

const isRecord = (value: Value | undefined): value is { [name: string]: Value } => typeof value === "object" && value !== null && !Array.isArray(value);

// The rows of a table value: rows, records with their names as header, or one row of values.
export function tableOf(value: Value | undefined): Table {
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

// The value with each number replaced by its unit.
function unitsIn(value: Value | undefined, units: Units | undefined): Value {
  const part = (key: string | number) => (typeof units === "object" ? (units as { [name: string]: Units })[key] : units);
  if (Array.isArray(value)) return value.map((each, i) => unitsIn(each, part(i)));
  if (isRecord(value)) return Object.fromEntries(Object.entries(value).map(([name, each]) => [name, unitsIn(each, part(name))]));
  return typeof value === "number" && typeof units === "string" ? units : "";
}

function leaves(value: Value | undefined): string[] {
  if (Array.isArray(value)) return value.flatMap(leaves);
  return isRecord(value) ? Object.values(value).flatMap(leaves) : [String(value ?? "")];
}

// The common unit of all numbers; null: they differ.
function unitOf(units: Value): string | null {
  const all = new Set(leaves(units).filter(Boolean));
  return all.size > 1 ? null : ([...all][0] ?? "");
}

// A cell in its unit, which follows the number unless it is in the header; if there are several units, number by number.
function withUnits(cell: Value | undefined, units: Value, isInHeader: boolean): string {
  const unit = unitOf(units);
  if (unit === null && Array.isArray(cell)) return `[${cell.map((each, i) => withUnits(each, Array.isArray(units) ? (units[i] ?? "") : units, false)).join(", ")}]`;
  const shown = shownUnit(unit);
  const words = cellText(cell, shown.factor);
  return isInHeader || !shown.unit || cell === null || cell === undefined ? words : `${words} ${shown.unit}`;
}

// A matrix of numbers: at least two rows and two columns.
function isMatrix(value: Value | undefined): value is number[][] {
  if (!Array.isArray(value) || value.length < 2 || !Array.isArray(value[0]) || value[0].length < 2) return false;
  const { length } = value[0];
  return value.every((row) => Array.isArray(row) && row.length === length && row.every((each) => typeof each === "number"));
}

const DIGITS = 4; // of the largest element of a matrix

// Numbers with the same number of decimals, by the largest of them; what is rounded away is 0.
export function roundedTogether(rows: readonly (readonly number[])[]): string[][] {
  const largest = Math.max(0, ...rows.flat().map(Math.abs).filter(Number.isFinite));
  const size = largest > 0 ? Math.floor(Math.log10(largest)) : 0;
  const isPlain = size < 7 && size > -5;
  const isWhole = isPlain && rows.flat().every(Number.isInteger);
  const decimals = isWhole ? 0 : Math.max(0, DIGITS - 1 - size);
  const text = (v: number) => {
    if (!isPlain) return Math.abs(v) < largest * 10 ** -DIGITS ? "0" : v.toExponential(DIGITS - 2);
    const plain = v.toFixed(decimals);
    return Number(plain) === 0 ? "0" : plain;
  };
  return rows.map((row) => row.map((v) => text(v).replace(/^-/, "−")));
}

const TWIST = ["vx", "vy", "vz", "ωx", "ωy", "ωz"];

// The names of rows and columns: joints, if the matrix belongs to an arm as its size and symmetry show; otherwise numbers from 1.
// joints  the names of the joints of each arm.
function namesOf(matrix: readonly (readonly number[])[], joints: readonly (readonly string[])[]): [readonly string[], readonly string[]] {
  const [rows, columns] = [matrix.length, matrix[0]!.length];
  const numbers = (n: number) => Array.from({ length: n }, (_, i) => String(i + 1));
  const largest = Math.max(...matrix.flat().map(Math.abs));
  const isSymmetric = rows === columns && matrix.every((row, i) => row[i]! > 0 && row.every((v, k) => Math.abs(v - matrix[k]![i]!) <= 1e-9 * largest));
  const arm = joints.find((each) => each.length === columns);
  if (arm && isSymmetric) return [arm, arm];
  if (arm && rows === 6 && columns !== 6) return [TWIST, arm];
  return [numbers(rows), numbers(columns)];
}

export interface ShownTable {
  header: string[];
  rows: string[][];
  named?: boolean; // the first column has the names of the rows
}

// The table for display: lengths in millimetres, angles in degrees. A unit is in the header if a column has one unit, otherwise with each
// number. A matrix has one unit, and its elements are rounded together.
// given   a header for it.
// joints  the names of the joints of each arm.
export function shownTable(value: Value | undefined, units: Units | undefined, given: string[] = [], joints: readonly (readonly string[])[] = []): ShownTable {
  const { header: own, rows } = tableOf(value);
  const unitRows = tableOf(unitsIn(value, units)).rows;
  const header = given.length ? given : own;
  const common = unitOf(unitRows);
  if (isMatrix(value) && !header.length && common !== null) {
    const shown = shownUnit(common);
    const [names, columns] = namesOf(value, joints);
    const cells = roundedTogether(value.map((row) => row.map((v) => v * shown.factor)));
    return { header: [shown.unit && `[${shown.unit}]`, ...columns], rows: cells.map((row, i) => [names[i]!, ...row]), named: true };
  }
  const columns = Math.max(header.length, ...rows.map((row) => row.length));
  const shared = Array.from({ length: columns }, (_, k) => (header.length ? unitOf(unitRows.map((row) => row[k] ?? "")) : null));
  const text = (cell: Value | undefined, i: number, k: number) => {
    return typeof cell === "string" ? cell : withUnits(cell, unitRows[i]?.[k] ?? "", typeof shared[k] === "string");
  };
  return {
    header: header.map((name, k) => (shared[k] ? `${name} [${shownUnit(shared[k]).unit}]` : name)),
    rows: rows.map((row, i) => row.map((cell, k) => text(cell, i, k))),
  };
}
