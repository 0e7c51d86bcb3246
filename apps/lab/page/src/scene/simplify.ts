// Removes points of a line without a visible change.

// The indices of the points that are needed so that every other one is within `tolerance` of the line segment that replaces it (Douglas
// and Peucker, 1973). Points have any number of coordinates, all the same; the first and the last one are kept.
export function neededPoints(points: readonly (readonly number[])[], tolerance: number): number[] {
  if (points.length < 3) return points.map((_, i) => i);
  const needed = new Set([0, points.length - 1]);
  const pieces: [number, number][] = [[0, points.length - 1]];
  for (let piece = pieces.pop(); piece; piece = pieces.pop()) {
    const [from, to] = piece;
    let farthest = tolerance * tolerance;
    let at = -1;
    for (let i = from + 1; i < to; i++) {
      const d = squareToPiece(points[i]!, points[from]!, points[to]!);
      if (d > farthest) [farthest, at] = [d, i];
    }
    if (at < 0) continue;
    needed.add(at);
    pieces.push([from, at], [at, to]);
  }
  return [...needed].sort((a, b) => a - b);
}

// The squared distance of p from the line segment from a to b.
function squareToPiece(p: readonly number[], a: readonly number[], b: readonly number[]): number {
  let along = 0;
  let length = 0;
  for (let k = 0; k < p.length; k++) {
    const d = b[k]! - a[k]!;
    along += (p[k]! - a[k]!) * d;
    length += d * d;
  }
  const s = length > 0 ? Math.min(1, Math.max(0, along / length)) : 0;
  let square = 0;
  for (let k = 0; k < p.length; k++) square += (p[k]! - a[k]! - s * (b[k]! - a[k]!)) ** 2;
  return square;
}
