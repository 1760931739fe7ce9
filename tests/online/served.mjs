// What the tests of the editor share: a site of two chapters and the front page, served as a static host would, with a
// checker that only plays its part.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { onlinePage } from '../../tools/online/pages.mjs';
import { stubs } from '../../tools/online/sources.mjs';
import { serve } from './server.mjs';
import { browser, copyOf, root, site } from '../site/browser.mjs';

export const one = 'chapter_01_motion.html', eight = 'chapter_08_nt_collisions.html', section = '08_nt_collisions';
export const folder = copyOf(site, (name) => !/\.html$/.test(name) || [one, eight, 'index.html'].includes(path.basename(name)));

export const { stub } = stubs()[section];

// Its verdict is by the text: `right`, `broken`, without `mended`, or `forever` in it; else one test is red.
const checker = `
const red = (words) => '\\x1b[31m' + words + '\\x1b[0m', bold = (words) => '\\x1b[1m' + words + '\\x1b[0m';
export class Checker {
  constructor(base) { (self.asked ??= []).push(base); }
  stop() { this.end?.(new DOMException('stopped', 'AbortError')); }
  async feedback(records) {
    const attempts = records.flatMap((record) => record.attempts);
    return { text: attempts.length > 0 ? JSON.stringify(attempts) : '' };
  }
  async check({ section, exercise, text, progress }) {
    self.asked.push({ section, exercise, text });
    progress({ step: 'load', loaded: 12_000_000, total: 30_000_000 });
    if (text.includes('forever')) await new Promise((done, failed) => (this.end = failed));
    progress({ step: 'compile' });
    if (text.includes('broken') && !text.includes('mended')) {
      const line = text.split('\\n').findIndex((one) => one.includes('broken')) + 1;
      return { text: red('✗ exercises/' + section + '.cpp does not compile') + '\\n    exercises/' + section + '.cpp:' + line + ': what is broken?\\n',
        states: { [exercise]: 'does not compile' }, mistake: '', picture: null, place: { line, column: 5 } };
    }
    if (text.includes('right')) return { text: '\\x1b[32m✓ ' + exercise + ' is done\\x1b[0m: 12 tests passed\\n', states: { [exercise]: 'passed' }, mistake: '', picture: null, place: null };
    return { text: red('✗ ' + exercise) + ': 7 of 12 tests passed\\n    ' + red('✗') + ' ' + bold('how far apart <the> centres are') + '\\n      see       tests/' + section + '/tests.cpp:41\\n    \\x1b[33mThis is what comes out when you forget it.\\x1b[0m\\n\\x1b[2mdim\\x1b[0m\\n',
      states: { [exercise]: 'wrong' }, place: null, mistake: 'you forget it.',
      picture: '<svg class="verdict-picture" xmlns="http://www.w3.org/2000/svg" width="480" height="300" viewBox="0 0 480 300" role="img" aria-label="the call"><circle class="yours dot" cx="99" cy="99" r="9"/></svg>' };
  }
}
`;

for (const name of [one, eight, 'index.html']) {
  const file = path.join(folder, name);
  fs.writeFileSync(file, onlinePage(fs.readFileSync(file, 'utf8'), 'online'));
}
execFileSync('node', [path.join(root, 'tools/online/build_editor.mjs'), path.join(folder, 'online')]);
fs.writeFileSync(path.join(folder, 'online/stubs.json'), JSON.stringify(stubs()));
fs.writeFileSync(path.join(folder, 'online/checker.js'), checker);

export const asked = []; // names of files, as they were asked for
export const host = await serve(folder, asked);

// A page in this context, or in one of its own, and what goes wrong on it.
export async function open(t, name = `${eight}#exercise-8.1`, { context, width = 1280, ...more } = {}) {
  if (!context) {
    context = await (await browser()).newContext({ viewport: { width, height: 900 }, ...more });
    t.after(() => context.close());
    await context.addInitScript('delete Navigator.prototype.serviceWorker'); // which offline.test.mjs tries
  }
  const page = await context.newPage(), troubles = [];
  page.on('console', (message) => troubles.push(message.text()));
  page.on('pageerror', (error) => troubles.push(error.message));
  page.on('request', (request) => request.url().startsWith(host) || /^(data|blob|file|about):/.test(request.url()) || troubles.push(`asks for ${request.url()}`));
  page.on('response', (response) => response.ok() || troubles.push(`${response.status()} ${response.url()}`));
  await page.goto(/^\w+:/.test(name) ? name : `${host}/${name}`);
  return { page, troubles, context };
}

export { inBox } from './in_box.mjs';

// What the browser keeps: the records of all sections.
export const kept = (page) => page.evaluate(() => new Promise((done) => {
  indexedDB.open('frame-by-frame').onsuccess = ({ target: { result } }) => {
    result.transaction('sections').objectStore('sections').getAll().onsuccess = ({ target }) => (result.close(), done(target.result));
  };
}));

// When these words are kept.
export async function saved(page, words) {
  while (!(await kept(page)).some(({ text }) => text.includes(words))) await page.waitForTimeout(50);
}
