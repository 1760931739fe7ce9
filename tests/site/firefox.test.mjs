// The demos in Firefox: the other engine. It is spoken to by WebDriver BiDi, with Debian's package firefox-esr.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import puppeteer from 'puppeteer-core';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const build = path.resolve(process.env.COURSE_BUILD ?? path.join(root, 'build/default'));
const shelf = path.join(build, 'site/play.html'); // all demos on one page
const wrong = path.join(build, 'play/wrong'); // compiled only where there is a compiler for pages
const seven = '07_segment_intersection';
const firefox = process.env.FIREFOX ?? ['/usr/bin/firefox-esr', '/usr/bin/firefox'].find(fs.existsSync);

describe('in Firefox', { skip: !firefox && 'it is not installed: apt-get install firefox-esr' }, () => {
  let browser;
  // Its window has the size, since an older Firefox (140) refuses what puppeteer says when a page is given one.
  before(async () => (browser = await puppeteer.launch({ browser: 'firefox', executablePath: firefox, headless: true, defaultViewport: null, args: ['--width=1280', '--height=900'] })));
  after(() => browser?.close());

  // A copy of the page with this code. (Code that the driver puts into a page meets errors of its own in Firefox 140.)
  function pageWith(script) {
    const copy = script.replace(/js$/, 'html');
    const more = `<base href="${pathToFileURL(shelf)}"><script src="${pathToFileURL(script)}"></script>`;
    fs.writeFileSync(copy, fs.readFileSync(shelf, 'utf8').replace('<head>', `<head>${more}`));
    return copy;
  }

  async function open(demo, shown = shelf) {
    const page = await browser.newPage(), troubles = [];
    page.on('console', (message) => troubles.push(message.text()));
    page.on('pageerror', (error) => troubles.push(String(error)));
    await page.goto(pathToFileURL(shown).href);
    const figure = `.play[data-demo="${demo}"]`;
    await page.waitForSelector(`${figure}[data-ready]`);
    await page.$eval(`${figure} canvas`, (canvas) => canvas.scrollIntoView({ block: 'center' }));
    const labelled = (kind, words) => page.evaluateHandle((figure, kind, words) => [...document.querySelectorAll(`${figure} ${kind}`)].find((each) => each.textContent.startsWith(words)), figure, kind, words);
    return {
      page,
      picture: () => page.$eval(`${figure} canvas`, (canvas) => canvas.toDataURL()),
      act: () => page.$eval(`${figure} .buttons`, (buttons) => buttons.querySelector('button:nth-child(n + 4):not([hidden])')?.click()), // its own button, if it waits for one: Fire
      press: async (words) => (await labelled('button', words)).asElement().click(),
      games: () => page.$$eval(`${figure} fieldset:first-of-type label`, (labels) => labels.map((each) => each.textContent.trim())),
      choose: async (words) => (await labelled('fieldset label', words)).asElement().click(),
      slide: async (words, value) => (await labelled('.controls > label', words)).evaluate((label, value) => {
        const slider = label.querySelector('input');
        slider.value = value;
        slider.dispatchEvent(new Event('input'));
      }, value),
      read: (name) => page.$eval(`${figure} dl`, (list, name) => Number([...list.children].find((each) => each.querySelector('dt').textContent === name).querySelector('b').textContent.replace('−', '-')), name),
      said: () => page.$eval(`${figure} .trouble`, (alarm) => (alarm.hidden ? '' : alarm.querySelector('p').textContent)),
      at: (x, y) => page.$eval(`${figure} canvas`, (canvas, x, y) => { // metres in the room of section 7
        const { left, top, width, height } = canvas.getBoundingClientRect();
        return [left + (x / 12) * width, top + (1 - (y + 0.5) / 8) * height];
      }, x, y),
      wait: (ms) => new Promise((done) => setTimeout(done, ms)),
      done: async () => {
        assert.deepEqual(troubles, []);
        await page.close();
      },
    };
  }

  // The first game that moves: some wait for a guess, or to be dragged.
  async function begin(demo) {
    for (const game of [null, ...(await demo.games())]) {
      if (game) await demo.choose(game);
      await demo.act();
      await demo.wait(700);
      const before = await demo.picture();
      await demo.wait(800);
      if ((await demo.picture()) !== before) return;
    }
    assert.fail('no game moves');
  }

  for (const section of fs.readdirSync(path.join(root, 'demos')).filter((name) => name.endsWith('.js')))
    test(`${section.replace('.js', '')} starts, stands still, steps and is reset`, async () => {
      const demo = await open(section.replace('.js', ''));
      await begin(demo);
      await demo.press('Pause');
      await demo.wait(100);
      const paused = await demo.picture();
      await demo.wait(300);
      assert.ok((await demo.picture()) === paused, 'it stands still');
      await demo.act();
      for (let i = 0; i < 5; i++) await demo.press('Step');
      const stepped = await demo.picture();
      assert.ok(stepped !== paused, 'steps move it');
      await demo.press('Reset');
      await demo.wait(200);
      assert.ok((await demo.picture()) !== stepped, 'it begins again');
      assert.equal(await demo.said(), '');
      await demo.done();
    });

  test('a handle is dragged, a slider slid, a key pressed', async () => {
    const demo = await open(seven);
    await demo.press('Pause');
    await demo.press('Reset');
    await demo.wait(200);
    await demo.page.mouse.move(...(await demo.at(2.36, 3.17)));
    await demo.page.mouse.down();
    await demo.page.mouse.move(...(await demo.at(5.6, 4.7)), { steps: 3 });
    await demo.page.mouse.up();
    const speed = await demo.read('speed');
    assert.ok(Math.abs(speed - 39.8) < 1, `${speed} m/s`);
    await demo.slide('frames per second', 120);
    assert.ok(Math.abs((await demo.read('from frame to frame')) - speed / 120) < 0.01);
    await demo.choose('bounces (7.4)');
    const before = await demo.picture();
    await demo.page.keyboard.press('t');
    await demo.page.keyboard.press('.');
    assert.equal(await demo.picture(), before, 'keys are for the demo that has the focus');
    await demo.page.focus(`.play[data-demo="${seven}"] canvas`);
    await demo.page.keyboard.press('t');
    assert.notEqual(await demo.picture(), before);
    await demo.press('Play');
    await demo.wait(1500);
    assert.ok((await demo.read('walls noticed')) > 3);
    assert.equal(await demo.said(), '');
    await demo.done();
  });

  for (const name of ['endless_loop', 'throws', 'endless_recursion', 'index_beyond_end', 'not_a_number', 'flies_through'])
    test(`what goes wrong is said in the same sentence: ${name}`, { skip: !fs.existsSync(wrong) && 'there is no compiler for pages here' }, async () => {
      const expected = /^\/\/ the page says: ?(.*)/.exec(fs.readFileSync(path.join(root, 'tests/play', seven, `${name}.cpp`), 'utf8'))[1];
      const demo = await open(seven, pageWith(path.join(wrong, `${name}.js`)));
      await demo.choose('bounces (7.4)');
      await demo.press('Yours');
      for (let waited = 0; waited < 10000 && !(expected ? await demo.said() : waited > 1500); waited += 100) await demo.wait(100);
      assert.equal((await demo.said()).slice(0, expected.length || undefined), expected);
      await demo.press('Ours');
      await demo.wait(300);
      assert.equal(await demo.said(), '');
      await demo.done();
    });
});
