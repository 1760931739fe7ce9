// The handout to write in, as `./course export handout --online` makes it of what is committed: ours are in none of its files,
// and answers are judged as elsewhere.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { gunzipSync } from 'node:zlib';
import { browser, build, root } from '../site/browser.mjs';
import { manifestIn, scriptsIn } from './built.mjs';
import { inBox, open } from './served.mjs';
import { serve } from './server.mjs';

const out = fs.mkdtempSync(path.join(os.tmpdir(), 'handout-')), folder = path.join(out, 'frame-by-frame-online');
after(() => fs.rmSync(out, { recursive: true }));
execFileSync(path.join(build, 'course-tool'), ['export', 'handout', out, '--online'], { env: { ...process.env, COURSE_ROOT: root, COURSE_BUILD: build } });

const read = (...names) => fs.readFileSync(path.join(root, ...names), 'utf8');
const bare = (text) => text.replace(/\s+/g, ''), enough = 20; // letters that aren't by chance the same
const sections = Object.keys(manifestIn(folder).sections);

// What anybody may read of a section: its headers, its tests, and the chapter with its hints.
function readByAll(section) {
  const chapter = path.join('chapters', section), code = fs.readdirSync(path.join(root, chapter)).filter((name) => /\.[ch]pp$/.test(name));
  const text = read(chapter, 'README.md').replace(/^<details><summary>Our solution[^]*?^<\/details>/gm, '');
  return [...code.map((name) => read(chapter, name)), read('tests', section, 'tests.cpp'), read('tests', section, 'stub.cpp'), text].join('\n');
}
const known = bare(sections.map(readByAll).join('\n'));
const lines = sections.flatMap((section) => read('solutions', `${section}.cpp`).split('\n')).filter((line) => !/^\s*\/\//.test(line)).map(bare)
  .filter((line) => line.length >= enough && !known.includes(line));

// A page or a script without what's between its letters.
const letters = { '&lt;': '<', '&gt;': '>', '&quot;': '"', '&#39;': "'", '&amp;': '&' };
const shown = (text) => bare(text.replaceAll('\\n', '\n').replaceAll('\\"', '"').replace(/<\/?[a-z][^>]*>/g, '').replace(/&\w+;|&#39;/g, (one) => letters[one] ?? one));
const files = fs.readdirSync(folder, { recursive: true }).filter((name) => fs.statSync(path.join(folder, name)).isFile());

test('no line of ours is in a page or a script', () => {
  assert.ok(lines.length > 300, `only ${lines.length} lines are known`);
  for (const name of files.filter((one) => /\.(html|js|json|svg|css|txt)$/.test(one))) {
    const text = shown(fs.readFileSync(path.join(folder, name), 'utf8'));
    assert.deepEqual(lines.filter((line) => text.includes(line)), [], name);
  }
});

test('nor in what a page compiles and judges with', () => {
  const all = new Set(lines), packs = files.filter((name) => name.endsWith('.gz'));
  assert.equal(packs.length, sections.length + 6);
  for (const name of packs) {
    const inside = gunzipSync(fs.readFileSync(path.join(folder, name))).toString('latin1').split('\n').map(bare);
    assert.deepEqual(inside.filter((line) => all.has(line)), [], name);
  }
});

test('a file says which tests it was handed out with', () => {
  const stubs = JSON.parse(fs.readFileSync(path.join(folder, scriptsIn(folder), 'stubs.json')));
  assert.deepEqual(Object.keys(stubs), sections);
  for (const { stub } of Object.values(stubs)) assert.match(stub, /\n\/\/ Handed out with tests [0-9a-f]{12} \([\d.]+\)\.\n$/);
});

test('a student’s answer is judged there, and a solution is offered nowhere', async (t) => {
  const host = await serve(folder, [], '/phys');
  const { page } = await open(t, `${host}/chapter_08_nt_collisions.html#exercise-8.1`), box = inBox(page);
  page.setDefaultTimeout(120_000); // a busy machine compiles slowly
  await box.code.waitFor();
  await box.check();
  assert.equal((await box.verdict.textContent()).split('\n')[0], '· 8.1 decompose, core: not started');
  assert.equal(await page.locator('details.solution').count(), 0);
});
