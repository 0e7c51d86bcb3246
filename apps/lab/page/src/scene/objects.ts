// The objects of the world at an instant.
import {
  BoxGeometry, BufferGeometry, Color, ConeGeometry, CylinderGeometry, DoubleSide, Group, Mesh, PlaneGeometry, SphereGeometry, type Texture,
} from "three";
import { RoundedBoxGeometry } from "three/examples/jsm/geometries/RoundedBoxGeometry.js";
import type { ObjectInfo } from "../protocol/messages.ts";
import { poseMatrix } from "../store/kinematics.ts";
import type { Run } from "../store/run.ts";
import type { MeshLibrary, Model } from "./meshes.ts";
import { surface, type Surface } from "./surface.ts";

const TOP = 4; // the face of a box towards +z

// A picture on a box has its lower left corner at -x, -y; on a round object it goes once around, upright along z.
function geometryOf(object: ObjectInfo): BufferGeometry {
  const [a = 0.04, b = 0.04, c = 0.04] = object.size;
  if (object.shape === "sphere") return new SphereGeometry(a, 48, 32).rotateX(Math.PI / 2);
  if (object.shape === "cylinder") return new CylinderGeometry(a, a, b, 64).rotateX(Math.PI / 2);
  if (object.shape === "cone") return new ConeGeometry(a, b, 64).rotateX(Math.PI / 2);
  if (object.shape === "plane") return new PlaneGeometry(a, b);
  if (object.texture !== undefined) return new BoxGeometry(a, b, c);
  return new RoundedBoxGeometry(a, b, c, 2, Math.min(0.003, 0.06 * Math.min(a, b, c)));
}

// Colours are names of CSS or in its notation; anything else is grey.
export function colorOf(name: string): Color {
  const grey = new Color("#8c939d");
  if (/^#[0-9a-f]{6}$/i.test(name)) return grey.set(name);
  return /^[a-z]+$/i.test(name) && CSS.supports("color", name) ? grey.setStyle(name) : grey;
}

class ObjectView {
  readonly group = new Group();
  private readonly info: ObjectInfo;
  private readonly plain: boolean;
  private body: Mesh<BufferGeometry, Surface | Surface[]> | null;
  private model: Model | null = null;
  private texture: Texture | null = null;

  constructor(info: ObjectInfo, plain: boolean) {
    this.info = info;
    this.plain = plain;
    this.group.matrixAutoUpdate = false;
    this.body = new Mesh<BufferGeometry, Surface | Surface[]>(geometryOf(info), this.surfaceOf());
    this.body.castShadow = this.body.receiveShadow = true;
    this.body.userData["object"] = info.name;
    this.group.add(this.body);
  }

  private surfaceOf(): Surface {
    const material = surface(this.plain, colorOf(this.info.color), 0.72);
    if (this.info.shape === "plane") material.side = DoubleSide;
    return material;
  }

  // Uses the files of the object that were loaded since.
  take(library: MeshLibrary): void {
    const { file, T, texture, shape, name } = this.info;
    const model = file !== undefined && T && !this.model ? library.model(file) : null;
    if (model && T) {
      this.model = model;
      this.dispose();
      const frame = new Group();
      frame.matrixAutoUpdate = false;
      frame.matrix.fromArray(T);
      frame.add(model.group.clone());
      const own = model.hasMaterials ? null : this.surfaceOf();
      frame.traverse((node) => {
        if (!(node instanceof Mesh)) return;
        if (own) node.material = own;
        node.userData = { ...node.userData, object: name };
      });
      this.group.add(frame);
    }
    const picture = texture !== undefined && !this.texture ? library.texture(texture) : null;
    if (picture && this.body) {
      this.texture = picture;
      const plain = this.body.material as Surface;
      const pictured = this.surfaceOf();
      pictured.color.set("#ffffff");
      pictured.map = picture;
      const faces = shape === "box" ? 6 : shape === "cylinder" ? 3 : 1;
      const shown = shape === "box" ? TOP : 0;
      this.body.material = faces === 1 ? pictured : Array.from({ length: faces }, (_, k) => (k === shown ? pictured : plain));
    }
  }

  dispose(): void {
    this.body?.geometry.dispose();
    for (const material of this.body ? [this.body.material].flat() : []) material.dispose();
    this.body?.removeFromParent();
    this.body = null;
  }
}

export class ObjectsView {
  readonly group = new Group();
  private views: ObjectView[] = [];
  private shown: ObjectInfo[] | null = null;
  private readonly plain: boolean;
  private readonly library: MeshLibrary;

  constructor(plain: boolean, library: MeshLibrary) {
    this.plain = plain;
    this.library = library;
  }

  place(run: Run, t: number): void {
    if (this.shown !== run.objects) this.build(run.objects);
    this.views.forEach((view, i) => {
      const pose = run.objectAt(i, t);
      view.group.visible = pose !== null;
      if (!pose) return;
      view.take(this.library);
      view.group.matrix.fromArray(poseMatrix(pose));
    });
    this.group.updateMatrixWorld(true);
  }

  // The drawn group of an object.
  viewOf(index: number): Group | null {
    return this.views[index]?.group ?? null;
  }

  private build(objects: ObjectInfo[]): void {
    for (const view of this.views) view.dispose();
    this.group.clear();
    this.shown = objects;
    this.views = objects.map((object) => new ObjectView(object, this.plain));
    for (const view of this.views) this.group.add(view.group);
  }
}
