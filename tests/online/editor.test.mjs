// The editor in the boxes of exercises, in Chromium, with a checker that plays its part (served.mjs).
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { describe, test } from 'node:test';
import { address, inaccessible } from '../site/browser.mjs';
import { findPiece } from '../../tools/online/pieces.mjs';
import { asked, eight, folder, host, inBox, kept, open, saved, section, stub } from './served.mjs';

const given = (number) => findPiece(stub, number, stub).body;
const firstLine = 'Components decompose(const Vec2 &velocity, const Vec2 &a, const Vec2 &b)';
const right = `${firstLine} {\n    return right;\n}`, wrong = right.replace('right', 'wrong'), broken = right.replace('right', 'broken');
const written = (text) => stub.replace(given('8.1'), text);
const asker = (page) => page.evaluate(() => self.asked?.filter((one) => one.text));

async function begin(t, options) {
  const opened = await open(t, undefined, options), box = inBox(opened.page);
  await box.code.waitFor();
  return { ...opened, box };
}
const download = async (page, press) => {
  const [file] = await Promise.all([page.waitForEvent('download'), press()]);
  return { name: file.suggestedFilename(), bytes: fs.readFileSync(await file.path()) };
};

describe('an editor', () => {
  test('is made near the view, with the exercise’s piece of the file, and nothing of the compiler comes before a check', async (t) => {
    asked.length = 0;
    const { page, box, troubles } = await begin(t);
    assert.equal(await box.text(), given('8.1'));
    assert.equal(await page.locator('.turn[data-exercise="8.6"] .cm-editor').count(), 0, 'far away');
    assert.ok(!asked.includes('online/checker.js'));
    assert.deepEqual(await box.box.locator('.cm-lineNumbers .cm-gutterElement').allTextContents().then((all) => all.filter((one) => one !== '99').slice(-4)), ['19', '20', '21', '22']);
    await page.locator('.turn[data-exercise="8.6"]').scrollIntoViewIfNeeded();
    await page.locator('.turn[data-exercise="8.6"] .cm-editor').waitFor();
    assert.equal(await inBox(page, '8.6').text(), given('8.6'));
    await box.check();
    assert.ok(asked.includes('online/checker.js'));
    assert.deepEqual(troubles, []);
  });

  test('gives the whole file to the tests at Ctrl+Enter, and shows what they say, in colours, and the picture', async (t) => {
    const { page, box, troubles } = await begin(t);
    await box.write(wrong);
    await box.check();
    assert.deepEqual(await asker(page), [{ section, exercise: '8.1', text: written(wrong) }]);
    assert.equal(await page.evaluate(() => self.asked[0]), `${host}/online/`);
    const says = await box.verdict.textContent();
    assert.ok(says.startsWith('✗ 8.1: 7 of 12 tests passed\n    ✗ how far apart <the> centres are\n'), says);
    assert.equal(await box.verdict.getAttribute('role'), 'status');
    const colours = await box.verdict.locator('span').evaluateAll((all) => all.map((one) => [one.className, getComputedStyle(one).color, one.textContent]));
    const of = (name) => colours.find(([className]) => className === name);
    assert.equal(of('red')[2], '✗ 8.1');
    assert.equal(of('bold')[2], 'how far apart <the> centres are');
    assert.equal(new Set(['', 'red', 'yellow', 'dim'].map((name) => of(name)[1])).size, 4, JSON.stringify(colours));
    assert.equal(await box.verdict.locator('a').getAttribute('href'), `source_tests_${section}_tests_cpp.html#L41`);
    assert.ok(await box.box.locator('svg.verdict-picture').isVisible());
    assert.deepEqual(troubles, []);
  });

  test('says what the first check loads, and stops it', async (t) => {
    const { box } = await begin(t);
    await box.write('forever');
    await box.button('Check').click();
    await box.button('Stop').waitFor();
    await box.box.locator('.step').getByText('Loading the compiler, this once: 12.0 of 30.0 MB', { exact: true }).waitFor();
    assert.deepEqual(await box.box.locator('progress').evaluate((bar) => [bar.value, bar.max]), [12e6, 30e6]);
    await box.button('Stop').click();
    await box.button('Check').waitFor();
    assert.equal(await box.verdict.textContent(), 'Stopped.');
    assert.equal(await box.box.locator('progress').isVisible(), false);
    await box.write(right);
    await box.check();
    assert.match(await box.verdict.textContent(), /8\.1 is done/);
  });

  test('says so when the compiler can’t be loaded, and checks when it can', async (t) => {
    const { page, box } = await begin(t);
    await page.route('**/checker.js', (route) => route.abort());
    await box.check();
    assert.match(await box.verdict.textContent(), /couldn’t be checked: .* Are you online\? Your code is kept/);
    await page.unroute('**/checker.js');
    await box.button('Check').waitFor();
  });

  test('keeps what was typed, even if the page goes at once', async (t) => {
    const { page, box } = await begin(t);
    await box.write(wrong);
    await saved(page, wrong);
    await page.reload();
    await box.code.waitFor();
    assert.equal(await box.text(), wrong);
    await box.write(right);
    await page.goto(`${host}/index.html`);
    await page.goBack();
    await box.code.waitFor();
    assert.equal(await box.text(), right);
    assert.equal(await page.evaluate(() => new Promise((done) => setTimeout(() => done(Object.keys(localStorage).join()), 500))), '');
  });

  test('has what a page could not save any more, and it follows the stub as all else does', async (t) => {
    const { page, box } = await begin(t), older = stub.replace('how fast does each ball', 'how slow does each ball');
    await page.evaluate(([name, left]) => localStorage.setItem(`unsaved/${name}`, JSON.stringify(left)),
      [section, { text: older.replace(given('8.1'), wrong), base: older, stub: older }]);
    await page.reload();
    await box.code.waitFor();
    assert.equal(await box.text(), wrong);
    await saved(page, written(wrong));
    assert.equal(await page.evaluate(() => localStorage.length), 0);
  });

  test('starts again, and takes it back; the menu has it, too', async (t) => {
    const { page, box } = await begin(t);
    await box.write(wrong);
    await box.button('Start again').click();
    await box.note.getByText('8.1 is as it was at the start').waitFor();
    assert.equal(await box.text(), given('8.1'));
    await box.button('Take it back').click();
    await box.note.getByText('It’s back').waitFor();
    assert.equal(await box.text(), wrong);
    await box.button('Start again').click();
    await page.reload();
    await box.menu.click();
    assert.match(await box.box.locator('.answers li').textContent(), /, before you started again Take it back$/);
    await box.button('Take it back').click();
    await box.note.getByText('It’s back').waitFor();
    assert.equal(await box.text(), wrong);
  });

  test('shows the whole file, and its piece again; all boxes have the same text', async (t) => {
    const { page, box } = await begin(t);
    await box.button('The whole file').click();
    assert.match(await box.text(), /^\/\/ Section 8[^]*\/\/ 8\.1 core/);
    await page.locator('.turn[data-exercise="8.2"]').scrollIntoViewIfNeeded();
    const second = inBox(page, '8.2');
    await second.write('Velocities exchange; // 8.2');
    await box.button('Only 8.1').click();
    await box.write(`${wrong}\n// one more line`);
    assert.equal(await second.text(), 'Velocities exchange; // 8.2');
    await second.check();
    const { text } = (await asker(page)).at(-1);
    assert.equal(text, written(`${wrong}\n// one more line`).replace(given('8.2'), 'Velocities exchange; // 8.2'));
  });

  test('goes to the line that the compiler names, in its piece or in the whole file', async (t) => {
    const { page, box } = await begin(t);
    const cursor = () => page.evaluate(() => getSelection().focusNode.parentElement.closest('.cm-line').textContent);
    await box.write(broken);
    await box.check();
    await box.button(`exercises/${section}.cpp:20`).click();
    assert.equal(await cursor(), '    return broken;');
    await box.write(wrong);
    await page.locator('.turn[data-exercise="8.2"]').scrollIntoViewIfNeeded();
    const second = inBox(page, '8.2');
    await second.write('int broken;');
    await box.check();
    await box.verdict.getByText('does not compile').waitFor();
    await box.verdict.getByRole('button').click();
    assert.equal(await cursor(), 'int broken;');
    assert.ok(await box.button('Only 8.1').isVisible());
    assert.ok(await box.box.locator('.cm-editor.cm-focused').isVisible());
  });

  test('marks the line that doesn’t compile until that line is changed, or the next check compiles', async (t) => {
    const { page, box, troubles } = await begin(t), mark = box.box.getByRole('group', { name: 'This line doesn’t compile' }), marked = () => mark.allTextContents();
    await box.write(broken);
    await box.check();
    await mark.waitFor();
    assert.deepEqual(await marked(), ['    return broken;']);
    assert.deepEqual(await inaccessible(page, '.turn'), []);
    await box.button('The whole file').click();
    assert.deepEqual(await marked(), ['    return broken;'], 'in the whole file, too');
    await box.button('Only 8.1').click();
    await page.keyboard.insertText('// above\n');
    assert.deepEqual(await marked(), ['    return broken;'], 'it moves with its line');
    await box.check();
    await page.keyboard.insertText('// mended\n');
    await box.check();
    await mark.waitFor({ state: 'detached' });
    await box.write(broken);
    await box.check();
    await mark.waitFor();
    await page.keyboard.press('Control+End');
    await page.keyboard.press('ArrowUp');
    await page.keyboard.type('!');
    assert.deepEqual(await marked(), []);
    assert.deepEqual(troubles, []);
  });

  for (const [how, enter, options] of [
    ['a key', (box) => box.code.focus()],
    ['a click', (box) => box.code.click()],
    ['a finger', (box) => box.code.tap(), { width: 390, hasTouch: true, isMobile: true }],
  ])
    test(`has the throw of an untouched exercise selected when ${how} enters it, so that typing replaces it`, async (t) => {
      const { page, box, troubles } = await begin(t, options), written = given('8.1').replace(/throw course::NotYet\{.*?\};/, 'return mine;');
      const chosen = () => page.evaluate(() => String(getSelection()));
      await enter(box);
      await page.waitForFunction(() => /^throw course::NotYet\{.*\};$/s.test(String(getSelection())));
      await page.waitForTimeout(300);
      assert.match(await chosen(), /^throw course::NotYet/, 'it stays selected');
      await page.keyboard.type('return mine;');
      assert.equal(await box.text(), written);
      await page.locator('h1').click();
      await enter(box);
      assert.equal(await chosen(), '', 'once something is written, the cursor is where it is put');
      await box.button('Start again').click();
      await box.note.getByText('8.1 is as it was at the start').waitFor();
      await enter(box);
      await page.waitForFunction(() => String(getSelection()).startsWith('throw'));
      await box.code.press('ArrowRight');
      await box.code.click();
      assert.equal(await chosen(), '', 'only the first time');
      assert.deepEqual(troubles, []);
    });

  test('shows the whole file when a piece’s line is gone', async (t) => {
    const { box, page } = await begin(t);
    await box.button('The whole file').click();
    await box.write(stub.replace('// 8.1 core\n', '// mine\n'));
    await saved(page, '// mine');
    await page.reload();
    await box.note.getByText('There’s no one line “// 8.1” in your file').waitFor();
    assert.match(await box.text(), /^\/\/ Section 8/);
    assert.equal(await box.button('The whole file').isVisible(), false);
  });

  test('follows a new stub where nothing was written', async (t) => {
    const { page, box } = await begin(t);
    await box.write(wrong);
    await saved(page, wrong);
    const newer = stub.replaceAll('throw course::NotYet{"', 'throw course::NotYet{"new: ');
    await page.route('**/stubs.json', (route) => route.fulfill({ json: { [section]: { stub: newer, exercises: [] } } }));
    await page.reload();
    await box.code.waitFor();
    assert.equal(await box.text(), wrong);
    await page.locator('.turn[data-exercise="8.2"]').scrollIntoViewIfNeeded();
    await inBox(page, '8.2').code.waitFor();
    assert.equal(await inBox(page, '8.2').text(), findPiece(newer, '8.2', newer).body);
  });
});

