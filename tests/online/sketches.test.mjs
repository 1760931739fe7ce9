// Sketches in the online edition as it is built, in Chromium: they're written, run, kept and shared in the page.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { address, browser, build, inaccessible, root } from '../site/browser.mjs';
import { demoOn } from '../site/demo.mjs';
import { inBox } from './in_box.mjs';
import { serve } from './server.mjs';

const host = await serve(path.join(build, 'online/site'), [], '/some/path');
let context;
before(async () => (context = await (await browser()).newContext({ viewport: { width: 1280, height: 900 } })));
after(() => context?.close());

async function openPage(t, name) {
  const page = await context.newPage(), troubles = [];
  t.after(() => page.close());
  page.on('pageerror', (error) => troubles.push(error.message));
  page.on('request', (request) => request.url().startsWith(host) || /^(data|blob):/.test(request.url()) || troubles.push(`asks for ${request.url()}`));
  await page.goto(`${host}/${name}`);
  const place = page.locator('#sketch'), code = place.locator('.cm-content'), button = (name) => place.getByRole('button', { name, exact: true });
  return {
    page, troubles, place, code, button, said: place.locator('.verdict'),
    text: () => place.locator('.cm-line').allTextContents().then((lines) => lines.join('\n')),
    async write(text) {
      await code.click();
      await page.keyboard.press('Control+A');
      await page.keyboard.insertText(text);
    },
    async run() {
      await button('Run').click();
      await page.locator('.play[data-demo="sketch"][data-ready]').waitFor({ timeout: 180_000 });
      return demoOn(page, 'sketch');
    },
  };
}
const titled = (page, words) => page.locator('.play figcaption', { hasText: words }).waitFor({ timeout: 120_000 });

// One after the other: they share what is kept.
describe('a sketch in the page', { concurrency: 1 }, () => {
  test('begins with a scene that runs, follows what is typed, and says what can’t be compiled, and where', async (t) => {
    const { page, troubles, code, text, write, run, said, place, button } = await openPage(t, 'sketches.html');
    await code.waitFor();
    const first = await text();
    assert.match(first, /struct Mine : Scene \{/);
    const demo = await run();
    assert.equal(await demo.figure.locator('figcaption').textContent(), 'A disc that follows the pointer');
    const before = await demo.picture();
    await demo.canvas.hover({ position: { x: 40, y: 40 } });
    await demo.page.waitForFunction((was) => document.querySelector('#sketch canvas').toDataURL() !== was, before);

    await write(first.replace('A disc that follows the pointer', 'Another title'));
    await titled(page, 'Another title');
    await write(first.replace('double dt', 'double'));
    await said.filter({ hasText: '✗ sketch.cpp does not compile' }).waitFor({ timeout: 120_000 });
    const line = first.split('\n').findIndex((one) => one.includes('double dt')) + 1;
    assert.equal(await place.getByRole('group', { name: 'This line doesn’t compile' }).textContent(), first.replace('double dt', 'double').split('\n')[line]);
    await place.getByRole('button', { name: new RegExp(`sketch\\.cpp:${line + 1}`) }).click();
    assert.equal(await page.evaluate(() => document.activeElement.className.includes('cm-content')), true);
    assert.equal(await demo.figure.locator('figcaption').textContent(), 'Another title', 'what ran goes on');
    const files = [], heard = (file) => files.push(file.suggestedFilename());
    page.on('download', heard);
    await button('Share as a page').click();
    await page.waitForTimeout(2500);
    assert.deepEqual(files, [], 'nothing is shared that isn’t what is written');
    assert.match(await said.textContent(), /does not compile/);
    page.off('download', heard);
    await write(first.replace('if (hand.inside)', 'for (;;)'));
    await demo.figure.locator('.trouble', { hasText: 'Your sketch gave no answer: look for a loop that never ends.' }).waitFor({ timeout: 120_000 });
    await write(first.replace('if (hand.inside)', 'throw std::logic_error{"no"}; if (hand.inside)'));
    await demo.figure.locator('.trouble', { hasText: 'Your sketch threw std::logic_error: no.' }).waitFor({ timeout: 120_000 });
    await write(first);
    await demo.figure.locator('.trouble').waitFor({ state: 'hidden', timeout: 120_000 });
    assert.deepEqual(await inaccessible(page, '#sketch'), []);
    assert.deepEqual(troubles, []);
  });

  test('is begun with a scene of a chapter, calls the reader’s function, and is there the next time', async (t) => {
    const chapter = await openPage(t, 'chapter_07_segment_intersection.html'), box = inBox(chapter.page, '7.4');
    await box.box.scrollIntoViewIfNeeded();
    await box.button('The whole file').click();
    await box.write(fs.readFileSync(path.join(root, 'solutions/07_segment_intersection.cpp'), 'utf8'));
    await box.button('Check').click();
    await box.box.locator('.done').waitFor({ timeout: 120_000 });
    const scene = await demoOn(chapter.page, '07_segment_intersection', '[data-exercise="7.4"]');
    await scene.figure.getByRole('link', { name: 'Change it' }).click();
    const { page } = chapter;
    await page.waitForURL(/sketches\.html#sketch_2$/);
    const sketch = page.locator('#sketch');
    await sketch.locator('.cm-line', { hasText: '#include "07_segment_intersection/scenes/shared.hpp"' }).waitFor();
    await sketch.getByRole('button', { name: 'Run' }).click();
    await page.locator('.play[data-demo="sketch"][data-ready]').waitFor({ timeout: 180_000 });
    const demo = await demoOn(page, 'sketch');
    assert.equal(await demo.said(), '');
    await demo.figure.locator('.lamps [data-whose=yours]', { hasText: '7.4 move_and_bounce yours' }).waitFor();
    assert.equal(await demo.moves(3000), true);
    const again = await openPage(t, 'sketches.html');
    await again.code.waitFor();
    assert.deepEqual(await again.place.locator('option').evaluateAll((all) => all.map(({ value, selected }) => [value, selected])), [['sketch_1', false], ['sketch_2', true]]);
  });

  test('is shared as one page, which plays from a disk', async (t) => {
    const { page, button, write, place } = await openPage(t, 'sketches.html#sketch_1');
    await write(fs.readFileSync(path.join(root, 'docs/gallery/marbles.cpp'), 'utf8'));
    const [file] = await Promise.all([page.waitForEvent('download', { timeout: 180_000 }), button('Share as a page').click()]);
    assert.equal(file.suggestedFilename(), 'sketch_1.html');
    await place.getByText('Saved as sketch_1.html').waitFor();
    const saved = path.join(fs.mkdtempSync(path.join(build, 'shared-')), 'sketch_1.html');
    t.after(() => fs.rmSync(path.dirname(saved), { recursive: true }));
    await file.saveAs(saved);
    const friend = await context.newPage(), troubles = [];
    t.after(() => friend.close());
    friend.on('pageerror', (error) => troubles.push(error.message));
    friend.on('request', (request) => /^(file|data|blob):/.test(request.url()) || troubles.push(`asks for ${request.url()}`));
    await friend.goto(address('sketch_1.html', path.dirname(saved)));
    const demo = await demoOn(friend, 'sketch');
    assert.equal(await demo.moves(3000), true);
    assert.equal(await demo.said(), '');
    assert.deepEqual(troubles, []);
  });
});
