// Plays each demo as a reader would, from disk: by mouse, finger and keys, with our code and with code that goes wrong.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { browser, open, root, site, wrong } from './browser.mjs';
import { demoOn, openDemo, room, said, seven, wrongFiles } from './demo.mjs';

const four = '04_trajectories', eight = '08_nt_collisions', nine = '09_forward_kinematics', eleven = '11_particles', first = '01_motion';
const inChapter = async (t, name, start, options) => {
  const { page, troubles } = await open(t, `chapter_${name}.html`, options);
  t.after(() => assert.deepEqual(troubles, []));
  return demoOn(page, name, start === '' ? ':not([data-start])' : `[data-start^="${start}"]`);
};

describe('a demo', { concurrency: 2 }, () => {
  test('starts by itself, pauses, steps, goes on and is reset', async (t) => {
    const demo = await openDemo(t, seven), first = await demo.picture();
    await demo.wait(400);
    assert.notEqual(await demo.picture(), first, 'it moves');
    await demo.still();
    const paused = await demo.picture();
    await demo.wait(300);
    assert.equal(await demo.picture(), paused, 'it stands still');
    await demo.button('Step').click();
    assert.notEqual(await demo.picture(), paused, 'a step moves it');
    await demo.button('Reset').click();
    await demo.wait(100);
    const start = await demo.picture();
    await demo.button('Play').click();
    await demo.wait(300);
    assert.notEqual(await demo.picture(), start);
  });

  test('is played with keys alone', async (t) => {
    const demo = await openDemo(t, four), press = (key) => demo.page.keyboard.press(key);
    await demo.canvas.focus();
    await press(' ');
    const paused = await demo.picture();
    await demo.wait(200);
    assert.equal(await demo.picture(), paused, 'space pauses');
    let stepped = paused;
    for (let i = 0; i < 120 && stepped === paused; i++) { // at its end a film stands still for a while
      await press('.');
      stepped = await demo.picture();
    }
    assert.notEqual(stepped, paused, 'the full stop steps');
    await press('h');
    const chosen = await demo.picture();
    assert.notEqual(chosen, stepped, 'h marks a handle');
    await press('ArrowUp');
    assert.notEqual(await demo.picture(), chosen, 'an arrow key moves it');
    const moved = await demo.picture();
    await press('f');
    const fired = await demo.picture();
    assert.notEqual(fired, moved, "the demo's own key works");
    await press('r');
    await demo.wait(100);
    assert.notEqual(await demo.picture(), fired, 'r resets');
  });

  test('where somebody jumps, the space bar is for that, and pauses nothing', async (t) => {
    const demo = await inChapter(t, '12_time_based_motion', 'The game: run and jump');
    await demo.canvas.focus();
    await demo.page.keyboard.press(' '); // the first press starts the runner
    const before = await demo.picture();
    await demo.wait(400);
    assert.notEqual(await demo.picture(), before, 'it runs on');
    const named = await demo.figure.locator('.keys').innerText();
    assert.match(named, /space jump/);
    assert.doesNotMatch(named, /space pause/);
  });

  test('is dragged by the mouse, and by a finger while the page stays where it is', async (t) => {
    const demo = await openDemo(t, seven), tip = room(2.54, 3.255); // of the arrow, where the ball starts
    await demo.still();
    await demo.button('Reset').click();
    await demo.wait(100);
    const before = await demo.picture();
    await demo.page.mouse.move(...(await demo.at(...tip)));
    assert.equal(await demo.canvas.evaluate((it) => it.style.cursor), 'grab');
    await demo.page.mouse.down();
    await demo.page.mouse.move(...(await demo.at(...room(5, 4.8))), { steps: 4 });
    await demo.page.mouse.up();
    const dragged = await demo.picture();
    assert.notEqual(dragged, before);

    const phone = await openDemo(t, seven, { width: 390, touch: true, deviceScaleFactor: 2 });
    await phone.still();
    await phone.button('Reset').click();
    await phone.wait(100);
    const first = await phone.picture(), [x, y] = await phone.at(...tip), scrolled = await phone.page.evaluate(() => scrollY);
    await phone.stroke([x + 5, y], [x + 5, y + 20]);
    assert.notEqual(await phone.picture(), first);
    assert.equal(await phone.page.evaluate(() => scrollY), scrolled);
  });

  test('starts paused for readers who want less motion', async (t) => {
    const demo = await openDemo(t, seven, { reducedMotion: 'reduce' }), first = await demo.picture();
    await demo.wait(300);
    assert.equal(await demo.picture(), first);
    await demo.button('Play').click();
    await demo.wait(300);
    assert.notEqual(await demo.picture(), first);
  });

  test('moves if it came into sight while the page was busy, and hears of that and of an earlier change at once', async (t) => {
    const observer = `window.IntersectionObserver = class {
      constructor(tell) { this.tell = tell; }
      observe() { setTimeout(() => this.tell([{ isIntersecting: false }, { isIntersecting: true }])); }
    }`;
    const demo = await openDemo(t, seven, { script: observer }), first = await demo.picture();
    await demo.wait(400);
    assert.notEqual(await demo.picture(), first);
  });

  test('stands still out of sight, and goes on without a jump', async (t) => {
    const demo = await openDemo(t, first);
    await demo.choose('across the screen (1.2)');
    await demo.wait(300);
    await demo.page.evaluate(() => scrollTo(0, document.body.scrollHeight));
    await demo.wait(200);
    const time = await demo.read('time');
    await demo.wait(2500);
    assert.equal(await demo.read('time'), time);
    await demo.canvas.evaluate((it) => it.scrollIntoView({ block: 'center' }));
    await demo.wait(300);
    const later = await demo.read('time');
    assert.ok(later > time && later < time + 2, `${time} s, then ${later} s`);
  });

  test('takes the colours of the page, and those of paper in print', async (t) => {
    const demo = await openDemo(t, four, { colorScheme: 'dark', reducedMotion: 'reduce' });
    const dark = await demo.picture();
    await demo.page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    const paper = await demo.picture();
    assert.notEqual(paper, dark);
    await demo.page.evaluate(() => dispatchEvent(new Event('afterprint')));
    assert.equal(await demo.picture(), dark);
    await demo.page.locator('#site-theme').click();
    await demo.wait(100);
    assert.equal(await demo.picture(), paper);
  });

  test('says its scene, and what came out when it stands; on paper is the picture that forges show', async (t) => {
    const demo = await inChapter(t, four, 'The game: range (4.3)'), result = demo.figure.locator('[aria-live=polite]');
    assert.match(await demo.canvas.getAttribute('aria-label'), /^A cannon.*range \(4\.3\)$/);
    await demo.wait(1500);
    assert.equal(await result.textContent(), '', 'who only looks is told nothing');
    await demo.canvas.press('f');
    await demo.page.waitForFunction((it) => it.textContent.includes('54.1 m'), await result.elementHandle());
    await demo.page.emulateMedia({ media: 'print' });
    assert.deepEqual([await demo.canvas.isVisible(), await demo.figure.locator('> img').isVisible()], [false, true]);
  });

  test('draws a frame in time', async (t) => {
    const demo = await openDemo(t, eleven);
    for (let i = 0; i < 6; i++) await demo.button('Burst').click();
    const times = await demo.page.evaluate(() => new Promise((done) => {
      const between = [];
      let last = performance.now();
      requestAnimationFrame(function next(now) {
        between.push(performance.now() - last);
        last = performance.now();
        if (between.length < 90) requestAnimationFrame(next);
        else done(between.sort((a, b) => a - b));
      });
    }));
    assert.ok(times[45] < 40, `a frame takes ${times[45].toFixed(1)} ms at the median`);
  });
});

