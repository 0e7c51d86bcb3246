// Highlighting of programs: the words of the language come from the laboratory.
import { HighlightStyle, StreamLanguage, syntaxHighlighting, type StringStream } from "@codemirror/language";
import type { Extension } from "@codemirror/state";
import { tags } from "@lezer/highlight";
import type { Words } from "../protocol/messages.ts";

interface Inside {
  // The characters that end the text or comment in which the line begins.
  until: string;
}

const style = HighlightStyle.define([
  { tag: tags.keyword, color: "var(--code-keyword)", fontWeight: "500" },
  { tag: tags.typeName, color: "var(--code-type)" },
  { tag: [tags.number, tags.unit], color: "var(--code-number)" },
  { tag: tags.string, color: "var(--code-string)" },
  { tag: tags.comment, color: "var(--code-comment)", fontStyle: "italic" },
  { tag: tags.function(tags.variableName), color: "var(--code-function)" },
]);

const NUMBER = /^(0[xb][\da-f_]+|\d[\d_]*(\.\d+)?(e[+-]?\d+)?)/i;
const WORD = /^[A-Za-z_]\w*/;

export function language(words: Partial<Words> = {}): Extension {
  const kinds = new Map<string, string>();
  const put = (list: string[] | undefined, kind: string) => list?.forEach((word) => kinds.set(word, kind));
  put(words.functions, "function");
  put(words.soft, "keyword");
  put(words.types, "typeName");
  put(words.keywords, "keyword");
  const units = new Set(words.units ?? []);
  const rbt = StreamLanguage.define<Inside>({
    name: "rbt",
    startState: () => ({ until: "" }),
    copyState: (state) => ({ ...state }),
    token: (stream, state) => token(stream, state, kinds, units),
    languageData: { commentTokens: { line: "//", block: { open: "/*", close: "*/" } }, closeBrackets: { brackets: ["(", "[", "{", '"'] } },
    tokenTable: { function: tags.function(tags.variableName) },
  });
  return [rbt, syntaxHighlighting(style)];
}

function token(stream: StringStream, state: Inside, kinds: Map<string, string>, units: Set<string>): string | null {
  if (state.until) return ending(stream, state);
  if (stream.eatSpace()) return null;
  if (stream.match("//")) {
    stream.skipToEnd();
    return "comment";
  }
  if (stream.match("/*")) {
    state.until = "*/";
    return ending(stream, state);
  }
  if (stream.match(/^f?"""/)) {
    state.until = '"""';
    return ending(stream, state);
  }
  if (stream.match(/^f?"/)) {
    state.until = '"';
    return ending(stream, state);
  }
  if (stream.match("'")) {
    state.until = "'";
    return ending(stream, state);
  }
  if (stream.match(NUMBER)) {
    const unit = /^([A-Za-z]+)/.exec(stream.string.slice(stream.pos))?.[1];
    if (unit && units.has(unit)) stream.match(unit);
    return "number";
  }
  const word = (stream.match(WORD) as RegExpMatchArray | null)?.[0];
  if (word) {
    const known = kinds.get(word);
    if (known && known !== "function") return known;
    return /^\s*\(/.test(stream.string.slice(stream.pos)) ? "function" : null;
  }
  stream.next();
  return null;
}

// Reads to the end of a text or comment; texts end with their line, except between three quotes.
function ending(stream: StringStream, state: Inside): string {
  const comment = state.until === "*/";
  while (!stream.eol()) {
    if (!comment && stream.match(/^\\./)) continue;
    if (stream.match(state.until)) {
      state.until = "";
      return comment ? "comment" : "string";
    }
    stream.next();
  }
  if (state.until.length === 1) state.until = "";
  return comment ? "comment" : "string";
}
