// What answers are compiled behind and linked with, made by the page's own compiler: objects of two compilers never meet.
//     node make_objects.mjs EIGEN OUT                      the precompiled header, and what all sections need
//     node make_objects.mjs EIGEN OUT 08_nt_collisions     a section's server, our solution, and what stands in for functions that a file lacks
//     node make_objects.mjs EIGEN OUT 13_table_hockey 02_momentum...   and, if it plays the reader's of these, what asks for them
//     node make_objects.mjs EIGEN OUT sketches             what sketches begin with, and what shows one, and has functions of all sections asked for
import fs from 'node:fs';
import path from 'node:path';
import { compilerFiles, courseFiles, llvmProgram, sections } from './sources.mjs';
import { compile, compileBehindHeader, compileHeader, compileSketchHeader, folder, headersOf, precompile, precompileSketch, sketchFiles } from './toolchain.mjs';
import { weakened } from '../play/wasm.mjs';

const [eigen, out, section, ...asked] = process.argv.slice(2);
const llvm = new WebAssembly.Module(llvmProgram()), files = [...compilerFiles(), ...courseFiles(eigen)];

function done(result, what) {
  if (result.code === 0) return result;
  console.error(result.said, result.trapped ?? '');
  throw new Error(`the page's compiler refuses ${what}`);
}
const write = (name, bytes) => fs.writeFileSync(path.join(out, name), bytes);
fs.mkdirSync(out, { recursive: true });

if (section === 'sketches') {
  const behind = [...files, ['/loop/quick.pch', new Uint8Array(fs.readFileSync(path.join(out, 'quick.pch')))], ...sketchFiles()];
  const pch = done(precompileSketch(llvm, folder(behind), sections()), 'what sketches begin with').object;
  write('sketch.pch', pch);
  const shared = folder([...behind, ['/loop/sketch.pch', pch]]);
  write('sketch.o', done(compileSketchHeader(llvm, shared), 'the templates of sketches').object);
  const flags = ['-I/tools/play/host', '-DCOURSE_OURS_APART', '-DCOURSE_EMITTED', '-DDEMO="sketched.hpp"', '-include', 'calls.hpp', ...headersOf(sections())];
  write('sketch_page.o', done(compileBehindHeader(llvm, shared, '', '/tools/play/host/page.cpp', ...flags), 'page.cpp').object);
} else if (section) {
  const slug = section.slice(3), shared = folder([...files, ['/loop/quick.pch', new Uint8Array(fs.readFileSync(path.join(out, 'quick.pch')))]]);
  const make = (file, ...flags) => done(compileBehindHeader(llvm, shared, section, file, ...flags), file).object;
  write(`${section}_server.o`, make('/tools/judge/page/server.cpp', `-DCOURSE_SECTION="${slug}.hpp"`));
  write(`${section}_ours.o`, make(`/solutions/${section}.cpp`));
  write(`${section}_missing.o`, weakened(make(`/tests/${section}/stub.cpp`, '-w', '-DCOURSE_STUB_BEHIND', '-include', '/tools/judge/server/missing.hpp')));
  const asking = (after) => ['-I/tools/play/host', '-DCOURSE_OURS_BESIDE', '-include', 'calls.hpp', ...headersOf(asked.filter((one) => one < after))];
  if (asked.length > 0) write(`${section}_asks.o`, make('/tools/play/host/asks.cpp', ...asking(section), '-DCOURSE_EMITTED'));
  for (const one of asked) write(`${section}_asks_${one}.o`, make(`/solutions/${one}.cpp`, `-I/chapters/${one}`, ...asking(one), '-include', 'answers.hpp', '-DCOURSE_IF_CALLED'));
} else {
  const pch = done(precompile(llvm, folder(files)), 'quick.hpp').object;
  write('quick.pch', pch);
  const shared = folder([...files, ['/loop/quick.pch', pch]]);
  write('quick.o', done(compileHeader(llvm, shared), 'the templates of quick.hpp').object);
  for (const name of ['exceptions', 'assertion']) write(`${name}.o`, done(compile(llvm, shared, `/tools/judge/page/${name}.cpp`), name).object);
}
