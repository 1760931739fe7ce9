// bursts.mjs NATIVE: the task of 3.1's demo. Five bursts keep the ship beyond 4 m; four do not, in whatever directions.
import assert from 'node:assert';
import { player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]), values = demo.values({ 'The game': 'ship and hole (3.1)' });

/// How near the ship comes to the hole within six seconds, with these presses: the time in seconds, and the key.
function nearest(presses) {
  const keys = seconds(6);
  for (const [time, key] of presses) keys[Math.round(time * 60)] = `Arrow${key}`;
  return Math.min(...demo.readouts(values, keys).map((seen) => seen.nearest));
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
