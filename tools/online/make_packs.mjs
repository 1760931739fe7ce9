// What a page loads before its first verdict, as files whose names change with what is in them, and manifest.json, which names them.
//     node make_packs.mjs EIGEN BUILT OUT SECTION=EARLIER,EARLIER…     BUILT: what cmake/Online.cmake has made
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import path from 'node:path';
import { gzipSync } from 'node:zlib';
import { cut, loadCalled } from './cut.mjs';
import { pack } from './pack.mjs';
import { compilerFiles, courseFiles, llvmProgram, root } from './sources.mjs';
import { libraries, sketchFiles } from './toolchain.mjs';

const [eigen, built, out, ...sections] = process.argv.slice(2);
const made = (name) => new Uint8Array(fs.readFileSync(path.join(built, name)));
const object = (name) => [`/objects/${name}`, made(`objects/${name}`)];
const source = (name) => [`/${name}`, new Uint8Array(fs.readFileSync(path.join(root, name)))];

fs.rmSync(out, { recursive: true, force: true });
fs.mkdirSync(out, { recursive: true });
function save(name, bytes) {
  const zipped = gzipSync(bytes, { level: 9 }), hash = createHash('sha256').update(zipped).digest('hex').slice(0, 12);
  const file = `${name}-${hash}.gz`;
  fs.writeFileSync(path.join(out, file), zipped);
  return { file, bytes: zipped.length };
}

// Headers that are in the precompiled one, too: warnings look into them.
function files() {
  const needed = [...compilerFiles(), ...courseFiles(eigen)].filter(([name]) => /^\/(usr\/include|eigen|loop|tools\/judge\/page\/libcxx)\/|^\/chapters\/[^/]*$/.test(name) || libraries.includes(name));
  return [...needed, ...['quick.o', 'exceptions.o', 'assertion.o'].map(object)];
}
function section(name, earlier) {
  const header = (one) => source(`chapters/${one}/${one.slice(3)}.hpp`);
  const texts = [`tests/${name}/mistakes.tsv`, `tests/${name}/stub.cpp`, `chapters/${name}/renamed.txt`].filter((file) => fs.existsSync(path.join(root, file)));
  const asking = fs.readdirSync(path.join(built, 'objects')).filter((file) => file.startsWith(`${name}_asks`)); // the reader's of earlier sections
  const called = asking.length > 0 ? asking : earlier.map((one) => `${one}_ours.o`);
  return pack([...[name, ...earlier].map(header), ...texts.map(source), ['/tests.wasm', made(`${name}.wasm`)], ['/catalogue.json', made(`../catalogue/${name}.json`)],
    ...[`${name}_server.o`, `${name}_missing.o`, ...called].map(object)]);
}

const names = sections.map((each) => each.split('=')[0]);
// Of sketches: all sections' headers, and what their scenes share; and what one is compiled behind and linked with.
const headers = (name) => fs.readdirSync(path.join(root, 'chapters', name), { recursive: true }).filter((file) => file.endsWith('.hpp')).map((file) => source(`chapters/${name}/${file}`));
const sketches = () => pack([...names.flatMap(headers), ...sketchFiles(), ['/loop/sketch.pch', made('objects/sketch.pch')],
  ...['sketch.o', 'sketch_page.o'].map(object)]);

const compiler = llvmProgram();
const manifest = {
  compiler: save('compiler', cut(compiler, loadCalled(compiler))),
  wholeCompiler: save('whole_compiler', compiler),
  header: save('header', made('objects/quick.pch')),
  files: save('files', pack(files())),
  words: save('words', made('words.wasm')),
  sketches: save('sketches', sketches()),
  sections: Object.fromEntries(sections.map((each) => each.split('=')).map(([name, earlier]) => [name, save(name, section(name, earlier.split(',').filter(Boolean)))])),
};
fs.writeFileSync(path.join(out, 'manifest.json'), JSON.stringify(manifest));

// What the page about sketches loads as it is: scenes to begin with, and our functions.
for (const file of ['scenes.json', ...names.map((name) => `ours/${name}.js`)]) fs.copyFileSync(path.join(built, file), path.join(out, file.replace('/', '_')));
