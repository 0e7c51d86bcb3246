// Relations between bodies: clearances, contacts and overlaps, and contact forces.
import {
  ConeGeometry, CylinderGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, SphereGeometry, Vector3, type BufferGeometry, type Object3D, type PerspectiveCamera,
} from "three";
import { Line2 } from "three/examples/jsm/lines/Line2.js";
import { LineGeometry } from "three/examples/jsm/lines/LineGeometry.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import type { NearBody, NearPair } from "../protocol/messages.ts";
import { SOFT, overlaps, textOf } from "./near.ts";
import type { Palette } from "./palette.ts";
import type { Label } from "./triad.ts";

const over = (opacity = 1) => new MeshBasicMaterial({ transparent: true, opacity, depthTest: false, depthWrite: false, toneMapped: false });

// Lengths on the screen, px.
const DOT = 4;
const SHAFT = 2.5;
const HEAD = [7, 18] as const;

// A line between the nearest points of two bodies, and both bodies coloured if they touch.
export class Clearances {
  readonly group = new Group();
  private readonly dots: Mesh<SphereGeometry, MeshBasicMaterial>[] = [];
  private readonly sphere = new SphereGeometry(1, 16, 12);
  private tints: Mesh[] = [];
  private materials: MeshBasicMaterial[] = [];
  private lines: Line2[] = [];
  private key = "";

  // partOf  the drawn group of a body; null: it is not drawn.
  show(pairs: readonly NearPair[], palette: Palette, partOf: (body: NearBody) => Object3D | null, labels: Label[]): void {
    const key = JSON.stringify(pairs) + palette.accent;
    for (const pair of pairs) {
      const [a, b] = [new Vector3(...pair.body.at), new Vector3(...pair.other.at)];
      labels.push({ text: textOf(pair), at: a.lerp(b, 0.5), warning: overlaps(pair) });
    }
    if (key !== this.key) this.build(pairs, palette);
    this.key = key;
    this.tint(pairs, palette, partOf);
  }

  private build(pairs: readonly NearPair[], palette: Palette): void {
    for (const line of this.lines) {
      line.geometry.dispose();
      line.material.dispose();
    }
    for (const old of [...this.lines, ...this.dots]) old.removeFromParent();
    this.lines = pairs.map((pair) => {
      const geometry = new LineGeometry();
      geometry.setPositions([...pair.body.at, ...pair.other.at]);
      const line = new Line2(geometry, new LineMaterial({ linewidth: 2, depthTest: false, depthWrite: false, transparent: true, toneMapped: false }));
      line.material.color.set(overlaps(pair) ? palette.warning : palette.accent);
      line.frustumCulled = false;
      line.renderOrder = 6;
      return line;
    });
    pairs.flatMap((pair) => [pair.body.at, pair.other.at]).forEach((at, i) => {
      const dot = (this.dots[i] ??= new Mesh(this.sphere, over()));
      dot.renderOrder = 6;
      dot.material.color.set(overlaps(pairs[i >> 1]!) ? palette.warning : palette.accent);
      dot.position.set(...at);
      this.group.add(dot);
    });
    for (const line of this.lines) this.group.add(line);
  }

  // Draws both bodies of a pair again, in a transparent colour.
  private tint(pairs: readonly NearPair[], palette: Palette, partOf: (body: NearBody) => Object3D | null): void {
    for (const tint of this.tints) tint.removeFromParent();
    for (const material of this.materials) material.dispose();
    this.tints = [];
    this.materials = [];
    for (const pair of pairs) {
      if (pair.distance > SOFT) continue;
      const material = new MeshBasicMaterial({
        transparent: true, opacity: overlaps(pair) ? 0.5 : 0.28, depthWrite: false, toneMapped: false, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -4,
      });
      material.color.set(overlaps(pair) ? palette.warning : palette.accent);
      this.materials.push(material);
      for (const body of [pair.body, pair.other]) {
        partOf(body)?.traverseVisible((node) => {
          if (!(node instanceof Mesh)) return;
          const tinted = new Mesh(node.geometry as BufferGeometry, material);
          tinted.matrixAutoUpdate = false;
          tinted.matrix.copy(node.matrixWorld);
          tinted.renderOrder = 2;
          this.tints.push(tinted);
        });
      }
    }
    for (const tint of this.tints) this.group.add(tint);
    this.group.updateMatrixWorld(true);
  }

