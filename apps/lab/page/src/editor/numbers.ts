// Numbers in a text that can be pulled: where they are, and what they become.

export interface NumberAt {
  from: number;
  to: number;
  text: string;
}

const NUMBERS = /(?<![\w.])(?:(?<=(?:^|[(,=[{:;<>*/+-])\s*)-)?\d+(?:\.\d+)?(?![\d.]*\.?\d)(?!e[+-]?\d)/g;

// The number at a place of a line (columns from 0), with its sign where that is no operator.
export function numberAt(line: string, column: number): NumberAt | null {
  for (const match of line.matchAll(NUMBERS)) {
    const from = match.index;
    const to = from + match[0].length;
    if (from <= column && column <= to) return { from, to, text: match[0] };
  }
  return null;
}

// The number after so many steps of its last digit; it keeps its digits after the point.
export function pulled(text: string, steps: number): string {
  const decimals = /\.(\d+)$/.exec(text)?.[1]?.length ?? 0;
  const scale = 10 ** decimals;
  return ((Math.round(Number(text) * scale) + steps) / scale).toFixed(decimals).replace(/^-(0(\.0*)?)$/, "$1");
}
