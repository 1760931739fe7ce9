// A sketch of a reader's own, from the command to the page, which follows each save.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, describe, test } from 'node:test';
import { build, open, root } from './browser.mjs';

const name = 'sketch_of_a_test', folder = path.join(build, 'play/sketches'), file = path.join(root, 'exercises/sketches', `${name}.cpp`);
const skip = !fs.existsSync(path.join(build, 'play/can_compile')) && 'there is no compiler for pages here';
const sketch = (...words) => spawnSync(path.join(root, 'course'), ['sketch', name, ...words], { encoding: 'utf8', env: { ...process.env, DISPLAY: '', WAYLAND_DISPLAY: '' } });
function forget() {
  for (const each of [file, ...['.js', '.html', '.o', '.o.d', '.wasm'].map((end) => path.join(folder, name + end))]) fs.rmSync(each, { force: true });
}
after(forget);

const cannon = (aim, more = '') => `#include "sketch.hpp"
using namespace demo;

struct Cannon : Scene {
    motion::State shell{{10, 3}, {0, 0}};
    std::vector<Vec2> sparks;
    void begin() override {
        shell.velocity = trajectories::launch_velocity(25, ${aim});${more}
        sparks = particles::ring_burst(48, 9, 0);
    }
    View view() const override { return {{0, 0}, {80, 45}, Stage::skyline, 2}; }
    void step(double dt) override { shell = motion::accelerated_motion(shell, {0, -10}, dt); }
    void draw(Canvas &canvas) const override { canvas.ball(shell.position, 0.5, Colour::ink); }
};
SKETCH(Cannon, "A cannon")
`;
async function shown(t, page = path.join(folder, `${name}.html`)) {
  const opened = await open(t, path.basename(page), { folder: path.dirname(page) }), figure = opened.page.locator('.play[data-ready]');
  await figure.waitFor();
  return { ...opened, figure, sees: () => figure.locator('canvas').evaluate((it) => it.toDataURL()) };
}

