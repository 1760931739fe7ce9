// What the pages say of what is done: by progress.js, which `course check` writes and this makes up.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { describe, test } from 'node:test';
import { address, copyOf, inaccessible, open, site } from './browser.mjs';

const seven = 'chapter_07_segment_intersection.html';
const copy = copyOf(site);
const openCopy = (t, name, options) => open(t, name, { folder: copy, ...options });

// As if these exercises had passed.
function done(...numbers) {
  const functions = ['intersect_lines', 'segments_intersect', 'common_points', 'move_and_bounce', 'time_of_impact', 'orientation'];
  const exercises = functions.map((name, at) => ({ number: `7.${at + 1}`, function: name, done: numbers.includes(`7.${at + 1}`) }));
  const next = exercises.find((one) => !one.done);
  const known = { sections: [{ number: '7', page: seven, exercises }], ...(next && { next: { ...next, address: `${seven}#exercise-${next.number}` } }) };
  fs.writeFileSync(path.join(copy, 'progress.js'), `self.progress = ${JSON.stringify(known)};\n`);
}

const boxes = (page) => page.$$eval('.turn[data-exercise]', (all) => all.map((box) => [
  box.dataset.exercise, box.querySelector('.done')?.textContent ?? '', [...box.children].slice(1).every((part) => !part.checkVisibility())]));

