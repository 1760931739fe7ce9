// A worker of a page: compiles a reader's file, links it, has the tests call it, and tells what the terminal would print.
import { withFuel } from '../play/fuel.mjs';
import { judge } from './judge.mjs';
import { cacheOf } from './kept.mjs';
import { load } from './load.mjs';
import { unpack } from './pack.mjs';
import { compileAnswer, compileSketch, folder, link } from './toolchain.mjs';
import { definedFunctions } from '../play/wasm.mjs';
import { loadWords } from './words.mjs';

const seed = 2026; // as in `./course check`
const decoder = new TextDecoder();
let manifest, tell; // `tell` of the check that is running

// A file of the manifest, unzipped, as a response; what arrives is told. It's kept for the next time, where a browser keeps
// anything: a page that isn't from a safe address has no caches.
const arrived = { loaded: 0, total: 0 };
async function loadPack({ file, bytes }, what) {
  arrived.total += bytes;
  const address = new URL(`../${file}`, location), packs = await self.caches?.open(cacheOf(new URL('../..', location), 'packs'));
  const kept = await packs?.match(address), response = kept ?? await load(address, what);
  if (!kept) packs?.put(address, response.clone()).catch(() => { /* no room */ });
  const count = new TransformStream({
    transform(part, to) {
      arrived.loaded += part.length;
      tell({ step: 'load', ...arrived });
      to.enqueue(part);
    },
  });
  return new Response(response.body.pipeThrough(count).pipeThrough(new DecompressionStream('gzip')), { headers: { 'content-type': 'application/wasm' } });
}
const loadBytes = async (...pack) => new Uint8Array(await (await loadPack(...pack)).arrayBuffer());
const loadModule = (...pack) => WebAssembly.compileStreaming(loadPack(...pack));

// Each of these is loaded once. What failed is tried again at the next check.
const kept = new Map();
function once(name, make) {
  if (!kept.has(name)) kept.set(name, make().catch((error) => {
    kept.delete(name);
    throw error;
  }));
  return kept.get(name);
}
const compiler = () => once('compiler', () => loadModule(manifest.compiler, 'the compiler'));
const words = () => once('words', async () => loadWords(await loadModule(manifest.words, 'the compiler')));
const commonFiles = () => once('files', async () => {
  const [files, header] = await Promise.all([loadBytes(manifest.files, 'the compiler'), loadBytes(manifest.header, 'the compiler')]);
  return [...unpack(files), ['/loop/quick.pch', header]];
});
const linkedWith = (files) => ({ shared: folder(files), objects: files.map(([name]) => name).filter((name) => name.startsWith('/objects/')) });
const sectionParts = (section) => once(section, async () => {
  const [common, own] = await Promise.all([commonFiles(), loadBytes(manifest.sections[section], `what tests section ${Number(section.slice(0, 2))}`).then(unpack)]);
  const tests = await WebAssembly.compile(own.find(([name]) => name === '/tests.wasm')[1]);
  const text = (name) => decoder.decode(own.find(([file]) => file === name)?.[1] ?? new Uint8Array());
  return {
    tests,
    ...linkedWith([...own, ...common]),
    facts: {
      section,
      sections: Object.keys(manifest.sections),
      exercises: JSON.parse(text('/catalogue.json')).exercises,
      header: text(`/chapters/${section}/${section.slice(3)}.hpp`),
      stub: text(`/tests/${section}/stub.cpp`),
      mistakes: text(`/tests/${section}/mistakes.tsv`),
      renamed: text(`/chapters/${section}/renamed.txt`),
    },
  };
});

// A step of the compiler's; where the cut one lacks a function, by the whole one, and so from then on.
async function compilerStep(work) {
  const result = work(await compiler());
  if (!result.trapped) return result;
  const whole = await once('whole compiler', () => loadModule(manifest.wholeCompiler, 'the part of the compiler that this code needs'));
  kept.set('compiler', Promise.resolve(whole));
  return work(whole);
}

// What Clang calls a `main` for WASI. A page's module has none, so its linker takes one where the terminal's refuses it.
const mains = new Set(['main', '__main_void', '__main_argc_argv', '__original_main']);

// What a file becomes: { compiler: what was printed, module, as bytes, symbols }, or where it ended: { step, compiler }.
async function toModule(compile, { shared, objects }) {
  tell({ step: 'compile' });
  const compiled = await compilerStep((llvm) => compile(llvm, shared));
  if (compiled.code !== 0) return { step: 'not compiled', compiler: compiled.said || compiled.trapped };
  const symbols = definedFunctions(compiled.object);
  if (symbols.some((name) => mains.has(name))) return { step: 'not linked', compiler: "multiple definition of `main'" };
  tell({ step: 'link' });
  const linked = await compilerStep((llvm) => link(llvm, shared, compiled.object, objects));
  if (linked.code !== 0) return { step: 'not linked', compiler: linked.said || linked.trapped };
  return { compiler: compiled.said, module: withFuel(linked.linked), symbols };
}

async function check({ section, exercise, text }) {
  const [parts, report] = await Promise.all([sectionParts(section), words(), compiler()]);
  const about = { ...parts.facts, only: exercise, text, file: `/own/${section}.cpp` };
  const { module, ...built } = await toModule((llvm, shared) => compileAnswer(llvm, shared, section, text), parts);
  if (!module) return report({ ...about, ...built });
  const verdicts = [];
  tell({ step: 'test', module });
  judge(parts.tests, await WebAssembly.compile(module), exercise, seed, (verdict) => verdicts.push(verdict));
  return report({ ...about, ...built, step: 'compiled', verdicts });
}

const sketchParts = () => once('sketches', async () => {
  const [common, own] = await Promise.all([commonFiles(), loadBytes(manifest.sketches, 'what sketches need').then(unpack)]);
  return linkedWith([...own, ...common]);
});

// A sketch: { module, as bytes } or, if it can't be compiled, as a check says it: { text, place }.
async function sketch({ text }) {
  const [parts, report] = await Promise.all([sketchParts(), words(), compiler()]);
  const { module, ...built } = await toModule((llvm, shared) => compileSketch(llvm, shared, text), parts);
  return module ? { module } : report({ sketch: true, section: '00_sketch', exercises: [], file: '/own/sketch.cpp', name: 'sketch.cpp', text, ...built });
}

// How it went, as `./course feedback` writes it: { text }.
const feedback = async ({ attempts, hints }) => (await words())({ attempts, hints });

// One check after the other, in the order in which they came.
let last = Promise.resolve();
addEventListener('message', ({ data: { id, ...request } }) => {
  last = last.then(async () => {
    tell = (progress) => postMessage({ id, progress });
    try {
      manifest ??= await (await load('manifest.json', 'the compiler')).json();
      postMessage({ id, result: await (request.section ? check : request.attempts ? feedback : sketch)(request) });
    } catch (error) {
      postMessage({ id, error: String(error?.message ?? error) });
    }
  });
});