// One after the other: they share the file.
describe('a sketch', { concurrency: 1, skip }, () => {
  test('begins with a disc that follows the pointer, and keeps what is there', async (t) => {
    forget();
    const made = sketch();
    assert.equal(made.status, 0, made.stderr);
    assert.match(made.stdout, /^Written: exercises\/sketches\/sketch_of_a_test\.cpp$/m);
    const { troubles, figure, sees, page } = await shown(t), before = await sees();
    await page.waitForTimeout(300);
    assert.equal(await sees(), before);
    await figure.locator('canvas').hover({ position: { x: 40, y: 40 } });
    await page.waitForTimeout(300);
    assert.notEqual(await sees(), before);
    assert.equal(await figure.locator('.lamps').isVisible(), false);
    assert.deepEqual(troubles, []);
    fs.appendFileSync(file, '// mine\n');
    assert.doesNotMatch(sketch().stdout, /Written/);
    assert.match(fs.readFileSync(file, 'utf8'), /\/\/ mine\n$/);
  });

  test('calls functions of several sections, each with a lamp; an open page follows a save, and says what is wrong', async (t) => {
    fs.writeFileSync(file, cannon(60));
    assert.equal(sketch().status, 0);
    const { troubles, figure, page } = await shown(t);
    assert.deepEqual(await figure.locator('.lamps code').allTextContents(), ['accelerated_motion', 'launch_velocity', 'ring_burst']);
    await figure.locator('.lamps li', { hasText: '4.1' }).locator('text=ours: not done yet').waitFor();

    fs.writeFileSync(file, cannon('degree'));
    const refused = sketch();
    assert.equal(refused.status, 1);
    assert.match(refused.stdout, /^Not in the page: exercises\/sketches\/sketch_of_a_test\.cpp:8: .*degree/m);
    await figure.locator('.trouble', { hasText: 'sketch_of_a_test.cpp:8: ' }).waitFor({ timeout: 3000 });

    fs.writeFileSync(file, cannon(60).replace('Colour::ink', 'Colour{20, 60, 40}'));
    assert.match(sketch().stdout, /A colour has a name, as Colour::green/);

    fs.writeFileSync(file, cannon(30, ' while (shell.position.x() > 0) shell.position.y() += 1;'));
    assert.equal(sketch().status, 0);
    await figure.locator('.trouble', { hasText: 'Your sketch gave no answer: look for a loop that never ends.' }).waitFor({ timeout: 3000 });
    fs.writeFileSync(file, cannon('0 * std::sqrt(-1.0)'));
    assert.equal(sketch().status, 0);
    await figure.locator('.trouble', { hasText: '(NaN)' }).waitFor({ timeout: 3000 });
    assert.deepEqual(troubles.filter((words) => !/debug/.test(words)), []);
    await page.close();
  });

  test('is shared as one page, which needs nothing else', async (t) => {
    const shared = fs.mkdtempSync(path.join(os.tmpdir(), 'shared-'));
    t.after(() => fs.rmSync(shared, { recursive: true }));
    fs.writeFileSync(file, cannon(60));
    const page = path.join(shared, 'cannon.html');
    assert.match(sketch('--share', page).stdout, /Written: .*cannon\.html, \d+ kB\. Send it to a friend/);
    const { troubles, figure, sees } = await shown(t, page), before = await sees();
    assert.deepEqual(await figure.locator('.whose button').allTextContents(), ['The book’s', 'Mine']);
    await figure.locator('summary', { hasText: 'Functions in this game, mine and the book’s' }).waitFor();
    await figure.locator('.lamps li', { hasText: '4.1' }).locator('text=the book’s: not done yet').waitFor();
    assert.doesNotMatch(await figure.page().locator('main').innerText(), /\b(yours?|ours)\b/i);
    await figure.page().waitForTimeout(300);
    assert.notEqual(await sees(), before);
    assert.deepEqual(troubles, []);
    fs.rmSync(page);
    fs.writeFileSync(file, cannon('degree'));
    assert.match(sketch('--share', page).stdout, /cannon\.html was not written/);
    assert.equal(fs.existsSync(page), false);
  });

  test('is whatever the page about sketches has in whole', async (t) => {
    const examples = [...fs.readFileSync(path.join(root, 'docs/sketches.md'), 'utf8').matchAll(/```cpp\n([^]*?)```/g)].map(([, code]) => code);
    assert.equal(examples.length, 2);
    for (const example of examples) {
      fs.writeFileSync(file, example);
      const made = sketch();
      assert.equal(made.status, 0, made.stdout);
      const { troubles, page } = await shown(t);
      await page.waitForTimeout(1000);
      assert.equal(await page.locator('.trouble:visible').count(), 0);
      assert.deepEqual(troubles, []);
    }
  });

  test('is what strangers made of that page alone', async (t) => {
    for (const each of fs.readdirSync(path.join(root, 'tests/sketches'))) {
      fs.copyFileSync(path.join(root, 'tests/sketches', each), file);
      const made = sketch();
      assert.equal(made.status, 0, made.stdout);
      const { troubles, page, figure, sees } = await shown(t), before = await sees(), title = /SKETCH\(\w+, "(.*)"\)/.exec(fs.readFileSync(file, 'utf8'))[1];
      await page.waitForTimeout(2000); // a ball may wait to be served
      assert.notEqual(await sees(), before, each);
      assert.equal(await figure.locator('figcaption').textContent(), title);
      assert.deepEqual(troubles, []);
    }
  });

  test('hears keys before it is touched, and says which are its own', async (t) => {
    fs.writeFileSync(file, `#include "sketch.hpp"
using namespace demo;
struct Counts : Scene {
    int presses = 0;
    Button more = button("r", "One more", [this] { ++presses; });
    void draw(Canvas &canvas) const override { canvas.readout("presses", presses); }
};
SKETCH(Counts, "It counts")
`);
    assert.equal(sketch().status, 0);
    const { page, figure } = await shown(t);
    await page.keyboard.press('r');
    await figure.locator('dd', { hasText: /^1 *$/ }).waitFor();
    assert.deepEqual(await figure.locator('.keys span').allTextContents(), ['space pause', '. step', 'r one more']);
    assert.equal(await figure.locator('.whose').isVisible(), false, 'it calls nobody');
  });

  test('begins with a scene of the book, the first and the last of each chapter', () => {
    for (const section of fs.readdirSync(path.join(root, 'chapters')).filter((each) => fs.existsSync(path.join(root, 'chapters', each, 'scenes'))))
      for (const scene of fs.readdirSync(path.join(root, 'chapters', section, 'scenes')).filter((each) => fs.readFileSync(path.join(root, 'chapters', section, 'scenes', each), 'utf8').includes('string_view name')).filter((_, i, all) => i === 0 || i === all.length - 1)) {
        forget();
        const made = sketch('--from', `${parseInt(section, 10)}/${scene.replace('.hpp', '')}`);
        assert.equal(made.status, 0, `${section}/${scene}: ${made.stdout}${made.stderr}`);
      }
  });

  test('begins with one of the gallery, and is in the list', () => {
    const all = fs.readdirSync(path.join(root, 'docs/gallery')).map((each) => each.replace('.cpp', ''));
    for (const each of [all[0], all.at(-1)]) {
      forget();
      const made = sketch('--from', each);
      assert.equal(made.status, 0, `${each}: ${made.stdout}${made.stderr}`);
    }
    const listed = spawnSync(path.join(root, 'course'), ['list'], { encoding: 'utf8' });
    assert.match(listed.stdout, new RegExp(`^./course sketch ${name}$`, 'm'));
    forget();
    assert.match(sketch('--from', 'chess').stderr, new RegExp(`a sketch of the gallery: ${all.join(', ')}`));
  });
});
