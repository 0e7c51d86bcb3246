import { createHash } from "node:crypto";
import { defineConfig, type Plugin } from "vite";
import { comparedNotices } from "./notices.ts";

// KaTeX has each font in three formats; every browser that runs this page reads the first. Letters of \mathfrak, \mathscr and bold or
// slanted \mathsf, which lessons on robots do not use, are those of the system.
const LEFT_OUT = /@font-face\s*\{[^}]*(?:KaTeX_Fraktur|KaTeX_Script|KaTeX_SansSerif-(?:Bold|Italic))[^}]*\}/g;
function onlyWoff2(): Plugin {
  return {
    name: "only-woff2",
    enforce: "pre",
    transform(code, id) {
      if (!id.includes("katex") || !id.endsWith(".css")) return null;
      return code.replace(LEFT_OUT, "").replace(/,\s*url\([^)]*\.(woff|ttf)\)\s*format\(["'](woff|truetype)["']\)/g, "");
    },
  };
}

// The policy of the page: only its own script, known by its hash, may run, and nothing that comes with a program.
function policy(code: string): string {
  const hash = createHash("sha256").update(code).digest("base64");
  return [
    "default-src 'none'", `script-src 'sha256-${hash}' 'wasm-unsafe-eval'`, "style-src 'unsafe-inline'", "img-src data: blob:", "font-src data:",
    "connect-src 'self' ws: wss: data: blob:", "worker-src blob:", "base-uri 'none'", "form-action 'none'",
  ].join("; ");
}

// One file: script and styles are included in the page, so that it can be embedded in a program, mailed, and opened from a
// disk.
function oneFile(): Plugin {
  return {
    name: "one-file",
    enforce: "post",
    generateBundle(_options, bundle) {
      const page = bundle["index.html"];
      if (page?.type !== "asset") return;
      let html = String(page.source);
      for (const [name, file] of Object.entries(bundle)) {
        const escaped = name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
        if (file.type === "chunk") {
          const code = file.code.replace(/<\/script/gi, "<\\/script").replace(/<!--/g, "<\\!--");
          html = html.replace(new RegExp(`<script[^>]*src="[^"]*${escaped}"[^>]*></script>`), "");
          html = html.replace("</body>", () => `<script type="module">${code}</script>\n</body>`);
          html = html.replace('<meta name="referrer"', () => `<meta http-equiv="Content-Security-Policy" content="${policy(code)}" />\n    <meta name="referrer"`);
        } else if (name.endsWith(".css")) {
          const tag = new RegExp(`<link[^>]*href="[^"]*${escaped}"[^>]*>`);
          html = html.replace(tag, () => `<style>${String(file.source)}</style>`);
        } else continue;
        delete bundle[name];
      }
      page.source = html;
    },
  };
}

// Further scripts, each built as one file: `vite build --mode boot`, `--mode worker` and `--mode converter` (src/alone).
const ALONE = ["boot", "worker", "converter"];
const alone = (name: string) => ({
  plugins: [comparedNotices(false)],
  build: {
    target: "es2022",
    emptyOutDir: false,
    reportCompressedSize: false,
    lib: { entry: `src/alone/${name}.ts`, formats: ["iife" as const], name: "armlet", fileName: () => `${name}.js` },
  },
});

export default defineConfig(({ mode }) => (ALONE.includes(mode) ? alone(mode) : {
  base: "./",
  plugins: [onlyWoff2(), comparedNotices(true), oneFile()],
  build: {
    target: "es2022",
    assetsInlineLimit: 100_000_000,
    cssCodeSplit: false,
    modulePreload: false,
    reportCompressedSize: false,
    chunkSizeWarningLimit: 4000,
    rolldownOptions: { output: { codeSplitting: false } },
  },
}));
