// The 3D view as a vector picture of lines and areas: the farthest are drawn first.
import { BoxGeometry, BufferGeometry, Color, DoubleSide, Matrix3, Mesh, Vector3, type Object3D, type PerspectiveCamera } from "three";
import type { Surface } from "./surface.ts";

export interface Stroke {
  points: Vector3[];
  color: string;
  width: number;
}
export interface Drawing {
  width: number;
  height: number;
  ground: string;
  // Drawn under everything, in this order, and over everything.
  below: Stroke[];
  above: Stroke[];
}

const LIGHT = new Vector3(-0.35, -0.95, 1.6).normalize();

// The brightness of an area with this normal: light from above and a lamp.
function brightness(normal: Vector3): number {
  return 0.5 + 0.14 * (1 + normal.z) + 0.32 * Math.max(0, normal.dot(LIGHT));
}

// A triangle in the picture: pixels, and the depth of each corner as seen by the camera.
interface Area {
  corners: [Vector3, Vector3, Vector3];
  color: string;
}

const MOST_TRIANGLES = 20_000; // of one mesh; a finer one is drawn as its bounding box

function coarse(mesh: Mesh): Mesh {
  const { geometry } = mesh as Mesh<BufferGeometry>;
  if ((geometry.getIndex()?.count ?? geometry.getAttribute("position").count) <= 3 * MOST_TRIANGLES) return mesh;
  geometry.computeBoundingBox();
  const size = geometry.boundingBox!.getSize(new Vector3());
  const middle = geometry.boundingBox!.getCenter(new Vector3());
  const box = new Mesh(new BoxGeometry(size.x, size.y, size.z).translate(middle.x, middle.y, middle.z), mesh.material);
  box.matrixWorld.copy(mesh.matrixWorld);
  return box;
}

const SPLIT = 14; // px: a smaller area is either before or behind another one, hardly both
const HIDDEN = 1.5e-5; // of depth: an area farther behind than this is hidden

function areasOf(mesh: Mesh, camera: PerspectiveCamera, project: (p: Vector3) => Vector3): Area[] {
  const { geometry } = mesh as Mesh<BufferGeometry>;
  const material = [mesh.material].flat()[0] as Surface;
  const position = geometry.getAttribute("position");
  const index = geometry.getIndex();
  const count = index ? index.count : position.count;
  const turn = new Matrix3().getNormalMatrix(mesh.matrixWorld);
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  const areas: Area[] = [];
  for (let i = 0; i + 2 < count; i += 3) {
    [a, b, c].forEach((corner, k) => corner.fromBufferAttribute(position, index ? index.getX(i + k) : i + k));
    const normal = b.clone().sub(a).cross(c.clone().sub(a)).applyMatrix3(turn).normalize();
    for (const corner of [a, b, c]) corner.applyMatrix4(mesh.matrixWorld);
    const faces = normal.dot(camera.position.clone().sub(a)) > 0;
    if (!faces && material.side !== DoubleSide) continue;
    if (!faces) normal.negate();
    const corners: Area["corners"] = [project(a), project(b), project(c)];
    if (corners.some((p) => p.z > 1 || p.z < -1)) continue;
    const shade = new Color(material.color).multiplyScalar(brightness(normal));
    split({ corners, color: `#${shade.getHexString()}` }, areas);
  }
  return areas;
}

// Halves an area across its longest side until it is small.
function split(area: Area, into: Area[]): void {
  const { corners, color } = area;
  const sides = corners.map((p, k) => Math.hypot(p.x - corners[(k + 1) % 3]!.x, p.y - corners[(k + 1) % 3]!.y));
  const longest = sides.indexOf(Math.max(...sides));
  if (sides[longest]! <= SPLIT) {
    into.push(area);
    return;
  }
  const [p, q, r] = [corners[longest]!, corners[(longest + 1) % 3]!, corners[(longest + 2) % 3]!];
  const middle = p.clone().add(q).multiplyScalar(0.5);
  split({ corners: [p, middle, r], color }, into);
  split({ corners: [middle, q, r], color }, into);
}

// The nearest depth at each pixel.
class DepthMap {
  private readonly depth: Float64Array;
  private readonly width: number;
  private readonly height: number;

