// What a check in a page costs, in Chromium, beside its goals: `./course dev bench page`, on a machine that does nothing else.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { browser, build, root } from '../site/browser.mjs';
import { folder, manifestIn, scriptsIn } from './built.mjs';
import { serve } from './server.mjs';

const section = '08_nt_collisions', exercise = '8.1', firsts = 5, furthers = 3;
const file = (kind, name) => path.join(root, kind === 'stub' ? `tests/${name}/stub.cpp` : `solutions/${name}.cpp`);
const asked = [], host = await serve(folder, asked), base = `${host}/${scriptsIn(folder)}/`;

const median = (all) => [...all].sort((a, b) => a - b)[Math.floor(all.length / 2)];
const seconds = (ms) => `${(ms / 1000).toFixed(2)} s`, megabytes = (bytes) => `${(bytes / 1e6).toFixed(1)} MB`;
const bytesOf = (names) => names.reduce((sum, name) => sum + fs.statSync(path.join(folder, name)).size, 0);

// A sketch of the gallery, compiled and linked [ms].
async function timeOfSketch(page, text) {
  const { took, module } = await page.evaluate(async (text) => {
    const start = performance.now(), { module } = await self.checker.sketch({ text });
    return { took: performance.now() - start, module: Boolean(module) };
  }, text);
  assert.ok(module, `a sketch can't be compiled:\n${text}`);
  return took;
}

// Without a service worker, which would keep the whole site meanwhile.
async function openPage(t) {
  const context = await (await browser()).newContext({ serviceWorkers: 'block' });
  t.after(() => context.close());
  const page = await context.newPage();
  await page.goto(`${host}/chapter_${section}.html#exercise-${exercise}`);
  await page.locator('.cm-content').first().waitFor();
  await page.evaluate(async (base) => {
    const { Checker } = await import(`${base}checker.js`);
    self.checker = new Checker(base);
  }, base);
  return { page, context };
}
// [ms]; the first starts the compiler, too.
async function timeOf(page, task) {
  const { took, states } = await page.evaluate(async (task) => {
    const start = performance.now(), { states } = await self.checker.check(task);
    return { took: performance.now() - start, states };
  }, task);
  assert.ok(Object.keys(states).length > 0, `${task.section} has no verdict`);
  return took;
}
function timeInTerminal() {
  const start = performance.now(), { status, stderr } = spawnSync(path.join(root, 'course'), ['check', exercise, '--file', file('solution', section)], { encoding: 'utf8' });
  assert.equal(status, 0, stderr);
  return performance.now() - start;
}
// What the process of the tab has in memory, and its part of what it shares [bytes]: of several, the largest.
async function memory() {
  const { processInfo } = await (await (await browser()).newBrowserCDPSession()).send('SystemInfo.getProcessInfo');
  const sizeOf = ({ id }) => 1024 * Number(fs.readFileSync(`/proc/${id}/smaps_rollup`, 'utf8').match(/^Pss: +(\d+)/m)[1]);
  return Math.max(...processInfo.filter(({ type }) => type === 'renderer').map(sizeOf));
}

test('what a check in the page costs', async (t) => {
  const rows = [], load = os.loadavg()[0];
  const row = (what, measured, goal = '') => rows.push(`| ${what} | ${measured} | ${goal} |`);

  const text = fs.readFileSync(file('solution', section), 'utf8');
  timeInTerminal(); // builds what is missing
  const here = [], there = [];
  for (let i = 0; i < firsts; ++i) { // in turns, so that a busy moment meets both
    asked.length = 0;
    const { page, context } = await openPage(t), ofPage = bytesOf(asked);
    here.push(await timeOf(page, { section, exercise, text }));
    there.push(timeInTerminal());
    if (i === 0) {
      row('bytes before the first verdict', megabytes(bytesOf(asked)), '≤ 36 MB, aim at 25');
      row('… of which the page, its scripts and the editor', megabytes(ofPage));
    }
    await context.close();
  }
  row(`first check of ${exercise}, median of ${firsts}`, seconds(median(here)), '≤ 3 s');
  row('… and ./course check in the same run', seconds(median(there)));
  row('… their ratio', (median(here) / median(there)).toFixed(2));

  const { page } = await openPage(t);
  await timeOf(page, { section, exercise, text });
  const before = await memory(), times = [];
  for (const name of Object.keys(manifestIn(folder).sections))
    for (const kind of ['stub', 'solution']) {
      const task = { section: name, exercise: '', text: fs.readFileSync(file(kind, name), 'utf8') }, runs = [];
      await timeOf(page, task); // loads what the section needs
      for (let i = 0; i < furthers; ++i) runs.push(await timeOf(page, task));
      times.push({ name, kind, took: median(runs) });
    }
  const of = (kind) => times.filter((one) => one.kind === kind).map(({ took }) => took), slowest = times.reduce((a, b) => (a.took > b.took ? a : b));
  row(`further checks of whole sections, median of ${times.length}`, seconds(median(times.map(({ took }) => took))), '≤ 1 s');
  row('… of stubs, of solutions', `${seconds(median(of('stub')))}, ${seconds(median(of('solution')))}`);
  row(`… the slowest, the ${slowest.kind} of ${slowest.name}`, seconds(slowest.took), '≤ 1.5 s');
  row('memory of the tab after its first check', megabytes(before));
  row('… and after all of these', megabytes(await memory()), '≤ 500 MB');

  const gallery = path.join(root, 'docs/gallery'), sketches = fs.readdirSync(gallery).map((name) => fs.readFileSync(path.join(gallery, name), 'utf8'));
  const fresh = (await openPage(t)).page;
  row('first sketch of a page', seconds(await timeOfSketch(fresh, sketches[0])));
  const again = [];
  for (let i = 0; i < furthers; ++i) for (const text of sketches) again.push(await timeOfSketch(fresh, text));
  row(`further sketches, median of ${again.length}`, seconds(median(again)), '≤ 1 s');
  row('… the slowest', seconds(Math.max(...again)));

  console.log(`${os.cpus().length} cores, load ${load.toFixed(1)} at the start and ${os.loadavg()[0].toFixed(1)} at the end\n\n| | measured | goal |\n|:--|:--|:--|\n${rows.join('\n')}\n`);
});
