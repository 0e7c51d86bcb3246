// Polygons as triangles, also where they are not convex.

type Point = readonly number[];

// Twice the area of a triangle; positive: counterclockwise.
const area = (a: Point, b: Point, c: Point) => (b[0]! - a[0]!) * (c[1]! - a[1]!) - (b[1]! - a[1]!) * (c[0]! - a[0]!);

// The points on the plane along which the polygon is seen largest, counterclockwise.
//
// source  M. Newell, in I. Sutherland, R. Sproull and R. Schumacker, A characterization of ten hidden-surface algorithms, 1974.
function flattened(points: readonly Point[]): Point[] {
  const normal = [0, 0, 0];
  points.forEach((p, i) => {
    const q = points[(i + 1) % points.length]!;
    for (let k = 0; k < 3; k++) {
      const [u, v] = [(k + 1) % 3, (k + 2) % 3];
      normal[k]! += (p[u]! - q[u]!) * (p[v]! + q[v]!);
    }
  });
  const sizes = normal.map(Math.abs);
  const k = sizes.indexOf(Math.max(...sizes));
  const [u, v] = normal[k]! < 0 ? [(k + 2) % 3, (k + 1) % 3] : [(k + 1) % 3, (k + 2) % 3];
  return points.map((p) => [p[u]!, p[v]!]);
}

// Numbers of corners, three for each triangle; always two triangles fewer than corners, so that the edges of the polygon stay, those
// with corners on them too.
//
// source  G. Meisters, Polygons have ears, 1975.
export function cutPolygon(points: readonly Point[]): [number, number, number][] {
  const left = points.map((_, i) => i);
  if (left.length < 4) return left.length === 3 ? [[0, 1, 2]] : [];
  const flat = flattened(points);
  const at = (i: number) => flat[left[(i + left.length) % left.length]!]!;
  const size = (i: number) => area(at(i - 1), at(i), at(i + 1));
  const isEar = (i: number) => {
    const [a, b, c] = [at(i - 1), at(i), at(i + 1)];
    if (!(area(a, b, c) > 0)) return false;
    return left.every((j) => {
      const p = flat[j]!;
      if (p === a || p === b || p === c) return true;
      return area(a, b, p) < 0 || area(b, c, p) < 0 || area(c, a, p) < 0 || [a, b, c].some((q) => q[0] === p[0] && q[1] === p[1]);
    });
  };
  const triangles: [number, number, number][] = [];
  let isConvex = left.every((_, i) => size(i) > 0);
  let i = 1;
  while (left.length > 3) {
    if (!isConvex) {
      let tried = 0;
      while (tried < left.length && !isEar(i % left.length)) [i, tried] = [i + 1, tried + 1];
      // Without an ear it crosses itself: any cut is as good as another.
    }
    i %= left.length;
    triangles.push([left[(i - 1 + left.length) % left.length]!, left[i]!, left[(i + 1) % left.length]!]);
    left.splice(i, 1);
  }
  triangles.push(left as [number, number, number]);
  return triangles;
}
