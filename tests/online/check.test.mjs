// The online edition as it is built (`./course site --online`), in Chromium: stubs, solutions and slips come to the same as in
// the terminal, and what hangs or crashes leaves the page usable.
//     SECTIONS="08_nt_collisions"   only these; SLIPS=10 and MUTANTS=10 of each section; SEED=7 draws others
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { browser, build, root } from '../site/browser.mjs';
import { dice, slip } from '../../tools/online/slips.mjs';
import { folder, manifestIn, scriptsIn } from './built.mjs';
import { serve } from './server.mjs';

const sections = process.env.SECTIONS?.split(' ') ?? Object.keys(manifestIn(folder).sections), slips = Number(process.env.SLIPS ?? 2), mutants = Number(process.env.MUTANTS ?? 2);
const seed = Number(process.env.SEED ?? 20785);
const read = (of, section) => fs.readFileSync(path.join(root, of, `${section}.cpp`), 'utf8');
const stub = (section) => fs.readFileSync(path.join(root, 'tests', section, 'stub.cpp'), 'utf8');

const host = await serve(folder, [], '/some/path'), troubles = [];
let page;
before(async () => {
  page = await (await browser()).newPage();
  page.on('request', (request) => request.url().startsWith(host) || /^(data|blob):/.test(request.url()) || troubles.push(`asks for ${request.url()}`));
  await page.goto(`${host}/chapter_08_nt_collisions.html`);
  await page.evaluate(async (base) => {
    const { Checker } = await import(`${base}checker.js`);
    self.checker = new Checker(base);
  }, `${host}/${scriptsIn(folder)}/`);
});
after(() => page?.close());
const check = (section, text, exercise = '') => page.evaluate((task) => self.checker.check(task), { section, exercise, text });

