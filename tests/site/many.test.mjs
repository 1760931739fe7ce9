// A demo that plays the reader's functions of many sections: by its lamps, whose each of them is and when it's called. And
// its keys, which are held.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { describe, test } from 'node:test';
import { address, copyOf, inaccessible, site, wrong } from './browser.mjs';
import { openDemo, seven } from './demo.mjs';

// Its files in tests/play: the reader has solved its own exercise, and of the earlier ones in earlier/ one, which is called
// in each frame, is right, and one never ends; a file doesn't compile, and the others are gone.
const game = '13_table_hockey', right = '1.2 uniform_motion', endless = '5.6 table_friction', broken = '2.5 impulse', gone = '8.1 decompose';
const file = 'as_solved', own = 13, brokenFile = '02_momentum.cpp';
const here = fs.existsSync(path.join(site, 'demos', `${game}.js`));
const copy = here && copyOf(site), numberOf = (name) => name.split(' ')[0];

const progress = (done) => fs.writeFileSync(path.join(copy, 'progress.js'), `self.progress = ${JSON.stringify({ sections: [{ number: '1', page: '', exercises: done.map((name) => ({ number: numberOf(name), function: name.split(' ')[1], done: true })) }] })};\n`);
// The demo when these exercises are done, with the reader's code; and what its lamps show: words, and whether they glow.
async function openGame(t, done, { theirs = true, ...more } = {}) {
  progress(done);
  const demo = await openDemo(t, game, { folder: copy, ...(theirs && { wrong: file }), ...more });
  demo.lamps = () => demo.figure.locator('.lamps li').evaluateAll((all) => all.map((it) => ({ says: it.querySelector('span').textContent, whose: it.dataset.whose, glows: it.classList.contains('lit') })));
  demo.lamp = async (name) => (await demo.lamps()).find(({ says }) => says.startsWith(`${name} `)) ?? assert.fail(`${name} has no lamp`);
  if (theirs) await demo.button('Yours').click();
  return demo;
}

