// What docs/voice.cjs counts in a chapter, and what it says of it.
import assert from 'node:assert';
import { test } from 'node:test';
import voice from '../../docs/voice.cjs';

const budget = (chapter, name) => voice.budgets(chapter).find((one) => one.name === name);
const value = (chapter, name) => budget(chapter, name).value;
const exceeded = (chapter) => voice.exceededBudgets(chapter).map(({ sentence }) => sentence);
const habits = (chapter) => voice.outOfVoice(chapter).map(({ line, sentence }) => `${line} ${sentence}`);
const listing = (lines, first = 'int x;\n') => `\`\`\`cpp\n${first}${'int y;\n'.repeat(lines - 1)}\`\`\`\n\n`;
const folded = (text) => `<details><summary>More</summary>\n\n${text}</details>\n\n`;
const box = '> ### Your turn: 7.1 `meet` (10 minutes)\n>\n> Write it.\n\n';

test('the first box is looked for where its heading is, in or out of a quote', () => {
  assert.equal(value(`${'Words.\n'.repeat(10)}### Your turn: 7.1 \`meet\`\n${'Words.\n'.repeat(89)}`, 'first box'), 10);
  assert.equal(budget('Words.\n'.repeat(50) + box, 'first box').line, 51);
  assert.equal(value('Your turn: said in passing.\n', 'first box'), 100);
});

test('code counts against prose, folded code does not, and the longest listing is named with its line', () => {
  const prose = `${'A sentence.\n'.repeat(10)}\n`;
  assert.equal(value(prose + listing(4), 'listings'), 40);
  assert.equal(value(prose + folded(listing(40)), 'listings'), 0);
  const longest = budget(prose + listing(3) + listing(16) + folded(listing(30)), 'longest listing');
  assert.equal(longest.value, 16);
  assert.equal(longest.line, 18);
  assert.equal(value(`${prose}> \`\`\`cpp\n> int x;\n> int y;\n> \`\`\`\n`, 'longest listing'), 2);
});

test('unfolded tests are added up, output within each part', () => {
  const tests = listing(5, '//> A test\n') + listing(3, 'TEST_CASE("a", "[7.1]") {\n') + folded(listing(9, 'TEST_CASE("b", "[7.1]") {\n'));
  assert.equal(value(tests, 'tests'), 2);
  const output = '```console\n$ ./course run 7 walls\none\ntwo\n```\n\n';
  assert.equal(value(`## One\n\n${output}${output}## Two\n\n${output}`, 'output'), 4);
});

const ten = 'One two three four five six seven $a + b = c$ nine ten.\n';

test('words are counted up to what the reader does, and from there to the next; a formula is one word', () => {
  assert.equal(value(`${ten}${ten}*Try it: throw the ball.*\n${ten}`, 'opening'), 20);
  assert.equal(value(ten, 'opening'), 10);
  for (const task of ['<!-- demo: room -->\n', '**Pencil (1 minute).** Guess.\n', box, '**Finish 7.1.**\n', '> **Your test (10 minutes).** A law.\n'])
    assert.equal(value(ten + task + ten, 'opening'), 10, task);
  const reading = budget(`**Pencil.**\n${ten.repeat(3)}${folded(ten.repeat(9))}${box}${ten}`, 'reading');
  assert.equal(reading.value, 31); // with the word that asks for it
  assert.equal(reading.line, 1);
});

test('what stands for a demo on a forge is no reading', () => {
  const demo = '<!-- demo: room | Throw. -->\n\n';
  const shown = '![A ball in a room](../../demos/07_wall.svg)\n\n*Play it:* `./course play 7`. Throw.\n\n';
  assert.equal(value(`${demo}${shown}One two three.\n`, 'reading'), 3);
  assert.equal(value(`${demo}*Play it* again.\n`, 'reading'), 3);
});

test("minutes are those of the chapter's table, reading and doing", () => {
  const table =
    '| | you write | level | minutes |\n|:--|:--|:--|--:|\n| 7.1 | `meet`: [do they](#x) | core | 25 + 21 |\n| 7.2 | `turn`: round | stretch | 45 |\n';
  assert.equal(value(table, 'part'), 46);
  assert.equal(value(table, 'core box'), 21);
  assert.equal(value('| 7.2 | `turn`: round | challenge | 50 min |\n', 'part'), 50);
});

test('what exceeds its budget is reported with the remedy, unless the chapter says why; not for longer than needed', () => {
  const prose = `${box}${'A sentence.\n'.repeat(100)}\n`, chapter = prose + listing(16);
  assert.deepEqual(exceeded(chapter), [
    '16 lines of the longest unfolded listing, where 15 are the most: split it, or fold it, or write `<!-- budget: longest listing 16, since ... -->` with a reason.',
  ]);
  const exception = '\n<!-- budget: longest listing 16, since it is one table -->\n';
  assert.deepEqual(exceeded(chapter + exception), []);
  assert.equal(exceeded(chapter + listing(17) + exception).length, 1);
  assert.deepEqual(exceeded(prose + exception), ['this exception is no longer needed, for 0 are within the budget; take it out.']);
  assert.equal(exceeded(`${chapter}\n<!-- budget: longest listing 16 -->\n`).length, 2);
  assert.equal(exceeded(`${prose}<!-- budget: patience 3, since -->\n`).length, 1);
  assert.deepEqual(exceeded(`${prose}<!-- budget: patience 3, since ever -->\n`), ['there is no budget called "patience".']);
});

const good = "# 7 Wall\n\nIt's high, isn't it? You'll see why it can't fall.\n\n";

test('a chapter is told of its habits, each with the last line that has it', () => {
  assert.deepEqual(habits(good), []);
  assert.deepEqual(habits(`${good}The ball begins here.\nIt has not begun.\nWe begin.\n`), ['7 the voice: 3 times "begin", for "start", where 1 are the most.']);
  assert.deepEqual(habits(`${good}## Further\n`), ['5 the voice: 1 times a standing heading, where 0 are the most.']);
  assert.equal(habits(`${good}> ### What your function must do\n`).length, 1);
  assert.equal(habits(`${good}That one is wanted.\n`).length, 1);
  assert.deepEqual(habits(`${good}Which way? All the way.\nBy the way, a way.\n`), []);
  assert.equal(habits(`${good}A way, and another way.\n`).length, 1);
  assert.deepEqual(habits('A wall stands on a hill.\n'.repeat(100)), ['1 the voice: 0 contractions, where 3 are the fewest.']);
});

test('what is folded away, a listing, a formula or a comment has no voice', () => {
  const begin = 'begin, begin, begin\n', quiet = `\`\`\`text\n${begin}\`\`\`\n\n<details><summary>Answer</summary>\n\n${begin}</details>\n\n`;
  assert.deepEqual(habits(`${good}${quiet}<!-- words: begin, begin -->\n\n$\\begin{pmatrix}\\begin{a}\\begin{b}$\n`), []);
  assert.equal(habits(`${good}<details><summary>Answer</summary>\n\nNo.\n</details>\n\n${begin}`).length, 1);
});

test('all hints of an exercise are one fold', () => {
  const folds = (count, summary) => `<details><summary>${summary}</summary>\n\nx\n</details>\n\n`.repeat(count);
  assert.deepEqual(habits(good + folds(30, '7.1, a hint: why')), []);
  assert.deepEqual(habits(good + folds(25, 'Answer')), []);
  assert.deepEqual(habits(good + folds(26, 'Answer')), ['1 the voice: 26 folds, where 25 are the most.']);
  assert.deepEqual(habits(good + `*Play it:* drag it.\n\n${folds(1, 'Answer')}`.repeat(30)), []);
});
