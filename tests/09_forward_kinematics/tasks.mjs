// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import { near, player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
const pictures = (game, keys, chosen) => demo.pictures(demo.values({ 'The game': game, ...chosen }), keys);
const last = (...all) => pictures(...all).at(-1);
const words = ({ shapes }) => shapes.filter(({ kind }) => kind === 'words').map(({ text }) => text);
const told = (picture, unit) => words(picture).filter((text) => text.endsWith(unit)).map((text) => Number(text.replace('−', '-').slice(0, -unit.length)));
const arms = ({ shapes }) => shapes.filter(({ kind, material }) => kind === 'line' && material === 'solid').map(({ points }) => points);
const handles = ({ shapes }) => shapes.filter(({ kind }) => kind === 'handle').map(({ points }) => points[0]);
const away = ([x, y], [a, b]) => Math.hypot(x - a, y - b);
const idle = (frames) => Array(frames).fill('');
const hold = (handle, x, y, frames = 60) => [...Array(frames).fill([handle, x, y]), ''];

{ // the opening: a guess that is right, and one that is 1 m off; by itself it's never near
  const game = 'you guess', off = (...keys) => told(last(game, [...keys, ...idle(60)]), ' m off');
  assert.deepEqual([off([0, 3.116, 3.432], 'f'), off([0, 3.116, 2.432], 'f'), off([0, 3.116, 2.432])], [[0], [1], []]);
  assert.ok(away(arms(last(game, ['f', ...idle(60)]))[0].at(-1), [3.116, 3.432]) < 0.001);
  assert.ok(pictures(game, seconds(20)).every((picture) => away(handles(picture)[0], [3.116, 3.432]) > 0.5));
}
{ // *New* bolts another arm to the table, which stays in the picture; the last five guesses stay as dots
  const rounds = Array.from({ length: 40 }, () => ['f', ...idle(40), 'n']).flat(), seen = pictures('you guess', rounds), answers = seen.filter((_, i) => i % 42 === 40);
  const hands = answers.map((picture) => arms(picture)[0].at(-1));
  assert.ok(new Set(hands.map(String)).size > 30);
  for (const [x, y] of hands) assert.ok(x > 0 && x < 5 && y > 0 && y < 4, `${x}, ${y}`);
  const dots = ({ shapes }) => shapes.filter(({ kind, colour, material }) => kind === 'discs' && colour === 'amber' && material === 'glow').length;
  assert.deepEqual([0, 1, 2, 3, 4, 5, 39].map((i) => dots(answers[i])), [1, 2, 3, 4, 5, 5, 5]);
  assert.ok(words(seen[0]).includes('3 m at 30°, then 2 m, bent by 45°'));
  for (const picture of seen.filter((_, i) => i % 42 === 41)) assert.ok(words(picture).includes('hand?') && arms(picture).length === 0);
}
const drawn = (rate) => pictures('an arm that draws (9.1)', seconds(9), { 'second motor': rate }).map((picture) => arms(picture)[0].slice(1));
for (const rate of [4, 5]) { // one loop for each turn of the second motor: there the hand is closest to the origin
  drawn(rate).forEach(([, hand], i) => near(away(hand, [0, 0]), Math.sqrt(13 + 12 * Math.cos((rate * (i + 1)) / 60)), 1e-5));
}
for (const [elbow, hand] of drawn(-1)) near(away(hand, [elbow[0] + 2, elbow[1]]), 0, 1e-5); // the second link keeps its direction
{ // the digger: cab and slope move all of it, the stick only stick and bucket
  const game = 'a digger (9.2)', start = ['', [2, 0, 4.2]], before = handles(last(game, start));
  const moved = (...drag) => handles(last(game, [...start, ...drag])).map((at, i) => away(at, before[i]) > 0.05);
  assert.deepEqual([moved([0, -2, 1]), moved([3, 0.5, 0.5])], [[true, false, true, true, true], [false, false, false, true, true]]);
  assert.deepEqual(moved([1, 5, 1]), [true, true, true, true, true]);
  // the teeth can't reach the stone by one handle alone, and do by two; left alone, they don't
  const nearest = (...drags) => Math.min(...drags.map((drag) => told(last(game, ['', ...drag]), ' m')[0])), range = (from, to, by) => Array.from({ length: Math.floor((to - from) / by) + 1 }, (_, i) => from + by * i);
  const round = ([x, y], radius) => range(0, 6.2, 0.2).map((angle) => [x + radius * Math.cos(angle), y + radius * Math.sin(angle)]);
  const first = handles(last(game, ['', [0, -4, 1]])); // by that its own hand has let go, and all is as at the start
  const alone = [range(-7, 3, 0.25).map((x) => [x, 1]), range(-2, 2, 0.2).map((y) => [5.6, y]), round([-2.5, 1.2], 3.2), round(first[2], 2.4), round(first[3], 0.6)];
  alone.forEach((places, handle) => assert.ok(nearest(...places.map(([x, y]) => [[0, -4, 1], [handle, x, y]])) > 1, `${handle}`));
  assert.ok(nearest(...range(-2.9, -2.3, 0.02).map((x) => [[0, x, 1], [2, x + 1.5 + 3.2 * Math.cos(0.5934), 1.2 + 3.2 * Math.sin(0.5934)]])) < 0.1);
  assert.ok(pictures(game, seconds(60)).every((picture) => told(picture, ' m')[0] > 1));
}
{ // no lag: all links bend to one side; at 1 rad the wave is about six links long, and the tip swings far less
  const swing = (lag) => Math.max(...pictures('tentacle (9.3)', seconds(4), { lag }).map((picture) => Math.abs(arms(picture)[2].at(-1)[0])));
  near(swing(1) / swing(0), 1.1 / 5.6, 0.02);
  assert.deepEqual([3, 40].map((links) => arms(last('tentacle (9.3)', [''], { links }))[2].length), [4, 41]);
}
{ // in the cab: the stone is grabbed, carried, and let go on the mat
  const game = 'in the cab (9.4)', stone = ({ shapes }) => shapes.filter(({ kind, size }) => kind === 'discs' && size === 0.24).at(-1).points[0];
  const to = (handle, x, y) => hold(handle, x, y, 120), path = [...to(0, -4.51, 1), ...to(1, -0.14, 2.6)];
  const there = last(game, path), grabbed = last(game, [...path, 'c', '']);
  assert.ok(away(stone(there), [1.5, 0.02]) < 1e-6 && away(stone(grabbed), stone(there)) > 0.01, `${stone(grabbed)}`);
  const carried = [...path, 'c', ...to(1, -0.5, 4), ...to(0, -7.51, 1), ...idle(30)], end = last(game, [...carried, 'c', ...seconds(2)]);
  assert.ok(stone(last(game, carried))[1] > 0.5);
  assert.ok(Math.abs(stone(end)[0] + 1.5) < 0.4 && Math.abs(stone(end)[1] - 0.02) < 1e-6, `${stone(end)}`);
  assert.ok(words(end).some((text) => /^there after \d+\.\d s$/.test(text)), words(end).join());
  const alone = pictures(game, seconds(30)).map(stone); // and left alone, again and again
  assert.ok(alone.filter(([x], i) => i > 0 && x > alone[i - 1][0] + 2).length > 5 && Math.min(...alone.map(([x]) => x)) > -1.9);
}
{ // how the hand moves: the area is that of 3 m and 2 m, whatever the first angle is
  const game = 'how the hand moves (9.5)', area = (...keys) => told(last(game, ['', ...keys]), ' m²')[0], [base, elbow] = arms(last(game, ['']))[0];
  const square = [1, elbow[0] - 2 * (elbow[1] - base[1]) / 3, elbow[1] + 2 * (elbow[0] - base[0]) / 3];
  near(area(square), 6, 0.06);
  near(area(square, [0, 5, -2.6]), 6, 0.06);
  near(area([1, 2 * elbow[0] - base[0], 2 * elbow[1] - base[1]]), 0, 0.06);
  assert.ok(area([1, elbow[0] + elbow[1] - base[1], elbow[1] - elbow[0] + base[0]]) < -5.9); // minus: it bends to the right
}
{ // pick up: the two numbers for the hand stay the same while the box is held, and only then
  const game = 'pick up (9.6)', start = ['', [2, 2.4, 1]], path = Array.from({ length: 40 }, (_, i) => [2, 2.5 - 0.1 * i, 0.5 + 0.05 * i]);
  const local = (...keys) => words(last(game, [...start, ...keys]))[0], crate = (...keys) => last(game, [...start, ...keys]).shapes.find(({ kind, colour }) => kind === 'area' && colour === 'wood').points;
  assert.match(local('t'), /^x −?\d\.\d\d, y −?\d\.\d\d$/);
  assert.equal(local('t', ...path), local('t'));
  assert.notEqual(local(...path), local());
  assert.ok(away(crate('t', ...path)[0], crate()[0]) > 0.3 && away(crate(...path)[0], crate()[0]) < 1e-9);
  // the hand can be dragged into the box, which reaches 0.5 m from its middle
  const inside = words(last(game, ['', [0, 0, 1], [1, 2.5, 0.5], [2, 2.5, 0.5]]))[0].match(/[\d.]+/g).map(Number);
  assert.ok(Math.hypot(...inside) < 0.5, `${inside}`);
  // and by half a turn of the hand it's upside down
  const upside = crate('t', [1, -4, 0.5], [0, -5, -2], [1, -5.5, -3], [2, -5, -3.3]), upright = crate('t');
  assert.ok(upright[2][1] > upright[1][1] && upside[2][1] < upside[1][1], JSON.stringify(upside));
}
{ // over the wall: never in the ground, in any round
  for (let rounds = 0; rounds < 20; ++rounds) {
    const seen = pictures('over the wall (9.8)', [...Array(rounds).fill('n'), ...seconds(8)]).slice(rounds);
    assert.ok(seen.every((picture) => arms(picture).at(-1).every(([, y]) => y >= 0)), `${rounds}`);
    assert.ok(seen.some((picture) => told(picture, ' poses')[0] > 20), `${rounds}`);
  }
}