  constructor(areas: Area[], width: number, height: number) {
    this.width = Math.ceil(width);
    this.height = Math.ceil(height);
    this.depth = new Float64Array(this.width * this.height).fill(Infinity);
    for (const { corners: [a, b, c] } of areas) {
      const area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
      if (Math.abs(area) < 1e-9) continue;
      const clamp = (v: number, most: number) => Math.min(Math.max(Math.floor(v), 0), most - 1);
      for (let y = clamp(Math.min(a.y, b.y, c.y), this.height); y <= clamp(Math.max(a.y, b.y, c.y), this.height); y++) {
        for (let x = clamp(Math.min(a.x, b.x, c.x), this.width); x <= clamp(Math.max(a.x, b.x, c.x), this.width); x++) {
          const [u, v] = [x + 0.5 - a.x, y + 0.5 - a.y];
          const s = (u * (c.y - a.y) - v * (c.x - a.x)) / area;
          const t = ((b.x - a.x) * v - (b.y - a.y) * u) / area;
          if (s < 0 || t < 0 || s + t > 1) continue;
          const z = a.z + s * (b.z - a.z) + t * (c.z - a.z);
          const at = y * this.width + x;
          if (z < this.depth[at]!) this.depth[at] = z;
        }
      }
    }
  }

  // Whether a part of the area is visible: its middle, or a point near a corner.
  shows({ corners }: Area): boolean {
    const middle = corners[0].clone().add(corners[1]).add(corners[2]).divideScalar(3);
    return [middle, ...corners.map((corner) => corner.clone().lerp(middle, 0.3))].some((p) => {
      const [x, y] = [Math.floor(p.x), Math.floor(p.y)];
      if (x < 0 || y < 0 || x >= this.width || y >= this.height) return false;
      return p.z <= this.depth[y * this.width + x]! + HIDDEN;
    });
  }
}

const number = (value: number) => String(+value.toFixed(1));
const depthOf = ({ corners: [a, b, c] }: Area) => a.z + b.z + c.z;
const outline = ({ corners }: Area) => `M${corners.map((p) => `${number(p.x)} ${number(p.y)}`).join("L")}Z`;

export function vectorPicture(content: Object3D[], camera: PerspectiveCamera, drawing: Drawing): string {
  const { width, height } = drawing;
  const project = (p: Vector3) => {
    const seen = p.clone().project(camera);
    return new Vector3(((seen.x + 1) / 2) * width, ((1 - seen.y) / 2) * height, seen.z);
  };
  const areas: Area[] = [];
  for (const part of content) {
    part.updateMatrixWorld(true);
    part.traverseVisible((node) => {
      if (node instanceof Mesh) for (const area of areasOf(coarse(node), camera, project)) areas.push(area);
    });
  }
  const map = new DepthMap(areas, width, height);
  const seen = areas.filter((area) => map.shows(area)).sort((one, other) => depthOf(other) - depthOf(one));
  const stroke = ({ points, color, width: w }: Stroke): string => {
    const places = points.map(project);
    if (places.some((p) => p.z > 1)) return "";
    return `<polyline points="${places.map((p) => `${number(p.x)},${number(p.y)}`).join(" ")}" fill="none" stroke="${color}" stroke-width="${w}" stroke-linecap="round"/>`;
  };
  // Neighbours with the same colour in the drawing order become one path.
  const paths: string[] = [];
  for (let i = 0; i < seen.length; ) {
    const { color } = seen[i]!;
    let path = "";
    for (; i < seen.length && seen[i]!.color === color; i++) path += outline(seen[i]!);
    paths.push(`<path d="${path}" fill="${color}" stroke="${color}"/>`);
  }
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}">`,
    `<rect width="100%" height="100%" fill="${drawing.ground}"/>`,
    ...drawing.below.map(stroke),
    `<g stroke-width="0.7" stroke-linejoin="round">`, ...paths, `</g>`,
    ...drawing.above.map(stroke),
    `</svg>`,
  ].filter(Boolean).join("\n");
}

// Lines of a floor of squares of `step` m around a point.
export function floorLines(x: number, y: number, reach: number, step: number, color: string): Stroke[] {
  const lines: Stroke[] = [];
  const first = (v: number) => Math.ceil((v - reach) / step) * step;
  for (let at = first(x); at <= x + reach; at += step) lines.push({ points: [new Vector3(at, y - reach, 0), new Vector3(at, y + reach, 0)], color, width: 1 });
  for (let at = first(y); at <= y + reach; at += step) lines.push({ points: [new Vector3(x - reach, at, 0), new Vector3(x + reach, at, 0)], color, width: 1 });
  return lines;
}
