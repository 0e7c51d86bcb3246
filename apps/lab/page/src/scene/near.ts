// The distance of two bodies as text.
import type { NearPair } from "../protocol/messages.ts";

export const SOFT = 1e-4; // m: a smaller overlap is only a contact, as in collision reports

const PRESSED = 0.01; // m: up to this depth of the tool in an object there is a contact force, which may be intended

export const overlaps = (pair: NearPair) => pair.distance < -(pair.felt ? PRESSED : SOFT);

const millimetres = (distance: number) => `${(1000 * distance).toFixed(Math.abs(distance) < 0.01 ? 1 : 0)} mm`;

export function textOf(pair: NearPair): string {
  const [body, other] = [pair.body, pair.other].map(({ text }) => text.replaceAll("`", "")) as [string, string];
  const depth = `${pair.at_least ? "at least " : ""}${millimetres(-pair.distance)}`;
  if (overlaps(pair)) return `${body} is ${depth} deep in ${other}`;
  if (pair.distance < -SOFT) return `${body} presses ${depth} into ${other}`;
  return pair.distance <= SOFT ? `${body} touches ${other}` : `${body}: ${millimetres(pair.distance)} to ${other}`;
}
