// Words and numbers of text files.
import { refuse, shown } from "./triangles.ts";

// A number in the syntax of these formats.
export const NUMBER = /[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/i;
const WHOLE = new RegExp(`^${NUMBER.source}$`, "i");

export function textOf(bytes: Uint8Array<ArrayBuffer>): string {
  if (bytes.includes(0)) refuse("it is no text: it has a byte of 0");
  return new TextDecoder().decode(bytes);
}

// where  the position for the message if the word is no number.
export function numberOf(word: string | undefined, where: string): number {
  if (word === undefined) refuse(`${where} has fewer numbers than it should`);
  if (!WHOLE.test(word)) refuse(`${where} has "${shown(word)}" where a number should be`);
  return Number(word); // a number that is too large becomes infinite, and is refused as a coordinate
}
