// Bytes compressed by gzip and written as text (apps/wasm/pack_laboratory.mjs).
import { fromBase85 } from "./base85.ts";

export function unpacked(text: string): ReadableStream<Uint8Array<ArrayBuffer>> {
  return new Blob([fromBase85(text.trim())]).stream().pipeThrough(new DecompressionStream("gzip"));
}
