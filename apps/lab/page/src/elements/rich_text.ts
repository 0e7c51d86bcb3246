// Markdown with formulas. The resulting HTML is sanitised: no script of a program's text can run.
import DOMPurify from "dompurify";
import katex from "katex";
import "katex/dist/katex.min.css";
import { Marked, type TokenizerAndRendererExtension } from "marked";

function formula(name: string, sign: string, pattern: RegExp, block: boolean): TokenizerAndRendererExtension {
  return {
    name,
    level: "inline",
    start: (text) => text.indexOf(sign),
    tokenizer(text) {
      const match = pattern.exec(text);
      return match ? { type: name, raw: match[0], text: match[1] ?? "" } : undefined;
    },
    renderer: (token) =>
      katex.renderToString(String(token["text"]), { displayMode: block, throwOnError: false, trust: false, maxExpand: 200, maxSize: 20 }),
  };
}

const marked = new Marked({
  extensions: [formula("display", "$$", /^\$\$([^$]+)\$\$/, true), formula("formula", "$", /^\$([^$\n]+)\$/, false)],
});

export function richText(markdown: string): DocumentFragment {
  const html = marked.parse(markdown, { async: false });
  const clean = DOMPurify.sanitize(html, {
    RETURN_DOM_FRAGMENT: true,
    FORBID_TAGS: ["style", "form", "input", "button", "textarea", "select", "iframe", "audio", "video"],
    ALLOWED_URI_REGEXP: /^(?:https?:|mailto:|#|data:image\/(?:png|jpeg|gif|webp);)/i,
  });
  for (const link of clean.querySelectorAll("a")) {
    link.setAttribute("target", "_blank");
    link.setAttribute("rel", "noopener noreferrer");
  }
  for (const picture of clean.querySelectorAll("img:not([alt])")) picture.setAttribute("alt", "");
  // The first level of headings belongs to the page.
  for (const heading of clean.querySelectorAll("h1")) {
    const lower = document.createElement("h2");
    lower.append(...heading.childNodes);
    heading.replaceWith(lower);
  }
  return clean;
}
