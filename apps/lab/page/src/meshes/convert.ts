// STL, OBJ and PLY as GLB.
import { readObj } from "./obj.ts";
import { readPly } from "./ply.ts";
import { readStl } from "./stl.ts";
import { refuse, Triangles, type Files } from "./triangles.ts";

const READERS = { stl: readStl, obj: readObj, ply: readPly };

// throws  Unusable with what is wrong, as a sentence without an end.
export function convert(name: string, bytes: Uint8Array<ArrayBuffer>, files: Files): ArrayBuffer {
  const read = READERS[name.split(".").at(-1)!.toLowerCase() as keyof typeof READERS];
  if (!read) refuse("it is none of STL, OBJ and PLY");
  const triangles = new Triangles(files);
  read(bytes, triangles);
  return triangles.finish(name);
}
