// The pages of the online edition: its first door, what they say instead of a command, and hints below the editor. With a
// checker that plays its part (served.mjs).
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { describe, test } from 'node:test';
import { onlinePage } from '../../tools/online/pages.mjs';
import { here } from '../../tools/online/words_here.mjs';
import { inaccessible, root, site } from '../site/browser.mjs';
import { eight, inBox, kept, open } from './served.mjs';

const chapters = fs.readdirSync(site).filter((name) => /^chapter_.*\.html$/.test(name));
const read = (name) => fs.readFileSync(path.join(site, name), 'utf8');
const commandsIn = (...pages) => [...new Set(pages.flatMap((name) => onlinePage(read(name), 'online').match(/\.\/course \w+/g) ?? []))].sort();

describe('what pages say', () => {
  test('is on the site in other words, each of them', () => {
    const pages = [...chapters, 'index.html', 'preface.html'].map(read);
    for (const [there] of here) assert.ok(pages.some((html) => html.match(there)), `nothing on the site is like ${there}: mend tools/online/words_here.mjs`);
  });

  test('has no command for what the page does', () => {
    assert.deepEqual(commandsIn(...chapters), ['bug', 'dev', 'mytests', 'play', 'plot', 'run'].map((name) => `./course ${name}`));
    assert.deepEqual(commandsIn('index.html'), ['./course check'], 'of those who teach');
    assert.deepEqual(commandsIn('preface.html'), []);
    for (const name of chapters) assert.doesNotMatch(onlinePage(read(name), 'online'), /[Ss]ave, and|-v shows all|Stuck\? \.\/course/, name);
  });
});

describe('hints', () => {
  test('are in each box of their exercise, as the terminal has them, and nowhere else', () => {
    for (const name of chapters) {
      const html = onlinePage(read(name), 'online'), chapter = fs.readFileSync(path.join(root, 'chapters', name.slice(8, -5), 'README.md'), 'utf8');
      const plain = (text) => text.replace(/<[^>]*>/g, '').replace(/[^\p{L}\p{N}]+/gu, ' '); // quotes and spaces are a printer's
      const hints = (part) => [...part.matchAll(/<summary>Hint (\d+)<span>: (.*?)<\/span><\/summary>/g)].map(([, at, title]) => `${at} ${plain(title)}`);
      const boxes = [...html.matchAll(/<article class="turn"[^>]* data-exercise="([\d.]+)"[^>]*>([^]*?)<\/article>/g)];
      for (const [, exercise, box] of boxes) {
        const told = [...chapter.matchAll(/<summary>(\S+), a hint: (.*)<\/summary>/g)].filter(([, number]) => number === exercise);
        assert.deepEqual(hints(box), told.map(([, , title], at) => `${at + 1} ${plain(title)}`), exercise);
      }
      assert.deepEqual(hints(html.replace(/<article class="turn"[^]*?<\/article>/g, '')), [], name);
    }
  });

  for (const width of [390, 1280])
    for (const colorScheme of ['light', 'dark'])
      test(`show one after the other, by a press or by keys, before a check and below its verdict, ${width} px, ${colorScheme}`, async (t) => {
        const { page, troubles } = await open(t, undefined, { width, colorScheme, hasTouch: width < 1000, isMobile: width < 1000 });
        const box = inBox(page), chips = box.box.locator('.hint > summary'), shown = () => chips.evaluateAll((all) => all.filter((one) => one.checkVisibility()).map((one) => `${one.textContent}, ${one.parentElement.open ? 'open' : 'closed'}`));
        await box.code.waitFor();
        assert.deepEqual(await shown(), ['Hint 1: where to begin, closed']);
        if (width < 1000) assert.ok((await chips.first().boundingBox()).height >= 44);
        await box.menu.focus();
        await page.keyboard.press('Tab');
        await page.keyboard.press('Enter');
        await chips.nth(1).waitFor();
        const second = await chips.nth(1).textContent();
        assert.deepEqual(await shown(), ['Hint 1: where to begin, open', `${second}, closed`]);
        await page.keyboard.press('Tab');
        assert.equal(await page.evaluate(() => document.activeElement.textContent), second);
        await box.check();
        const edge = async (place, side) => place.evaluate((one, name) => one.getBoundingClientRect()[name], side);
        assert.ok(await edge(box.verdict, 'bottom') < await edge(chips.first(), 'top'));
        await chips.nth(1).click();
        await chips.first().click();
        assert.deepEqual((await shown()).slice(0, 2), ['Hint 1: where to begin, closed', `${second}, open`], 'what was seen stays');
        assert.deepEqual(await inaccessible(page, '.turn'), []);
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= width, 'the page does not scroll sideways');
        assert.deepEqual(troubles, []);
      });
});

