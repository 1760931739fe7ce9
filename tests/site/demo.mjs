// A demo in a page, played as a reader would, in Chromium and in Firefox.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { open, root, wrong as compiled } from './browser.mjs';

export const seven = '07_segment_intersection';

// The files of section 7 that go wrong in a page, and what it says of one.
const folder = path.join(root, 'tests/play', seven);
export const wrongFiles = fs.readdirSync(folder).map((name) => name.replace('.cpp', ''));
export const said = (name) => /^\/\/ the page says: ?(.*)/.exec(fs.readFileSync(path.join(folder, `${name}.cpp`), 'utf8'))[1];

// A demo on this page, the first one or at a certain place, and what one does with it.
export async function demoOn(page, name, place = '') {
  const figure = page.locator(`.play[data-demo="${name}"][data-ready]${place}:not(.suspects *)`);
  await figure.waitFor();
  const canvas = figure.locator('canvas');
  await canvas.evaluate((it) => it.scrollIntoView({ block: 'center' }));
  const demo = {
    page, figure, canvas,
    // At least so long, and until what came before has been in a frame, however busy the machine is.
    wait: async (ms) => {
      await page.waitForTimeout(ms);
      await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
    },
    button: (name) => figure.getByRole('button', { name, exact: true }),
    choose: async (words) => {
      const games = figure.locator('details:not([open])', { hasText: words });
      if (await games.count()) await games.locator('summary').click();
      await figure.locator('fieldset label', { hasText: words }).click();
    },
    slide: (name, value) => figure.locator('.controls > label', { hasText: name }).locator('input').fill(String(value)),
    // A finger comes down, moves and is lifted.
    stroke: async ([x, y], [to_x, to_y]) => {
      const session = await page.context().newCDPSession(page);
      const send = (type, ...touchPoints) => session.send('Input.dispatchTouchEvent', { type, touchPoints });
      await send('touchStart', { x, y });
      for (let i = 1; i <= 5; i++) await send('touchMove', { x: x + ((to_x - x) * i) / 5, y: y + ((to_y - y) * i) / 5 });
      await send('touchEnd');
      await page.waitForTimeout(100);
    },
    read: async (name) => Number((await figure.locator('dl > div').filter({ has: page.locator('dt', { hasText: new RegExp(`^${name}$`) }) }).locator('b').textContent()).replace('−', '-')),
    picture: () => canvas.evaluate((it) => it.toDataURL()),
    at: async (x, y, [wide, high]) => {
      await canvas.scrollIntoViewIfNeeded();
      const box = await canvas.boundingBox();
      return [box.x + (x / wide) * box.width, box.y + (1 - y / high) * box.height];
    },
    said: async () => ((await figure.locator('.trouble').isVisible()) ? figure.locator('.trouble p').textContent() : ''),
    // Throws the ball of section 7: where it starts, its arrow ends at (2.54, 3.255).
    throwAt: async (x, y) => {
      if (await demo.button('Pause').isVisible()) await demo.still();
      await demo.button('Reset').click();
      await demo.wait(100);
      await demo.drag(room(2.54, 3.255), room(x, y));
    },
    // The first game that moves: some wait for a guess, to be dragged, or for a button of their own, Fire.
    begin: async () => {
      const games = figure.locator('details:not([open]) summary');
      if (await games.count()) await games.click();
      for (const game of [null, ...(await figure.locator('fieldset').first().locator('label').all())]) {
        await game?.click();
        await demo.act();
        await demo.wait(200);
        if (await demo.moves()) return;
      }
      assert.fail(`${name}: no game moves`);
    },
    act: () => figure.locator('.buttons').evaluate((it) => it.querySelector('button:not([hidden])')?.click()),
    moves: (within = 800) => canvas.evaluate((it, within) => new Promise((done) => {
      const before = it.toDataURL(), end = performance.now() + within;
      const look = () => (it.toDataURL() !== before ? done(true) : performance.now() > end ? done(false) : setTimeout(look, 50));
      look();
    }), within),
    // Plays with the reader's code until the page says this, or for a while.
    runInto: async (words) => {
      await demo.choose('bounces (7.4)');
      await demo.button('Yours').click();
      if (words) await figure.locator('.trouble').waitFor();
      else await demo.wait(1500);
      assert.equal((await demo.said()).slice(0, words.length || undefined), words);
    },
    still: async () => {
      await demo.button('Pause').click();
      await demo.wait(50);
    },
    drag: async (from, to) => {
      await page.mouse.move(...(await demo.at(...from)));
      await page.mouse.down();
      await page.mouse.move(...(await demo.at(...to)), { steps: 3 });
      await page.mouse.up();
    },
  };
  return demo;
}

// The same on the page with all demos, where nothing may go wrong.
// @param wrong the reader's code, by the name of a file that goes wrong in a page
export async function openDemo(t, name, { touch = false, wrong, ...more } = {}) {
  const script = wrong && fs.readFileSync(path.join(compiled, `${wrong}.js`), 'utf8');
  const { page, troubles } = await open(t, 'play.html', { ...(touch && { hasTouch: true, isMobile: true }), script, ...more });
  t.after(() => assert.deepEqual(troubles, []));
  return demoOn(page, name);
}

export const room = (x, y) => [x + 0.75, y + 0.3, [13.5, 7.59375]]; // from metres in the room of section 7 to what `at` wants
