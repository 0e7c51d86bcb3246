// Ranges of the axes of a plot.
export type Range = [number, number];

const MARGIN = 0.06; // of the height, above and below the values

// The ranges of several axes beside one plot: zero is at the same height on all of them. Each range holds the smallest and the largest value
// of its axis, and as little else as possible. null: an axis without values.
export function alignedRanges(extents: readonly (Range | null)[]): Range[] {
  const known = extents.map((each): Range => {
    const [low, high] = each ?? [0, 0];
    const [below, above] = [Math.min(0, low), Math.max(0, high)];
    return above - below > 0 ? [below, above] : [0, 1];
  });
  // With the share p of the height below zero an axis from -a to b needs the height max(a / p, b / (1 - p)).
  const shares = known.map(([low, high]) => Math.abs(low) / (high - low)); // no -0
  const heightOf = ([low, high]: Range, p: number) => Math.max(low < 0 ? -low / p : 0, high > 0 ? high / (1 - p) : 0);
  const waste = (p: number) => Math.max(...known.map((each) => heightOf(each, p) / (each[1] - each[0])));
  const share = [...shares, 0.5].reduce((a, b) => (waste(b) < waste(a) ? b : a));
  return known.map((each) => {
    const height = heightOf(each, share);
    const [low, high] = [0 - share * height, (1 - share) * height];
    const margin = MARGIN * height;
    // No margin where zero is at the edge on all axes.
    const [lower, upper] = [share > 0 ? margin * 2 * share : 0, share < 1 ? margin * 2 * (1 - share) : 0];
    return [low - lower, high + upper];
  });
}
