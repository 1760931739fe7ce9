// A reader's own copy of the site: demos begin with their code, and what is not there leaves ours, without a word of the browser's.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const build = path.resolve(process.env.COURSE_BUILD ?? path.join(root, 'build/default'));
const seven = '07_segment_intersection', chapter = `chapter_${seven}.html`;
const code = path.join(build, 'play/wrong/flies_through.js'); // compiled only where there is a compiler for pages

let browser, copy;
before(async () => {
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu'] });
  copy = fs.mkdtempSync(path.join(os.tmpdir(), 'own-site-'));
  fs.cpSync(path.join(build, 'mine/site'), copy, { recursive: true });
});
after(async () => {
  await browser.close();
  fs.rmSync(copy, { recursive: true });
});

// The first demo of a page, when the reader's code is this.
async function open(name, script, { width = 1280, colorScheme = 'light' } = {}) {
  fs.writeFileSync(path.join(copy, `demos/${seven}_mine.js`), script);
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme });
  const page = await context.newPage(), troubles = [];
  page.on('console', (message) => troubles.push(message.text()));
  page.on('pageerror', (error) => troubles.push(error.message));
  page.on('requestfailed', (request) => troubles.push(`cannot read ${request.url()}`));
  await page.goto(pathToFileURL(path.join(copy, name)).href);
  const figure = page.locator(`.play[data-demo="${seven}"][data-ready]`).first();
  await figure.waitFor();
  return { page, context, troubles, figure, yours: figure.getByRole('button', { name: 'Yours', exact: true }) };
}

// One after the other: they share the file.
describe("a reader's own copy", { concurrency: 1 }, () => {
  for (const name of ['index.html', 'play.html', chapter])
    for (const [width, colorScheme] of [[390, 'dark'], [1280, 'light']])
      test(`${name} has our demo while nothing is begun, ${width} px, ${colorScheme}`, async () => {
        const { page, context, troubles, figure, yours } = await open(name, '', { width, colorScheme });
        assert.equal(await yours.isVisible(), false);
        assert.match(await figure.locator('.answers').textContent(), /This is our code/);
        assert.match(await page.locator('.bar').textContent(), /your copy/);
        assert.equal(await page.locator('.own').first().isVisible(), name !== 'play.html');
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
        assert.deepEqual(troubles, []);
        await context.close();
      });

  test('begins with their code, and takes up what is compiled anew', { skip: !fs.existsSync(code) && 'there is no compiler for pages here' }, async () => {
    const own = `${fs.readFileSync(code, 'utf8')}\nself.playable['${seven}/trouble'] = '';\n`;
    const { page, context, troubles, figure, yours } = await open('index.html', own);
    assert.equal(await yours.getAttribute('aria-pressed'), 'true');
    await figure.locator('.answers', { hasText: 'Yours: 7.4.' }).waitFor();
    fs.writeFileSync(path.join(copy, `demos/${seven}_mine.js`), `self.playable['${seven}/trouble'] = 'a wall is missing';\n`);
    await figure.locator('.trouble', { hasText: 'a wall is missing' }).waitFor({ timeout: 2000 });
    await figure.getByRole('button', { name: 'Ours', exact: true }).click();
    await figure.locator('.trouble').waitFor({ state: 'hidden' });
    assert.deepEqual(troubles, []);
    await page.close();
    await context.close();
  });
});
