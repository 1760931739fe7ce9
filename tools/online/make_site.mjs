// Puts the online edition together: the site, its pages with the editor, and in online/ what they load.
//     node make_site.mjs SITE PACKS OUT [HANDOUT]     HANDOUT: whose site it is, if it isn't ours
//
// What pages load is in a folder with a name by what's in it, so that a page never meets another version's script.
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import path from 'node:path';
import { onlinePage } from './pages.mjs';
import { listFiles } from './list_files.mjs';
import { stubs } from './sources.mjs';

const [site, packs, out, handout] = process.argv.slice(2);

const files = Object.fromEntries(fs.readdirSync(packs).sort().map((name) => [name, fs.readFileSync(path.join(packs, name))]));
const isPack = (name) => name.endsWith('.gz'), { 'service_worker.js': serviceWorker, ...loaded } = files;
loaded['stubs.json'] = Buffer.from(JSON.stringify(stubs(handout)));
const hash = createHash('sha256');
for (const name of Object.keys(loaded).filter((name) => !isPack(name))) hash.update(name).update(loaded[name]);
const folder = `online/${hash.digest('hex').slice(0, 12)}`;

fs.rmSync(out, { recursive: true, force: true });
fs.cpSync(site, out, { recursive: true });
for (const file of fs.readdirSync(out).filter((name) => name.endsWith('.html'))) {
  const page = path.join(out, file);
  fs.writeFileSync(page, onlinePage(fs.readFileSync(page, 'utf8'), folder, file));
}
// Whoever makes the site may have done some exercises: its readers haven't.
const progress = path.join(out, 'progress.js');
fs.writeFileSync(progress, fs.readFileSync(progress, 'utf8').replaceAll('"done":true', '"done":false').replace(/,"next":\{.*?\}/, ''));
fs.mkdirSync(path.join(out, folder), { recursive: true });
for (const [name, bytes] of Object.entries(loaded)) fs.writeFileSync(path.join(out, isPack(name) ? 'online' : folder, name), bytes);
fs.writeFileSync(path.join(out, 'service_worker.js'), serviceWorker);
listFiles(out);
