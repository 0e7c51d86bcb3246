// The same body as STL, OBJ and PLY: a U of 300 x 200 x 100 mm, z up, whose ends are polygons of eight corners that are not convex.
const OUTLINE = [[0, 0], [0.3, 0], [0.3, 0.2], [0.2, 0.2], [0.2, 0.1], [0.1, 0.1], [0.1, 0.2], [0, 0.2]];
const HEIGHT = 0.1;
export const VOLUME = (0.3 * 0.2 - 0.1 * 0.1) * HEIGHT;

const points = [0, HEIGHT].flatMap((z) => OUTLINE.map(([x, y]) => [x, y, z]));
const n = OUTLINE.length;
const faces = [
  OUTLINE.map((_, k) => n - 1 - k),
  OUTLINE.map((_, k) => n + k),
  ...OUTLINE.map((_, k) => [k, (k + 1) % n, n + ((k + 1) % n), n + k]),
];
// The same in triangles.
const END = [[0, 5, 6], [0, 6, 7], [0, 4, 5], [0, 1, 4], [1, 2, 4], [2, 3, 4]];
const triangles = [
  ...END.map((three) => [...three].reverse()),
  ...END.map((three) => three.map((k) => n + k)),
  ...faces.slice(2).flatMap((face) => [[0, 1, 2], [0, 2, 3]].map((three) => three.map((k) => face[k]))),
];

export const body = { points, faces, triangles };

export const obj = (more = "") => Buffer.from(`# a U\n${more}${points.map((p) => `v ${p.join(" ")}`).join("\n")}\n${faces.map((face) => `f ${face.map((k) => k + 1).join(" ")}`).join("\n")}\n`);

export const stlText = () => Buffer.from(`solid facet U\n${triangles.map((three) => `facet normal 0 0 0\n  outer loop\n${three.map((k) => `    vertex ${points[k].join(" ")}\n`).join("")}  endloop\nendfacet\n`).join("")}endsolid facet U\n`);

// colors  of each triangle its two last bytes; 0: none.
export function stl(colors = () => 0, header = "") {
  const bytes = Buffer.alloc(84 + 50 * triangles.length);
  bytes.write(header, "latin1");
  bytes.writeUInt32LE(triangles.length, 80);
  triangles.forEach((three, i) => {
    three.forEach((k, corner) => points[k].forEach((x, axis) => bytes.writeFloatLE(x, 84 + 50 * i + 12 + 12 * corner + 4 * axis)));
    bytes.writeUInt16LE(colors(i), 84 + 50 * i + 48);
  });
  return bytes;
}

const HEAD = (format, color) => `ply\nformat ${format} 1.0\ncomment a U\nelement vertex ${points.length}\nproperty float x\nproperty float y\nproperty float z\n${color ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : ""}element face ${faces.length}\nproperty list uchar int vertex_indices\nend_header\n`;
export const plyText = (color = null) => Buffer.from(`${HEAD("ascii", color)}${points.map((p) => `${[...p, ...(color ?? [])].join(" ")}\n`).join("")}${faces.map((face) => `${face.length} ${face.join(" ")}\n`).join("")}`);
export function ply(isLittle = true) {
  const float = (x) => {
    const bytes = Buffer.alloc(4);
    isLittle ? bytes.writeFloatLE(x) : bytes.writeFloatBE(x);
    return bytes;
  };
  const int = (x) => {
    const bytes = Buffer.alloc(4);
    isLittle ? bytes.writeInt32LE(x) : bytes.writeInt32BE(x);
    return bytes;
  };
  return Buffer.concat([Buffer.from(HEAD(`binary_${isLittle ? "little" : "big"}_endian`, null)), ...points.flat().map(float), ...faces.flatMap((face) => [Buffer.from([face.length]), ...face.map(int)])]);
}
