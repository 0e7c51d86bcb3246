// A short program in the address of a page: #p= and the text, compressed with zlib, in base64 for addresses.

const MOST = 32_768; // characters of an address that browsers and mail programs accept

async function through(bytes: Uint8Array<ArrayBuffer>, stream: CompressionStream | DecompressionStream): Promise<Uint8Array<ArrayBuffer>> {
  const piped = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(piped).arrayBuffer());
}

// The part of the address after #, or null if the program is too long for one.
export async function textToHash(text: string): Promise<string | null> {
  const packed = await through(new TextEncoder().encode(text), new CompressionStream("deflate"));
  const hash = `#p=${btoa(Array.from(packed, (b) => String.fromCharCode(b)).join("")).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`;
  return hash.length <= MOST ? hash : null;
}

// The program of an address, or null if it has none that can be read.
export async function hashToText(hash: string): Promise<string | null> {
  const packed = /^#p=([\w-]+)$/.exec(hash)?.[1];
  if (!packed || packed.length > MOST) return null;
  try {
    const bytes = Uint8Array.from(atob(packed.replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));
    return new TextDecoder("utf-8", { fatal: true }).decode(await through(bytes, new DecompressionStream("deflate")));
  } catch {
    return null;
  }
}
