// The declaration of an object that is added to a program, and its position in the text.

const DECLARES = /^(import|robot|object|frame|camera)\b/;

// The offset of the line after the last declaration of an object, otherwise of a robot, otherwise of an import; without any of them,
// after the comments at the top.
export function placeForObject(text: string): number {
  const ends = new Map<string, number>();
  let depth = 0;
  let declared: string | null = null;
  let behindRemarks = 0;
  let onlyRemarks = true;
  let inRemark = false;
  let at = 0;
  for (const line of text.split("\n")) {
    if (depth === 0 && !inRemark) {
      declared = DECLARES.exec(line)?.[1] ?? null;
      if (onlyRemarks && !/^\s*(\/\/.*|\/\*.*)?$/.test(line)) onlyRemarks = false;
    }
    for (let i = 0; i < line.length; i++) {
      if (inRemark) {
        if (line.startsWith("*/", i)) [inRemark, i] = [false, i + 1];
      } else if (line.startsWith("//", i)) break;
      else if (line.startsWith("/*", i)) [inRemark, i] = [true, i + 1];
      else if (line[i] === '"') {
        for (i++; i < line.length && line[i] !== '"'; i++) if (line[i] === "\\") i++;
      } else if ("([{".includes(line[i]!)) depth++;
      else if (")]}".includes(line[i]!)) depth = Math.max(0, depth - 1);
    }
    at = Math.min(text.length, at + line.length + 1);
    if (onlyRemarks && line.trim()) behindRemarks = at;
    if (depth === 0 && !inRemark && declared) ends.set(declared, at);
  }
  return ends.get("object") ?? ends.get("robot") ?? ends.get("import") ?? behindRemarks;
}

// A name for the object of a file that neither the program nor the language uses.
export function nameForObject(file: string, text: string, taken: Iterable<string>): string {
  const words = new Set([...(text.match(/[A-Za-z_]\w*/g) ?? []), ...taken]);
  let base = file.replace(/\.[^.]*$/, "").replace(/\W+/g, "_").replace(/^_+|_+$/g, "");
  if (!/^[A-Za-z]/.test(base)) base = `thing_${base}`.replace(/_$/, "");
  base = base[0]!.toLowerCase() + base.slice(1);
  for (let k = 1; ; k++) {
    const name = k === 1 ? base : `${base}${k}`;
    if (!words.has(name)) return name;
  }
}

// position  m. scale: of the lengths in the file.
export function objectText(name: string, file: string, position: readonly number[], scale = 1): string {
  const mm = position.map((v) => `${+(1000 * v).toFixed(1) + 0}mm`).join(", ");
  return `object ${name} { shape: mesh("${file}"${scale === 1 ? "" : `, scale: ${scale}`}); at: xyz(${mm}) }\n`;
}
