// Meshes of formats other than GLB, in a page without a server: a worker, whose source is part of the page, reads them. A harmful file
// can block or crash only that worker.
import { unpacked } from "../protocol/packed.ts";

const READ = /\.(stl|obj|ply)$/i;
const OTHERS = /\.(3ds|wrl|vrml|dae|gltf)$/i;
const COMPANION = /\.(mtl|png|jpe?g)$/i;
const MOST_ASIDE = 128 * 2 ** 20; // bytes
const LONGEST = 20_000; // ms

export class MeshConverter {
  private readonly packed: string;
  private readonly aside = new Map<string, Uint8Array<ArrayBuffer>>();
  private source: Promise<string> | null = null;

  constructor(packed: string) {
    this.packed = packed;
  }

  // The file in the form in which it is stored; null: it waits for the mesh that names it.
  //
  // throws  an Error whose message has the reason.
  async take(name: string, bytes: Uint8Array<ArrayBuffer>): Promise<{ name: string; bytes: Uint8Array<ArrayBuffer> } | null> {
    if (COMPANION.test(name)) {
      const others = [...this.aside].reduce((sum, [other, { length }]) => sum + (other === name ? 0 : length), 0);
      if (others + bytes.length > MOST_ASIDE) throw new Error("There is no room for files that are converted.");
      this.aside.set(name, bytes);
      return null;
    }
    if (OTHERS.test(name)) throw new Error(`This page reads GLB, STL, OBJ and PLY. Make a GLB of it: armlet mesh convert ${name} ${name.replace(OTHERS, ".glb")}`);
    if (!READ.test(name)) return { name, bytes };
    return { name: name.replace(READ, ".glb"), bytes: new Uint8Array(await this.convert(name, bytes)) };
  }

  private async convert(name: string, bytes: Uint8Array<ArrayBuffer>): Promise<ArrayBuffer> {
    this.source ??= new Response(unpacked(this.packed)).text();
    const address = URL.createObjectURL(new Blob([await this.source], { type: "text/javascript" }));
    const worker = new Worker(address);
    try {
      return await new Promise<ArrayBuffer>((resolve, reject) => {
        setTimeout(() => reject(new Error(`it was not read after ${LONGEST / 1000} s.`)), LONGEST);
        worker.onerror = () => reject(new Error("it needs more memory than there is."));
        worker.onmessage = ({ data }: MessageEvent<{ glb?: ArrayBuffer; why?: string }>) => (data.glb ? resolve(data.glb) : reject(new Error(`${data.why}.`)));
        worker.postMessage({ name, bytes, files: this.aside });
      });
    } finally {
      worker.terminate();
      URL.revokeObjectURL(address);
    }
  }
}

// The converter in this page; null: the laboratory converts.
export function findConverter(): MeshConverter | null {
  const packed = document.getElementById("armlet-converter");
  return packed ? new MeshConverter(packed.textContent) : null;
}
