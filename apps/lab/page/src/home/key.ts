// The key by which a laboratory recognises a page after a reload or a lost connection; it comes with the welcome message.
const NAME = "armlet.key";
let known: string | null = null;

export function keepKey(key: string): void {
  known = key;
  try {
    sessionStorage.setItem(NAME, key);
  } catch {
    // A page opened from a disk may have no storage.
  }
}

export function keptKey(): string | null {
  try {
    return known ?? sessionStorage.getItem(NAME);
  } catch {
    return known;
  }
}