describe('what is done', () => {
  test('has its tick at once, keeps it until it is red, and is on the front page', async (t) => {
    const { page, box, context, troubles } = await begin(t);
    const tick = box.box.locator('header .done');
    await box.write(right);
    await box.check();
    await tick.waitFor();
    assert.ok(await box.verdict.isVisible(), 'it stays open');
    assert.match(await page.locator(`#site-contents a[href="${eight}"]`).textContent(), /1\/6 done$/);
    await box.write(broken);
    await box.check();
    await box.verdict.getByText('does not compile').waitFor();
    assert.equal(await tick.count(), 1, 'it was not tried');
    const { page: front } = await open(t, 'index.html', { context });
    const goOn = front.getByRole('link', { name: 'Go on: 8.2' });
    await goOn.waitFor();
    assert.equal(await goOn.getAttribute('href'), `${eight}#exercise-8.2`);
    await page.goto(`${host}/${eight}`);
    await page.locator('#exercise-8\\.1.folded').waitFor();
    await page.locator('#exercise-8\\.1 .unfold').click();
    await box.write(wrong);
    await box.check();
    await tick.waitFor({ state: 'detached' });
    await front.locator('.card [data-progress="8"]').filter({ hasText: /^$/ }).waitFor({ state: 'attached' });
    assert.deepEqual(troubles, []);
  });

  test('is not done any more when the whole file starts again', async (t) => {
    const { page, box } = await begin(t);
    await box.write(right);
    await box.check();
    await box.box.locator('header .done').waitFor();
    await box.button('The whole file').click();
    await box.button('Start again').click();
    await box.box.locator('header .done').waitFor({ state: 'detached' });
    await page.reload();
    await box.code.waitFor();
    assert.equal(await box.box.locator('header .done').count(), 0);
  });
});

