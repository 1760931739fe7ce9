// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import { near, player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
const pictures = (game, keys, chosen) => demo.pictures(demo.values({ 'The game': game, ...chosen }), keys);
const last = (...all) => pictures(...all).at(-1);
const words = ({ shapes }) => shapes.filter(({ kind }) => kind === 'words').map(({ text }) => text);
const told = (picture, unit) => words(picture).filter((text) => text.endsWith(unit)).map((text) => Number(text.replace('−', '-').replace(/^[a-z]+ /, '').slice(0, -unit.length)));
const bars = ({ shapes }, colour = 'blue') => shapes.filter((each) => each.kind === 'line' && each.material === 'solid' && each.colour === colour).map(({ points }) => points);
const handles = ({ shapes }) => shapes.filter(({ kind }) => kind === 'handle').map(({ points }) => points[0]);
const lead = (x, y, frames = 60) => Array(frames).fill([0, x, y]);
const away = ([x, y], [a, b]) => Math.hypot(x - a, y - b);
const around = (radius, from, to, frames) => Array.from({ length: frames }, (_, i) => {
  const at = from + ((to - from) * i) / (frames - 1);
  return [0, radius * Math.cos(at), radius * Math.sin(at)];
});

{ // the opening: both poses can be found by hand, and a hand that is let go beside the apple is none of them
  const game = 'you find it', left = [[0, 3, 0], [0, 3, 0], [1, 3, 2], ''], right = [[0, 1.1538, 2.7692], [1, 3, 2], ''];
  const one = last(game, left), both = last(game, [...left, ...right]);
  assert.ok(words(one).includes('found') && words(both).includes('both found'));
  assert.deepEqual([told(one, '°'), told(both, '°')], [[0, 90], [67.4, -90]]);
  assert.deepEqual(told(last(game, [[0, 3, 0], [1, 4, 1], '']), ' m off'), [1.53]);
  assert.equal(words(last(game, [...left, 'n'])).length, 2);
  // its own hand only wonders, and stays beside
  assert.ok(Math.min(...pictures(game, seconds(20)).map((picture) => away(handles(picture)[1], [3, 2]))) > 0.5);
  for (let round = 1; round <= 20; ++round) { // other apples are seen, and in reach
    const { shapes, low, high } = last(game, Array(round).fill('n')), { points: [[x, y]] } = shapes.find(({ kind, colour }) => kind === 'discs' && colour === 'pink');
    const [[shoulder, elbow, hand]] = bars({ shapes }), lengths = [away(shoulder, elbow), away(elbow, hand)];
    assert.ok(x < high[0] - 2.4 && y > low[1] + 1 && y < high[1] - 0.8, `${x}, ${y}`);
    assert.ok(Math.hypot(x, y) < lengths[0] + lengths[1] - 0.1 && Math.hypot(x, y) > Math.abs(lengths[0] - lengths[1]) + 0.1);
  }
}
{ // eyes: led around the left one, its number jumps by a whole turn; its pupil doesn't
  const eye = (x, y) => last('eyes (10.1)', lead(x, y, 2)), [above, below] = [eye(-4.5, 0.51), eye(-4.5, 0.49)];
  assert.ok(told(above, '°')[0] > 179 && told(below, '°')[0] < -179);
  const pupil = ({ shapes }) => shapes.filter(({ kind, colour, size }) => kind === 'discs' && colour === 'violet' && size === 0.475)[0].points[0];
  assert.ok(away(pupil(above), pupil(below)) < 0.01);
  near(told(eye(-1.169, 1.5), '°')[0], 45, 0.1);
}
{ // both elbows: two, one on the border, none beyond it and none in the hole; untouched, there are always two
  const said = (x, y) => words(last('both elbows (10.2)', lead(x, y, 2)))[0];
  assert.deepEqual([said(3, 2), said(5, 0), said(0, -1), said(5.1, 0), said(0.5, 0.5)], ['2 arms', '1 arm', '1 arm', 'no arm', 'no arm']);
  assert.ok(pictures('both elbows (10.2)', seconds(20)).every((picture) => words(picture)[0] === '2 arms'));
}
{ // out of reach: as near as the leash allows; where both links are as long, there's no hole
  const off = (x, y, chosen) => told(last('out of reach (10.3)', lead(x, y, 2), chosen), ' m');
  assert.deepEqual([off(6, 4.5), off(0.3, 0.4), off(0.3, 0.4, { 'upper arm': 2 })], [[2.5], [0.5], []]);
}
{ // apples: ten are caught before ten are missed, by waiting below each one; left alone, it goes on for good
  const game = 'apples (10.4)', places = Array.from({ length: 40 }, (_, i) => (-3.8 + (7.6 * (Math.imul(i + 1, 2654435761 | 0) >>> 20)) / 4096));
  assert.ok(pictures(game, places.flatMap((x) => lead(x, -1, 72))).some((picture) => words(picture).includes('ten caught')));
  assert.ok(pictures(game, lead(0, -3, 60 * 40)).some((picture) => words(picture).includes('ten missed')));
  const long = pictures(game, seconds(120)).map((picture) => told(picture, ' caught')[0]);
  assert.ok(Math.max(...long) === 10 && long.filter((count, i) => count < long[i - 1]).length >= 2);
}
{ // the hand slides along the rim of the hole, and is stuck where the pointer is exactly opposite
  const hand = (x, y) => bars(last('apples (10.4)', [...lead(3, 0, 120), ...lead(x, y, 180)]))[0].at(-1);
  assert.ok(away(hand(-3, 0), [1, 0]) < 1e-6 && away(hand(-3, 0.3), [-3, 0.3]) < 1e-6);
}
{ // led around twice: its first angle goes on, and the pale arm's comes back
  const game = 'led around (10.5)', start = lead(3.6, 0, 120), twice = around(3.6, 0, 4 * Math.PI, 600);
  const before = told(last(game, start), '°'), after = told(last(game, [...start, ...twice, ...start]), '°');
  near(after[0] - before[0], 720, 1.1), near(after[1] - before[1], 0, 1.1);
  const apart = ([yours, pale]) => Math.abs(yours - pale) > 90;
  assert.ok(pictures(game, seconds(20)).every((picture) => !apart(told(picture, '°')))); // untouched, nothing of that is seen
  // back in from the border while it turns anticlockwise, the elbow bends left; clockwise, right
  for (const way of [1, -1]) {
    const out = [...start, ...lead(6, 0), ...around(6, 0, way, 60), ...Array.from({ length: 60 }, (_, i) => [0, (6 - i / 25) * Math.cos(way), (6 - i / 25) * Math.sin(way)]), ...around(3.6, way, 1.5 * way, 60)];
    const [[shoulder, elbow, hand]] = bars(last(game, out)), bend = (elbow[0] - shoulder[0]) * (hand[1] - elbow[1]) - (elbow[1] - shoulder[1]) * (hand[0] - elbow[0]);
    assert.ok(Math.abs(bend) > 1, `${bend}`);
  }
}
{ // the tentacle gets to whatever is near, at any side of its base
  for (const [x, y] of [[0, 2], [3, 0.5], [-3.5, 0], [1, -2]])
    assert.deepEqual(told(last('tentacle (10.6)', lead(x, y, 120)), ' m'), [], `${x}, ${y}`);
}
{ // each letter is written, the next one by a press; and left alone, one after the other
  const done = (letter) => pictures('your letter (10.8)', [...Array(letter).fill([-1, 0, 0]).flatMap((press) => [press, '']), ...seconds(11)]).flatMap((picture) => told(picture, ' poses'));
  for (let letter = 0; letter < 5; ++letter) assert.ok(done(letter).length > 30 && done(letter)[0] > 20 && done(letter)[0] < 300);
  assert.ok(new Set(pictures('your letter (10.8)', seconds(40)).flatMap((picture) => told(picture, ' poses'))).size >= 4);
}
{ // stretched, which has no scene: steps until the hand is within 1 cm, of DLS with a damping, and of CCD; as the text says
  const limits = [[-0.1, 3.2], [-2.8, 2.8]], turn = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));
  const joints = ([one, two]) => { const elbow = [3 * Math.cos(one), 3 * Math.sin(one)]; return [[0, 0], elbow, [elbow[0] + 2 * Math.cos(one + two), elbow[1] + 2 * Math.sin(one + two)]]; };
  const dls = (damping) => (angles, [x, y]) => {
    const [base, elbow, hand] = joints(angles), columns = [base, elbow].map(([a, b]) => [b - hand[1], hand[0] - a]);
    const [xx, xy, yy] = [[0, 0], [0, 1], [1, 1]].map(([i, k]) => columns.reduce((sum, column) => sum + column[i] * column[k], i === k ? damping ** 2 : 0));
    const [u, v] = [x - hand[0], y - hand[1]], pull = [yy * u - xy * v, xx * v - xy * u].map((part) => part / (xx * yy - xy * xy));
    return angles.map((angle, i) => Math.min(limits[i][1], Math.max(limits[i][0], angle + columns[i][0] * pull[0] + columns[i][1] * pull[1])));
  };
  const ccd = (angles, [x, y]) => [1, 0].reduce((now, i) => {
    const all = joints(now), seen = ([a, b]) => Math.atan2(b - all[i][1], a - all[i][0]);
    return now.map((angle, k) => (k === i ? angle + turn(seen([x, y]) - seen(all[2])) : angle));
  }, angles);
  const count = (step, angles, target) => { let steps = 0; for (; away(joints(angles)[2], target) > 0.01 && steps < 50; steps++) angles = step(angles, target); return steps; };
  const bent = [[2.618, -0.9], [4.2, 0.7]], straight = [[Math.PI / 3, 0.01], [2.25, 3.897]];
  assert.ok(count(dls(0.5), ...bent) < 10 && count(ccd, ...bent) < 10);
  assert.ok(count(dls(0.5), ...straight) < 10 && count(ccd, ...straight) > 20 && count(dls(2), ...straight) > 20);
  assert.equal(Math.abs(dls(0.01)(...straight)[1]), 2.8);
}
