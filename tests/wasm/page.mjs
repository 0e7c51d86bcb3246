// Runs the script of examples/embed/page.html with a document of our own: node page.mjs armlet.js
import assert from 'node:assert';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const script = path.resolve(process.argv[2]);
const page = readFileSync(new URL('../../examples/embed/page.html', import.meta.url), 'utf8');
const text = page.match(/<textarea[^>]*>(.*?)<\/textarea>/s)[1];
const code = page.match(/<script type="module">(.*?)<\/script>/s)[1];
assert(page.split('\n').length <= 32, 'the page stays short');

// Elements with what the page uses of them; `shown` are the times that it showed.
const shown = [];
const elements = {
  text: { value: text }, run: {}, output: { textContent: '' },
  time: { set textContent(value) { shown.push(value); } },
};
const document = { getElementById: (id) => elements[id] };
const create = createRequire(fileURLToPath(import.meta.url))(script);
const createArmlet = () => create({ wasmBinary: readFileSync(script.replace(/\.js$/, '.wasm')) });

const AsyncFunction = (async () => {}).constructor;
await new AsyncFunction('document', 'createArmlet', code)(document, createArmlet);

async function runPage(program) {
  shown.length = 0;
  elements.output.textContent = '';
  elements.text.value = program;
  elements.run.onclick();
  for (let last = 0; last !== shown.length;) {
    last = shown.length;
    await new Promise((go) => setTimeout(go, 200));
  }
  return elements.output.textContent;
}

assert.match(await runPage(text), /^done at [0-9.]+ s\n$/);
assert(shown.length > 20, `the program runs in slices: ${shown.length} times were shown`);
for (let i = 1; i < shown.length; ++i) {
  const step = parseFloat(shown[i].slice(4)) - parseFloat(shown[i - 1].slice(4));
  assert(step >= 0 && step < 0.03, `time goes on by a slice: ${shown[i - 1]}, then ${shown[i]}`);
}
assert.match(await runPage('moveJ(1);'), /error/);
assert.match(await runPage('print(1 / 0);\nassert false;'), /error/);
console.log(`the page ran a program in ${shown.length} slices`);
