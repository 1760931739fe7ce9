// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import { player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
const seen = (game, chosen, keys = ['f', ...seconds(8)]) => demo.last({ 'The game': game, ...chosen }, keys);
const angles = (from, to) => Array.from({ length: to - from + 1 }, (_, i) => from + i);
const best = (among, value) => among.map((one) => [value(one), one]).reduce((one, other) => (other[0] > one[0] ? other : one))[1];
const equal = (one, other) => assert.equal(one.toFixed(2), other.toFixed(2));

{ // the farthest: 45° on level ground, 37° from a cliff of 25 m
  const lands = (height) => (angle) => seen('you guess', { angle, 'muzzle above the ground': height })['shell landed at'];
  assert.equal(best(angles(30, 60), lands(0)), 45);
  assert.equal(best(angles(30, 45), lands(25)), 37);
}
{ // without 4.2 the game notices the ground too late
  const late = seen('it flies (4.1)', { angle: 60 })['shell landed at'], right = seen('it lands (4.2)', { angle: 60 })['shell landed at'];
  assert.ok(late > right + 0.5);
}
equal(seen('it lands (4.2)', { angle: 90 }).clock, 2 * seen('it lands (4.2)', { angle: 30 }).clock);
{ // two angles for 50 m; from 25 m the high one has to change less
  const range = (angle, height = 0) => seen('range (4.3)', { angle, 'muzzle above the ground': height }, seconds(1)).range;
  const nearest = (from, to, height) => best(angles(from, to), (angle) => -Math.abs(range(angle, height) - 50));
  assert.deepEqual([nearest(0, 45, 0), nearest(45, 90, 0)], [27, 63]);
  assert.deepEqual([nearest(-45, 30, 25), nearest(30, 90, 25)], [-6, 69]);
}
for (const [game, flag] of [['range (4.3)', 'range'], ['wind (4.6)', 'range'], ['a terrace (4.7)', 'comes down at']]) { // the shell lands at the flag
  const it = seen(game, { angle: 60 });
  equal(it['shell landed at'], it[flag]);
}
for (const [wind, farthest] of [[-2, 39], [2, 51]])
  assert.equal(best(angles(30, 60), (angle) => seen('wind (4.6)', { angle, wind }, seconds(1)).range), farthest);
{ // a terrace of 20 m can be hit, but not at the angle that is set at first; 24 m is the most
  const hit = (height) => angles(35, 80).filter((angle) => seen('a terrace (4.7)', { angle, 'height of the terrace': height }, seconds(1))['comes down at'] >= 30);
  const twenty = hit(20);
  assert.ok(twenty.length > 0 && !twenty.includes(40));
  assert.ok(hit(24).length > 0);
  assert.deepEqual(hit(25), []);
}
{ // exact steps are close first
  const loops = (rate) => seen('frame loops (4.9)', { angle: 50, 'frames per second': rate });
  for (const rate of [2, 5, 30]) {
    const { 'explicit Euler': explicit, 'semi-implicit Euler': implicit, 'exact steps': exact, range } = loops(rate);
    assert.ok(Math.abs(exact - range) < Math.min(Math.abs(explicit - range), Math.abs(implicit - range)) / 10);
  }
}
{ // a target out of reach: the cannon stays, and points where it did
  const values = demo.values({ 'The game': 'it aims (4.8)' });
  const barrel = ({ shapes }) => JSON.stringify(shapes.find(({ kind, colour, size }) => kind === 'line' && colour === 'ink' && size === 7).points);
  const [near, far] = demo.pictures(values, ['', [0, 1000, 1000]]);
  assert.ok(far.shapes.some(({ text }) => text === 'out of reach'));
  assert.equal(barrel(far), barrel(near));
}
