// Bytes as text, four of them as five digits to the base 85, which is a sixteenth shorter than base64 (apps/lab/messages/base85.hpp,
// apps/wasm/pack_laboratory.mjs). The digits are the characters from ( to ; and from > to ~: none of them begins an element. A remainder
// of n bytes at the end becomes n + 1 digits.

export function fromBase85(text: string): Uint8Array<ArrayBuffer> {
  const rest = text.length % 5;
  const bytes = new Uint8Array(4 * Math.floor(text.length / 5) + Math.max(0, rest - 1));
  const digit = (i: number) => {
    if (i >= text.length) return 84;
    const code = text.charCodeAt(i);
    return code - (code < 60 ? 40 : 42);
  };
  for (let i = 0, to = 0; i < text.length; i += 5) {
    const value = (((digit(i) * 85 + digit(i + 1)) * 85 + digit(i + 2)) * 85 + digit(i + 3)) * 85 + digit(i + 4);
    for (let shift = 24; shift >= 0 && to < bytes.length; shift -= 8) bytes[to++] = value >>> shift;
  }
  return bytes;
}

export function toBase85(bytes: Uint8Array): string {
  const text: string[] = [];
  const signs = new Uint8Array(5);
  for (let i = 0; i < bytes.length; i += 4) {
    let value = 0;
    for (let k = 0; k < 4; k++) value = 256 * value + (bytes[i + k] ?? 0);
    for (let k = 4; k >= 0; k--, value = Math.floor(value / 85)) {
      const digit = value % 85;
      signs[k] = digit + (digit < 20 ? 40 : 42);
    }
    text.push(String.fromCharCode(...signs.subarray(0, Math.min(4, bytes.length - i) + 1)));
  }
  return text.join("");
}