describe('a scene plays by itself', { concurrency: 2 }, () => {
  const takes = {
    'a click on an empty place': (demo) => demo.canvas.click({ position: { x: 12, y: 60 } }),
    'an arrow key, which moves a handle': async (demo) => {
      await demo.canvas.focus();
      for (const key of ['h', 'ArrowUp']) await demo.page.keyboard.press(key);
    },
  };
  for (const [what, take] of Object.entries(takes))
    test(`until there is ${what}`, async (t) => {
      const demo = await inChapter(t, eight, '');
      assert.ok(await demo.moves(2000), 'it moves by itself');
      await take(demo);
      await demo.wait(100);
      assert.equal(await demo.moves(1000), false, 'it is the reader who plays now');
    });
});

describe('a place is for one game', { concurrency: 2 }, () => {
  test('the others are behind More games, for a mouse and for keys', async (t) => {
    const demo = await inChapter(t, nine, 'The game: a digger (9.2)'), choice = demo.figure.getByRole('radio', { name: 'tentacle (9.3)' });
    assert.equal(await choice.isVisible(), false);
    await demo.figure.locator('summary', { hasText: 'More games' }).focus();
    await demo.page.keyboard.press('Enter');
    await choice.focus();
    await demo.page.keyboard.press('ArrowRight');
    assert.ok(await demo.figure.getByRole('radio', { name: 'in the cab (9.4)' }).isChecked());
  });

  test('its picture is high enough on a phone, and the numbers stand below its buttons, which they never move', async (t) => {
    const { page } = await open(t, `chapter_${nine}.html`, { width: 390, reducedMotion: 'reduce' });
    await page.waitForFunction(() => [...document.querySelectorAll('.play')].every(({ dataset }) => 'ready' in dataset));
    const seen = await page.locator('.play:not(.suspects *)').evaluateAll((all) => all.map((it) => {
      const picture = it.querySelector('canvas').getBoundingClientRect(), numbers = it.querySelector('dl').getBoundingClientRect();
      return { high: picture.height, below: numbers.height ? numbers.top - picture.bottom : 0 };
    }));
    assert.equal(seen.length, 8);
    for (const { high, below } of seen) assert.ok(high >= 190 && (below === 0 || (below > 40 && below < 200)), `${high} px high, numbers ${below} px below`);
  });
});

