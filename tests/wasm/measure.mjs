// What the module costs: its size, also compressed as servers do, and how soon a page is ready. The size has a limit.
//   node measure.mjs armlet.js EXAMPLE.rbt
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { brotliCompressSync, constants, gzipSync } from 'node:zlib';
import { Answer, What, loadArmlet } from './armlet_module.mjs';

const most = 1.6e6;  // bytes, compressed by brotli, script and module together

const script = path.resolve(process.argv[2]);
const both = [script, script.replace(/\.js$/, '.wasm')].map((file) => readFileSync(file));
const total = (size) => both.map(size).reduce((a, b) => a + b);
const brotli = total((bytes) => brotliCompressSync(bytes, { params: {
  [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_LGWIN]: 24, [constants.BROTLI_PARAM_SIZE_HINT]: bytes.length } }).length);
const megabytes = (size) => `${(size / 1e6).toFixed(2)} MB`;
console.log(`size: ${megabytes(total((bytes) => bytes.length))} raw, ` +
  `${megabytes(total((bytes) => gzipSync(bytes, { level: 9 }).length))} gzip, ${megabytes(brotli)} brotli`);

function timed(work) {
  const start = performance.now();
  const result = work();
  return [performance.now() - start, result];
}

const start = performance.now();
const armlet = await loadArmlet(script);
console.log(`ready after ${(performance.now() - start).toFixed(1)} ms`);
const text = readFileSync(process.argv[3], 'utf8');
for (const round of ['first', 'second', 'third', '4th', '5th', '6th', '7th', '8th', '9th', '10th']) {
  const session = armlet.checked(armlet.open('scara', '', 1e8, 0));
  const [checking] = timed(() => armlet.checked(armlet.compile(session, text, 'program.rbt')));
  const [running, answer] = timed(() => {
    let answer = Answer.paused;
    while (answer === Answer.paused) answer = armlet.checked(armlet.run(session, 1 / 60, 100_000));
    return answer;
  });
  const simulated = armlet.time(session);
  if (answer !== Answer.done) throw new Error(armlet.takeText(session, What.messages));
  armlet.close(session);
  if (['first', 'second', '10th'].includes(round))
    console.log(`${round} time: ${checking.toFixed(1)} ms to check, ${running.toFixed(1)} ms to run ${simulated.toFixed(1)} s`);
}
if (brotli > most) {
  console.log(`the module is larger than ${megabytes(most)}`);
  process.exit(1);
}
