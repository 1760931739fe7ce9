// clock.mjs NATIVE: in 3.2's demo the clock stops when the ball arrives, where 3.2 has said.
import assert from 'node:assert';
import { player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
for (const up of [-2, 0, 2]) {
  const seen = demo.last({ 'The game': 'falling (3.2)', throw: up }, seconds(9));
  assert.ok(seen.predicted > 2 && seen.predicted < 8, `${seen.predicted} s`);
  assert.equal(seen.clock, seen.predicted);
  assert.ok(Math.abs(seen.height) < 1e-9, `${seen.height} m`);
}
