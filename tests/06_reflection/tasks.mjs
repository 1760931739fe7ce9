// tasks.mjs NATIVE: what the chapter says of its demo: what comes back, where the ball goes, which shots get there.
import assert from 'node:assert';
import { near, player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]), { last } = demo;

{ // the ball of the opening
  const seen = last({}, ['f', ...seconds(1.5).slice(1), ...seconds(0.5)]);
  near(seen['after, to the right'], -4.8);
  near(seen['after, up'], 1.4);
}
{ // put far outside, it comes back and stays
  const seen = demo.readouts(demo.values({ 'The game': 'a screen (6.1)' }), [...seconds(1), 'l', ...seconds(6)]);
  assert.ok(seen[1]['past a side by'] > 1);
  assert.ok(seen.at(-1)['past a side by'] < 0.1);
  near(seen.at(-1).speed, 5);
}
const after = (seen) => Math.atan2(seen['after, up'], seen['after, to the right']) * 180 / Math.PI;
let atFirst;
for (const turns of [0, 8, -57]) { // the angle out is the angle in; the ball's way turns by twice as much as the wall
  const keys = Array(Math.abs(turns)).fill(turns > 0 ? 'u' : 'd');
  const seen = last({ 'The game': 'a wall (6.2)', speed: 3 }, [...keys, ...seconds(4).slice(keys.length)].slice(0, 120));
  near(seen['angle out'], seen['angle in'], 1e-9);
  atFirst ??= after(seen);
  near((after(seen) - atFirst - 2 * turns) % 360, 0, 1e-6);
}
for (const game of ['a wall (6.2)', 'rough wall (6.4)']) { // turned after the meeting, the wall gets a new throw
  const values = demo.values({ 'The game': game, speed: 3, restitution: 1, mu_k: 0 });
  for (const turn of ['u', 'd', [0, 1, 3]]) { // by a key, or by the handle
    const seen = demo.readouts(values, [...seconds(2), turn, ...seconds(2).slice(1)]);
    assert.deepEqual(seen.map((each) => 'angle out' in each), [false, true, false, true]);
    for (const each of [seen[1], seen[3]]) near(each['angle out'], each['angle in'], 1e-5);
  }
}
for (const swapped of [false, true]) { // the ball bounces; with the ends swapped it falls through the wall
  const ends = swapped ? [[0, 4, 1], [1, -4, -2]] : [[0, -4, -2], [1, 4, 1]];
  const seen = demo.readouts(demo.values({ 'The game': 'two ends (6.3)' }), [...ends, ...seconds(2).slice(2)]).at(-1);
  assert.equal(seen['normal, up'] < 0, swapped);
  assert.equal('after, up' in seen, !swapped);
}
{ // dragged after the meeting, this wall gets a new throw, too
  const seen = demo.readouts(demo.values({ 'The game': 'two ends (6.3)', speed: 3 }), [...seconds(2), [0, -4, -1], ...seconds(2).slice(1)]);
  assert.deepEqual(seen.map((each) => 'after, up' in each), [false, true, false, true]);
}
{ // with restitution 1 the ball leaves along the normal from a mu_k of 0.4 on, with 0.5 from 0.6 on
  const values = { 'The game': 'rough wall (6.4)', speed: 3 };
  const out = (restitution, mu_k) => last({ ...values, restitution, mu_k }, seconds(2))['angle out'];
  near(out(1, 0.4), 0, 1e-5);
  near(out(1, 0.3), 8.7, 0.05);
  near(out(0.5, 0.6), 0, 1e-5);
  near(out(0.5, 0.5), 0.4, 0.05);
  const smooth = last({ ...values, mu_k: 0, restitution: 1 }, seconds(2));
  near(smooth['angle out'], smooth['angle in'], 1e-9);
}
near(last({ 'The game': 'turned box (6.5)' }, [...Array(50).fill('u'), ...seconds(10)].slice(0, 600)).speed, 5);
{ // the straight shot hits the ball in the way; over a cushion or two the target is reached
  const shot = (across, up) => last({ 'The game': 'bank shot (6.6)', across, up }, ['f', ...seconds(5)].slice(0, 300))['target is away by'];
  const there = [-1, 0, 1].flatMap((across) => [-1, 0, 1].filter((up) => shot(across, up) < 1e-6).map((up) => `${across} ${up}`));
  assert.deepEqual(there, ['-1 1', '0 1', '1 -1']);
}
