// The demos in Firefox: the other engine, in Debian's package firefox-esr.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { describe, test } from 'node:test';
import { firefoxHere, root, wrong } from './browser.mjs';
import { openDemo, room, said, seven } from './demo.mjs';

const open = (t, name, more) => openDemo(t, name, { engine: 'firefox', ...more });

describe('in Firefox', { skip: !firefoxHere && 'it is not installed: apt-get install firefox-esr' }, () => {
  for (const section of fs.readdirSync(path.join(root, 'demos')).filter((name) => name.endsWith('.js')))
    test(`${section.replace('.js', '')} starts, stands still, steps and is reset`, async (t) => {
      const demo = await open(t, section.replace('.js', ''));
      await demo.begin();
      await demo.still();
      assert.equal(await demo.moves(300), false, 'it stands still');
      await demo.act();
      await demo.wait(50);
      const paused = await demo.picture();
      for (let i = 0; i < 5; i++) await demo.button('Step').click();
      const stepped = await demo.picture();
      assert.ok(stepped !== paused, 'steps move it');
      await demo.button('Reset').click();
      await demo.wait(200);
      assert.ok((await demo.picture()) !== stepped, 'it begins again');
      assert.equal(await demo.said(), '');
    });

  test('a handle is dragged, a slider slid, a key pressed', async (t) => {
    const demo = await open(t, seven);
    await demo.throwAt(5.6, 4.7);
    const thrown = await demo.picture();
    await demo.choose('bounces (7.4)');
    await demo.slide('frames per second', 120);
    const before = await demo.picture();
    assert.ok(before !== thrown);
    await demo.page.keyboard.press('.');
    assert.ok((await demo.picture()) === before, 'keys are for the demo that has the focus');
    await demo.canvas.focus();
    await demo.page.keyboard.press('.');
    assert.ok((await demo.picture()) !== before);
    await demo.button('Play').click();
    await demo.wait(1500);
    assert.ok(await demo.moves());
    assert.equal(await demo.said(), '');
  });

  for (const name of ['endless_loop', 'throws', 'endless_recursion', 'index_beyond_end', 'not_a_number', 'flies_through'])
    test(`what goes wrong is said in the same sentence: ${name}`, { skip: !fs.existsSync(wrong) && 'there is no compiler for pages here' }, async (t) => {
      const demo = await open(t, seven, { wrong: name });
      await demo.runInto(said(name));
      await demo.button('Ours').click();
      await demo.wait(300);
      assert.equal(await demo.said(), '');
    });
});
