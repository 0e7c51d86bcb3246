// The module armlet.wasm with its functions of C as functions of JavaScript, for Node.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

const names = {
  open: ['number', ['string', 'string', 'number', 'number']],
  close: ['number', ['number']],
  compile: ['number', ['number', 'string', 'string']],
  run: ['number', ['number', 'number', 'number']],
  cancel: ['number', ['number']],
  time: ['number', ['number']],
  take: ['number', ['number', 'number']],
  taken_bytes: ['number', []],
  error: ['string', []],
  get_file: ['number', ['string']],
  remove_file: ['number', ['string']],
  list_files: ['string', ['string']],
};

export const Answer = { done: 0, failed: 1, paused: 2, cancelled: 3, misused: -1 };
export const What = { output: 0, messages: 1, messagesAsJson: 2, events: 3, hash: 4 };

// script  the path of armlet.js; armlet.wasm lies beside it.
export async function loadArmlet(script) {
  const create = createRequire(import.meta.url)(script);
  const wasmBinary = readFileSync(script.replace(/\.js$/, '.wasm'));
  const module = await create({ wasmBinary });
  const armlet = { module };
  for (const [name, [result, parameters]] of Object.entries(names))
    armlet[name] = module.cwrap(`armlet_${name}`, result, parameters);
  const decoder = new TextDecoder();
  // What the last call has returned, as bytes; texts of programs may hold a zero.
  const bytes = (address) => module.HEAPU8.slice(address, address + armlet.taken_bytes());
  armlet.takeText = (session, what) => decoder.decode(bytes(armlet.take(session, what)));
  armlet.putFile = (path, content) => {
    const address = module._malloc(Math.max(content.length, 1));
    module.HEAPU8.set(content, address);
    module.ccall('armlet_put_file', 'number', ['string', 'number', 'number'], [path, address, content.length]);
    module._free(address);
  };
  armlet.getFile = (path) =>
    armlet.get_file(path) === Answer.done ? bytes(module._armlet_taken()) : null;
  armlet.checked = (answer) => {
    if (answer === Answer.misused) throw new Error(armlet.error());
    return answer;
  };
  return armlet;
}
