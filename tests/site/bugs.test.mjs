// Which of these two is wrong? Each chapter's page has its demo twice, and in one of them a function has a bug.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { describe, test } from 'node:test';
import { inaccessible, open, root, site } from './browser.mjs';

const chapters = fs.readdirSync(path.join(root, 'chapters')).filter((name) => fs.existsSync(path.join(site, 'demos', `${name}.js`)));
const always = (value) => `Math.random = () => ${value};`; // 0: A has the bug, 0.5: B

async function openSuspects(t, chapter, more) {
  const { page, troubles } = await open(t, `chapter_${chapter}.html`, more), place = page.locator('.suspects');
  await place.scrollIntoViewIfNeeded();
  await place.locator('.play[data-ready]').nth(1).waitFor();
  const figures = await place.locator('.play').all(), form = place.locator('form');
  return {
    page, troubles, place, figures,
    cause: Number(await place.getAttribute('data-cause')),
    guilty: await place.locator('.play').evaluateAll((all) => all.findIndex(({ dataset }) => dataset.bug)),
    answer: async (which, why) => {
      await form.locator('[name=which]').nth(which).check();
      await form.locator('[name=why]').nth(why).check();
      await form.getByRole('button', { name: 'Check' }).click();
      return { said: await form.getByRole('status').textContent(), told: await form.locator('.told').isVisible() };
    },
  };
}

describe('which of these two is wrong', { concurrency: 1 }, () => {
  for (const chapter of chapters)
    test(`${chapter}: both play, and the answer is known`, async (t) => {
      const { page, troubles, place, guilty, cause, answer } = await openSuspects(t, chapter);
      await page.waitForTimeout(1000);
      assert.equal(await place.locator('.trouble:visible').count(), 0);
      assert.equal(await place.locator('[name=why]').count(), 4);
      const no = await answer(1 - guilty, cause), why = await answer(guilty, (cause + 1) % 4);
      assert.match(no.said, /^No, that one runs on our code/);
      assert.match(why.said, /^Yes, that one. But not because of that/);
      assert.ok(!no.told && !why.told);
      assert.deepEqual(await answer(guilty, cause), { said: 'Yes, that’s it.', told: true });
      assert.deepEqual(troubles, []);
    });

  for (const [value, guilty] of [[0, 0], [0.5, 1]])
    test(`only the one with the bug breaks a law: ${'AB'[guilty]}`, async (t) => {
      const two = await openSuspects(t, '08_nt_collisions', { script: always(value), reducedMotion: 'reduce' });
      assert.equal(two.guilty, guilty);
      const lost = [];
      for (const figure of two.figures) {
        await figure.getByRole('button', { name: 'Roll' }).click();
        for (let i = 0; i < 120; ++i) await figure.getByRole('button', { name: 'Step' }).click();
        const heard = figure.locator('> p.hidden');
        await two.page.waitForTimeout(1200); // it tells what has stood for a second, when a frame is drawn
        await figure.locator('canvas').hover({ position: { x: 5, y: 5 } });
        await figure.locator('canvas').hover({ position: { x: 9, y: 9 } });
        lost.push(parseFloat(/[\d.]+(?= J lost)/.exec(await heard.textContent())[0]));
      }
      assert.ok(lost[guilty] > 2 * lost[1 - guilty], `${lost}`);
    });

  for (const [width, colorScheme] of [[390, 'dark'], [1280, 'light']])
    test(`it can be read by all, ${width} px, ${colorScheme}`, async (t) => {
      const { page } = await openSuspects(t, '03_gravity_wells', { width, colorScheme });
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
      assert.deepEqual(await inaccessible(page, '.suspects'), []);
    });
});
