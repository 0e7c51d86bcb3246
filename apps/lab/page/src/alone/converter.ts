// The worker in which a page without a server reads meshes of other formats: it only computes, and can be ended at any time.
import { convert } from "../meshes/convert.ts";
import { Unusable, type Files } from "../meshes/triangles.ts";

const scope = globalThis as unknown as {
  onmessage: ((event: MessageEvent<{ name: string; bytes: Uint8Array<ArrayBuffer>; files: Files }>) => void) | null;
  postMessage(message: { glb: ArrayBuffer } | { why: string }, transfer?: Transferable[]): void;
};

scope.onmessage = ({ data: { name, bytes, files } }) => {
  try {
    const glb = convert(name, bytes, files);
    scope.postMessage({ glb }, [glb]);
  } catch (error) {
    scope.postMessage({ why: error instanceof Unusable ? error.message : "it needs more memory than there is" });
  }
};
