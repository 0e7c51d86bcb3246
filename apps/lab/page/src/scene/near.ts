// How near two things are, in words.
import type { NearPair } from "../protocol/messages.ts";

export const SOFT = 1e-4; // m: what overlaps less touches only, as collisions are told

const PRESSED = 0.01; // m: what a hand presses into so deep is felt, as it may be wanted

export const overlaps = (pair: NearPair) => pair.distance < -(pair.felt ? PRESSED : SOFT);

const millimetres = (distance: number) => `${(1000 * distance).toFixed(Math.abs(distance) < 0.01 ? 1 : 0)} mm`;

export function textOf(pair: NearPair): string {
  const [body, other] = [pair.body, pair.other].map(({ text }) => text.replaceAll("`", "")) as [string, string];
  const depth = `${pair.at_least ? "at least " : ""}${millimetres(-pair.distance)}`;
  if (overlaps(pair)) return `${body} is ${depth} deep in ${other}`;
  if (pair.distance < -SOFT) return `${body} presses ${depth} into ${other}`;
  return pair.distance <= SOFT ? `${body} touches ${other}` : `${body}: ${millimetres(pair.distance)} to ${other}`;
}
