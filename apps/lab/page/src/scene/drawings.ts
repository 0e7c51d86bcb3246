// Drawings of a program: arrows, lines, texts, disks, ellipsoids and capsules.
//
// All drawings of one form are instances of one mesh, so that thousands cost little more than one.
import {
  CircleGeometry, Color, ConeGeometry, CylinderGeometry, DoubleSide, Group, InstancedMesh, Matrix4, Mesh, SphereGeometry, Vector3, type BufferGeometry,
} from "three";
import type { DrawingInfo, Matrix } from "../protocol/messages.ts";
import { carrierFrame } from "../store/carried.ts";
import { multiply, poseMatrix } from "../store/kinematics.ts";
import type { Run } from "../store/run.ts";
import { colorOf } from "./objects.ts";
import { surface, type Surface } from "./surface.ts";
import type { Label } from "./triad.ts";

const HALF = Math.PI / 2;
// Of unit size, along z: from 0 to 1, or about the origin.
const FORMS = {
  rod: () => new CylinderGeometry(1, 1, 1, 10).rotateX(HALF).translate(0, 0, 0.5),
  head: () => new ConeGeometry(1, 1, 16).rotateX(HALF).translate(0, 0, 0.5),
  disk: () => new CircleGeometry(1, 48),
  ball: () => new SphereGeometry(1, 32, 20).rotateX(HALF),
  wall: () => new CylinderGeometry(1, 1, 1, 32, 1, true).rotateX(HALF).translate(0, 0, 0.5),
  cap: () => new SphereGeometry(1, 32, 10, 0, 2 * Math.PI, 0, HALF).rotateX(HALF),
} satisfies Record<string, () => BufferGeometry>;
type Form = keyof typeof FORMS;

const SEEN_THROUGH = new Set<Form>(["disk", "ball", "wall", "cap"]);
const OPACITY = 0.45;
// The head of an arrow in units of its width, and its largest fraction of the length.
const HEAD_LONG = 3.2;
const HEAD_WIDE = 1.3;
const HEAD_MOST = 0.5;

class Copies {
  mesh: InstancedMesh<BufferGeometry, Surface>;
  private readonly geometry: BufferGeometry;
  private readonly material: Surface;

  constructor(form: Form, plain: boolean) {
    this.geometry = FORMS[form]();
    const through = SEEN_THROUGH.has(form) ? { transparent: true, opacity: OPACITY, depthWrite: false, side: DoubleSide } : {};
    this.material = surface(plain, "#ffffff", 0.6, 0, through);
    this.mesh = this.make(64);
  }

  private make(most: number): InstancedMesh<BufferGeometry, Surface> {
    const mesh = new InstancedMesh(this.geometry, this.material, most);
    mesh.frustumCulled = false;
    mesh.count = 0;
    return mesh;
  }

  add(frame: Matrix4, color: Color): void {
    const i = this.mesh.count;
    if (i === this.mesh.instanceMatrix.count) {
      const larger = this.make(2 * i);
      larger.instanceMatrix.array.set(this.mesh.instanceMatrix.array);
      larger.setColorAt(0, color); // allocates memory for colours
      if (this.mesh.instanceColor) larger.instanceColor!.array.set(this.mesh.instanceColor.array);
      this.mesh.parent?.add(larger);
      this.mesh.removeFromParent();
      this.mesh.dispose();
      this.mesh = larger;
    }
    this.mesh.count = i + 1;
    this.mesh.setMatrixAt(i, frame);
    this.mesh.setColorAt(i, color);
  }

  shown(): void {
    this.mesh.visible = this.mesh.count > 0;
    this.mesh.instanceMatrix.needsUpdate = true;
    if (this.mesh.instanceColor) this.mesh.instanceColor.needsUpdate = true;
  }
}

export class DrawingsView {
  readonly group = new Group();
  private readonly copies = new Map<Form, Copies>();
  private readonly plain: boolean;
  private readonly colors = new Map<string, Color>();

