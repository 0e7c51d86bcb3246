// Settings of calls: arguments with a name.

// The name of the setting in whose argument the offset is ("speed" in `moveL(p, speed: 1mm/s)`, also before its name); null: it has none.
export function settingAt(text: string, offset: number): string | null {
  let depth = 0;
  let begin = offset;
  for (; begin > 0; begin--) {
    const before = text[begin - 1]!;
    if (")]}".includes(before)) depth++;
    else if ("([{".includes(before) && depth-- === 0) break;
    else if (before === "," && depth === 0) break;
  }
  return /^\s*([A-Za-z_]\w*)\s*:(?!:)/.exec(text.slice(begin))?.[1] ?? null;
}
