// bugs.mjs ROOT TESTS ANSWERS JUDGED CATALOGUE: whether each bug of a section in tests/bugs.txt is one of its wrong answers,
// breaks the law that is said, keeps the three others, and begins its demo at a place that there is. TESTS and ANSWERS are
// the section's tests for authors and its answers, JUDGED the list of these, CATALOGUE that of exercises and tests.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { test } from 'node:test';

const [root, tests, answers, judged, catalogue] = process.argv.slice(2);
const section = path.basename(tests), number = parseInt(section, 10), read = (...file) => fs.readFileSync(path.join(...file), 'utf8');
const differences = read(root, 'tests', section, 'mutants.diff');
const { tests: known } = JSON.parse(read(catalogue));
const bugs = [];
for (const words of read(root, 'tests/bugs.txt').split('\n').map((line) => line.trim())) {
  const [first, rest] = [words.split(' ')[0], words.slice(words.indexOf(' ') + 1)];
  if (/^\d/.test(first)) bugs.push({ exercise: first, name: rest, keeps: [], or: [] });
  else if (['keeps', 'or'].includes(first)) bugs.at(-1)[first].push(rest);
  else if (first !== '#' && words) bugs.at(-1)[first] = rest;
}
const here = bugs.filter(({ exercise }) => parseInt(exercise, 10) === number);

// Of these answers alone, which tests stop them.
const list = path.join(fs.mkdtempSync(path.join(os.tmpdir(), 'bugs ')), 'list');
fs.writeFileSync(list, read(judged).split('\n').filter((line) => here.some(({ name }) => line.startsWith(`mutant_${name} `))).join('\n') + '\n');
const stopped = new Map(execFileSync(tests, [answers, '--kills', list], { encoding: 'utf8' }).trim().split('\n').map((line) => {
  const [exercise, name, ...places] = line.split(' ');
  return [`${exercise} ${name}`, places.map((place) => known[place - 1].claim)];
}));
fs.rmSync(path.dirname(list), { recursive: true });

test(`section ${number} has three bugs, and one of them is on the site`, { skip: here.length === 0 && 'none yet' }, () => {
  assert.equal(here.length, 3);
  assert.deepEqual(here.map((bug) => bug.or.length).sort(), [0, 0, 3]);
});
for (const { exercise, name, breaks, keeps, at, or } of here)
  test(`${exercise} ${name}`, () => {
    const red = stopped.get(`${exercise} mutant_${name}`);
    assert.ok(red, 'is a wrong answer of this exercise');
    for (const law of [breaks, ...keeps]) assert.ok(known.some((one) => one.exercise === exercise && one.claim === law), `no test is called: ${law}`);
    assert.equal(new Set(keeps).size, 3);
    assert.ok(red.includes(breaks), `is green: ${breaks}`);
    for (const law of keeps) assert.ok(!red.includes(law), `is red: ${law}`);
    const [, changes] = new RegExp(`^${exercise} ${name}\\b.*: you .*\\n((?:(?!\\d+\\.\\d+ |#).*\\n)*)`, 'm').exec(differences) ?? [];
    assert.ok(changes, 'is a small difference, which says what the reader did');
    for (const change of changes.trim().split(/\n\n+/)) assert.match(change, /^-/m, 'leaves what is right below the mistake');
    for (const each of or) assert.match(differences, new RegExp(`^${exercise} ${each}\\b.*: you `, 'm'), `${each} says what the reader did`);
    assert.ok(!at || read(root, 'chapters', section, 'README.md').includes(`, ${at} | `), `no demo begins at: ${at}`);
  });
