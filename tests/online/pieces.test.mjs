// A section's file in pieces: with the stubs of all sections, and with what readers do to them.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { findPiece, follow, startedAgain } from '../../tools/online/pieces.mjs';

const tests = fileURLToPath(new URL('..', import.meta.url));
const stubs = fs.readdirSync(tests).filter((name) => /^\d\d_/.test(name)).map((name) => [name, fs.readFileSync(path.join(tests, name, 'stub.cpp'), 'utf8')]);
const numbers = (text) => [...text.matchAll(/^\/\/ (\d+\.\d+) /gm)].map(([, number]) => number);
const eight = stubs.find(([name]) => name.startsWith('08'))[1];
const whole = ({ before, body, after }) => before + body + after;
const write = (text, number, code, stub = eight) => whole({ ...findPiece(text, number, stub), body: code });

test('every exercise of every stub is one function, and the rest of the file is around it', () => {
  assert.equal(stubs.length, 13);
  for (const [name, stub] of stubs) {
    for (const number of numbers(stub)) {
      const piece = findPiece(stub, number, stub);
      assert.equal(whole(piece), stub, `${name}, ${number}`);
      assert.match(piece.before, new RegExp(`// ${number} \\w+\n$`));
      assert.match(piece.body, /^\w[^]*throw course::NotYet\{[^]*\n\}$/, number);
      assert.equal(piece.body.match(/^\}/gm).length, 1, number);
    }
  }
});

test('a piece keeps what is written below its function, but not what the stub has there', () => {
  const text = write(eight, '8.1', 'int mine;\n\nint more;\n');
  assert.equal(findPiece(text, '8.1', eight).body, 'int mine;\n\nint more;\n');
  assert.equal(findPiece(text, '8.2', eight).body, findPiece(eight, '8.2', eight).body);
  const helpers = text.replace('static void require_ball(', 'static void require_ball_of_mine(');
  assert.match(findPiece(helpers, '8.1', eight).body, /^int mine;[^]*require_ball_of_mine[^]*\}\n$/);
  assert.equal(whole(findPiece(helpers, '8.1', eight)), helpers);
});

test('a piece can be emptied, and its neighbours are still found', () => {
  const text = write(eight, '8.2', '');
  assert.equal(findPiece(text, '8.2', eight).body, '');
  for (const number of ['8.1', '8.3', '8.6']) assert.equal(findPiece(text, number, eight).body, findPiece(eight, number, eight).body);
});

test('there is no piece without its line, nor with two of them, nor in another file', () => {
  assert.equal(findPiece(eight.replace('// 8.2 core', '//'), '8.2', eight), null);
  assert.equal(findPiece(write(eight, '8.1', '// 8.2 core\n'), '8.2', eight), null);
  assert.equal(findPiece('', '8.1', eight), null);
  assert.equal(findPiece(eight, '8.7', eight), null);
});

test('starting one exercise again leaves the others', () => {
  const text = write(write(eight, '8.1', 'one'), '8.2', 'two');
  assert.equal(startedAgain(text, '8.1', eight), write(eight, '8.2', 'two'));
  assert.equal(startedAgain('nothing', '8.1', eight), null);
});

test('when a stub changes, what was never changed follows, and what was stays', () => {
  const newer = eight.replace('which way does the line', 'where does the line').replace('how many metres do', 'by how much do')
    .replace('radius [m] must be positive', 'radius [m] must be above 0').replace('#include <map>', '#include <set>');
  const mine = write(eight, '8.1', '// my own\nint answer;');
  const after = follow(mine, eight, newer);
  assert.equal(after, write(newer, '8.1', '// my own\nint answer;', newer));
  assert.equal(follow(eight, eight, newer), newer);
  assert.equal(follow(mine, eight, eight), mine);
});

test('what the reader wrote around the functions stays, too', () => {
  const newer = eight.replace('#include <map>', '#include <set>').replace('how many metres do', 'by how much do');
  const mine = eight.replace('#include <map>', '#include <map>\n#include <array>').replace('static void require_ball(', 'static int tau;\nstatic void require_ball(');
  const after = follow(mine, eight, newer);
  assert.match(after, /#include <map>\n#include <array>/);
  assert.match(after, /static int tau;\nstatic void require_ball\(/);
  assert.match(after, /by how much do/);
  assert.equal(after.match(/static void require_ball\(/g).length, 1);
});

test('an exercise that is new appears; one that is gone goes, unless the reader wrote it', () => {
  const without = eight.replace(/\/\/ 8\.5[^]*?\n\}\n\n/, '');
  assert.equal(follow(without, without, eight), eight);
  assert.equal(follow(eight, eight, without), without);
  const mine = write(eight, '8.5', 'int kept;');
  assert.match(follow(mine, eight, without), /\/\/ 8\.6[^]*\/\/ 8\.5 stretch\nint kept;\n\n\} \/\/ namespace nt_collisions\n$/);
});

test('a file without its lines is left to the reader', () => {
  assert.equal(follow('int all = mine;\n', eight, `${eight}\n`), null);
  assert.equal(follow(eight.replace('// 8.3 core', ''), eight, `${eight}\n`), null);
});
