// A page says of a check what the terminal prints: the same files go both ways, with the same words of compiler and tests.
//     COURSE_BUILD=build/default node --test tests/online/words.test.mjs
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { definedFunctions } from '../../tools/play/wasm.mjs';
import { loadWords } from '../../tools/online/words.mjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const build = path.resolve(process.env.COURSE_BUILD ?? path.join(root, 'build/default'));
const config = JSON.parse(fs.readFileSync(path.join(build, 'course.json'), 'utf8'));
const words = loadWords(new WebAssembly.Module(fs.readFileSync(path.join(build, 'online/words.wasm'))));
const section = '07_segment_intersection', slug = section.slice(3);
const own = fs.mkdtempSync(path.join(os.tmpdir(), 'words-'));
test.after(() => fs.rmSync(own, { recursive: true }));

const read = (...names) => fs.readFileSync(path.join(root, ...names), 'utf8');
const ours = read('solutions', `${section}.cpp`), stub = read('tests', section, 'stub.cpp');
const file = path.join(own, 'answer.cpp'), object = path.join(own, 'answer.o'), subject = path.join(own, 'subject');
const plain = { encoding: 'utf8', env: { ...process.env, LC_ALL: 'C.UTF-8', NO_COLOR: '1' }, maxBuffer: 1 << 26 };

const about = {
  section,
  sections: config.sections.map(({ name }) => name),
  exercises: JSON.parse(fs.readFileSync(path.join(build, 'catalogue', `${section}.json`), 'utf8')).exercises,
  header: read('chapters', section, `${slug}.hpp`),
  stub,
  renamed: fs.existsSync(path.join(root, 'chapters', section, 'renamed.txt')) ? read('chapters', section, 'renamed.txt') : '',
  mistakes: read('tests', section, 'mistakes.tsv'),
  name: file,
  file,
};

// What GCC, the linker and the tests say of an answer, as a page's do.
function said(text, only) {
  fs.writeFileSync(file, text);
  const { server, missing, earlier } = config.sections.find(({ name }) => name === section);
  const compiled = spawnSync(config.compiler, [...config.flags, ...config.precompiled, `-I${path.join(root, 'chapters', section)}`, '-fdiagnostics-color=never',
    '-c', file, '-o', object], plain);
  if (compiled.status !== 0) return { step: 'not compiled', compiler: compiled.stderr };
  const linked = spawnSync(config.compiler, [object, server, missing, '-o', subject, ...earlier, ...config.link], plain);
  if (linked.status !== 0) return { step: 'not linked', compiler: compiled.stderr + linked.stderr };
  const tests = execFileSync(path.join(build, 'tests', section), [subject, '--json', ...(only ? ['--exercise', only] : [])], plain);
  const defined = execFileSync(config.nm, ['--defined-only', object], plain).matchAll(/ T (.*)/g);
  return {
    step: 'compiled',
    compiler: compiled.stderr,
    verdicts: tests.trim().split('\n').map((line) => JSON.parse(line)),
    symbols: [...defined].map(([, name]) => name),
  };
}

const inPage = (text, only = '') => words({ ...about, text, only, ...said(text, only) });
const inTerminal = (text, what = String(Number(section.slice(0, 2)))) => {
  fs.writeFileSync(file, text);
  return spawnSync(path.join(build, 'course-tool'), ['check', what, '--file', file], plain).stdout;
};
// Without what names a command.
const withoutCommands = (text) => text.replace(/ \(-v shows all\)/g, '').replace(/^(Next: |All of section|The whole section: ).*\n/gm, '')
  .replace(/: \.\/course check \d+ judges it/, '').replace(/ `\.\/course .*/, '');
const withoutColours = (text) => text.replace(/\x1b\[\d+m/g, '');

function sameAsInTerminal(text, only) {
  const page = inPage(text, only), terminal = inTerminal(text, only);
  assert.ok(terminal.length > 0);
  assert.equal(withoutColours(page.text), withoutCommands(terminal));
  assert.ok(!page.text.includes('./course'), page.text);
  return page;
}
const changed = (text, old, by) => {
  assert.equal(text.split(old).length, 2, `${old} is there once`);
  return text.replace(old, () => by);
};

const swapped = changed(ours, 'LineIntersection{t, s,', 'LineIntersection{s, t,');

test('a right answer, and one that is not begun', () => {
  const { states, picture, place } = sameAsInTerminal(ours);
  assert.deepEqual(new Set(Object.values(states)), new Set(['passed']));
  assert.equal(picture, null);
  assert.equal(place, null);
  assert.equal(sameAsInTerminal(stub).states['7.2'], 'not started');
});

test('a wrong answer, with the mistake that is known, and its colours', () => {
  const { text, states, mistake } = sameAsInTerminal(swapped);
  assert.match(text, /\x1b\[31m✗ 7\.1 intersect_lines, core\x1b\[0m/);
  assert.match(text, /\x1b\[33mThis is what comes out when you/);
  assert.ok(text.includes(`This is what comes out when ${mistake}`) && mistake.startsWith('you '), mistake);
  assert.match(text, /and \d+ more\x1b/);
  assert.equal(states['7.1'], 'wrong');
  assert.equal(states['7.2'], 'passed');
  assert.deepEqual(sameAsInTerminal(swapped, '7.1').states, { '7.1': 'wrong' });
});

test('how it went, as `./course feedback` writes it', () => {
  const attempts = [{ number: '7.1', state: 'wrong', mistake: 'you add.', when: '2026-11-29T10:00:00Z' }, { number: '7.1', state: 'passed', mistake: '', when: '2026-11-29T10:03:10Z' }];
  assert.match(words({ attempts, hints: { 7.1: 2 } }).text, /^Frame by Frame \d+\.\d+\.\d+, in a page: how it went.*\n\n.*\n7\.1 +2 +passed +2 +3\n {4}once: you add\.\n$/);
});

test('a failure that can be drawn', () => {
  const twice = changed(ours, 'if (square == 0) return {first.start};', 'if (square == 0) return {first.start, first.start};');
  assert.match(sameAsInTerminal(twice, '7.3').picture, /^<svg/);
});

test('warnings, all of them or those of one exercise', () => {
  const warned = changed(ours, 'if (square == 0) return {first.start};', 'int unused = 1 / 2;\n    if (square == 0) return {first.start};');
  assert.match(sameAsInTerminal(warned).text, /warning .*`1 \/ 2` is 0/);
  assert.doesNotMatch(sameAsInTerminal(warned, '7.1').text, /warning/);
});

test('bad input that is accepted, where lines of the stub refused it', () => {
  const accepting = changed(ours, '    course::require(dt >= 0, "dt [s] must not be negative", dt);\n', '');
  assert.match(sameAsInTerminal(accepting, '7.4').text, /the function began with lines that refuse it: put `course::require\(dt/);
});

