// The program and its file.
import type { State } from "./state.ts";

const plain = (text: string) => text.replaceAll("\r\n", "\n");

// Whether the text differs from its file; false where there is no file that could be written.
export function isUnsaved(state: State): boolean {
  const { document, text } = state;
  return document !== null && (!document.exists || plain(text) !== plain(document.text));
}

export const fileName = (state: State): string => state.welcome?.file.split("/").at(-1) || "program.rbt";

// The name of the file without its ending.
export const baseName = (state: State): string => fileName(state).replace(/\.rbt$/, "");
