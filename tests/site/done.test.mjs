// What the pages say of what is done: by progress.js, which `course check` writes and this makes up.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const site = path.resolve(process.env.COURSE_BUILD ?? path.join(root, 'build/default'), 'site');
const axe = fs.readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const seven = 'chapter_07_segment_intersection.html';

let browser, copy;
before(async () => {
  browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu'] });
  copy = fs.mkdtempSync(path.join(os.tmpdir(), 'site-'));
  fs.cpSync(site, copy, { recursive: true });
});
after(async () => {
  await browser.close();
  fs.rmSync(copy, { recursive: true });
});

// As if these exercises had passed.
function done(...numbers) {
  const functions = ['intersect_lines', 'segments_intersect', 'common_points', 'move_and_bounce', 'time_of_impact', 'orientation'];
  const exercises = functions.map((name, at) => ({ number: `7.${at + 1}`, function: name, done: numbers.includes(`7.${at + 1}`) }));
  const next = exercises.find((one) => !one.done);
  const known = { sections: [{ number: '7', page: seven, exercises }], ...(next && { next: { ...next, address: `${seven}#exercise-${next.number}` } }) };
  fs.writeFileSync(path.join(copy, 'progress.js'), `self.progress = ${JSON.stringify(known)};\n`);
}

async function open(name, { width = 1280, ...more } = {}) {
  const context = await browser.newContext({ viewport: { width, height: 900 }, ...more });
  const page = await context.newPage(), troubles = [];
  page.on('console', (message) => troubles.push(message.text()));
  page.on('pageerror', (error) => troubles.push(error.message));
  await page.goto(pathToFileURL(path.join(copy, name)).href);
  return { page, troubles, context };
}
const boxes = (page) => page.$$eval('.turn[data-exercise]', (all) => all.map((box) => [
  box.dataset.exercise, box.querySelector('.done')?.textContent ?? '', [...box.children].slice(1).every((part) => !part.checkVisibility())]));

