// Where a position is inserted into a program.

// Goes through the text from `from`, and calls `at` before each character that is neither in a remark nor in a text.
function scan(text: string, from: number, to: number, at: (character: string, offset: number) => boolean | void): "code" | "text" | "remark" {
  for (let i = from; i < to; i++) {
    if (text.startsWith("//", i)) {
      const end = text.indexOf("\n", i);
      if (end < 0 || end >= to) return "remark";
      i = end;
    } else if (text.startsWith("/*", i)) {
      const end = text.indexOf("*/", i + 2);
      if (end < 0 || end + 2 > to) return "remark";
      i = end + 1;
      continue;
    } else if (text[i] === '"') {
      for (i++; i < to && text[i] !== '"'; i++) if (text[i] === "\\") i++;
      if (i >= to) return "text";
      continue;
    }
    if (at(text[i]!, i) === false) return "code";
  }
  return "code";
}

// Whether a value belongs at the offset: within round or square brackets, or behind "=", "," or "return".
export function wantsValue(text: string, offset: number): boolean {
  const open: string[] = [];
  const where = scan(text, 0, offset, (character) => {
    if ("([{".includes(character)) open.push(character);
    else if (")]}".includes(character)) open.pop();
  });
  if (where !== "code") return false;
  const line = text.slice(text.lastIndexOf("\n", offset - 1) + 1, offset);
  return open.at(-1) === "(" || open.at(-1) === "[" || /(=|,|\breturn)\s*$/.test(line);
}

// The offset behind the statement that begins on the line, and its indentation; null: behind the text.
export function behindStatement(text: string, line: number | null): { at: number; indent: string } {
  const lines = text.split("\n");
  if (line === null || line < 1 || line > lines.length) return { at: text.length, indent: "" };
  const begin = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0);
  let depth = 0;
  let end = text.length;
  scan(text, begin, text.length, (character, offset) => {
    if ("([{".includes(character)) depth++;
    else if (")]}".includes(character)) depth--;
    if (character !== "\n" || depth > 0) return true;
    end = offset + 1;
    return false;
  });
  return { at: end, indent: /^[ \t]*/.exec(lines[line - 1]!)![0] };
}