describe('07, the room', { concurrency: 2 }, () => {
  test('is thrown in each game, and each has its own sliders', async (t) => {
    const demo = await openDemo(t, seven);
    for (const game of ['bounces (7.4)', 'has a size (7.5)']) {
      await demo.choose(game);
      const radius = demo.figure.locator('.controls > label', { hasText: 'radius' });
      assert.equal(await radius.isVisible(), game.startsWith('has'), 'a slider that changes nothing is not shown');
      if (await radius.isVisible()) await demo.slide('radius', 0.5);
      await demo.throwAt(4.7, 4.3);
      await demo.button('Play').click();
      await demo.wait(1500);
      assert.ok(await demo.moves(), game);
      assert.equal(await demo.said(), '');
    }
  });

  test('a finger that scrolls the page turns nothing, one that taps does', async (t) => {
    const phone = await openDemo(t, seven, { width: 390, touch: true });
    await phone.still();
    const scrolled = () => phone.page.evaluate(() => scrollY);
    const first = await phone.picture(), place = await scrolled();
    const [x, y] = await phone.at(...room(8, 2));
    await phone.stroke([x, y], [x, y - 150]);
    let before; // the page glides on, and a tap then would only stop it
    do {
      before = await scrolled();
      await phone.wait(200);
    } while ((await scrolled()) !== before);
    assert.ok(before > place + 50);
    assert.equal(await phone.picture(), first);
    await phone.canvas.evaluate((it) => it.scrollIntoView({ block: 'center' })); // it may have glided out of sight
    await phone.page.touchscreen.tap(...(await phone.at(...room(8, 2))));
    for (let waited = 0; waited < 2000 && (await phone.picture()) === first; waited += 50) await phone.wait(50);
    assert.ok((await phone.picture()) !== first, 'it has turned');
  });
});

describe('11, fireworks', { concurrency: 2 }, () => {
  test('a press is a burst where it was, by a button and by a finger, too', async (t) => {
    const demo = await openDemo(t, eleven), centre = await demo.at(16, 10, [24, 13.5]);
    await demo.still();
    for (const act of [() => demo.page.mouse.click(...centre), () => demo.button('Burst').click(), () => demo.stroke(centre, centre)]) {
      const before = await demo.picture();
      await act();
      await demo.button('Step').click();
      await demo.button('Step').click();
      assert.notEqual(await demo.picture(), before);
    }
    assert.equal(await demo.said(), '');
  });
});

describe('the site from a server', () => {
  const kinds = { html: 'text/html', js: 'text/javascript', css: 'text/css', svg: 'image/svg+xml' };
  let server, address;
  before(() => new Promise((done) => {
    server = http.createServer(({ url }, answer) => {
      const file = path.join(site, new URL(url, 'http://localhost').pathname);
      if (!fs.existsSync(file)) return answer.writeHead(404).end();
      answer.writeHead(200, { 'Content-Type': kinds[path.extname(file).slice(1)] ?? 'application/octet-stream' }).end(fs.readFileSync(file));
    }).listen(0, '127.0.0.1', () => (address = `http://127.0.0.1:${server.address().port}/`, done()));
  }));
  after(() => server.close());

  test('every demo starts and moves, and nothing is asked for that is not there', async () => {
    const page = await (await browser()).newPage(), troubles = [];
    page.on('console', (message) => troubles.push(message.text()));
    page.on('pageerror', (error) => troubles.push(error.message));
    page.on('response', (response) => response.ok() || troubles.push(`${response.status()} ${response.url()}`));
    await page.route(/favicon/, (route) => route.fulfill({ status: 204 })); // asked for by the browser, not by a page
    await page.goto(`${address}play.html`);
    for (const figure of await page.locator('.play').all()) await (await demoOn(page, await figure.getAttribute('data-demo'))).begin();
    assert.deepEqual(troubles, []);
    await page.close();
  });
});

