// What is kept, what is done, and how a verdict is taken apart: without a browser.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { howItWent } from '../../tools/online/checker.mjs';
import { asZip, read } from '../../tools/online/files.mjs';
import { onlinePage } from '../../tools/online/pages.mjs';
import { attempted, begun, checked, renewed, replaced, restarted, typed } from '../../tools/online/store.mjs';
import { laidOver } from '../../tools/online/ticks.mjs';
import { inColours, withPlaces } from '../../tools/online/verdict.mjs';

const copies = (record) => record.copies.map(({ text }) => text);
const fresh = begun('08_nt_collisions', 'stub');

test('what another tab wrote in the meantime is kept as a copy, and nothing else is', () => {
  const mine = typed(fresh, 'mine', 'stub');
  assert.deepEqual([mine.text, copies(mine)], ['mine', []]);
  assert.deepEqual(copies(typed(mine, 'more', 'mine')), []);
  const both = typed(mine, 'theirs', 'stub');
  assert.deepEqual([both.text, copies(both)], ['theirs', ['mine']]);
  assert.deepEqual(copies(typed(mine, 'mine', 'stub')), [], 'the same text');
});

test('a text that is replaced is kept, once, unless it is the stub', () => {
  const again = restarted(typed(fresh, 'mine', 'stub'), 'newer');
  assert.deepEqual([again.text, again.stub, copies(again)], ['newer', 'newer', ['mine']]);
  const back = replaced(again, 'mine', 'again');
  assert.deepEqual(copies(back), ['mine'], 'the stub is no loss');
  assert.deepEqual(copies(replaced(back, 'other', 'again')), ['mine']);
});

test('a new stub is followed, and the text from before is kept', () => {
  const [stub, newer] = ['a', 'b'].map((name) => `// 8.1 core\nint ${name};\n}\n\n// 8.2 core\nint two;\n}\n`);
  const mine = typed(begun('x', stub), stub.replace('two', 'mine'), stub), after = renewed(mine, newer);
  assert.equal(after.text, newer.replace('two', 'mine'));
  assert.deepEqual(copies(after), [mine.text]);
  assert.deepEqual(renewed(begun('x', stub), newer), { ...begun('x', newer) });
  assert.equal(renewed(after, newer), after);
});

test('a tick goes when the exercise is red, not when nothing could be tried', () => {
  const green = checked(fresh, { 8.1: 'passed', 8.2: 'not started' });
  assert.ok(Date.now() - green.checked < 10_000);
  for (const state of ['does not compile', 'does not link']) assert.equal(checked(green, { 8.1: state }).states[8.1], 'passed');
  for (const state of ['wrong', 'is empty', 'crashed', 'not started']) assert.equal(checked(green, { 8.1: state }).states[8.1], state);
  assert.equal(checked(green, { 8.2: 'does not compile' }).states[8.2], 'does not compile');
});

test('each check of something new is an attempt, until the exercise is done', () => {
  const attempt = (record, text, state, mistake = '') => checked(attempted(record, { number: '8.1', state, mistake, text }), { 8.1: state });
  const states = ({ attempts }) => attempts.map(({ state, mistake }) => state + mistake);
  let record = attempt(fresh, 'a', 'wrong', ': you add.');
  assert.match(record.attempts[0].when, /^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$/);
  record = attempt(record, 'a', 'wrong', ': you add.');
  assert.deepEqual(states(record), ['wrong: you add.'], 'the same text');
  record = attempt(attempt(attempt(record, 'b', 'not started'), 'c', 'does not compile'), 'd', 'passed');
  assert.deepEqual(states(record), ['wrong: you add.', 'does not compile', 'passed']);
  assert.deepEqual(states(attempt(record, 'e', 'wrong')), states(record), 'it was done');
  const { attempts, ...older } = fresh; // as an earlier version has left it
  assert.equal(attempt(older, 'a', 'wrong').attempts.length, 1);
});

test('how it went has no code, and counts hints by their exercise', () => {
  const records = [{ text: 'code', attempts: [{ number: '8.1' }], hints: { '8.1 Hint 1: a': true, '8.1 Hint 2: b': false, '8.2 Hint 1': true } }, { text: 'code' }];
  assert.deepEqual(howItWent(records), { attempts: [{ number: '8.1' }], hints: { 8.1: 2, 8.2: 1 } });
});

