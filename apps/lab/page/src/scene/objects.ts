// The objects of the world at an instant.
import { BufferGeometry, Color, ConeGeometry, CylinderGeometry, DoubleSide, Group, Mesh, PlaneGeometry, SphereGeometry } from "three";
import { RoundedBoxGeometry } from "three/examples/jsm/geometries/RoundedBoxGeometry.js";
import type { ObjectInfo } from "../protocol/messages.ts";
import { poseMatrix } from "../store/kinematics.ts";
import type { Run } from "../store/run.ts";
import { surface, type Surface } from "./surface.ts";

function geometryOf(object: ObjectInfo): BufferGeometry {
  const [a = 0.04, b = 0.04, c = 0.04] = object.size;
  if (object.shape === "sphere") return new SphereGeometry(a, 48, 32);
  if (object.shape === "cylinder") return new CylinderGeometry(a, a, b, 64).rotateX(Math.PI / 2);
  if (object.shape === "cone") return new ConeGeometry(a, b, 64).rotateX(Math.PI / 2);
  if (object.shape === "plane") return new PlaneGeometry(a, b);
  return new RoundedBoxGeometry(a, b, c, 2, Math.min(0.003, 0.06 * Math.min(a, b, c)));
}

// Colours have the names of CSS or are written as there; anything else is grey.
function colorOf(name: string): Color {
  const grey = new Color("#8c939d");
  if (/^#[0-9a-f]{6}$/i.test(name)) return grey.set(name);
  return /^[a-z]+$/i.test(name) && CSS.supports("color", name) ? grey.setStyle(name) : grey;
}

export class ObjectsView {
  readonly group = new Group();
  private meshes: Mesh<BufferGeometry, Surface>[] = [];
  private shown: ObjectInfo[] | null = null;
  private readonly plain: boolean;

  constructor(plain: boolean) {
    this.plain = plain;
  }

  place(run: Run, t: number): void {
    if (this.shown !== run.objects) this.build(run.objects);
    this.meshes.forEach((mesh, i) => {
      const pose = run.objectAt(i, t);
      mesh.visible = pose !== null;
      if (pose) mesh.matrix.fromArray(poseMatrix(pose));
    });
    this.group.updateMatrixWorld(true);
  }

  private build(objects: ObjectInfo[]): void {
    for (const mesh of this.meshes) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
    this.group.clear();
    this.shown = objects;
    this.meshes = objects.map((object) => {
      const material = surface(this.plain, colorOf(object.color), 0.72);
      if (object.shape === "plane") material.side = DoubleSide;
      const mesh = new Mesh(geometryOf(object), material);
      mesh.matrixAutoUpdate = false;
      mesh.castShadow = true;
      mesh.receiveShadow = true;
      mesh.userData["object"] = object.name;
      this.group.add(mesh);
      return mesh;
    });
  }
}
