// Links readers' files into modules whose functions a demo may call, and packs them as the reader's in it:
//     link_answers.mjs OUT.js DEMO compiler and its words... -- SECTION=FILE.cpp,OBJECT,OBJECT... SECTION=...
// Of sections that aren't the demo's those that aren't begun are left out, and one that doesn't compile is null: see
// earlier.cjs. Among the objects those whose names end in _missing.o stand in for functions that a file lacks.
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { gzipSync } from 'node:zlib';
import { withFuel } from './fuel.mjs';
import { weakened } from './wasm.mjs';

const [out, demo, ...words] = process.argv.slice(2), root = path.join(import.meta.dirname, '../..');
const command = words.slice(0, words.indexOf('--')), entries = words.slice(words.indexOf('--') + 1);
const isBroken = (object) => fs.readFileSync(object, { encoding: 'utf8' }).startsWith('broken');
const isBegun = (section, file) => !fs.readFileSync(file).equals(fs.readFileSync(path.join(root, 'tests', section, 'stub.cpp')));

function link(section, objects) {
  const weak = objects.filter((object) => object.endsWith('_missing.o')).map((object) => {
    const copy = `${out}.${path.basename(object)}`;
    fs.writeFileSync(copy, weakened(new Uint8Array(fs.readFileSync(object))));
    return copy;
  });
  const strong = objects.filter((object) => !object.endsWith('_missing.o') && !isBroken(object)), linked = `${out}.${section}.wasm`;
  const { status } = spawnSync(command[0], [...command.slice(1), ...strong, ...weak, '-o', linked], { stdio: 'inherit' });
  if (status !== 0) process.exit(1);
  const module = withFuel(new Uint8Array(fs.readFileSync(linked)));
  for (const file of [...weak, linked]) fs.rmSync(file);
  return gzipSync(module, { level: 9 }).toString('base64');
}

const packed = {};
for (const entry of entries) {
  const [section, parts] = entry.split('='), [file, ...objects] = parts.split(',');
  if (demo.endsWith(section) || isBegun(section, file)) packed[section] = isBroken(objects[0]) ? null : link(section, objects);
}
fs.writeFileSync(out, `(self.playable ??= {})['${demo}/mine'] = ${JSON.stringify(packed)};\n`);
