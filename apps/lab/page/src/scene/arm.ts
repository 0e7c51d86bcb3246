// An arm made of the shapes in its description, drawn at given joint values.
import {
  BufferAttribute, BufferGeometry, CapsuleGeometry, Color, CylinderGeometry, DoubleSide, Group, Matrix4, Mesh, Vector3,
} from "three";
import { RoundedBoxGeometry } from "three/examples/jsm/geometries/RoundedBoxGeometry.js";
import type { RobotChange, RobotInfo, Shape } from "../protocol/messages.ts";
import { jointsAtLimits, rowsOf, shapeFrames } from "../store/kinematics.ts";
import { footprintOf, type Footprint } from "./contact.ts";
import type { MeshLibrary } from "./meshes.ts";
import type { Palette } from "./palette.ts";
import { surface, type Surface } from "./surface.ts";

const NONE: Shape[] = [];
const ROUND = 48; // faces of a full circle

// A cylinder about z with slightly rounded edges, which reflect the light.
function turned(round: number, radius: number, length: number, inner = 0): BufferGeometry {
  const bevel = Math.min(0.12 * radius, 0.12 * length, 0.004, inner ? 0.4 * (radius - inner) : Infinity);
  const h = length / 2;
  const profile: [number, number][] = [
    [inner, -h], [radius - bevel, -h], [radius - 0.3 * bevel, -h + 0.3 * bevel], [radius, -h + bevel],
    [radius, h - bevel], [radius - 0.3 * bevel, h - 0.3 * bevel], [radius - bevel, h], [inner, h],
  ];
  if (inner) profile.push([inner, -h]);
  return aroundZ(profile, round);
}

