// Writes called.txt: compiles and links our answers and some thousand slips, and notes which of the compiler's functions the
// engine was asked for.
//     node tools/online/train.mjs EIGEN OBJECTS [SLIPS [SEED]]      see make_objects.mjs; 2000 slips take half an hour
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { saveCalled } from './cut.mjs';
import { dice, slip } from './slips.mjs';
import { compilerFiles, courseFiles, llvmProgram, root, sections } from './sources.mjs';
import { compileAnswer, compileSketch, folder, link, sketchFiles } from './toolchain.mjs';

const [eigen, objects, slips = 2000, seed = 2026, inside] = process.argv.slice(2);

// Text and section of each answer, the slips after them.
function* answers() {
  const read = (folder, section) => fs.readFileSync(path.join(root, folder, `${section}.cpp`), 'utf8');
  const all = sections();
  for (const section of all) for (const of of ['exercises', 'solutions']) yield [section, read(of, section)];
  const roll = dice(Number(seed));
  for (let i = 0; i < slips; ++i) {
    const section = all[roll(all.length)];
    yield [section, slip(read(roll(4) === 0 ? 'exercises' : 'solutions', section), roll)];
  }
}

// And of the gallery, and of some readers.
function* sketches() {
  for (const folder of ['docs/gallery', 'tests/sketches']) for (const file of fs.readdirSync(path.join(root, folder))) yield fs.readFileSync(path.join(root, folder, file), 'utf8');
}

function exercise() {
  const object = (name) => new Uint8Array(fs.readFileSync(path.join(objects, name)));
  const llvm = new WebAssembly.Module(llvmProgram()), names = fs.readdirSync(objects).filter((name) => name.endsWith('.o'));
  const shared = folder([...compilerFiles(), ...courseFiles(eigen), ...sketchFiles(), ...['quick.pch', 'sketch.pch'].map((name) => [`/loop/${name}`, object(name)]), ...names.map((name) => [`/objects/${name}`, object(name)])]);
  for (const [section, text] of answers()) {
    const compiled = compileAnswer(llvm, shared, section, text);
    const others = names.filter((name) => name.endsWith('_ours.o') && !name.startsWith(section)); // what it builds on, and more
    const objects = ['quick.o', 'exceptions.o', 'assertion.o', `${section}_server.o`, `${section}_missing.o`, ...others];
    if (compiled.code === 0) link(llvm, shared, compiled.object, objects.map((name) => `/objects/${name}`));
  }
  for (const text of sketches()) {
    const compiled = compileSketch(llvm, shared, text);
    if (compiled.code !== 0) throw new Error(compiled.said);
    link(llvm, shared, compiled.object, ['sketch_page.o', 'sketch.o', 'quick.o', 'exceptions.o', 'assertion.o'].map((name) => `/objects/${name}`));
  }
}

if (inside) exercise();
else {
  const flags = ['--trace-wasm-compilation-times', '--no-wasm-tier-up', '--max-old-space-size=4000'];
  const traced = spawnSync(process.execPath, [...flags, fileURLToPath(import.meta.url), eigen, objects, slips, seed, 'inside'], { encoding: 'latin1', maxBuffer: 2 ** 30, stdio: ['ignore', 'pipe', 'inherit'] });
  if (traced.status !== 0) throw new Error('the training has failed');
  // The compiler is the module of most functions; what it makes is compiled, too, but never run.
  saveCalled(llvmProgram(), [...traced.stdout.matchAll(/Compiled function 0x\w+#(\d+)/g)].map(([, index]) => Number(index)));
}
