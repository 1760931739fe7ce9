// Lists the files of the online edition with their checksums, for its service worker, which knows the list by its own:
// so it changes with each of them.
//     node list_files.mjs FOLDER     after a change to a file in it
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const checksum = (bytes) => `sha256-${createHash('sha256').update(bytes).digest('base64')}`;

// Seldom needed and large: the whole compiler. It's kept once it was loaded.
const isForLater = (name) => /^online\/whole_compiler-/.test(name);
// Those that make the list, and pictures for whoever links to a page.
const isKept = (name) => !/\.png$|^(online\/files\.json|service_worker\.js)$/.test(name);

export function listFiles(folder) {
  const inside = fs.readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile())
    .map((entry) => path.relative(folder, path.join(entry.parentPath ?? entry.path, entry.name))).filter(isKept).sort();
  const read = (name) => fs.readFileSync(path.join(folder, name));
  const files = Object.fromEntries(inside.filter((name) => !isForLater(name)).map((name) => [name, checksum(read(name))]));
  const list = JSON.stringify({ files, later: inside.filter(isForLater) });
  fs.writeFileSync(path.join(folder, 'online/files.json'), list);
  const script = read('service_worker.js').toString().replace(/^self\.version = .*\n/, '');
  fs.writeFileSync(path.join(folder, 'service_worker.js'), `self.version = '${checksum(list)}';\n${script}`);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) listFiles(process.argv[2]);
