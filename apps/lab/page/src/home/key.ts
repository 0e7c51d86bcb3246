// What a page shows to be known again when it is reloaded or its connection was lost: the laboratory gave it in its welcome.
const NAME = "armlet.key";
let known: string | null = null;

export function keepKey(key: string): void {
  known = key;
  try {
    sessionStorage.setItem(NAME, key);
  } catch {
    // A page from a disk may have no place for it.
  }
}

export function keptKey(): string | null {
  try {
    return known ?? sessionStorage.getItem(NAME);
  } catch {
    return known;
  }
}