  // Called before each picture: `pixel` returns the size of a pixel at a point, m.
  face(pixel: (at: Vector3) => number): void {
    for (const dot of this.dots) dot.scale.setScalar(DOT * pixel(dot.position));
    this.group.updateMatrixWorld(true);
  }
}

// A force at a point; its length on the screen shows its magnitude.
export interface Force {
  at: Vector3;
  force: Vector3; // N
  share: number; // of the largest force of the run, 0 to 1
  on?: string; // the pressed body at this point; missing: the whole contact force of the tool
}

const LONGEST = 0.35; // of the size of the cell
const SHORTEST = 0.08;

class ArrowView {
  readonly group = new Group();
  private readonly shaft = new Mesh(new CylinderGeometry(1, 1, 1, 12).translate(0, 0.5, 0), over(0.95));
  private readonly head = new Mesh(new ConeGeometry(1, 1, 20).translate(0, -0.5, 0), over(0.95));
  private readonly dot = new Mesh(new SphereGeometry(1, 12, 8), over(0.95));
  private length = 0;
  private slender = 1;

  constructor() {
    this.shaft.renderOrder = this.head.renderOrder = this.dot.renderOrder = 6;
    this.group.add(this.shaft, this.head, this.dot);
  }

  show({ at, force, share, on }: Force, reach: number, color: string): void {
    this.slender = on === undefined ? 1 : 0.6;
    this.dot.visible = on !== undefined;
    this.length = this.slender * reach * (SHORTEST + (LONGEST - SHORTEST) * Math.min(1, share));
    this.group.position.copy(at);
    this.group.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), force.clone().normalize());
    for (const mesh of [this.shaft, this.head, this.dot]) mesh.material.color.set(color);
  }

  end(): Vector3 {
    return new Vector3(0, this.length, 0).applyQuaternion(this.group.quaternion).add(this.group.position);
  }

  face(pixel: (at: Vector3) => number): void {
    const size = this.slender * pixel(this.group.position);
    this.dot.scale.setScalar(DOT * size);
    const head = Math.min(HEAD[1] * size, 0.6 * this.length);
    this.head.position.set(0, this.length, 0);
    this.head.scale.set((HEAD[0] * head) / HEAD[1], head, (HEAD[0] * head) / HEAD[1]);
    this.shaft.scale.set(SHAFT * size, this.length - 0.9 * head, SHAFT * size);
  }

  dispose(): void {
    for (const mesh of [this.shaft, this.head, this.dot]) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
    this.group.removeFromParent();
  }
}

export class Forces {
  readonly group = new Group();
  private arrows: ArrowView[] = [];

  // named  whether each contact point has the name of the pressed body.
  show(forces: readonly Force[], named: boolean, reach: number, palette: Palette, labels: Label[]): void {
    while (this.arrows.length > forces.length) this.arrows.pop()!.dispose();
    forces.forEach((force, i) => {
      const arrow = (this.arrows[i] ??= new ArrowView());
      if (!arrow.group.parent) this.group.add(arrow.group);
      arrow.show(force, reach, palette.force);
      const size = force.force.length();
      if (force.on === undefined || named) labels.push({ text: `${size.toFixed(size < 10 ? 1 : 0)} N${force.on ? ` on ${force.on}` : ""}`, at: arrow.end(), beside: true });
    });
  }

  face(pixel: (at: Vector3) => number): void {
    for (const arrow of this.arrows) arrow.face(pixel);
    this.group.updateMatrixWorld(true);
  }
}

// The size of a pixel of a picture with this height at a point, m.
export function pixelSize(camera: PerspectiveCamera, height: number): (at: Vector3) => number {
  const forward = camera.getWorldDirection(new Vector3());
  return (at) => {
    const depth = Math.max(at.clone().sub(camera.position).dot(forward), camera.near);
    return (2 * depth * Math.tan((camera.fov * Math.PI) / 360)) / Math.max(1, height);
  };
}