const plainly = (printed) => printed.replace(/\x1b\[[\d;]*m/g, '');
// How each exercise stands by what was printed: { '8.1': '✓' }, or why there is none of it.
function standing(printed) {
  const plain = plainly(printed), marks = [...plain.matchAll(/^(✓|✗|·) (\d+\.\d+) /gm)].map(([, mark, number]) => [number, mark]);
  return marks.length > 0 ? Object.fromEntries(marks) : plain.match(/^✗ .*/m)?.[0] ?? plain;
}
const own = fs.mkdtempSync(path.join(os.tmpdir(), 'online-'));
after(() => fs.rmSync(own, { recursive: true }));
function inTerminal(section, text, exercise = section.slice(0, 2)) {
  const file = path.join(own, `${section}.cpp`);
  fs.writeFileSync(file, text);
  const { stdout } = spawnSync(path.join(build, 'course-tool'), ['check', exercise, '--file', file], { encoding: 'utf8', env: { ...process.env, NO_COLOR: '1', COURSE_ROOT: root, COURSE_BUILD: build } });
  return stdout.replaceAll(file, `exercises/${section}.cpp`);
}

// All that was printed, but for a command to type, another compiler's warnings, and which of its lines a check is said to be on.
const said = (printed) => plainly(printed).replace(/^(warning .*(\n {2}.*)*|Next: .*)\n/gm, '').replace(' (-v shows all)', '').replace(/(tests\.cpp):\d+/g, '$1').trim();
// So many wrong answers of a section, drawn: { exercise, name, text }.
function drawMutants(section, roll, count) {
  const { stdout } = spawnSync(path.join(build, 'answers-in-one'), [root, section], { encoding: 'utf8', maxBuffer: 2 ** 28 }), all = stdout.split(/^>>> /m).slice(1);
  return Array.from({ length: count }, () => {
    const [, exercise, name, text] = /^(\S+) (\S+)\n([^]*)/.exec(all.splice(roll(all.length), 1)[0]);
    return { exercise, name, text };
  });
}
// Those of which it's known that the page says something else, each with the reason.
const differs = new Map(fs.readFileSync(path.join(import.meta.dirname, 'differs.tsv'), 'utf8').trim().split('\n').map((line) => line.split('\t')));

describe(`answers in the page (seed ${seed})`, () => {
  for (const section of sections)
    test(section, async (t) => {
      const begun = await check(section, stub(section));
      assert.deepEqual([...new Set(Object.values(begun.states))].filter((state) => !/^(not started|needs )/.test(state)), [], 'a stub');
      const done = await check(section, read('solutions', section));
      assert.deepEqual([...new Set(Object.values(done.states))], ['passed'], done.text);
      assert.equal(done.picture, null);
      const roll = dice(seed + Number(section.slice(0, 2)));
      for (let i = 0; i < slips; ++i) {
        const text = slip(read('solutions', section), roll), here = standing((await check(section, text)).text), there = standing(inTerminal(section, text));
        t.diagnostic(`${JSON.stringify(here)}`);
        assert.deepEqual(here, there, text);
      }
      for (const { exercise, name, text } of drawMutants(section, roll, mutants)) {
        const here = (await check(section, text, exercise)).text, there = inTerminal(section, text, exercise);
        t.diagnostic(`${exercise} ${name}`);
        if (!differs.get(name)?.startsWith('passes in the page')) assert.deepEqual(standing(here), standing(there), `${name}\n${text}`);
        if (!differs.has(name)) assert.equal(said(here), said(there), `${name}\n${text}`);
      }
      assert.deepEqual(troubles, []);
    });
});

describe('what goes wrong in section 8', () => {
  const body = 'throw course::NotYet{"which way does the line from a to b point, as a vector of length 1?"};';
  const section = '08_nt_collisions', with_ = (code) => stub(section).replace(body, code);
  const says = async (code, expected) => assert.match((await check(section, with_(code), '8.1')).text, expected);
  test('a loop without an end is stopped', () => says('for (;;) {}', /too long[\s\S]*a loop that never stops/));
  test('a loop in the library is stopped, too', () => says('std::vector<int> v(2); return {double(std::count_if(v.begin(), v.begin() + 1, [](int) { for (;;) {} return true; })), 0};', /too long/));
  test('so is a recursion', () => says('return decompose(velocity, a, b);', /until the stack was full/));
  test('and one that branches', () => says('struct Rabbits { static double born(int n) { return n < 2 ? 1 : born(n - 1) + born(n - 2); } }; return {Rabbits::born(60), 0};', /too long/));
  test('memory is told', () => says('std::vector<double> all; for (;;) all.push_back(1);', /out of memory/));
  test('an index beyond the end', () => says('std::vector<double> none; return {none[7], 0};', /crashed[\s\S]*an index beyond the end/));
  test('what is thrown', () => says('throw std::out_of_range{"no such ball"};', /threw[\s\S]*std::out_of_range: no such ball/));
  test('what is thrown past an object that must be destroyed', () => says('const std::vector<Vec2> all{a, b}; course::require(all.size() > 2, "more", 1); return {};', /refused this input with std::invalid_argument \(more, but is 1\)/));
  test('and caught', () => says('try { throw 7; } catch (int seven) { return {double(seven), 0}; }', /normal 7 m\/s/));
  test('exit()', () => says('std::exit(3);', /ended the program[\s\S]*exit code 3/));
  test('a flood of words', () => says('for (;;) std::puts("over and over again, and once more, and again, until nobody can bear to read it any longer");', /printed too much/));
  test('a function that is not there', async () => assert.match((await check(section, stub(section).replace('Components decompose(', 'Components decomposed('), '8.1')).text, /no function `decompose`/));
  test('a helper that is declared only', () => says('double helper(double); return {helper(1), 0};', /`.*helper\(double\)` is declared in .* and used, but never defined/));
  test('an own main', async () => assert.match((await check(section, `${stub(section)}int main() {}\n`, '8.1')).text, /`main` of its own/));
  test('a name that is taken', async () => assert.match((await check(section, `${stub(section)}extern "C" char *course_room(unsigned long) { return nullptr; }\n`, '8.1')).text, /`course_room` is defined twice/));
  test('and after all of that, a right answer is right', async () => assert.deepEqual((await check(section, read('solutions', section), '8.1')).states, { 8.1: 'passed' }));
});
