// Packs a demo for a page, compares two packed ones, and prints what is in one:
//     pack.cjs demo.wasm NAME   pack.cjs --same ONE TWO   pack.cjs --unpack ONE
//     pack.cjs demo.wasm NAME --fuel     one with a reader's code in it, which may never end: see fuel.mjs
// A page from disk can read scripts only, so WebAssembly travels as base64 of gzip. What another version of gzip makes
// of the same bytes may differ: what is compared is what was packed.
'use strict';
const fs = require('node:fs'), zlib = require('node:zlib');
// All that's packed in a script: a demo, or answers (link_answers.mjs). Whatever gzip makes begins alike.
const packed = (file) => Buffer.concat([...fs.readFileSync(file, 'utf8').matchAll(/['"](H4sI[^'"]*)['"]/g)].map(([, text]) => zlib.gunzipSync(Buffer.from(text, 'base64'))));
const [first, second, third] = process.argv.slice(2);
async function pack() {
  const module = fs.readFileSync(first), shipped = third === '--fuel' ? (await import('./fuel.mjs')).withFuel(new Uint8Array(module)) : module;
  process.stdout.write(`(self.playable ??= {})['${second}'] = '${zlib.gzipSync(shipped, { level: 9 }).toString('base64')}';\n`);
}
if (first === '--same') process.exitCode = packed(second).equals(packed(third)) ? 0 : 1;
else if (first === '--unpack') process.stdout.write(packed(second));
else pack();