test('a function that is missing, or is there with other parameters', () => {
  const name = 'segments_intersect';
  const misspelt = ours.replaceAll(name, 'segments_intersekt');
  assert.match(sameAsInTerminal(misspelt, '7.2').text, /Yours has `segments_intersekt`: is that it, misspelt\?/);
  const other = `${ours.replaceAll(name, 'helper_of_mine')}\nnamespace ${slug} {\nbool ${name}(const Segment &) { return true; }\n}\n`;
  assert.match(sameAsInTerminal(other, '7.2').text, /yours is `segment_intersection::segments_intersect\(/);
});

test('no test can start', () => {
  sameAsInTerminal(changed(ours, 'static double det', 'static const int boom = [] { throw 42; return 1; }();\nstatic double det'));
});

test('no text, or that of another section', () => {
  assert.equal(sameAsInTerminal('\n').states['7.6'], 'is empty');
  sameAsInTerminal('PK\x03\x04 and more');
  sameAsInTerminal('#include "motion.hpp"\n');
});

test('where the compiler stops', () => {
  const line = ours.split('\n').findIndex((each) => each.includes('LineIntersection{t, s,')) + 1;
  const text = changed(ours, 'LineIntersection{t, s,', '/* 🎱 τ */ LineIntersection{t, nothing,');
  const { states, place } = sameAsInTerminal(text, '7.1');
  assert.deepEqual(states, { '7.1': 'does not compile' });
  assert.equal(place.line, line);
  assert.deepEqual(sameAsInTerminal(text).states, {});
  // Clang counts bytes, and an editor what JavaScript has for characters.
  const code = text.split('\n')[line - 1], before = code.slice(0, code.indexOf('nothing'));
  const clang = `${file}:${line}:${Buffer.byteLength(before) + 1}: error: use of undeclared identifier 'nothing'\n${code}\n${' '.repeat(before.length)}^\n`;
  assert.deepEqual(words({ ...about, text, step: 'not compiled', compiler: clang }).place, { line, column: before.length + 1 });
});

test('what a compiler cannot tell: a bracket, a curly quote, a line that is gone', () => {
  const begins = stub.indexOf('throw course::NotYet');
  const { text, place } = sameAsInTerminal(`${stub.slice(0, begins)}if (true) {\n    ${stub.slice(begins)}`);
  assert.equal(place.line, Number(text.match(/answer\.cpp:(\d+): In 7\.1 intersect_lines, this \{ never closes/)[1]));
  sameAsInTerminal(`${stub}// \n“here”\n`);
  assert.equal(sameAsInTerminal(stub.replace(`namespace ${slug} {`, '')).place, null);
});

test('what is declared and never defined, in the words of either linker', () => {
  const undefined_ = changed(ours, 'static double det', 'double helper(double);\nstatic double det').replace('return LineIntersection{t, s,', 'return LineIntersection{helper(t), s,');
  const { text } = sameAsInTerminal(undefined_);
  const symbol = text.match(/`([^`]*helper\(double\))`/)[1];
  const llvm = words({ ...about, text: undefined_, step: 'not linked', compiler: `wasm-ld: error: /own/answer.o: undefined symbol: ${symbol}\n` });
  assert.equal(llvm.text, text);
});

test('an own main, which a page has no command for', () => {
  sameAsInTerminal(`${ours}\nint main() {}\n`);
});

test('a request that lacks something is refused', () => {
  assert.throws(() => words({ ...about, text: '' }), /can't be put into words: .*step/);
  assert.throws(() => words({ ...about, text: ours, step: 'compiled', verdicts: [{}] }), /can't be put into words/);
});

test('the functions of an object, as a linker knows them', { skip: spawnSync('clang++-19', ['--version']).status !== 0 }, () => {
  fs.writeFileSync(file, 'namespace ns { int there(int); extern int number; int here(int x) { return there(x) + number; } }\nint seen = ns::here(3);\n');
  execFileSync('clang++-19', ['--target=wasm32-wasi', '-g', '-c', file, '-o', object]);
  const names = definedFunctions(new Uint8Array(fs.readFileSync(object)));
  assert.ok(names.includes('_ZN2ns4hereEi'));
  assert.ok(!names.includes('_ZN2ns5thereEi'));
});