// One after the other: they share the file.
describe('what is done', { concurrency: 1 }, () => {
  test('has a tick and a word at its boxes, which are folded, and nothing else has', async (t) => {
    done('7.2', '7.3');
    const { page, troubles } = await openCopy(t, seven);
    for (const [number, words, folded] of await boxes(page)) {
      const isDone = ['7.2', '7.3'].includes(number);
      assert.equal(words, isDone ? '✓ Done' : '', number);
      assert.equal(folded, isDone, number);
    }
    assert.deepEqual(troubles, []);
  });

  test('shows what else would be right, and nothing of what is not done', async (t) => {
    done('7.3');
    const { page, troubles } = await openCopy(t, seven), others = (number) => page.locator(`.others[data-exercise="${number}"]`);
    assert.equal(await others('7.1').isVisible(), false);
    await others('7.3').locator('summary', { hasText: 'to write it' }).click();
    assert.match(await others('7.3').locator('pre').first().textContent(), /common_points\(/);
    assert.deepEqual(troubles, []);
  });

  test('opens at its button, by keys as well, and for a link into it', async (t) => {
    done('7.2');
    const { page } = await openCopy(t, seven);
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
  });

  test('survives a link whose escapes are broken, and so do search and keys', async (t) => {
    done('7.2');
    const { page, troubles } = await openCopy(t, 'index.html');
    await page.goto(`${address(seven, copy)}#%`);
    await page.keyboard.press('/');
    assert.equal(await page.locator('#site-search').isVisible(), true);
    assert.deepEqual(troubles, []);
  });

  test('is in the contents: how many, all, and the parts of this page; and in its table of exercises', async (t) => {
    done('7.1', '7.3');
    const { page } = await openCopy(t, seven);
    const entry = page.locator(`#site-contents a[href="${seven}"]`);
    assert.match(await entry.textContent(), /2\/6 done$/);
    const parts = () => page.$$eval('#site-contents .parts > li > a:has(.done)', (links) => links.map((link) => link.hash));
    assert.deepEqual(await parts(), ['#where-two-lines-cross', '#what-they-share']);
    done('7.1', '7.3', '7.4');
    await page.evaluate(() => { // a number in another table is no exercise
      document.querySelector('main').insertAdjacentHTML('beforeend', '<table><tr><td>7.1</td><td>7.2</td></tr></table>');
      dispatchEvent(new Event('focus'));
    });
    await page.locator('main td:has(> .done)').nth(2).waitFor();
    const rows = await page.$$eval('main td:has(> .done)', (cells) => cells.map((cell) => cell.textContent));
    assert.deepEqual(rows, ['7.1✓ done', '7.3✓ done', '7.4✓ done']);
    done('7.1', '7.2', '7.3', '7.4', '7.5', '7.6');
    await page.goto(address('readme.html', copy));
    assert.match(await entry.textContent(), /✓ done$/);
  });

  test('that is red again loses its tick when the reader comes back to the page; what is new is not folded', async (t) => {
    done('7.1');
    const { page } = await openCopy(t, seven);
    done('7.2');
    await page.evaluate(() => dispatchEvent(new Event('focus')));
    await page.locator('#exercise-7\\.2 .done').waitFor();
    const states = Object.fromEntries((await boxes(page)).map(([number, ...state]) => [number, state]));
    assert.deepEqual(states['7.1'], ['', false]);
    assert.deepEqual(states['7.2'], ['✓ Done', false]);
  });

  test('is said wherever it is asked for, and there is somewhere to go on', async (t) => {
    done('7.1');
    const { page } = await openCopy(t, seven);
    await page.evaluate(() => {
      document.querySelector('main').insertAdjacentHTML('beforeend', '<p><span data-progress="7"></span><span data-progress="1"></span><a data-go-on hidden></a></p>');
      dispatchEvent(new Event('focus'));
    });
    await page.locator('a[data-go-on]').waitFor();
    const said = await page.$$eval('[data-progress], [data-go-on]', (all) => all.map((one) => [one.textContent, one.getAttribute('href')]));
    assert.deepEqual(said, [['✓ 1 of 6 done', null], ['', null], ['Go on: 7.2', `${seven}#exercise-7.2`]]);
  });

  test('is on the front page: how far in each section, what is yours of the last game, and where to go on', async (t) => {
    done('7.1', '7.5');
    const { page, troubles } = await openCopy(t, 'index.html', { width: 390 });
    assert.deepEqual(await page.$$eval('.card [data-progress]', (all) => all.map((one) => [one.dataset.progress, one.textContent]).filter(([, said]) => said)), [['7', '✓ 2 of 6 done']]);
    assert.deepEqual(await page.$$eval('.parts-of-game .done', (all) => all.map((one) => one.parentElement.textContent.replace(/\s+/g, ' ').trim())), ['7.5 time_of_impact✓ yours']);
    assert.deepEqual(troubles, []);
    await page.getByRole('link', { name: 'Go on: 7.2' }).click();
    await page.waitForURL(/07_segment_intersection\.html#exercise-7\.2$/);
    fs.rmSync(path.join(copy, 'progress.js'));
    await page.goto(address('index.html', copy));
    assert.equal(await page.locator('.go a').last().isVisible(), false, 'nothing to go on with');
  });

  test('is on paper as if it were open, and nothing is lost without scripts or without the file', async (t) => {
    done('7.1');
    const printed = await openCopy(t, seven);
    await printed.page.emulateMedia({ media: 'print' });
    assert.equal(await printed.page.locator('#exercise-7\\.1 p').first().isVisible(), true);
    assert.equal(await printed.page.locator('.done').first().isVisible(), false);
    const plain = await openCopy(t, seven, { javaScriptEnabled: false });
    assert.equal(await plain.page.locator('#exercise-7\\.1 p').first().isVisible(), true);
    assert.equal(await plain.page.locator('.done').count(), 0);
    fs.rmSync(path.join(copy, 'progress.js'));
    const { page } = await openCopy(t, seven);
    assert.equal(await page.locator('#exercise-7\\.1 p').first().isVisible(), true);
    assert.equal(await page.locator('.done').count(), 0);
  });

  for (const width of [390, 1280])
    for (const colorScheme of ['light', 'dark'])
      test(`can be read by all, ${width} px, ${colorScheme}`, async (t) => {
        done('7.1', '7.2', '7.5');
        const { page } = await openCopy(t, seven, { width, colorScheme });
        await page.locator('#exercise-7\\.1 .unfold').click();
        if (width < 1000) await page.getByRole('button', { name: 'Contents' }).click();
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
        for (const part of ['.turn', '#site-contents']) assert.deepEqual(await inaccessible(page, part), []);
      });
});
