// A reader's own copy of the site: demos begin with their code, and what is not there leaves ours, without a word of the browser's.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { describe, test } from 'node:test';
import { build, copyOf, open, wrong } from './browser.mjs';

const seven = '07_segment_intersection', chapter = `chapter_${seven}.html`, front = '08_nt_collisions';
const code = path.join(wrong, 'flies_through.js');
const copy = copyOf(path.join(build, 'mine/site'));

// A page's first demo of section 7, or of the front page, when the reader's code of section 7 is this.
async function openOwn(t, name, script, { place = '', ...options } = {}) {
  fs.writeFileSync(path.join(copy, `demos/${seven}_mine.js`), script);
  const { page, troubles } = await open(t, name, { folder: copy, ...options });
  const figure = page.locator(`.play[data-demo="${name === 'index.html' ? front : seven}"]${place}[data-ready]`).first();
  await figure.waitFor();
  return { page, troubles, figure, yours: figure.getByRole('button', { name: 'Yours', exact: true }) };
}

// One after the other: they share the file.
describe("a reader's own copy", { concurrency: 1 }, () => {
  for (const name of ['index.html', 'play.html', chapter])
    for (const [width, colorScheme] of [[390, 'dark'], [1280, 'light']])
      test(`${name} has our demo while nothing is begun, ${width} px, ${colorScheme}`, async (t) => {
        const { page, troubles, figure, yours } = await openOwn(t, name, '', { width, colorScheme });
        assert.equal(await yours.isVisible(), false);
        assert.match(await figure.locator('.answers').textContent(), /This is our code/);
        assert.match(await page.locator('.bar').textContent(), /your copy/);
        assert.equal(await page.locator('.own').first().isVisible(), name !== 'play.html');
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
        assert.deepEqual(troubles, []);
      });

  test('begins with their code, and takes up what is compiled anew', { skip: !fs.existsSync(code) && 'there is no compiler for pages here' }, async (t) => {
    const own = `${fs.readFileSync(code, 'utf8')}\nself.playable['${seven}/trouble'] = '';\n`;
    const { troubles, figure, yours } = await openOwn(t, chapter, own, { place: '[data-exercise="7.4"]' });
    await figure.scrollIntoViewIfNeeded();
    assert.equal(await yours.getAttribute('aria-pressed'), 'true');
    await figure.locator('.answers', { hasText: 'Yours: 7.4.' }).waitFor();
    fs.writeFileSync(path.join(copy, `demos/${seven}_mine.js`), `self.playable['${seven}/trouble'] = 'a wall is missing';\n`);
    await figure.locator('.trouble', { hasText: 'a wall is missing' }).waitFor({ timeout: 2000 });
    await figure.getByRole('button', { name: 'Ours', exact: true }).click();
    await figure.locator('.trouble').waitFor({ state: 'hidden' });
    assert.deepEqual(troubles, []);
  });
});
