// Stops the build unless the bundled packages are those of notices/parts.json, with these versions, licences and copyrights.
import { existsSync, readFileSync } from "node:fs";
import path from "node:path";
import type { Plugin } from "vite";

type Part = { name: string; version?: string; copyright: string[]; licence: string; in: string[]; texts: string[]; npm?: string };

const FOLDER = "../../../notices";
const read = (file: string) => readFileSync(path.join(import.meta.dirname, file), "utf8");
const words = (text: string) => text.toLowerCase().replace(/[^a-z0-9]+/g, " ").trim();

// The package "@codemirror/view" of ".../node_modules/@codemirror/view/dist/index.js"; null: the file is one of our sources.
function packageOf(id: string): string | null {
  const [, after] = id.split("\0").join("").match(/.*\/node_modules\/(.*)/) ?? [];
  return after ? after.split("/").slice(0, after.startsWith("@") ? 2 : 1).join("/") : null;
}

function faultsOf(part: Part): string[] {
  const folder = `node_modules/${part.npm}`;
  const version = JSON.parse(read(`${folder}/package.json`)).version;
  const found = version === part.version ? [] : [`${part.name} is ${version}, not ${part.version}`];
  if (part.licence.startsWith("OFL")) return found; // fonts contain their licence
  const file = ["LICENSE", "LICENSE.md"].map((name) => `${folder}/${name}`).find((name) => existsSync(path.join(import.meta.dirname, name)));
  const licence = words(file ? read(file) : "");
  for (const text of part.texts) if (!licence.includes(words(read(`${FOLDER}/texts/${text}.txt`)))) found.push(`${part.name}: its licence is not ${text}`);
  for (const line of part.texts.length ? part.copyright : []) if (!licence.includes(words(line))) found.push(`${part.name}: its licence does not say "${line}"`);
  return found;
}

// isPage  whether this is the page itself, which must contain all packages; other scripts may contain any part of them.
export function comparedNotices(isPage: boolean): Plugin {
  return {
    name: "compared-notices",
    generateBundle(_options, bundle) {
      const parts: Part[] = JSON.parse(read(`${FOLDER}/parts.json`)).parts.filter((part: Part) => part.in.includes("page"));
      const bundled = new Set<string>();
      for (const file of Object.values(bundle)) {
        if (file.type !== "chunk") continue;
        for (const [id, module] of Object.entries(file.modules)) if (module.renderedLength > 0 && packageOf(id)) bundled.add(packageOf(id)!);
      }
      for (const id of this.getModuleIds()) if (/\.css(\?|$)/.test(id) && packageOf(id)) bundled.add(packageOf(id)!);
      const named = new Set(parts.map((part) => part.npm!));
      const faults = [
        ...[...bundled].filter((name) => !named.has(name)).map((name) => `${name} is bundled, but notices/parts.json does not name it`),
        ...(isPage ? [...named].filter((name) => !bundled.has(name)).map((name) => `${name} is named by notices/parts.json, but not bundled`) : []),
        ...(isPage ? parts.flatMap(faultsOf) : []),
      ];
      if (faults.length) this.error(faults.join("\n"));
    },
  };
}
