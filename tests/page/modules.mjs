// The modules that the tests need, from the folder into which run.sh has put them, and the page's own
// sources: TypeScript, made into JavaScript here, because Node 18 does not read it.
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
export const root = resolve(here, "../..");
const require = createRequire(join(process.env.ARMLET_PAGE_MODULES ?? here, "x.js"));

export const { chromium } = require("playwright-core");
export const axeSource = () => readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");

// The exports of a source of the page, for example "store/run.ts".
export async function source(name) {
  const built = require("esbuild").buildSync({
    entryPoints: [join(root, "apps/lab/page/src", name)],
    bundle: true,
    format: "esm",
    platform: "node",
    target: "node18",
    nodePaths: [join(process.env.ARMLET_PAGE_MODULES ?? here, "node_modules")],
    write: false,
  });
  const file = join(mkdtempSync(join(tmpdir(), "armlet-page-")), "source.mjs");
  writeFileSync(file, built.outputFiles[0].contents);
  return import(pathToFileURL(file).href);
}
