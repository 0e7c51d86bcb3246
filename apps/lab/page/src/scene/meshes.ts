// Meshes and pictures from files, as three.js draws them. Each file is read once; all drawings of it share its geometry.
import {
  CanvasTexture, Group, LoadingManager, Mesh, MeshLambertMaterial, MeshStandardMaterial, SRGBColorSpace, type BufferGeometry, type Material, type Object3D, type Texture,
} from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { decoded } from "../meshes/picture.ts";
import { onlyShapes } from "./safe_glb.ts";

const KEPT = 32; // files that stay loaded although nothing shows them

// A mesh from a file, z up. If the file has no materials, neither has the mesh.
export interface Model {
  group: Group;
  hasMaterials: boolean;
}
type Entry<T> = { value: T | null; ready: Promise<T | null> };

// Metallic glTF materials reflect their surroundings, of which there are none here: they would be black.
function calm(material: Material, plain: boolean): Material {
  if (!(material instanceof MeshStandardMaterial)) return material;
  if (!plain) {
    material.metalness = Math.min(material.metalness, 0.3);
    material.roughness = Math.max(material.roughness, 0.35);
    material.metalnessMap = material.roughnessMap = null;
    return material;
  }
  const { color, map, emissive, emissiveMap, vertexColors, side, transparent, opacity, alphaTest, name } = material;
  return new MeshLambertMaterial({ color, map, emissive, emissiveMap, vertexColors, side, transparent, opacity, alphaTest, name });
}

export async function readModel(bytes: ArrayBuffer, plain: boolean): Promise<Model> {
  const manager = new LoadingManager();
  manager.setURLModifier((address) => (/^(blob|data):/.test(address) ? address : "data:,"));
  const { scene, parser } = await new GLTFLoader(manager).register(onlyShapes).parseAsync(bytes, "");
  const group = new Group();
  group.rotation.x = Math.PI / 2; // y is up in the file
  group.add(scene);
  group.updateMatrixWorld(true);
  const known = new Map<Material, Material>();
  const others: Object3D[] = [];
  group.traverse((node) => {
    if (!(node instanceof Mesh)) {
      if ("isLine" in node || "isPoints" in node || "isLight" in node) others.push(node);
      return;
    }
    const mesh = node as Mesh<BufferGeometry, Material>;
    if (!mesh.geometry.hasAttribute("normal")) {
      // Then every triangle is flat (glTF 2.0 specification, 3.7.2.1), and needs corners of its own.
      if (mesh.geometry.index) mesh.geometry = mesh.geometry.toNonIndexed();
      mesh.geometry.computeVertexNormals();
    }
    const { material } = mesh;
    if (!known.has(material)) known.set(material, calm(material, plain));
    mesh.material = known.get(material)!;
    mesh.castShadow = mesh.receiveShadow = true;
    mesh.userData = { shared: true };
  });
  for (const node of others) node.removeFromParent();
  return { group, hasMaterials: Boolean(parser.json.materials?.length) };
}

export class MeshLibrary {
  private readonly models = new Map<string, Entry<Model>>();
  private readonly textures = new Map<string, Entry<Texture>>();
  private readonly file: (name: string) => Promise<ArrayBuffer>;
  private readonly plain: boolean;
  // Called when a file was loaded.
  changed: () => void = () => {};

  constructor(file: (name: string) => Promise<ArrayBuffer>, plain: boolean) {
    this.file = file;
    this.plain = plain;
  }

  // Null: it is not loaded yet, or cannot be shown.
  model(name: string): Model | null {
    return this.entry(this.models, name, async (bytes) => readModel(bytes, this.plain)).value;
  }

  texture(name: string): Texture | null {
    return this.entry(this.textures, name, async (bytes) => {
      const bitmap = await decoded(new Uint8Array(bytes));
      if (!bitmap) return null;
      const texture = new CanvasTexture(bitmap as unknown as HTMLCanvasElement);
      texture.flipY = false; // the picture is flipped already
      texture.colorSpace = SRGBColorSpace;
      texture.anisotropy = 8;
      return texture;
    }).value;
  }

  // Resolves when all requested files have been read.
  async settled(): Promise<void> {
    await Promise.all([...this.models.values(), ...this.textures.values()].map((entry) => entry.ready));
  }

  // Removes the files that were requested least recently.
  private entry<T extends Model | Texture>(map: Map<string, Entry<T>>, name: string, read: (bytes: ArrayBuffer) => Promise<T | null>): Entry<T> {
    let entry = map.get(name);
    if (!entry) {
      const made: Entry<T> = { value: null, ready: Promise.resolve(null) };
      made.ready = this.file(name).then(read).catch(() => null).then((value) => {
        made.value = value;
        if (value) this.changed();
        return value;
      });
      entry = made;
    } else map.delete(name);
    map.set(name, entry); // the newest last
    for (const [old, { value }] of map) {
      if (map.size <= KEPT) break;
      map.delete(old);
      if (value && "dispose" in value) value.dispose();
      else if (value) value.group.traverse((node) => node instanceof Mesh && (node.geometry as BufferGeometry).dispose());
    }
    return entry;
  }
}