// One after the other: they share the file.
describe('what is done', { concurrency: 1 }, () => {
  test('has a tick and a word at its boxes, which are folded, and nothing else has', async () => {
    done('7.2', '7.3');
    const { page, troubles, context } = await open(seven);
    for (const [number, words, folded] of await boxes(page)) {
      const isDone = ['7.2', '7.3'].includes(number);
      assert.equal(words, isDone ? '✓ Done' : '', number);
      assert.equal(folded, isDone, number);
    }
    assert.deepEqual(troubles, []);
    await context.close();
  });

  test('opens at its button, by keys as well, and for a link into it', async () => {
    done('7.2');
    const { page, context } = await open(seven);
    const box = page.locator('#exercise-7\\.2'), inside = box.locator('p').first(), button = box.locator('.unfold');
    assert.equal(await inside.isVisible(), false);
    assert.equal(await button.getAttribute('aria-expanded'), 'false');
    await button.focus();
    await page.keyboard.press('Enter');
    assert.equal(await inside.isVisible(), true);
    assert.equal(await button.getAttribute('aria-expanded'), 'true');
    await button.click();
    assert.equal(await inside.isVisible(), false);
    await page.evaluate(() => (location.hash = 'exercise-7.2'));
    await inside.waitFor({ state: 'visible' });
    await page.reload();
    assert.equal(await inside.isVisible(), true, 'a link leads into it');
    await context.close();
  });

  test('is in the contents: how many, all, and the parts of this page; and in its table of exercises', async () => {
    done('7.1', '7.3');
    const { page, context } = await open(seven);
    const entry = page.locator(`#site-contents a[href="${seven}"]`);
    assert.match(await entry.textContent(), /2\/6 done$/);
    const parts = () => page.$$eval('#site-contents .parts > li > a:has(.done)', (links) => links.map((link) => link.hash));
    assert.deepEqual(await parts(), ['#where-two-lines-cross', '#a-detour-what-they-have-in-common']);
    await page.evaluate(() => { // a number in another table is no exercise
      document.querySelector('main').insertAdjacentHTML('beforeend', '<table><tr><td>7.1</td><td>7.2</td></tr></table>');
      dispatchEvent(new Event('focus'));
    });
    await page.waitForTimeout(300);
    const rows = await page.$$eval('main td:has(> .done)', (cells) => cells.map((cell) => cell.textContent));
    assert.deepEqual(rows, ['7.1✓ done', '7.3✓ done']);
    done('7.1', '7.2', '7.3', '7.4', '7.5', '7.6');
    await page.goto(pathToFileURL(path.join(copy, 'readme.html')).href);
    assert.match(await entry.textContent(), /✓ done$/);
    await context.close();
  });

  test('that is red again loses its tick when the reader comes back to the page; what is new is not folded', async () => {
    done('7.1');
    const { page, context } = await open(seven);
    done('7.2');
    await page.evaluate(() => dispatchEvent(new Event('focus')));
    await page.locator('#exercise-7\\.2 .done').waitFor();
    const states = Object.fromEntries((await boxes(page)).map(([number, ...state]) => [number, state]));
    assert.deepEqual(states['7.1'], ['', false]);
    assert.deepEqual(states['7.2'], ['✓ Done', false]);
    await context.close();
  });

  test('is said wherever it is asked for, and there is somewhere to go on', async () => {
    done('7.1');
    const { page, context } = await open(seven);
    const said = await page.evaluate(() => {
      document.querySelector('main').insertAdjacentHTML('beforeend', '<p><span data-progress="7"></span><span data-progress="1"></span><a data-go-on hidden></a></p>');
      dispatchEvent(new Event('focus'));
      return new Promise((read) => setTimeout(() => read([...document.querySelectorAll('[data-progress], [data-go-on]')].map((one) => [one.textContent, one.getAttribute('href')])), 300));
    });
    assert.deepEqual(said, [['✓ 1 of 6 done', null], ['', null], ['Go on: 7.2', `${seven}#exercise-7.2`]]);
    await context.close();
  });

  test('is on the front page: how far in each section, and where to go on', async () => {
    done('7.1');
    const { page, troubles, context } = await open('index.html', { width: 390 });
    assert.deepEqual(await page.$$eval('.card [data-progress]', (all) => all.map((one) => [one.dataset.progress, one.textContent]).filter(([, said]) => said)), [['7', '✓ 1 of 6 done']]);
    assert.deepEqual(troubles, []);
    await page.getByRole('link', { name: 'Go on: 7.2' }).click();
    await page.waitForURL(/07_segment_intersection\.html#exercise-7\.2$/);
    fs.rmSync(path.join(copy, 'progress.js'));
    await page.goto(pathToFileURL(path.join(copy, 'index.html')).href);
    assert.equal(await page.locator('.go a').last().isVisible(), false, 'nothing to go on with');
    await context.close();
  });

  test('is on paper as if it were open, and nothing is lost without scripts or without the file', async () => {
    done('7.1');
    const printed = await open(seven);
    await printed.page.emulateMedia({ media: 'print' });
    assert.equal(await printed.page.locator('#exercise-7\\.1 p').first().isVisible(), true);
    assert.equal(await printed.page.locator('.done').first().isVisible(), false);
    await printed.context.close();
    const plain = await open(seven, { javaScriptEnabled: false });
    assert.equal(await plain.page.locator('#exercise-7\\.1 p').first().isVisible(), true);
    assert.equal(await plain.page.locator('.done').count(), 0);
    await plain.context.close();
    fs.rmSync(path.join(copy, 'progress.js'));
    const { page, context } = await open(seven);
    assert.equal(await page.locator('#exercise-7\\.1 p').first().isVisible(), true);
    assert.equal(await page.locator('.done').count(), 0);
    await context.close();
  });

  for (const width of [390, 1280])
    for (const colorScheme of ['light', 'dark'])
      test(`can be read by all, ${width} px, ${colorScheme}`, async () => {
        done('7.1', '7.2', '7.5');
        const { page, context } = await open(seven, { width, colorScheme });
        await page.locator('#exercise-7\\.1 .unfold').click();
        if (width < 1000) await page.getByRole('button', { name: 'Contents' }).click();
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
        await page.evaluate(axe);
        for (const part of ['.turn', '#site-contents']) {
          const { violations } = await page.evaluate((where) => window.axe.run(where, { preload: false, resultTypes: ['violations'] }), part);
          assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`), []);
        }
        await context.close();
      });
});
