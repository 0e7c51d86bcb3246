// Where a program names what is on the page.

// The offset of the name of what is declared by one of the words `kinds` ("object|robot"), or of the name as a text, or
// anywhere but in a comment; null: the program does not name it.
export function placeOfName(text: string, name: string, kinds: string): number | null {
  const bare = text.replace(/\/\/.*|\/\*[^]*?\*\//g, (comment) => " ".repeat(comment.length));
  const word = name.replace(/\W/g, "\\$&");
  const declared = new RegExp(`\\b(?:${kinds})\\s+(?=${word}\\b)`).exec(bare);
  if (declared) return declared.index + declared[0].length;
  const quoted = bare.indexOf(`"${name}"`);
  if (quoted >= 0) return quoted + 1;
  return new RegExp(`\\b${word}\\b`).exec(bare)?.index ?? null;
}