describe('a later box of an exercise', () => {
  test('has a link to the editor of its exercise, and no other box has', () => {
    for (const name of chapters) {
      const html = onlinePage(read(name), 'online'), parts = html.split(/<article class="turn"[^>]* id="exercise-([\d.]+)(?:-\d)?"/).slice(1);
      for (let i = 0; i < parts.length; i += 2)
        for (const [quoted] of parts[i + 1].matchAll(/<blockquote>[^]*?<\/blockquote>/g)) {
          const links = [...quoted.matchAll(/href="#code-([\d.]+)"/g)].map(([, to]) => to);
          assert.deepEqual(links, quoted.includes('<strong>Your test') ? [] : [parts[i]], quoted);
          for (const [, number] of quoted.matchAll(/<strong>Finish (\d+\.\d+)/g)) assert.deepEqual(links, [number]);
        }
    }
  });

  for (const width of [390, 1280])
    test(`leads back to one’s code, even where the exercise is folded, ${width} px`, async (t) => {
      const { page, troubles } = await open(t, `${eight}#exercise-8.2`, { width }), box = inBox(page, '8.2'), place = page.locator('#code-8\\.2');
      const back = page.locator('blockquote', { hasText: 'Finish 8.2.' }).getByRole('link', { name: 'Back to your code' });
      await box.write('right');
      await box.check();
      await box.box.locator('header .done').waitFor();
      await box.button('Hide').click();
      await back.click();
      await page.waitForFunction(() => document.querySelector('#code-8\\.2 .cm-editor').getBoundingClientRect().top < 200);
      assert.ok(await place.evaluate((it) => it.getBoundingClientRect().top) >= 48, 'below the bar');
      assert.deepEqual(troubles, []);
    });
});

test('hints are after a reload as they were left, and nothing is the reader’s by that', async (t) => {
  const { page, troubles } = await open(t), box = inBox(page), hint = (at) => box.box.locator('.hint').nth(at);
  const left = async (...states) => {
    while (JSON.stringify(Object.values((await kept(page))[0]?.hints ?? {})) !== JSON.stringify(states)) await page.waitForTimeout(50);
    await page.reload();
    await box.code.waitFor();
  };
  await box.code.waitFor();
  await hint(0).locator('summary').click();
  await left(true);
  await box.box.locator('.hint[open]').waitFor();
  assert.equal(await hint(1).isVisible(), true);
  await hint(0).locator('summary').click();
  await left(false);
  await hint(1).waitFor();
  assert.equal(await box.box.locator('.hint[open]').count(), 0);
  await box.menu.click();
  await box.button('Download my answers').click();
  await box.note.getByText('you haven’t changed any file').waitFor();
  assert.deepEqual(troubles, []);
});

describe('the first door', () => {
  for (const width of [390, 1280])
    test(`is Begin here: two clicks and at most 150 words to the cursor in 1.1, and what to do, ${width} px`, async (t) => {
      const { page, troubles } = await open(t, 'index.html', { width });
      const door = page.locator('main a').first();
      assert.equal(await door.innerText(), 'Begin here your first line');
      const before = await door.evaluate((link) => {
        const range = document.createRange();
        range.setStart(link.closest('main'), 0);
        range.setEndAfter(link);
        return range.toString();
      });
      await door.click();
      const box = inBox(page, '1.1'), first = page.locator('#exercise-1\\.1');
      await first.locator('.cm-content').click();
      await first.locator('.cm-focused').waitFor();
      const above = await first.evaluate((turn) => [...turn.children].slice(0, [...turn.children].indexOf(turn.querySelector('.answer'))).map((one) => one.innerText).join('\n'));
      const words = `${before} ${above}`.split(/\s+/).filter((word) => /\w/.test(word));
      assert.ok(words.length <= 150, `${words.length} words: ${words.join(' ')}`);
      assert.match(above, /replace the whole throw, semicolon and all, with return px_per_frame \/ frames_per_second;\.[^]*Press Check:/);
      assert.ok(!above.includes('0.133333333'), 'what comes out is folded');
      await page.keyboard.insertText('// here');
      assert.match(await box.text(), /\/\/ here/);
      assert.deepEqual(troubles, []);
    });

  for (const width of [390, 1280])
    test(`leads to the box below the bar, whatever grows above it, until the reader scrolls, ${width} px`, async (t) => {
      const { page, context } = await open(t, 'index.html', { width });
      await context.addInitScript(() => addEventListener('DOMContentLoaded', () => document.head.insertAdjacentHTML('beforeend', '<style>* { overflow-anchor: none }</style>'))); // as in Safari
      await page.locator('main a').first().click();
      await inBox(page, '1.1').code.waitFor();
      const grow = () => page.evaluate(() => {
        document.querySelector('main').insertAdjacentHTML('afterbegin', '<div style="height: 700px"></div>');
        return new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      });
      const belowTheBar = () => page.evaluate(() => document.querySelector('#exercise-1\\.1').getBoundingClientRect().top - document.querySelector('.bar').offsetHeight);
      await grow();
      const below = await belowTheBar();
      assert.ok(below >= 0 && below < 40, `${below} px below the bar`);
      const before = await page.evaluate(() => scrollY);
      await page.mouse.move(width - 90, 500);
      await page.mouse.wheel(0, 100);
      await page.waitForFunction((was) => scrollY !== was, before);
      await grow();
      assert.ok(await belowTheBar() > 500, 'it stays where the reader is');
      const where = await page.evaluate(() => (scrollTo(0, 2000), scrollY));
      await page.reload();
      await grow();
      assert.equal(await page.evaluate(() => scrollY), where, 'loaded again, too');
    });

  test('leads to where one goes on, once something was checked', async (t) => {
    const { page, context } = await open(t);
    await inBox(page).check();
    const { page: front } = await open(t, 'index.html', { context });
    await front.getByRole('link', { name: 'Go on: 8.1' }).click();
    await inBox(front).code.waitFor();
    assert.ok(front.url().endsWith(`${eight}#exercise-8.1`), front.url());
  });
});
