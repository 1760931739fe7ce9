// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import { near, player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
const rows = (game, chosen, keys) => demo.readouts(demo.values({ 'The game': game, ...chosen }), keys);
const filled = (actions) => [...actions, ...seconds(Math.ceil(actions.length / 60) + 1).slice(actions.length)];
const after = (game, chosen, ...actions) => rows(game, chosen, filled(actions)).at(-1);
const pointer = (x, y, frames = 60) => Array(frames).fill([-1, x, y]);
const around = (radius, from, to, frames) => Array.from({ length: frames }, (_, i) => {
  const at = from + ((to - from) * i) / (frames - 1);
  return [-1, radius * Math.cos(at), radius * Math.sin(at)];
});

{ // the opening: both poses can be found by hand, and a hand that is let go beside the cross is none of them
  const left = [[0, 3, 0], [0, 3, 0], [1, 3, 2], ''], right = [[0, 1.1538, 2.7692], [1, 3, 2], ''];
  const one = after('you find it', {}, ...left), all = after('you find it', {}, ...left, ...right);
  near(one['first angle'], 0, 0.1), near(one['second angle'], 90, 0.1), near(one['poses found'], 1);
  near(all['first angle'], 67.38, 0.1), near(all['second angle'], -90, 0.1), near(all['poses found'], 2);
  near(after('you find it', {}, [0, 3, 0], [1, 4, 1], '')['poses found'], 0);
  near(after('you find it', {}, ...left, 'n', '')['poses found'], 0);
}
{ // eyes: led around the left one, its number jumps by a whole turn
  const eye = (x, y) => after('eyes (10.1)', {}, ...pointer(x, y))['left eye'];
  assert.ok(eye(-4, 0.91) > 179 && eye(-4, 0.89) < -179);
  near(eye(-1.6, 1.9), 45, 0.1);
}
{ // both elbows: two, one on the border, none beyond it and none in the hole; they meet where the arm is straight
  const poses = (x, y) => after('both elbows (10.2)', {}, ...pointer(x, y)).poses;
  assert.deepEqual([poses(3, 2), poses(5, 0), poses(0, -1), poses(5.1, 0), poses(0.5, 0.5)], [2, 1, 1, 0, 0]);
}
{ // out of reach: as near as the leash allows; with links of one length there's no hole
  const away = (x, y, chosen = {}) => after('out of reach (10.3)', chosen, ...pointer(x, y))['from the hand to the fly'];
  near(away(6, 4.5), 2.5), near(away(0.3, 0.4), 0.5), near(away(0.3, 0.4, { 'upper arm': 2, forearm: 2 }), 0, 1e-6);
}
{ // apples: ten are caught before ten are missed, by waiting below each one; and the hand gets stuck across the hole
  const places = Array.from({ length: 40 }, (_, i) => (-3.8 + (7.6 * (Math.imul(i + 1, 2654435761 | 0) >>> 20)) / 4096));
  const waiting = places.flatMap((x) => pointer(x, -1, 72));
  const row = rows('apples (10.4)', {}, waiting).find((each) => each.caught >= 10);
  assert.ok(row && row.missed < 10, JSON.stringify(row));
}
{ // led around twice: its first angle goes on, and the pale arm's comes back; its elbow may change at the border only
  const game = 'led around (10.5)', twice = around(3.6, 0, 4 * Math.PI, 600);
  const row = after(game, {}, ...pointer(3.6, 0, 120), ...twice, ...pointer(3.6, 0, 120)), before = after(game, {}, ...pointer(3.6, 0, 120));
  near(row['first angle'] - before['first angle'], 720, 0.1);
  near(row['first angle of the pale arm'] - before['first angle'], 0, 0.1);
  near(row['second angle'], before['second angle'], 0.1);
}
{ // the tentacle gets to whatever is near, at any side of its base
  for (const [x, y] of [[0, 2], [3.5, 0], [-3.5, 0], [1, -2]])
    assert.ok(after('tentacle (10.6)', {}, ...pointer(x, y, 120))['from the hand to the fly'] < 0.02, `${x}, ${y}`);
}
{ // stretched: DLS takes a few steps, CCD none that gets anywhere; and out at the side they are as quick
  const race = (damping, ...keys) => after('stretched (10.7)', { damping }, ...keys, ...Array(240).fill(''));
  const side = race(0.5), straight = race(0.5, 'n'), shy = race(2, 'n');
  assert.ok(side['DLS: steps'] < 10 && side['CCD: steps'] < 10, JSON.stringify(side));
  assert.ok(straight['DLS: steps'] < 10 && straight['CCD: steps'] > 20, JSON.stringify(straight));
  assert.ok(shy['DLS: steps'] > 20, JSON.stringify(shy));
}
for (let letter = 0; letter < 5; ++letter) { // each letter is written
  const row = after('your letter (10.8)', {}, ...Array(letter).fill('n'), '');
  assert.ok(row.poses > 20 && row.poses < 300, JSON.stringify(row));
}
