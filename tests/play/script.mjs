// script.mjs NATIVE PUBLISHED: plays a demo by a script, compiled for this machine and as the page has it, and compares
// every number of 2000 frames. Where only + - * /, square roots and floor are used, each bit is the same; sines and
// their like differ from one C library to the next, and there the numbers agree to 1e-9, or to 1e-6 where a root of
// such a difference is taken.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import { gunzipSync } from 'node:zlib';
import { aboutOf, frameOf, line, printedRow, reader } from './rows.mjs';

const [native, published] = process.argv.slice(2);
const [, name, packed] = /\['(\w+)'\] = '(.*)';/.exec(fs.readFileSync(published, 'utf8'));
// One has no sines, and agrees to the last bit; an arm at full reach bends by the root of what was rounded.
const tolerance = /^07_/.test(name) ? 0 : /^10_/.test(name) ? 1e-6 : 1e-9;

const module = new WebAssembly.Module(gunzipSync(Buffer.from(packed, 'base64')));
const text = (from) => Buffer.from(world.memory.buffer).subarray(from, Buffer.from(world.memory.buffer).indexOf(0, from)).toString();
const nobody = () => { throw new Error('asked for a function of a reader, and there is none'); };
const imports = {
  play: { thrown: (type, what) => { throw new Error(`${text(type)}: ${text(what)}`); }, take: nobody },
  exercises: {},
  yours: {},
  wasi_snapshot_preview1: new Proxy({}, { get: () => () => 52 }),
};
for (const { module: from, name: called } of WebAssembly.Module.imports(module)) {
  if (from === 'exercises') imports.exercises[called] = (...values) => world[`ours ${called}`](...values);
  if (from === 'yours') imports.yours[called] = nobody;
}
const world = new WebAssembly.Instance(module, imports).exports;
world._initialize();

const seen = (address) => reader(new Float64Array(world.memory.buffer, address));
function frame(...input) {
  const rest = seen(world.frame(...input)), { shapes } = frameOf(rest);
  return { row: rest.taken(), handles: shapes.filter(({ kind }) => kind === 'handle').flatMap(({ points }) => points).length };
}
const about = aboutOf(seen(world.begin()));

let state = 7;
const chance = () => (state = (state * 48271) % 2147483647) / 2147483647;
const values = about.controls.map(({ value }) => value);
const lines = [], rows = [];
let pointer = [...about.low], inside = 0, held = -1, handles = 0;
for (let i = 0; i < 2000; i++) {
  const which = Math.floor(chance() * about.controls.length), { low, high, step } = about.controls[which] ?? {};
  const grain = step || high - low; // a key that is held is down or not
  if (i % 40 === 39 && which < values.length) values[which] = low + grain * Math.round((chance() * (high - low)) / grain);
  if (i % 25 === 0) inside = chance() < 0.6 ? 1 : 0;
  if (i % 10 === 0) held = chance() < 0.3 ? Math.floor(chance() * handles) : -1;
  if (held < 0 || i % 10 === 0) pointer = [0, 1].map((k) => Math.round(64 * (about.low[k] + chance() * (about.high[k] - about.low[k]))) / 64);
  const dt = i % 100 < 85 ? 1 / 64 + (i % 7) / 512 : 0, one = i % 100 > 95 ? 1 : 0; // it rests now and then, and is stepped
  const input = [dt, one, ...pointer, inside, inside && chance() < 0.05 ? 1 : 0, held >= 0 ? 1 : 0, held, about.keys.length > 0 && chance() < 0.02 ? Math.floor(chance() * about.keys.length) : -1];
  values.forEach((value, at) => world.control(at, value));
  const { row, handles: count } = frame(...input);
  lines.push(line(input, values));
  rows.push(row);
  handles = count;
}

const printed = execFileSync(native, { input: lines.join('\n') + '\n', maxBuffer: 1 << 30 }).toString().trim().split('\n');
let most = 0;
// One sweep of 10's tentacle doubles a difference, if the pointer jumps each frame: what was 1e-8 is 1e-4 after thirty of them.
// So does each hit of a round disc and a round mallet.
const compared = rows.slice(0, /^10_/.test(name) ? 1500 : name === 'sketch_duel' ? 400 : rows.length);
compared.forEach((row, i) => {
  const there = printedRow(printed[i]);
  const different = there.length === row.length ? row.findIndex((x, k) => !(Math.abs(x - there[k]) <= tolerance)) : 0;
  row.forEach((x, k) => (most = Math.max(most, Math.abs(x - there[k]))));
  if (there.length === row.length && different < 0) return;
  console.log(`${name}: the page's demo and this machine's differ from frame ${i} on: ${row.length} numbers and ${there.length}, ${row[different]} and ${there[different]}.`);
  console.log('If the demo was changed, type ./course dev publish');
  process.exit(1);
});
console.log(`${name}: ${compared.length} frames, ${compared.reduce((sum, row) => sum + row.length, 0)} numbers, largest difference ${most}`);