const file = {
  sections: [
    { number: '1', page: 'chapter_01_motion.html', exercises: [{ number: '1.1', function: 'one', done: true }, { number: '1.2', function: 'two', done: false }] },
    { number: '8', page: 'chapter_08_nt_collisions.html', exercises: [{ number: '8.1', function: 'decompose', done: true }, { number: '8.2', function: 'exchange', done: false }] }],
};
const done = ({ sections }) => sections.flatMap(({ exercises }) => exercises.filter((one) => one.done).map(({ number }) => number));

test('what the store knows is laid over what the file says', () => {
  const record = { name: '08_nt_collisions', states: { 8.1: 'wrong', 8.2: 'passed' }, checked: 5 };
  const laid = laidOver(file, [record]);
  assert.deepEqual(done(laid), ['1.1', '8.2']);
  assert.deepEqual(laid.next, { number: '8.1', function: 'decompose', address: 'chapter_08_nt_collisions.html#exercise-8.1' });
  assert.deepEqual(done(laidOver(laid, [{ ...record, states: {} }])), ['1.1', '8.1'], 'and over nothing else');
  assert.deepEqual(laidOver(undefined, [record]).sections, []);
  assert.equal(laidOver(file, []).next, undefined);
});

test('you go on where you checked last, and with what an exercise needs', () => {
  const all = { 8.1: 'passed', 8.2: 'passed' };
  assert.equal(laidOver(file, [{ name: '08_nt_collisions', states: all, checked: 5 }]).next.number, '1.2');
  assert.equal(laidOver(file, [{ name: '01_motion', states: {}, checked: 9 }, { name: '08_nt_collisions', states: {}, checked: 5 }]).next.number, '1.2');
  assert.equal(laidOver(file, [{ name: '08_nt_collisions', states: { 8.1: 'needs 8.2 exchange' }, checked: 5 }]).next.number, '8.2');
});

test('colours of the terminal, and places', () => {
  assert.deepEqual(inColours('a\x1b[31m✗ b\x1b[0mc\x1b[2md\x1b[0m'), [['a', ''], ['✗ b', 'red'], ['c', ''], ['d', 'dim']]);
  assert.deepEqual(withPlaces('see tests/08_x/tests.cpp:41, exercises/08_x.cpp:7:3: no', '08_x'), [
    { words: 'see ' }, { words: 'tests/08_x/tests.cpp:41', page: 'source_tests_08_x_tests_cpp.html#L41' }, { words: ', ' },
    { words: 'exercises/08_x.cpp:7:3', line: 7 }, { words: ': no' }]);
  assert.deepEqual(withPlaces('08_x.cpp:8', '08_x'), [{ words: '08_x.cpp:8', line: 8 }]);
  assert.deepEqual(withPlaces('exercises/07_y.cpp:8', '08_x'), [{ words: 'exercises/07_y.cpp:8' }]);
});

test('answers survive a zip', async () => {
  const zip = new File([asZip([{ name: '08_x', text: 'ä\n' }, { name: '01_y', text: '' }])], 'mine.zip');
  assert.deepEqual((await read([zip], { '08_x': {}, '01_y': {} })).answers, [['08_x', 'ä\n'], ['01_y', '']]);
  const { answers, refused } = await read([zip], { '09_z': {} });
  assert.deepEqual(answers, []);
  assert.match(refused[0], /^mine\.zip has no answer in it/);
  const large = await read([new File(['x'.repeat(2 << 20)], '08_x.cpp')], { '08_x': {} });
  assert.match(large.refused[0], /larger than 1 MB/);
});

test('a page gets its script and its policy; one that is no page is refused', () => {
  const page = (body) => `<head>\n<meta charset="utf-8">\n</head>${body}`;
  const chapter = onlinePage(page('<article class="turn" id="exercise-8.1" data-exercise="8.1">'), 'online/1a2b'), other = onlinePage(page(''), 'online/1a2b');
  assert.match(chapter, /<meta charset="utf-8">\n<meta http-equiv="Content-Security-Policy" content="default-src 'self'; [^"]*">[^]*"online\/1a2b\/editor\.css"[^]*"online\/1a2b\/editor\.js" defer[^]*<\/head>/);
  assert.match(other, /"online\/1a2b\/ticks\.js" defer/);
  assert.doesNotMatch(other, /editor/);
  assert.throws(() => onlinePage('<p>', 'online/1a2b'), /a page has no <meta charset/);
});