describe('a demo of many sections', { concurrency: 1, skip: !here && `there is no ${game} yet` }, () => {
  test('has a lamp for each function that it plays, in order, and they glow when they are called', async (t) => {
    const demo = await openGame(t, [], { theirs: false });
    await demo.wait(600);
    const lamps = await demo.lamps(), numbers = lamps.map(({ says }) => numberOf(says));
    assert.deepEqual(numbers, [...numbers].sort((a, b) => a.localeCompare(b, 'en', { numeric: true })));
    assert.ok(numbers.some((each) => parseInt(each, 10) === own) && numbers.some((each) => parseInt(each, 10) < own));
    assert.ok(lamps.every(({ says, whose }) => says.endsWith(' ours') && whose === 'ours'));
    assert.equal((await demo.lamp(right)).glows, true);
    assert.ok(lamps.some(({ glows }) => !glows), 'some are for rare moments');
    await demo.page.goto(address('index.html'));
    const parts = await demo.page.$$eval('.parts-of-game li', (all) => all.map((part) => part.textContent.replace(/\s+/g, ' ').trim()));
    assert.deepEqual(lamps.map(({ says }) => says.replace(/ ours$/, '')), parts, 'the front page names them all');
  });

  test('and some can be given a bug, and lose it again', async (t) => {
    const demo = await openGame(t, [], { theirs: false }), name = '6.4 bounce';
    await demo.button(`Break ${name}`).click();
    assert.deepEqual(await demo.lamp(name).then(({ says, whose }) => [says, whose]), [`${name} with a bug`, 'wrong']);
    await demo.button('Reset').click();
    await demo.wait(300);
    assert.equal((await demo.lamp(name)).whose, 'wrong');
    await demo.button(`Mend ${name}`).click();
    assert.deepEqual(await demo.lamp(name).then(({ says, whose }) => [says, whose]), [`${name} ours`, 'ours']);
    assert.equal(await demo.said(), '');
  });

  test('and one of a single section has none', async (t) => {
    const demo = await openDemo(t, seven);
    assert.equal(await demo.figure.locator('.lamps').isVisible(), false);
  });

  for (const [width, colorScheme] of [[390, 'dark'], [1280, 'light']])
    test(`its lamps can be read by all, ${width} px, ${colorScheme}`, { skip: !fs.existsSync(wrong) }, async (t) => {
      const demo = await openGame(t, [right], { width, colorScheme });
      await demo.wait(300);
      assert.ok(await demo.page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
      assert.deepEqual(await inaccessible(demo.page, `.play[data-demo="${game}"] .board`), []);
    });
});

describe('an earlier section in it', { concurrency: 1, skip: !(here && fs.existsSync(path.join(wrong, `${file}.js`))) && `there is no ${game} yet, or no compiler for pages` }, () => {
  test("is the reader's where it's done, and ours where it isn't, or cannot be", async (t) => {
    const demo = await openGame(t, [right, broken, gone]);
    await demo.wait(600);
    assert.equal(await demo.said(), '');
    assert.deepEqual(await demo.lamp(right), { says: `${right} yours`, whose: 'yours', glows: true });
    assert.deepEqual((await demo.lamp(endless)).says, `${endless} ours: not done yet`);
    if (broken) assert.equal((await demo.lamp(broken)).says, `${broken} ours: ${brokenFile} doesn't compile`);
    assert.equal((await demo.lamp(gone)).says, `${gone} ours: not written`);
    await demo.button('Ours').click();
    await demo.wait(300);
    assert.ok((await demo.lamps()).every(({ whose }) => whose === 'ours'));
  });

  test('that never ends is stopped by its name', async (t) => {
    const demo = await openGame(t, [right, endless]);
    if (game.startsWith('10')) await demo.choose('stretched');
    await demo.figure.locator('.trouble', { hasText: `${endless} gave no answer: look for a loop that never ends.` }).waitFor();
  });

  test("is the reader's as soon as they come back to the page with it done", async (t) => {
    const demo = await openGame(t, []);
    await demo.wait(300);
    assert.equal((await demo.lamp(right)).whose, 'ours');
    progress([right]);
    await demo.page.evaluate(() => dispatchEvent(new Event('focus')));
    await demo.figure.locator('.lamps [data-whose=yours]', { hasText: right }).waitFor();
    assert.equal(await demo.said(), '');
  });
});

describe('keys that are held', { concurrency: 2, skip: !here && `there is no ${game} yet` }, () => {
  const keyNames = { '↑': 'ArrowUp', '↓': 'ArrowDown', '←': 'ArrowLeft', '→': 'ArrowRight' };
  // The first two that count, each with its button.
  async function twoKeys(demo) {
    const buttons = await demo.figure.locator('.holds button:not([hidden])').all();
    return Promise.all(buttons.slice(0, 2).map(async (button) => {
      const words = await button.textContent(), hint = demo.figure.locator('.keys > span').filter({ hasText: new RegExp(`^\\S+ ${words}$`) });
      const shown = await hint.locator('kbd').textContent();
      return { button, key: keyNames[shown] ?? shown, down: async () => (await button.getAttribute('aria-pressed')) === 'true' };
    }));
  }

  test('are down until they are let go, several at once, whatever Shift does; and all are let go with the focus', async (t) => {
    const demo = await openDemo(t, game), [one, other] = await twoKeys(demo), { keyboard } = demo.page;
    const state = async () => (await demo.wait(100), [await one.down(), await other.down()]);
    await demo.canvas.focus();
    await keyboard.down(one.key);
    await keyboard.down(one.key); // as it repeats itself
    assert.deepEqual(await state(), [true, false]);
    await keyboard.down(other.key);
    assert.deepEqual(await state(), [true, true]);
    await keyboard.up(one.key.length === 1 ? one.key.toUpperCase() : one.key);
    assert.deepEqual(await state(), [false, true]);
    await demo.canvas.evaluate((it) => it.blur());
    assert.deepEqual(await state(), [false, false]);
  });

  test('are buttons for fingers, and act as long as these stay, without scrolling the page', async (t) => {
    const demo = await openDemo(t, game, { width: 390, touch: true }), [{ button, down }] = await twoKeys(demo);
    await button.scrollIntoViewIfNeeded();
    const scrolled = await demo.page.evaluate(() => scrollY), session = await demo.page.context().newCDPSession(demo.page), box = await button.boundingBox();
    const send = async (type, ...touchPoints) => (await session.send('Input.dispatchTouchEvent', { type, touchPoints }), demo.wait(100));
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await send('touchStart', { x, y });
    assert.equal(await down(), true);
    await send('touchMove', { x, y: y - 60 });
    assert.equal(await down(), true);
    await send('touchEnd');
    assert.equal(await down(), false);
    assert.equal(await demo.page.evaluate(() => scrollY), scrolled);
  });

  test('are buttons for keys, too', async (t) => {
    const demo = await openDemo(t, game), [{ button, down }] = await twoKeys(demo);
    await button.focus();
    await demo.page.keyboard.down('Enter');
    await demo.wait(100);
    assert.equal(await down(), true);
    await demo.page.keyboard.up('Enter');
    await demo.wait(100);
    assert.equal(await down(), false);
  });
});
