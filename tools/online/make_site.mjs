// Puts the online edition together: the site, its pages with the editor, and in online/ what they load.
//     node make_site.mjs SITE PACKS OUT
import fs from 'node:fs';
import path from 'node:path';
import { onlinePage } from './pages.mjs';
import { stubs } from './sources.mjs';

const [site, packs, out] = process.argv.slice(2);

fs.rmSync(out, { recursive: true, force: true });
fs.cpSync(site, out, { recursive: true });
for (const file of fs.readdirSync(out).filter((name) => name.endsWith('.html'))) {
  const page = path.join(out, file);
  fs.writeFileSync(page, onlinePage(fs.readFileSync(page, 'utf8')));
}
fs.cpSync(packs, path.join(out, 'online'), { recursive: true });
fs.writeFileSync(path.join(out, 'online/stubs.json'), JSON.stringify(stubs()));
