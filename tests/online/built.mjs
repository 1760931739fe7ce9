// The online edition as it is built.
import fs from 'node:fs';
import path from 'node:path';
import { build } from '../site/browser.mjs';

export const folder = path.join(build, 'online/site');

// What its pages load: the folder online/… of its scripts, and the manifest in it.
export const scriptsIn = (site) => `online/${fs.readdirSync(path.join(site, 'online')).find((name) => !name.includes('.'))}`;
export const manifestIn = (site) => JSON.parse(fs.readFileSync(path.join(site, scriptsIn(site), 'manifest.json')));
