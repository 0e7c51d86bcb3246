// Cameras as small pyramids that open in their viewing direction, with the picture in the opening if the page has it.
import { BufferGeometry, ClampToEdgeWrapping, DataTexture, DoubleSide, Float32BufferAttribute, Group, LinearFilter, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, RGBAFormat, SRGBColorSpace, Vector3 } from "three";
import type { CameraInfo } from "../protocol/messages.ts";
import type { PictureAnswer } from "../protocol/pictures.ts";
import { carrierFrame } from "../store/carried.ts";
import { multiply } from "../store/kinematics.ts";
import type { Run } from "../store/run.ts";
import type { Palette } from "./palette.ts";
import type { Label } from "./triad.ts";

// The corners of the picture at depth z in the camera's frame: upper left, upper right, lower right, lower left.
export function openingOf({ size: [width, height], focal: [fx, fy], centre: [cx, cy] }: Pick<CameraInfo, "size" | "focal" | "centre">, z: number): [number, number, number][] {
  const at = (x: number, y: number): [number, number, number] => [(z * (x - cx)) / fx, (z * (y - cy)) / fy, z];
  return [at(-0.5, -0.5), at(width - 0.5, -0.5), at(width - 0.5, height - 0.5), at(-0.5, height - 0.5)];
}

// The depth at which the opening has the width `wide`.
export const depthFor = ({ size, focal }: Pick<CameraInfo, "size" | "focal">, wide: number) => (wide * focal[0]) / size[0];

class CameraView {
  readonly group = new Group();
  private readonly lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity: 0.9, toneMapped: false }));
  private readonly picture = new Mesh(new BufferGeometry(), new MeshBasicMaterial({ side: DoubleSide, toneMapped: false }));
  private texture: DataTexture | null = null;
  private shown: PictureAnswer | null = null;

  constructor(info: CameraInfo, wide: number) {
    const corners = openingOf(info, depthFor(info, wide));
    const edges = corners.flatMap((corner, i) => [[0, 0, 0], corner, corner, corners[(i + 1) % 4]!]);
    this.lines.geometry.setAttribute("position", new Float32BufferAttribute(edges.flat(), 3));
    this.picture.geometry.setAttribute("position", new Float32BufferAttribute(corners.flat(), 3));
    this.picture.geometry.setAttribute("uv", new Float32BufferAttribute([0, 0, 1, 0, 1, 1, 0, 1], 2));
    this.picture.geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.picture.visible = false;
    this.group.matrixAutoUpdate = false;
    this.group.add(this.lines, this.picture);
  }

  show(picture: PictureAnswer | null, palette: Palette): void {
    this.lines.material.color.set(palette.accent);
    this.picture.visible = picture !== null;
    if (!picture || picture === this.shown) return;
    this.shown = picture;
    this.texture?.dispose();
    this.texture = new DataTexture(picture.rgba, picture.width, picture.height, RGBAFormat);
    this.texture.colorSpace = SRGBColorSpace;
    this.texture.minFilter = this.texture.magFilter = LinearFilter;
    this.texture.wrapS = this.texture.wrapT = ClampToEdgeWrapping;
    this.texture.needsUpdate = true;
    this.picture.material.map = this.texture;
    this.picture.material.needsUpdate = true;
  }

  dispose(): void {
    this.texture?.dispose();
    for (const part of [this.lines, this.picture]) {
      part.geometry.dispose();
      part.material.dispose();
    }
    this.group.removeFromParent();
  }
}

export class CamerasView {
  readonly group = new Group();
  private views: CameraView[] = [];
  private built = "";

  // The positions of the cameras.
  places(): Vector3[] {
    return this.views.filter(({ group }) => group.visible).map(({ group }) => new Vector3().setFromMatrixPosition(group.matrix));
  }

  // reach  the size of the cell, m.
  place(run: Run, t: number, reach: number, palette: Palette, labels: Label[], named: boolean): void {
    const wide = 0.16 * reach;
    const key = JSON.stringify([run.cameras.map(({ size, focal, centre }) => [size, focal, centre]), wide.toPrecision(3)]);
    if (key !== this.built) {
      this.built = key;
      for (const view of this.views) view.dispose();
      this.views = run.cameras.map((info) => new CameraView(info, wide));
      for (const view of this.views) this.group.add(view.group);
    }
    run.cameras.forEach((info, i) => {
      const view = this.views[i]!;
      const carrier = carrierFrame(run, t, info);
      view.group.visible = carrier !== null;
      if (!carrier) return;
      view.group.matrix.fromArray(multiply(carrier, info.T));
      view.group.matrixWorldNeedsUpdate = true;
      view.show(pictureOf(run, info.name), palette);
      if (named) labels.push({ text: info.name, at: new Vector3().setFromMatrixPosition(view.group.matrix), beside: true });
    });
  }
}

// The picture of a camera that one of the elements shows.
function pictureOf(run: Run, camera: string): PictureAnswer | null {
  const element = run.elements.find((each) => each.kind === "view" && each.camera === camera && run.pictures.get(each.name)?.picture);
  return element ? (run.pictures.get(element.name)?.picture ?? null) : null;
}
