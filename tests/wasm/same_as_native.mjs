// Runs programs with the command and with the module, each in a fresh folder, and compares standard output, messages,
// exit status, the hash of the run and the files that were written, byte for byte:
//   node same_as_native.mjs COMMAND armlet.js [--steps N] FILE_OR_FOLDER...
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { Answer, What, loadArmlet } from './armlet_module.mjs';

const exitStatus = { [Answer.done]: 0, [Answer.failed]: 70 };
const rejected = 65;

const [command, script, ...rest] = process.argv.slice(2).map((given, i) => (i < 2 ? path.resolve(given) : given));
let steps = 100_000_000;
if (rest[0] === '--steps') steps = Number(rest.splice(0, 2)[1]);
const armlet = await loadArmlet(script);

function filesBelow(folder, inside = '') {
  return readdirSync(path.join(folder, inside), { withFileTypes: true }).flatMap((entry) => {
    const name = path.posix.join(inside, entry.name);
    return entry.isDirectory() ? filesBelow(folder, name) : [name];
  }).sort();
}

const contentsOf = (folder) => new Map(filesBelow(folder).map((name) => [name, readFileSync(path.join(folder, name))]));

function runNatively(folder, program) {
  const ran = spawnSync(command, ['run', '--quiet', '--hash', '--steps', String(steps), program],
    { cwd: folder, maxBuffer: 1 << 28, env: { ...process.env, LC_ALL: 'C' } });
  // The hash is the last line; a program that was rejected has none.
  const [, output, hash] = /^([^]*?)(?:hash ([0-9a-f]{16})\n)?$/.exec(ran.stdout.toString());
  return { status: ran.status, output, hash: hash ?? '', messages: ran.stderr.toString() };
}

function runInModule(files, program) {
  for (const [name, content] of files) armlet.putFile('/' + name, content);
  const session = armlet.checked(armlet.open('scara', path.dirname(program), steps, 0));
  let status = armlet.checked(armlet.compile(session, files.get(program).toString(), program)) ? rejected : null;
  for (let answer = Answer.paused; status === null; status = exitStatus[answer] ?? null)
    answer = armlet.checked(armlet.run(session, 0.25, 100_000));
  const result = { status, output: armlet.takeText(session, What.output), messages: armlet.takeText(session, What.messages),
    hash: status === rejected ? '' : armlet.takeText(session, What.hash) };
  armlet.close(session);
  const written = new Map();
  for (const name of armlet.list_files('/').split('\n').filter(Boolean)) {
    written.set(name.slice(1), armlet.getFile(name));
    armlet.remove_file(name);
  }
  return { ...result, written };
}

// The module has neither the library that searches paths around obstacles, nor OpenCV, nor the readers of picture files.
const needsLibrary = (ran) => ran.status === exitStatus[Answer.failed] &&
  /error R06(46|91)|error R0680: [^]*not in a page by itself/.test(ran.messages);

// What a program differs in; nothing if it does not.
function difference(folder, files, program) {
  for (const [name, content] of files) {
    mkdirSync(path.dirname(path.join(folder, name)), { recursive: true });
    writeFileSync(path.join(folder, name), content);
  }
  const native = runNatively(folder, program);
  const here = runInModule(files, program);
  if (needsLibrary(here)) {
    console.log(`${program}: not compared, the module says that it lacks a library (R0646, R0680, R0691)`);
    return null;
  }
  for (const what of ['status', 'output', 'messages', 'hash'])
    if (native[what] !== here[what]) return `${what}: ${JSON.stringify(native[what]).slice(-400)} natively, ` +
      `${JSON.stringify(here[what]).slice(-400)} in the module`;
  const written = contentsOf(folder);
  for (const name of new Set([...written.keys(), ...here.written.keys()])) {
    const [a, b] = [written.get(name), here.written.get(name)];
    if (!a || !b) return `the file ${name} was written ${a ? 'natively' : 'in the module'} alone`;
    if (Buffer.compare(a, Buffer.from(b)) !== 0) return `the file ${name} differs`;
  }
  return null;
}

let count = 0, faults = 0;
for (const given of rest) {
  const top = statSync(given).isDirectory() ? given : path.dirname(given);
  const files = contentsOf(top);
  const programs = top !== given ? [path.basename(given)]
    : [...files.keys()].filter((name) => name.endsWith('.rbt') && !name.includes('modules/'));
  for (const program of programs) {
    const folder = mkdtempSync(path.join(tmpdir(), 'armlet_wasm_'));
    // Random programs stand alone, and there are many of them.
    const needed = program.startsWith('random_') ? new Map([[program, files.get(program)]]) : files;
    const differs = difference(folder, needed, program);
    rmSync(folder, { recursive: true });
    ++count;
    if (!differs) continue;
    ++faults;
    console.log(`${path.join(top, program)}: ${differs}`);
  }
}
console.log(`${count} programs, ${faults} of them not as natively`);
process.exit(faults === 0 && count > 0 ? 0 : 1);
