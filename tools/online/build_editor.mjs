// Makes the scripts and the stylesheet of the online edition's pages: node build_editor.mjs OUT
//   OUT/editor.js, OUT/editor.css   for pages with exercises
//   OUT/sketch.js                   for the page about sketches
//   OUT/ticks.js                    for all others
//   OUT/checker.js, OUT/worker.js   what compiles and judges: the editor asks for it at the first Check
//   OUT/service_worker.js           what keeps the site, after it
//   OUT/editor_licences.txt         of what is in them
// Before that the editor asks for OUT/stubs.json.
import { build, transform } from 'esbuild';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const here = path.dirname(fileURLToPath(import.meta.url));
const [out] = process.argv.slice(2);
if (!out) {
  console.error('build_editor.mjs: no folder is named: node build_editor.mjs build/default/site/online');
  process.exit(2);
}

// As the terminal draws them.
function styleOfPictures() {
  const source = path.join(here, '../check/picture.cpp'), style = fs.readFileSync(source, 'utf8').match(/style_of_pictures\(\) \{\s*return R"\((.*?)\)";/s);
  if (!style) throw new Error(`${source} has no style_of_pictures() that returns R"(…)": the editor takes the look of pictures from it`);
  return style[1];
}

// What a page compiles with, besides.
const compilers = `Clang, its linker and libc++, of the LLVM project: Apache 2.0 with LLVM Exceptions (llvm.org/LICENSE.txt), as @yowasp/clang builds them (ISC)
wasi-libc: MIT, Apache 2.0 (github.com/WebAssembly/wasi-libc)
Eigen: MPL 2 (www.mozilla.org/MPL/2.0)
`;

// What comes with a licence must be handed on with it.
function licences(inputs) {
  const folders = new Set(Object.keys(inputs).map((file) => file.match(/^node_modules\/(@[^/]+\/)?[^/]+/)?.[0]).filter(Boolean));
  return [...folders].sort().map((folder) => {
    const { name, version } = JSON.parse(fs.readFileSync(path.join(here, folder, 'package.json')));
    const text = ['LICENSE', 'LICENSE-MIT'].map((file) => path.join(here, folder, file)).find(fs.existsSync);
    return `${name} ${version}\n\n${fs.readFileSync(text, 'utf8')}`;
  }).concat(compilers).join('\n\n');
}

const bundle = (entryPoints, format) => build({ absWorkingDir: here, entryPoints, outdir: path.resolve(out), bundle: true, minify: true, format, target: 'es2022', metafile: true });
// What pages load is no module, which a page that was opened as a file can't load: it is to say so.
const bundles = await Promise.all([bundle({ editor: 'editor.mjs', sketch: 'sketch.mjs', ticks: 'ticks_page.mjs', service_worker: 'service_worker.mjs' }, 'iife'), bundle({ checker: 'checker.mjs', worker: 'worker.mjs' }, 'esm')]);
const { code } = await transform(styleOfPictures() + fs.readFileSync(path.join(here, 'editor.css'), 'utf8'), { loader: 'css', minify: true });
fs.writeFileSync(path.join(out, 'editor.css'), code);
fs.writeFileSync(path.join(out, 'editor_licences.txt'), licences(Object.assign({}, ...bundles.map(({ metafile }) => metafile.inputs))));
