// Makes laboratory.html, from which `armlet lab FILE --export` makes a page without a server: the page, with
// the engine, its start script and an element for a program. Browsers decompress gzip themselves.
//   node pack_laboratory.mjs VERSION PAGE_FOLDER armlet.js armlet.wasm laboratory.html
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { gzipSync } from 'node:zlib';

const [version, folder, script, module, out] = process.argv.slice(2);
const text = (file) => readFileSync(file, 'utf8');

// Four bytes as five digits to the base 85; their reader lists the digits
// (apps/lab/page/src/alone/packed.ts).
function written(bytes) {
  const signs = [];
  for (let i = 0; i < bytes.length; i += 4) {
    const group = [...bytes.subarray(i, i + 4)];
    let value = [0, 1, 2, 3].reduce((sum, k) => sum * 256 + (group[k] ?? 0), 0);
    const digits = [];
    for (let k = 0; k < 5; k++) {
      digits.unshift(value % 85);
      value = Math.floor(value / 85);
    }
    for (const digit of digits.slice(0, group.length + 1)) signs.push(String.fromCharCode(digit + (digit < 20 ? 40 : 42)));
  }
  return signs.join('');
}
const packed = (bytes) => written(gzipSync(bytes, { level: 9, memLevel: 9 }));
const element = (attributes, content) => {
  if (/<\/script|<!--/i.test(content)) throw new Error(`the script ${attributes} would end its element`);
  return `<script ${attributes}>${content}</script>\n`;
};

// The last script of the page is its own.
const page = text(path.join(folder, 'index.html'));
const opening = '<script type="module">';
const begin = page.lastIndexOf(opening);
const end = page.indexOf('</script>', begin);
const code = page.slice(begin + opening.length, end);
const hash = (content) => `'sha256-${createHash('sha256').update(content).digest('base64')}'`;
const boot = text(path.join(folder, 'boot.js')).trim();
if (begin < 0 || !page.includes(hash(code))) throw new Error('the page does not name the hash of its script');

const parts = [
  element('type="text/plain" class="armlet-part" id="armlet-engine"', packed(readFileSync(module))),
  element('type="text/plain" id="armlet-worker"', `${text(script)}\n${text(path.join(folder, 'worker.js'))}`),
  element('type="text/plain" id="armlet-converter"', packed(readFileSync(path.join(folder, 'converter.js')))),
  element('type="text/plain" id="armlet-page"', packed(code)),
  element('type="module"', boot),
].join('');
writeFileSync(out, (page.slice(0, begin) + parts + page.slice(end + '</script>'.length))
  .replace(hash(code), () => `${hash(code)} ${hash(boot)}`)
  .replace('<meta name="referrer"', () => `<meta name="armlet-engine" content="${version}" />\n    <meta name="referrer"`));