describe('two tabs', () => {
  test('know of each other, and show the same', async (t) => {
    const one = await begin(t), other = await begin(t, { context: one.context });
    await one.box.write(wrong);
    await other.box.note.getByText('This section is open in another tab').waitFor();
    await other.box.box.locator('.cm-line').getByText('return wrong;').waitFor();
    assert.equal(await other.box.text(), wrong);
    await one.page.close();
    await other.box.note.waitFor({ state: 'hidden' });
  });

  test('that both type lose nothing', async (t) => {
    const one = await begin(t), other = await begin(t, { context: one.context });
    await Promise.all([one.box.write('int first;'), other.box.write('int second;')]);
    let records;
    do records = await kept(one.page); while (!(records[0]?.copies.length > 0));
    const [record] = records;
    const all = [record.text, ...record.copies.map((copy) => copy.text)].map((text) => text.match(/int (first|second);/)[1]);
    assert.deepEqual([...all].sort(), ['first', 'second']);
    for (const { box } of [one, other]) await box.box.locator('.cm-line').getByText(`int ${all[0]};`).waitFor();
  });
});

describe('answers as files', () => {
  test('go out as a zip, and come in again; what was there is kept', async (t) => {
    const { page, box, troubles } = await begin(t);
    await box.menu.click();
    await box.button('Download my answers').click();
    await box.note.getByText('you haven’t changed any file').waitFor();
    await box.write(wrong);
    const zip = await download(page, () => box.button('Download my answers').click());
    assert.equal(zip.name, 'my-answers.zip');
    assert.ok(zip.bytes.includes(`exercises/${section}.cpp`));
    const one = await download(page, () => box.button('Download this file').click());
    assert.equal(one.name, `${section}.cpp`);
    assert.equal(one.bytes.toString(), written(wrong));
    await box.write('int other;');
    await page.setInputFiles(`.turn[data-exercise="8.1"] input[type=file]`, { name: 'my-answers.zip', mimeType: 'application/zip', buffer: zip.bytes });
    await box.note.getByText(`Opened: ${section}`).waitFor();
    assert.equal(await box.text(), wrong);
    assert.match((await box.box.locator('.answers li').allTextContents())[0], /before you opened a file/);
    assert.deepEqual(troubles, []);
  });

  test('and how it went, once something was checked, without any code', async (t) => {
    const { page, box, troubles } = await begin(t);
    await box.menu.click();
    await box.button('How it went').click();
    await box.note.getByText('Nothing to tell').waitFor();
    await box.write(wrong);
    await box.check();
    const told = await download(page, () => box.button('How it went').click());
    assert.equal(told.name, 'feedback.txt');
    const [{ when, ...attempt }, ...more] = JSON.parse(told.bytes);
    assert.deepEqual(attempt, { number: '8.1', state: 'wrong', mistake: 'you forget it.' });
    assert.ok(Date.now() - Date.parse(when) < 60_000);
    assert.deepEqual(more, []);
    assert.deepEqual(troubles, []);
  });

  test('are known by their names, of any section; what is no answer is refused with its name', async (t) => {
    const { page, box } = await begin(t);
    const file = (name, text) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) });
    await page.setInputFiles('.turn[data-exercise="8.1"] input[type=file]', [
      file(`${section}.cpp`, written(right).replaceAll('\n', '\r\n')), file('01_motion.cpp', '// 1.1 core\n'), file('notes.cpp', ''),
      file('02_momentum.cpp', Buffer.of(0xff, 0xfe)), file('broken.zip', 'PK?')]);
    await box.note.getByText(`Opened: ${section}, 01_motion.`).waitFor();
    const said = await box.note.textContent();
    for (const name of ['notes.cpp belongs to no section', '02_momentum.cpp is no text in UTF-8', 'broken.zip can']) assert.ok(said.includes(name), said);
    assert.equal(await box.text(), right);
    await box.menu.click();
    const zip = await download(page, () => box.button('Download my answers').click());
    assert.ok(zip.bytes.includes('exercises/01_motion.cpp'));
  });
});