// The surface that a profile of radii and heights makes when it rotates about z: smooth around z, with an edge at each point of the
// profile.
function aroundZ(profile: readonly [number, number][], round: number): BufferGeometry {
  const stretches = profile.length - 1;
  const rows = 2 * stretches * (round + 1);
  const position = new Float32Array(3 * rows);
  const normal = new Float32Array(3 * rows);
  const index = new Uint16Array(6 * stretches * round);
  let at = 0;
  let corner = 0;
  for (let s = 0; s < stretches; s++) {
    const [from, to] = [profile[s]!, profile[s + 1]!];
    const long = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
    const [out, up] = [(to[1] - from[1]) / long, (from[0] - to[0]) / long];
    for (let k = 0; k <= round; k++) {
      const angle = (2 * Math.PI * k) / round;
      const [x, y] = [Math.cos(angle), Math.sin(angle)];
      for (const [distance, height] of [from, to]) {
        position.set([x * distance, y * distance, height], 3 * at);
        normal.set([x * out, y * out, up], 3 * at++);
      }
      if (k === round) continue;
      index.set([at - 2, at, at - 1, at, at + 1, at - 1], corner);
      corner += 6;
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(position, 3));
  geometry.setAttribute("normal", new BufferAttribute(normal, 3));
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

function geometryOf(shape: Shape, round: number): BufferGeometry {
  const radius = shape.radius ?? 0.02;
  const length = shape.length ?? 0.05;
  switch (shape.kind) {
    case "box": {
      const [x = 0.05, y = 0.05, z = 0.05] = shape.size ?? [];
      return new RoundedBoxGeometry(x, y, z, round < ROUND ? 1 : 3, 0.18 * Math.min(x, y, z));
    }
    case "capsule":
      return new CapsuleGeometry(radius, length, Math.ceil(round / 4), round).rotateX(Math.PI / 2);
    case "ring":
      return turned(round, radius, length, Math.max(1e-4, radius - (shape.thickness ?? 0.3 * radius)));
    case "cylinder":
      return turned(round, radius, length);
    default:
      return new CylinderGeometry(radius, radius, length, round).rotateX(Math.PI / 2);
  }
}

// The body of a joint covers the round end of the link before it, which may be thicker: it is drawn longer, with its marks at its ends.
function covering(shapes: readonly Shape[]): Shape[] {
  return shapes.map((shape) => {
    const joint = shapes.find((each) => each.link === shape.link && each.role === "joint" && each.T[14] === 0);
    const before = shapes.filter((each) => each.link === shape.link - 1 && each.kind === "capsule");
    const more = joint ? Math.max(...before.map((each) => 1.03 * (each.radius ?? 0))) - (joint.length ?? 0) / 2 : 0;
    if (more <= 0) return shape;
    if (shape === joint) return { ...shape, length: (shape.length ?? 0) + 2 * more };
    return shape.role === "mark" ? { ...shape, T: shape.T.with(14, shape.T[14]! + Math.sign(shape.T[14]!) * more) } : shape;
  });
}

const DARK_ROLES = new Set(["base", "joint", "flange"]);

export class ArmView {
  readonly group = new Group();
  private readonly links: Group[] = [];
  private readonly marks: { link: number; material: Surface }[] = [];
  private readonly robot: RobotInfo;
  private readonly palette: Palette;
  private readonly ghost: boolean;
  private readonly round: number;
  private readonly opacity: number;
  private readonly library: MeshLibrary | null;
  private shapes: Shape[] | null = null;
  // Links whose pictures are loaded; the shapes that replaced them are not drawn.
  private pictured = new Map<number, Group>();
  private fingers: Mesh[] = [];
  // Whether it is drawn as the simplified shapes used for collision checks.
  asSolids = false;

  // round    faces of a full circle; few of them for drawings.
  // library  provides the pictures of links; without it shapes are drawn.
  // opacity  of a transparent copy.
  constructor(robot: RobotInfo, palette: Palette, ghost: boolean, { round = ROUND, library = null, opacity = 0.3 }: { round?: number; library?: MeshLibrary | null; opacity?: number } = {}) {
    this.robot = robot;
    this.palette = palette;
    this.ghost = ghost;
    this.round = round;
    this.library = library;
    this.opacity = opacity;
    for (let i = 0; i < rowsOf(robot).length + 2; i++) {
      const link = new Group();
      link.matrixAutoUpdate = false;
      this.links.push(link);
      this.group.add(link);
    }
    this.build(robot.shapes);
  }

  // Draws the arm at the joint values `q`.
  stand(q: readonly number[], change?: RobotChange): void {
    const solids = this.asSolids ? (change?.solids ?? this.robot.solids ?? NONE) : NONE;
    const areSolids = solids.length > 0 || (this.asSolids && (this.robot.pictures ?? []).some((each) => each.use === "collision"));
    this.build(areSolids ? solids : (change?.shapes ?? this.robot.shapes), areSolids);
    this.takePictures(areSolids ? "collision" : "picture");
    const frames = shapeFrames(this.robot, q, change?.T_world_base);
    frames.forEach((frame, i) => this.links[i]?.matrix.fromArray(frame));
    this.group.updateMatrixWorld(true);
    const limits = jointsAtLimits(this.robot, q);
    const rows = rowsOf(this.robot);
    for (const mark of this.marks) {
      const near = limits[rows[mark.link]?.joint ?? mark.link] ?? false;
      mark.material.color.set(near ? this.palette.warning : this.palette.accent);
      mark.material.emissive.set(near ? this.palette.warning : "#000000");
      mark.material.emissiveIntensity = near ? 0.35 : 0;
    }
  }

  // The direction from finger to finger in the world; null: it has no two fingers.
  fingersAlong(): Vector3 | null {
    const [one, other] = this.fingers;
    if (!one?.parent || !other) return null;
    const place = (mesh: Mesh) => new Vector3().setFromMatrixPosition(mesh.matrix);
    return place(other).sub(place(one)).transformDirection(one.parent.matrixWorld);
  }

  // Moves each finger `inward` m from its position in the description towards the other one.
  closeFingers(inward: number): void {
    const shapes = this.shapes?.filter((shape) => shape.role.startsWith("finger_")) ?? [];
    if (this.fingers.length !== 2) return;
    const [one, other] = this.fingers.map((mesh, i) => new Vector3().setFromMatrixPosition(mesh.matrix.fromArray(shapes[i]!.T))) as [Vector3, Vector3];
    const step = other.clone().sub(one).setLength(Math.min(inward, 0.5 * one.distanceTo(other)));
    this.fingers[0]!.matrix.setPosition(one.add(step));
    this.fingers[1]!.matrix.setPosition(other.sub(step));
    this.group.updateMatrixWorld(true);
  }

  // The parts of the base that stand on the floor.
  footprints(): Footprint[] {
    if ((this.robot.on ?? -1) >= 0) return [];
    const frame = this.frameOf(0);
    return (this.shapes ?? []).filter((shape) => shape.link === 0 && shape.role !== "mark").map((shape) => {
      const [radius, length] = [shape.radius ?? 0.02, shape.length ?? 0.05];
      const half: [number, number, number] = shape.kind === "box"
        ? [0, 1, 2].map((k) => (shape.size?.[k] ?? 0.05) / 2) as [number, number, number]
        : [radius, radius, length / 2 + (shape.kind === "capsule" ? radius : 0)];
      return footprintOf(frame.clone().multiply(new Matrix4().fromArray(shape.T)).elements, half, shape.kind !== "box");
    });
  }

  frameOf(link: number): Matrix4 {
    return this.links[link]?.matrix ?? new Matrix4();
  }

  // The drawn group of a link.
  linkOf(link: number): Group | null {
    return this.links[link] ?? null;
  }

  dispose(): void {
    this.group.traverse((node) => {
      if (!(node instanceof Mesh) || node.userData["shared"]) return;
      (node.geometry as BufferGeometry).dispose();
      (node.material as Surface).dispose();
    });
    this.group.removeFromParent();
  }

  private build(shapes: Shape[], areSolids = false): void {
    if (shapes === this.shapes) return;
    this.shapes = shapes;
    this.marks.length = 0;
    this.fingers = [];
    for (const link of this.links) link.clear();
    this.pictured.clear();
    for (const shape of areSolids ? shapes : covering(shapes)) {
      const mesh = new Mesh(geometryOf(shape, this.round), this.materialOf(shape));
      mesh.matrixAutoUpdate = false;
      mesh.matrix.fromArray(shape.T);
      mesh.castShadow = !this.ghost;
      mesh.receiveShadow = !this.ghost;
      mesh.userData["robot"] = this.robot.name;
      mesh.userData["given"] = shape.given === true;
      this.links[shape.link]?.add(mesh);
      if (shape.role.startsWith("finger_")) this.fingers.push(mesh);
      if (shape.role === "mark" && !this.ghost) this.marks.push({ link: shape.link - 1, material: mesh.material });
    }
  }

  // Replaces the shapes of links by pictures that were loaded since, for this use or for both.
  private takePictures(wanted: "picture" | "collision"): void {
    for (const { link, file, T, use = wanted } of this.robot.pictures ?? []) {
      if (use !== wanted) continue;
      const host = this.links[link];
      const model = host && this.library?.model(file);
      if (!host || !model) continue;
      let place = this.pictured.get(link);
      if (!place) {
        this.pictured.set(link, (place = new Group()));
        for (const shape of host.children) shape.visible = wanted === "collision" || shape.userData["given"] === true;
        host.add(place);
      }
      if (place.children.some((each) => each.userData["file"] === file && each.userData["T"] === T)) continue;
      const frame = new Group();
      frame.userData = { file, T };
      frame.matrixAutoUpdate = false;
      frame.matrix.fromArray(T);
      frame.add(model.group.clone());
      const plain = this.ghost || !model.hasMaterials ? this.surfaceOf("link", false) : null;
      frame.traverse((node) => {
        if (!(node instanceof Mesh)) return;
        if (plain) node.material = plain;
        node.castShadow = node.receiveShadow = !this.ghost;
        node.userData["robot"] = this.robot.name;
      });
      place.add(frame);
    }
  }

  private materialOf(shape: Shape): Surface {
    return this.surfaceOf(shape.role, shape.kind === "ring");
  }

  private surfaceOf(role: string, isRing: boolean): Surface {
    const { palette } = this;
    if (this.ghost) {
      return surface(palette.plain, palette.ghost, 0.8, 0, { transparent: true, opacity: this.opacity, depthWrite: false, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 8 });
    }
    const color = role === "mark" ? palette.accent : DARK_ROLES.has(role) ? palette.linkDark : role === "link" ? palette.link : palette.tool;
    return surface(palette.plain, new Color(color), role === "link" ? 0.42 : 0.55, role === "link" || role === "mark" ? 0 : 0.1, {
      ...(isRing ? { side: DoubleSide } : {}),
      // Rings are drawn on the part that they mark, also at equal depth.
      ...(role === "mark" ? { polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1 } : {}),
    });
  }
}