describe('demos in their chapters', { concurrency: 2 }, () => {
  for (const name of [first, seven, eleven])
    test(`${name}: each begins as its place says, and one that could be the reader's says how`, async (t) => {
      const { page, troubles } = await open(t, `chapter_${name}.html`);
      const figures = page.locator('.play');
      await page.waitForFunction(() => [...document.querySelectorAll('.play')].every(({ dataset }) => 'ready' in dataset));
      for (const figure of await figures.all())
        for (const setting of (await figure.getAttribute('data-start'))?.split(', ') ?? []) {
          const [title, chosen] = setting.split(': ');
          if (await figure.getByRole('slider', { name: title }).count()) assert.equal(await figure.getByRole('slider', { name: title }).inputValue(), chosen);
          else assert.ok(await figure.getByRole('group', { name: title, includeHidden: true }).getByRole('radio', { name: chosen, exact: true, includeHidden: true }).isChecked(), setting);
        }
      assert.ok((await figures.count()) > 1);
      for (const figure of await figures.all()) {
        const command = `./course play ${(await figure.getAttribute('data-exercise')) ?? parseInt(name, 10)} --mine`;
        assert.equal((await figure.locator('.answers').textContent()).includes(command), (await figure.getAttribute('data-mine')) !== null);
      }
      assert.deepEqual(troubles, []);
    });
});

describe('01, flight', { concurrency: 2 }, () => {
  test('a ring is dragged, and so are corners and sightings; whoever presses holds the engine', async (t) => {
    const demo = await openDemo(t, first), in16by9 = (x, y) => [x, y, [16, 9]];
    await demo.still();
    for (const [game, from, to] of [['you guess', [8.25, 3.75], [9.5, 3.75]], ['a plate (1.6)', [11.26, 3.38], [13, 5]], ['three sightings (1.7)', [6.54, 3.38], [7, 5]]]) {
      await demo.choose(game);
      await demo.page.mouse.click(...(await demo.at(15, 8.5, [16, 9]))); // from here on it doesn't play by itself
      const before = await demo.picture();
      await demo.drag(in16by9(...from), in16by9(...to));
      assert.notEqual(await demo.picture(), before, game);
    }
    await demo.choose('a chase (1.3)');
    await demo.page.mouse.click(...(await demo.at(8, 2, [16, 9])));
    const step = () => demo.button('Step').click();
    await step();
    const off = await demo.picture();
    await demo.canvas.focus();
    await demo.page.keyboard.down('e');
    await step();
    assert.notEqual(await demo.picture(), off);
    await demo.page.keyboard.up('e');
    assert.equal(await demo.said(), '');
  });
});

describe('your code in the page', { concurrency: 2, skip: !fs.existsSync(wrong) && 'there is no compiler for pages here' }, () => {
  for (const name of fs.existsSync(wrong) ? wrongFiles : [])
    test(name, async (t) => {
      const expected = said(name), demo = await openDemo(t, seven, { wrong: name });
      await demo.runInto(expected);
      if (!expected) {
        assert.equal(await demo.figure.locator('.answers').textContent(), 'Yours: 7.4. Ours: 7.1 (not written), 7.2 (not started).');
      } else {
        await demo.choose('asks once a frame'); // does not call 7.4, which would go wrong again before anybody looks
        await demo.figure.getByRole('button', { name: 'Restart' }).click(); // and the page lives on
        await demo.figure.locator('.trouble').waitFor({ state: 'hidden' });
        await demo.wait(300);
        assert.equal(await demo.said(), '');
      }
      await demo.button('Ours').click();
      await demo.wait(300);
      assert.equal(await demo.said(), '');
    });
});

describe('the gallery', { concurrency: 2 }, () => {
  for (const name of fs.readdirSync(path.join(root, 'docs/gallery')).map((file) => file.replace('.cpp', '')))
    test(`${name} plays by itself, and its few lines are beside it`, async (t) => {
      const demo = await openDemo(t, `sketch_${name}`), code = demo.figure.locator('+ div');
      assert.ok(await demo.moves(2000));
      const [, lines] = /^(\d+) lines of code$/.exec(await code.locator('> p').textContent());
      assert.ok(lines <= 60, `${lines} lines`);
      const [left, right] = [await demo.canvas.boundingBox(), await code.boundingBox()];
      assert.ok(left.x + left.width < right.x && right.y < left.y + left.height);
      assert.match(await code.locator('pre').innerText(), /^#include "sketch.hpp"$[^]*^SKETCH\(/m);
    });
});

test('a line that is taken away from the front page\'s code changes what its balls do, until it is back', async (t) => {
  const { page, troubles } = await open(t, 'index.html', { reducedMotion: 'reduce' });
  const demo = await demoOn(page, eight), lever = page.getByLabel('Take the marked line away');
  const after = async () => {
    await demo.button('Roll').click();
    for (let i = 0; i < 80; i++) await demo.button('Step').click();
    return demo.picture();
  };
  const rolled = await after();
  await lever.check();
  await demo.wait(200);
  const without = await after();
  assert.notEqual(without, rolled);
  assert.match(await page.locator('.behind .taken').evaluate((it) => getComputedStyle(it).textDecorationLine), /line-through/);
  await lever.uncheck();
  await demo.wait(200);
  assert.equal(await after(), rolled);
  assert.deepEqual(troubles, []);
});