describe('everybody', () => {
  test('can do it with keys alone', async (t) => {
    const { page, box, troubles } = await begin(t);
    await box.button('The whole file').focus();
    await page.keyboard.press('Tab');
    await box.box.locator('.cm-focused').waitFor(); // CodeMirror hears of the focus a moment later
    await page.keyboard.press('Control+End');
    await page.keyboard.press('Enter');
    await page.keyboard.press('Tab');
    await page.keyboard.type('// a/b');
    assert.equal(await page.locator('#site-search').isVisible(), false, 'a slash is text here');
    assert.equal(await box.text(), `${given('8.1')}\n    // a/b`);
    await page.keyboard.press('Control+z');
    await page.keyboard.press('Escape');
    await page.keyboard.press('Tab');
    assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Check');
    await page.keyboard.press('Enter');
    await box.verdict.locator('span').first().waitFor();
    for (const name of ['Start again', 'My answers']) {
      await page.keyboard.press('Tab');
      assert.equal(await page.evaluate(() => document.activeElement.textContent), name);
    }
    await page.keyboard.press('Enter');
    await box.button('Download my answers').waitFor();
    assert.deepEqual(troubles, []);
  });

  for (const width of [390, 1280])
    for (const colorScheme of ['light', 'dark'])
      test(`can read and press it, ${width} px, ${colorScheme}`, async (t) => {
        const { page, box, troubles } = await begin(t, { width, colorScheme, hasTouch: width < 1000, isMobile: width < 1000 });
        await box.write(wrong);
        await box.check();
        await box.menu.click();
        for (const name of ['The whole file', 'Only 8.1']) {
          assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= width, 'the page does not scroll sideways');
          assert.deepEqual(await inaccessible(page, '.turn'), []);
          await box.button(name).click();
        }
        const sizes = await box.box.locator('.answer :is(button, summary):not(.place)').evaluateAll((all) => all.map((one) => [one.textContent, one.getBoundingClientRect().height]));
        if (width < 1000) for (const [name, height] of sizes) assert.ok(height >= 44, `${name}: ${height} px`);
        if (width < 1000) assert.ok(await box.code.evaluate((one) => parseFloat(getComputedStyle(one).fontSize)) >= 16, 'or phones zoom in');
        assert.deepEqual(troubles, []);
      });

  test('has the page’s colours, by its switch', async (t) => {
    const { page, box } = await begin(t);
    await box.check();
    const colours = () => page.evaluate(() => ['.cm-content', '.cm-gutters', '.cm-content span', '.verdict .red', '.verdict-picture circle'].map((one) => {
      const element = document.querySelector(one), { color, fill } = getComputedStyle(element);
      return element instanceof SVGElement ? fill : color;
    }));
    const light = await colours();
    await page.locator('#site-theme').click();
    const dark = await colours();
    for (const [at, colour] of light.entries()) assert.notEqual(dark[at], colour, String(at));
  });

  test('is told why not, and what to type, where it can’t work', async (t) => {
    const words = (page) => page.locator('.turn[data-exercise="8.1"] .cannot').textContent();
    const file = await open(t, address(eight, folder));
    assert.match(await words(file.page), /a page that was opened as a file.*\.\/course check 8\.1$/);
    assert.equal(await file.page.locator('.cm-editor').count(), 0);
    const context = file.context;
    await context.addInitScript('delete self.DecompressionStream');
    const old = await open(t, eight, { context });
    assert.match(await words(old.page), /this browser has no decompression.*\.\/course check 8\.1$/);
    await context.addInitScript(() => (IDBFactory.prototype.open = () => { throw new DOMException('not here', 'SecurityError'); }));
    const forgetful = await open(t, `${eight}#exercise-8.1`, { context: await file.page.context().browser().newContext() });
    t.after(() => forgetful.context.close());
    await forgetful.page.addInitScript(() => (IDBFactory.prototype.open = () => { throw new DOMException('not here', 'SecurityError'); }));
    await forgetful.page.reload();
    assert.match(await words(forgetful.page), /not here.*\.\/course check 8\.1$/);
  });

  test('is safe from other hosts, and from text that is run', async (t) => {
    const { page, troubles } = await begin(t);
    const ran = await page.evaluate(async () => {
      document.head.append(Object.assign(document.createElement('script'), { textContent: 'self.inline = true' }));
      const works = (what) => what().then(() => true, () => false);
      return [self.inline ?? false, await works(() => fetch('http://127.0.0.1:9/', { mode: 'no-cors' })), await works(() => WebAssembly.compile(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0)))];
    });
    assert.deepEqual(ran, [false, false, true]);
    assert.ok(troubles.some((one) => /Refused|violates/.test(one) && one.includes('127.0.0.1:9')), troubles.join('\n'));
  });
});

test('the bundle is small enough to be on every chapter’s page, and has its licences with it', () => {
  const size = (name) => fs.statSync(path.join(folder, 'online', name)).size;
  assert.ok(size('editor.js') <= 455_000, `${size('editor.js')} bytes`);
  assert.ok(size('ticks.js') <= 4_000, `${size('ticks.js')} bytes`);
  const licences = fs.readFileSync(path.join(folder, 'online/editor_licences.txt'), 'utf8');
  for (const name of ['@codemirror/view', '@lezer/cpp', 'fflate']) assert.ok(licences.includes(name), name);
});
