// 03_bursts.mjs NATIVE: the task of 3.1's demo. Five bursts keep the ship beyond 4 m; four do not, in whatever directions.
import assert from 'node:assert';
import { execFileSync } from 'node:child_process';
import { aboutOf, line, pictureOf, printedRow, reader } from './rows.mjs';

const [native] = process.argv.slice(2), rate = 60;
const run = (words, input) => execFileSync(native, words, { input, maxBuffer: 1 << 30 }).toString().trim().split('\n');
const about = aboutOf(reader(printedRow(run(['--picture', ''], '')[0])));
const values = about.controls.map(({ name, value, options }) => (name === 'The game' ? options.indexOf('ship and hole (3.1)') : value));

/// How near the ship comes to the hole within six seconds, with these presses: the time in seconds, and the key.
function nearest(presses) {
  const keys = Array(6 * rate).fill(-1);
  for (const [time, key] of presses) keys[Math.round(time * rate)] = about.keys.findIndex((each) => each.key === `Arrow${key}`);
  const rows = run([], keys.map((key) => `${line([1 / rate, 0, 0, 0, 0, 0, -1, key], values)}\n`).join(''));
  const seen = rows.filter((_, at) => at % rate === 0).map((row) => pictureOf(reader(printedRow(row)))); // it lasts two seconds
  return Math.min(...seen.map(({ readouts }) => readouts.find(({ name }) => name === 'nearest').value));
}
const inTurn = (keys) => keys.map((key, at) => [0.1 + 0.3 * at, key]); // as fast as one can press without hurry
const up = (count) => Array(count).fill('Up');

assert.ok(nearest(inTurn(up(5))) > 7.8, `five bursts: ${nearest(inTurn(up(5)))} m`);
const directions = ['Up', 'Left', 'Down', 'Right'];
const fours = directions.flatMap((a, i) => directions.slice(i).flatMap((b, j) => directions.slice(i + j).flatMap((c, k) => directions.slice(i + j + k).map((d) => [a, b, c, d]))));
assert.equal(fours.length, 35);
for (const four of fours) assert.ok(nearest(inTurn(four)) < 4, `${four}: ${nearest(inTurn(four))} m`);
for (const key of directions) // and not if the last of them comes later
  for (let time = 2; time < 4; time += 0.5) assert.ok(nearest([...inTurn(up(3)), [time, key]]) < 4, `${key} after ${time} s`);
