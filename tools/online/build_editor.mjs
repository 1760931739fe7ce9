// Makes the scripts and the stylesheet of the online edition's pages: node build_editor.mjs OUT
//   OUT/editor.js, OUT/editor.css   for pages with exercises
//   OUT/ticks.js                    for all others
//   OUT/editor_licences.txt         of what is in them
// The editor asks for OUT/checker.js when the reader first presses Check, and for OUT/stubs.json before that.
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

// What comes with a licence must be handed on with it.
function licences(inputs) {
  const folders = new Set(Object.keys(inputs).map((file) => file.match(/^node_modules\/(@[^/]+\/)?[^/]+/)?.[0]).filter(Boolean));
  return [...folders].sort().map((folder) => {
    const { name, version } = JSON.parse(fs.readFileSync(path.join(here, folder, 'package.json')));
    return `${name} ${version}\n\n${fs.readFileSync(path.join(here, folder, 'LICENSE'), 'utf8')}`;
  }).join('\n\n');
}

const { metafile } = await build({
  absWorkingDir: here,
  entryPoints: { editor: 'editor.mjs', ticks: 'ticks_page.mjs' },
  outdir: path.resolve(out),
  bundle: true,
  minify: true,
  format: 'iife', // not as modules, which a page that was opened as a file can't load: it is to say so
  target: 'es2022',
  metafile: true,
});
const { code } = await transform(styleOfPictures() + fs.readFileSync(path.join(here, 'editor.css'), 'utf8'), { loader: 'css', minify: true });
fs.writeFileSync(path.join(out, 'editor.css'), code);
fs.writeFileSync(path.join(out, 'editor_licences.txt'), licences(metafile.inputs));
