// Makes laboratory.html, of which `armlet lab FILE --export` makes a page that stands alone: the page of
// laboratories, with the engine and what starts it, and a place for a program. Browsers unpack gzip by themselves.
//   node pack_laboratory.mjs VERSION PAGE_FOLDER armlet.js armlet.wasm laboratory.html
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { gzipSync } from 'node:zlib';

const [version, folder, script, module, out] = process.argv.slice(2);
const text = (file) => readFileSync(file, 'utf8');
const packed = (bytes) => gzipSync(bytes, { level: 9, memLevel: 9 }).toString('base64');
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
  element('type="text/plain" id="armlet-page"', packed(code)),
  element('type="module"', boot),
].join('');
writeFileSync(out, (page.slice(0, begin) + parts + page.slice(end + '</script>'.length))
  .replace(hash(code), () => `${hash(code)} ${hash(boot)}`)
  .replace('<meta name="referrer"', () => `<meta name="armlet-engine" content="${version}" />\n    <meta name="referrer"`));
