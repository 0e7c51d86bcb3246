// Numbers in a text that can be changed by dragging: where they are, and their new values.

export interface NumberAt {
  from: number;
  to: number;
  text: string;
}

const NUMBERS = /(?<![\w.])(?:(?<=(?:^|[(,=[{:;<>*/+-])\s*)-)?\d+(?:\.\d+)?(?![\d.]*\.?\d)(?!e[+-]?\d)/g;

// The number at a column of a line (from 0), with its sign unless that is an operator.
export function numberAt(line: string, column: number): NumberAt | null {
  for (const match of line.matchAll(NUMBERS)) {
    const from = match.index;
    const to = from + match[0].length;
    if (from <= column && column <= to) return { from, to, text: match[0] };
  }
  return null;
}

// The number after this many steps of its last digit; the number of decimals stays the same.
export function pulled(text: string, steps: number): string {
  const decimals = /\.(\d+)$/.exec(text)?.[1]?.length ?? 0;
  const scale = 10 ** decimals;
  return ((Math.round(Number(text) * scale) + steps) / scale).toFixed(decimals).replace(/^-(0(\.0*)?)$/, "$1");
}
