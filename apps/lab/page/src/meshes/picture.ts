// Pictures in files: PNG and JPEG. They come with programs of unknown origin.
const MOST_PIXELS = 64e6;
const MOST_SIDE = 8192;

// The type "image/png" or "image/jpeg", and the size in the header of the picture; null: it is neither.
export function pictureOf(bytes: Uint8Array): { type: string; width: number; height: number } | null {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length > 24 && view.getUint32(0) === 0x89504e47) return { type: "image/png", width: view.getUint32(16), height: view.getUint32(20) };
  if (bytes.length < 4 || view.getUint16(0) !== 0xffd8) return null;
  for (let at = 2; at + 9 < bytes.length; at += 2 + view.getUint16(at + 2)) {
    const kind = view.getUint16(at);
    if (kind < 0xffc0 || kind > 0xfffe) return null;
    const isFrame = kind <= 0xffcf && ![0xffc4, 0xffc8, 0xffcc].includes(kind);
    if (isFrame) return { type: "image/jpeg", height: view.getUint16(at + 5), width: view.getUint16(at + 7) };
  }
  return null;
}

// The picture, ready to be drawn, with its first row at the bottom; null: it is broken, too large or no picture.
export async function decoded(bytes: Uint8Array<ArrayBuffer>): Promise<ImageBitmap | null> {
  const picture = pictureOf(bytes);
  if (!picture || Math.max(picture.width, picture.height) > MOST_SIDE || picture.width * picture.height > MOST_PIXELS) return null;
  try {
    return await createImageBitmap(new Blob([bytes], { type: picture.type }), { imageOrientation: "flipY", premultiplyAlpha: "none" });
  } catch {
    return null;
  }
}