  constructor(plain: boolean) {
    this.plain = plain;
  }

  place(run: Run, t: number, labels: Label[]): void {
    for (const copies of this.copies.values()) copies.mesh.count = 0;
    const frames = new Map<string, Matrix | null>();
    run.drawings.forEach((info, number) => {
      const row = run.drawingRows.rowAt(number, t);
      if (row < 0) return;
      const base = this.frameOf(run, t, info, frames);
      if (!base) return;
      const at = (column: number) => run.drawingRows.at(row, column);
      const frame = new Matrix4().fromArray(multiply(base, poseMatrix([2, 3, 4, 5, 6, 7, 8].map(at))));
      this.show(info, frame, [at(9), at(10), at(11)], labels);
    });
    for (const copies of this.copies.values()) copies.shown();
    this.group.updateMatrixWorld(true);
  }

  // Each instance as a mesh of its own, for vector pictures.
  meshes(): Group {
    const group = new Group();
    const color = new Color();
    for (const { mesh: copies } of this.copies.values()) {
      for (let i = 0; i < copies.count; i++) {
        copies.getColorAt(i, color);
        const mesh = new Mesh(copies.geometry, surface(true, color, 0.6, 0, { side: copies.material.side }));
        mesh.matrixAutoUpdate = false;
        copies.getMatrixAt(i, mesh.matrix);
        group.add(mesh);
      }
    }
    group.updateMatrixWorld(true);
    return group;
  }

  private show(info: DrawingInfo, frame: Matrix4, [a, b, c]: [number, number, number], labels: Label[]): void {
    const color = this.colorOf(info.color);
    // An instance with the widths x, y and z, and its origin at `along` on z.
    const add = (form: Form, x: number, y: number, z: number, along = 0, turned = false) => {
      const copy = frame.clone();
      if (along) copy.multiply(new Matrix4().makeTranslation(0, 0, along));
      if (turned) copy.multiply(new Matrix4().makeRotationX(Math.PI));
      this.copiesOf(form).add(copy.scale(new Vector3(x, y, z)), color);
    };
    if (info.kind === "arrow") {
      const head = Math.min(HEAD_LONG * b, HEAD_MOST * a);
      add("rod", b / 2, b / 2, a - 0.9 * head);
      const wide = (HEAD_WIDE * b * head) / (HEAD_LONG * b);
      add("head", Math.max(wide, 0.75 * b), Math.max(wide, 0.75 * b), head, a - head);
    } else if (info.kind === "line") add("rod", b / 2, b / 2, a);
    else if (info.kind === "disk") add("disk", a, a, 1);
    else if (info.kind === "ellipsoid") add("ball", a, b, c);
    else if (info.kind === "capsule") {
      add("wall", a, a, b);
      add("cap", a, a, a, b);
      add("cap", a, a, a, 0, true);
    } else if (info.kind === "text") labels.push({ text: info.text, at: new Vector3().setFromMatrixPosition(frame), height: a, color: `#${color.getHexString()}` });
  }

  private copiesOf(form: Form): Copies {
    let copies = this.copies.get(form);
    if (!copies) {
      this.copies.set(form, (copies = new Copies(form, this.plain)));
      this.group.add(copies.mesh);
    }
    return copies;
  }

  private colorOf(name: string): Color {
    let color = this.colors.get(name);
    if (!color) this.colors.set(name, (color = colorOf(name)));
    return color;
  }

  // The frame in the world that carries a drawing; null: it does not exist. `known` stores the frames of this instant.
  private frameOf(run: Run, t: number, info: DrawingInfo, known: Map<string, Matrix | null>): Matrix | null {
    const key = info.robot === null ? `on ${info.object}` : `${info.robot} ${info.link}`;
    const found = known.get(key);
    if (found !== undefined) return found;
    const frame = carrierFrame(run, t, info);
    known.set(key, frame);
    return frame;
  }
}
