// The scenes of a page of the online edition as it is built, in Chromium: they run on what the reader has written in it.
import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { browser, build } from '../site/browser.mjs';
import { demoOn } from '../site/demo.mjs';
import { inBox } from './in_box.mjs';
import { serve } from './server.mjs';

const section = '07_segment_intersection', number = '7.4', place = `[data-exercise="${number}"]`;
const written = (body) => `Ball move_and_bounce(const Ball &ball, const std::vector<Vec2> &corners, double dt) {\n    ${body}\n}`;

const host = await serve(path.join(build, 'online/site'), [], '/some/path');
let context;
before(async () => (context = await (await browser()).newContext({ viewport: { width: 1280, height: 900 } })));
after(() => context?.close());

async function openChapter(t, name = `chapter_${section}.html`) {
  const page = await context.newPage(), troubles = [];
  t.after(() => page.close());
  page.on('pageerror', (error) => troubles.push(error.message));
  page.on('request', (request) => request.url().startsWith(host) || /^(data|blob):/.test(request.url()) || troubles.push(`asks for ${request.url()}`));
  await page.goto(`${host}/${name}`);
  return { page, troubles };
}
// Writes into the exercise's box, or does something else there; checks, and waits for the verdict.
async function check(page, text, exercise = number) {
  const box = inBox(page, exercise);
  await box.box.scrollIntoViewIfNeeded();
  await box.code.waitFor();
  if (text === startAgain) await box.button('Start again').click();
  else await box.write(text);
  await box.button('Check').click();
  await box.button('Check').waitFor({ timeout: 120_000 });
  return box.verdict.textContent();
}
const startAgain = Symbol('start again');
// What the scene says of whose functions it has called, once it is looked at again.
async function says(demo, words) {
  await demo.canvas.scrollIntoViewIfNeeded();
  await demo.figure.locator('.answers', { hasText: words }).waitFor();
}

// One after the other: what one has written the next one finds.
describe('the scenes of a page', { concurrency: 1 }, () => {
  test('run on ours until something is compiled, and on the reader’s as soon as it is, red or green', async (t) => {
    const { page, troubles } = await openChapter(t), demo = await demoOn(page, section, place);
    assert.equal(await demo.button('Yours').isVisible(), false);
    assert.match(await check(page, written('return {ball.position + dt * ball.velocity, ball.velocity};')), /✗ 7\.4/);
    await says(demo, 'Yours: 7.4.');
    assert.equal(await demo.moves(2000), true);
    assert.equal(await demo.said(), '');
    assert.deepEqual(troubles, []);
  });

  test('still do when the page is loaded again', async (t) => {
    const { page, troubles } = await openChapter(t), demo = await demoOn(page, section, place);
    await says(demo, 'Yours: 7.4.');
    await demo.button('Ours').click();
    await demo.figure.locator('.answers:empty').waitFor({ state: 'attached' });
    assert.deepEqual(troubles, []);
  });

  test('say what goes wrong, and leave the page usable', async (t) => {
    const { page } = await openChapter(t), demo = await demoOn(page, section, place);
    const trouble = async (words) => {
      await demo.canvas.scrollIntoViewIfNeeded();
      await demo.figure.locator('.trouble', { hasText: words }).waitFor();
    };
    await check(page, written('for (;;) {}'));
    await trouble('7.4 move_and_bounce gave no answer: look for a loop that never ends.');
    await check(page, written('std::vector<double> none; return {{none[7], 0}, ball.velocity};'));
    await trouble('7.4 move_and_bounce was stopped by a check of the library that it uses: vector[] index out of bounds.');
    await check(page, written('throw std::logic_error{"I give up"};'));
    await trouble('7.4 move_and_bounce threw std::logic_error: I give up.');
    await check(page, written('return move_and_bounce(ball, corners, dt);'));
    await trouble('7.4 move_and_bounce called itself, again and again, until the stack was full. When does it stop?');
    await check(page, written('return {ball.position, ball.velocity * '));
    await trouble('called itself'); // what can't be compiled changes nothing
    await check(page, written('return {ball.position + dt * ball.velocity, ball.velocity};'));
    await demo.figure.locator('.trouble').waitFor({ state: 'hidden' });
  });

  test('are ours again when nothing in the file is the reader’s', async (t) => {
    const { page } = await openChapter(t), demo = await demoOn(page, section, place);
    await says(demo, 'Yours: 7.4.');
    assert.match(await check(page, startAgain), /not started/);
    await demo.button('Yours').waitFor({ state: 'hidden' });
  });
});

test('the scene of many sections runs on the reader’s in what the reader’s own calls, too', async (t) => {
  const { page, troubles } = await openChapter(t, 'chapter_05_inclined_planes.html');
  const slower = 'require_frame(deceleration, dt);\n    return velocity.norm() > deceleration * dt ? Vec2{velocity - deceleration * dt * velocity.normalized()} : Vec2{0, 0};';
  const friction = `Vec2 table_friction(const Vec2 &velocity, double deceleration, double dt) {\n    ${slower}\n}`;
  const verdict = await check(page, friction, '5.6');
  const step = 'now.disc.velocity = inclined_planes::table_friction(now.disc.velocity, 1, dt);\n    return now;';
  await page.goto(`${host}/chapter_13_table_hockey.html`);
  const demo = await demoOn(page, '13_table_hockey', '[data-exercise="13.1"]'), lamp = demo.figure.locator('.lamps li', { hasText: '5.6 table_friction' });
  await check(page, `World step(World now, const Inputs &inputs, double dt) {\n    ${step}\n}`, '13.1');
  await demo.canvas.scrollIntoViewIfNeeded();
  await lamp.and(page.locator('.lit[data-whose=yours]')).waitFor();
  assert.match(verdict, /✓ 5\.6/);
  assert.deepEqual(troubles, []);
});
