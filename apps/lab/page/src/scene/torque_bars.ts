// Bars beside the joints: the torque of each motor relative to its limit. They face the camera, have a fixed size on the screen, and are
// never hidden.
import { Group, Mesh, MeshBasicMaterial, PlaneGeometry, Vector3, type PerspectiveCamera } from "three";
import { NEAR } from "../store/run.ts";
import type { Palette } from "./palette.ts";

const HALF = 22; // px: the height of a full bar above and below its middle
const WIDTH = 8;
const STEP = 12; // px from one bar to the next, for joints at the same point of the screen


export interface Bar {
  at: Vector3;
  share: number; // -1 to 1 is within the limit of the motor
}

const plane = new PlaneGeometry(1, 1);

function area(order: number): Mesh<PlaneGeometry, MeshBasicMaterial> {
  const mesh = new Mesh(plane, new MeshBasicMaterial({ transparent: true, depthTest: false, depthWrite: false, toneMapped: false }));
  mesh.renderOrder = order;
  return mesh;
}

class BarView {
  readonly group = new Group();
  readonly at = new Vector3();
  private readonly edge = area(6);
  private readonly ground = area(7);
  private readonly fill = area(8);
  private readonly middle = area(9);

  constructor() {
    this.edge.scale.set(WIDTH + 2, 2 * HALF + 2, 1);
    this.ground.scale.set(WIDTH, 2 * HALF, 1);
    this.middle.scale.set(WIDTH + 4, 1, 1);
    this.group.add(this.edge, this.ground, this.fill, this.middle);
  }

  show(bar: Bar, palette: Palette): void {
    this.at.copy(bar.at);
    const height = HALF * Math.min(1, Math.abs(bar.share));
    this.fill.visible = height > 0.2;
    this.fill.scale.set(WIDTH, height, 1);
    this.fill.position.y = (Math.sign(bar.share) * height) / 2;
    this.fill.material.color.set(Math.abs(bar.share) >= NEAR ? palette.warning : palette.accent);
    this.ground.material.color.set(palette.ground);
    for (const line of [this.edge, this.middle]) line.material.color.set(palette.linkDark);
  }

  dispose(): void {
    for (const mesh of [this.edge, this.ground, this.fill, this.middle]) mesh.material.dispose();
    this.group.removeFromParent();
  }
}

export class TorqueBars {
  readonly group = new Group();
  private bars: BarView[] = [];

  show(bars: readonly Bar[], palette: Palette): void {
    while (this.bars.length > bars.length) this.bars.pop()!.dispose();
    bars.forEach((bar, i) => {
      const view = (this.bars[i] ??= new BarView());
      if (!view.group.parent) this.group.add(view.group);
      view.show(bar, palette);
    });
  }

  // Called before each picture, which is `height` px high.
  face(camera: PerspectiveCamera, height: number): void {
    const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
    const forward = camera.getWorldDirection(new Vector3());
    const seen: Vector3[] = [];
    for (const bar of this.bars) {
      const depth = bar.at.clone().sub(camera.position).dot(forward);
      const pixel = (2 * Math.max(depth, camera.near) * Math.tan((camera.fov * Math.PI) / 360)) / Math.max(1, height);
      let at = bar.at.clone().addScaledVector(right, 2 * STEP * pixel);
      // Joints of a wrist are close together: their bars are drawn side by side.
      while (seen.some((other) => other.distanceTo(at) < 0.9 * STEP * pixel)) at = at.addScaledVector(right, STEP * pixel);
      seen.push(at);
      bar.group.position.copy(at);
      bar.group.quaternion.copy(camera.quaternion);
      bar.group.scale.setScalar(pixel);
    }
    this.group.updateMatrixWorld(true);
  }
}
