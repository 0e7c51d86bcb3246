// Lines and numbers of files that are texts.
import { refuse, shown } from "./triangles.ts";

const PIECE = 1 << 20; // bytes that are read at a time

// Calls `take` with each line and its number, from 1 on.
export function linesOf(bytes: Uint8Array<ArrayBuffer>, take: (line: string, number: number) => void): void {
  if (bytes.includes(0)) refuse("it is no text: it has a byte of 0");
  const decoder = new TextDecoder();
  let number = 0;
  let rest = "";
  for (let at = 0; at < bytes.length; at += PIECE) {
    const lines = (rest + decoder.decode(bytes.subarray(at, at + PIECE), { stream: true })).split("\n");
    rest = lines.pop()!;
    for (const line of lines) take(line, ++number);
  }
  rest += decoder.decode();
  if (rest) take(rest, ++number);
}

// where  told where the word is no number.
export function numberOf(word: string | undefined, where: string): number {
  if (word === undefined) refuse(`${where} has fewer numbers than it should`);
  const value = Number(word);
  // Too large a number is infinite, and refused as a coordinate.
  if (!/^[-+]?(\d|\.\d)/.test(word) || Number.isNaN(value)) refuse(`${where} has "${shown(word)}" where a number should be`);
  return value;
}
