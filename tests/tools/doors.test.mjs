// What only a forge, a container or an editor reads: it agrees with what the course prints and installs.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import test from 'node:test';

const root = new URL('../../', import.meta.url);
const read = (path) => fs.readFileSync(new URL(path, root), 'utf8');
const tasks = JSON.parse(read('.vscode/tasks.json')).tasks;

test('finds the place of a compile error, and of a red test, in what check prints', () => {
  const error = read('tests/verdicts/syntax_error.txt').split('\n'), red = read('README.md').split('\n');
  assert.equal(tasks.length, 2);
  for (const { problemMatcher } of tasks) {
    const [compiler, tests] = problemMatcher.map(({ pattern }) => (lines) => lines
      .map((line) => new RegExp(pattern.regexp, 'u').exec(line)).filter(Boolean)
      .map((match) => [match[pattern.file], match[pattern.line], match[pattern.message]]));
    assert.deepEqual(compiler(error).map(([file, line]) => [file, line]), [['tests/verdicts/syntax_error.cpp', '7']]);
    assert.match(compiler(error)[0][2], /^'det' was not declared/);
    assert.deepEqual(tests(red).map(([file]) => file), ['tests/07_segment_intersection/tests.cpp']);
    assert.deepEqual(tests(error), []);
  }
});

test('a round of --watch begins with its first line, and ends with its last', () => {
  const begins = new RegExp(tasks[1].problemMatcher[0].background.beginsPattern, 'u');
  const ends = new RegExp(tasks[1].problemMatcher[0].background.endsPattern, 'u');
  assert.match('✗ 7.1 intersect_lines, core: 6 of 19 tests passed', begins);
  assert.match(read('tests/verdicts/syntax_error.txt').split('\n')[0], begins);
  assert.doesNotMatch('· 7.2 segments_intersect, core: not started', begins);
  const said = /"(Waiting for you to save[^"]*)"/.exec(read('tools/commands/check.cpp'))[1];
  assert.match(said, ends);
});

test('a container gets its packages from ./course setup, and all that this reads', () => {
  const lines = read('Dockerfile').split('\n');
  assert.deepEqual(lines.filter((line) => /apt-get/.test(line)),
    ['RUN apt-get update && apt-get install --yes --no-install-recommends ca-certificates git']);
  const before = lines.slice(0, lines.indexOf('RUN ./course setup --yes'));
  const copied = before.flatMap((line) => /^COPY (.*) \S+$/.exec(line)?.[1].split(' ') ?? []);
  for (const path of copied) assert.ok(fs.existsSync(new URL(path, root)), path);
  const scripts = fs.readdirSync(new URL('tools/setup/', root)).filter((name) => name.endsWith('.sh'));
  const needed = scripts.flatMap((name) => [...read(`tools/setup/${name}`).matchAll(/\$root\/(tools\/setup\/\w+)/g)].map(([, path]) => path));
  assert.ok(needed.length > 0);
  for (const path of needed) assert.ok(copied.some((one) => path.startsWith(one)), path);
});

test('a devcontainer is built from the same file', () => {
  const { build } = JSON.parse(read('.devcontainer/devcontainer.json'));
  assert.match(read('Dockerfile'), new RegExp(`^FROM \\S+ AS ${build.target}$`, 'm'));
});
