// Finds names of objects, robots and rows in a program.

// The offset of a name declared with one of the words `kinds` ("object|robot"); otherwise of the name as a text, or anywhere outside of
// comments; null: the program does not contain it.
export function placeOfName(text: string, name: string, kinds: string): number | null {
  const bare = text.replace(/\/\/.*|\/\*[^]*?\*\//g, (comment) => " ".repeat(comment.length));
  const word = name.replace(/\W/g, "\\$&");
  const declared = new RegExp(`\\b(?:${kinds})\\s+(?=${word}\\b)`).exec(bare);
  if (declared) return declared.index + declared[0].length;
  const quoted = bare.indexOf(`"${name}"`);
  if (quoted >= 0) return quoted + 1;
  return new RegExp(`\\b${word}\\b`).exec(bare)?.index ?? null;
}
