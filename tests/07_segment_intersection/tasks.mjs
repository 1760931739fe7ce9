// tasks.mjs NATIVE: what the chapter says of its demo: what's missed and what isn't, who is late, and what two segments share.
import assert from 'node:assert';
import { near, player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
// The pictures of a scene whose controls are so; what stands in one; and where its ball is.
const pictures = (game, chosen, keys) => demo.pictures(demo.values({ 'The game': game, ...chosen }), keys);
const words = ({ shapes }) => shapes.filter(({ kind }) => kind === 'words').map(({ text }) => text);
const ball = ({ shapes }) => shapes.findLast(({ kind, colour, material }) => kind === 'discs' && colour === 'orange' && material === 'solid').points[0];
const arrow = ({ shapes }) => shapes.find(({ kind }) => kind === 'arrow').points;
const lamps = (colour) => ({ shapes }) => shapes.filter((each) => each.kind === 'discs' && each.colour === colour && each.material === 'glow').map(({ points }) => points[0]);
const beams = ({ shapes }) => shapes.filter(({ kind, material }) => kind === 'line' && material === 'glow');
const room = [[0.5, 1], [6, 0], [11.5, 1.5], [10, 6.5], [6.5, 3.5], [4, 7], [1, 5.5]], start = [2, 3];
const walls = room.map((corner, i) => [corner, room[(i + 1) % 7]]);
// Thrown at once, from where it starts, so fast into this direction [m/s, degrees]
const thrown = (speed, degrees) => [0, ...[Math.cos, Math.sin].map((of, k) => start[k] + 0.1 * speed * of((degrees * Math.PI) / 180))];
const outside = ([x, y]) => Math.max(...walls.map(([[a, b], [c, d]]) => ((x - a) * (d - b) - (y - b) * (c - a)) / Math.hypot(c - a, d - b)));
const inRoom = ([x, y]) => walls.filter(([[a, b], [c, d]]) => b > y !== d > y && x < a + ((y - b) / (d - b)) * (c - a)).length % 2 === 1;
const directions = [0, 70, 130, 200, 290];

{ // asked once a frame, a gentle ball is always noticed; a hard one gets through; left alone, none does
  const missed = (speed) => directions.filter((degrees) => pictures('asks once a frame', {}, [thrown(speed, degrees), ...seconds(10)]).some((picture) => words(picture).includes('missed')));
  assert.deepEqual(missed(4), []);
  assert.deepEqual(missed(60), directions);
  const alone = pictures('asks once a frame', {}, seconds(30));
  assert.deepEqual(alone.flatMap(words), []);
  assert.ok(alone.some((picture) => beams(picture).length > 0), 'a wall that has noticed it is lit');
}
{ // asked about the motion, no wall misses it, however hard it's thrown
  for (const degrees of directions) {
    const seen = pictures('bounces once a frame (7.2)', {}, [thrown(60, degrees), ...seconds(10)]);
    assert.deepEqual(seen.flatMap(words), []);
    assert.ok(seen.some((picture) => beams(picture).length > 2));
  }
}
{ // so many arrows to the next wall; and a dot on the line of each wall
  const seen = pictures('asks 7.1', {}, ['', [0, 4.6, 3.6], '']).at(-1), [[x, y], tip] = arrow(seen);
  assert.deepEqual([x, y], [4.6, 2.6]);
  near(tip[1], 3.6);
  near(Number(words(seen)[0].split(' = ')[1]), 7 - 1.4 * 0.6 - y, 0.01); // the wall above it, at x = 4.6
  assert.equal(lamps('orange')(seen).length + lamps('pink')(seen).length, 7);
  for (const [a, b] of [...lamps('orange')(seen), ...lamps('pink')(seen)]) near(a, 4.6, 1e-9), assert.ok(Number.isFinite(b));
  // parallel to a wall, and its dot is gone; just beside that, it's far away
  const along = (degrees) => pictures('asks 7.1', {}, ['', [0, 4.6 + Math.cos(degrees), 2.6 + Math.sin(degrees)], '']).at(-1), all = (picture) => [...lamps('orange')(picture), ...lamps('pink')(picture)];
  const upright = Math.atan2(4.5, 0.5);
  assert.equal(all(pictures('asks 7.1', {}, ['', [0, 4.6 + 0.25, 2.6 + 2.25], '']).at(-1)).length, 6);
  assert.ok(Math.max(...all(along(upright + 0.001)).map(([, b]) => Math.abs(b))) > 1000);
  // left alone, it's never near that
  for (const picture of pictures('asks 7.1', {}, seconds(10))) assert.equal(all(picture).filter(([a, b]) => Math.hypot(a, b) < 100).length, 7);
}
{ // it turns to where one presses, and keeps its speed
  const seen = pictures('bounces once a frame (7.2)', {}, ['', [-1, 2, 6], '']), [[x, y], [a, b]] = arrow(seen[1]);
  near(Math.hypot(a - x, b - y), 0.1 * Math.hypot(5.4, 2.55), 1e-9);
  near((a - x) * (6 - y) - (b - y) * (2 - x), 0, 1e-9);
}
{ // two segments: a piece, a single point in three ways, or nothing; the ends keep to whole metres
  const shared = (...drags) => words(pictures('two segments (7.3)', {}, ['', ...drags, '']).at(-1)).join();
  assert.equal(shared([0, 1, 1]), 'a piece');
  assert.equal(shared([3, 6.8, 4.2]), 'one point'); // end to end
  assert.equal(shared([1, 4, 6], [0, 4, 1]), 'one point'); // they cross at (4, 2.5)
  assert.equal(shared([0, 1, 3], [1, 5, 3]), 'one point'); // an end at the side
  assert.equal(shared([1, 2.1, 5.9]), '');
  assert.deepEqual([...new Set(pictures('two segments (7.3)', {}, seconds(20)).flatMap(words))], ['a piece']);
}
{ // one bounce a frame loses time at each wall: at 5 frames a second a lot, at 60 little
  const late = (rate) => pictures('bounces (7.4)', { 'frames per second': rate }, [thrown(6, 25), ...seconds(10)]).map((picture) => parseFloat(words(picture).find((text) => text.endsWith('s late')) ?? '0'));
  const [slow, fast] = [late(5), late(60)];
  assert.ok(slow.at(-1) > 5 * fast.at(-1) && fast.at(-1) > 0, `${slow.at(-1)} and ${fast.at(-1)}`);
  assert.ok(slow.every((time, i) => i === 0 || time >= slow[i - 1]));
  assert.ok(pictures('bounces (7.4)', { 'frames per second': 5 }, seconds(20)).every((picture) => words(picture).length === 0), 'left alone, nothing is said of that');
}
for (const [game, chosen] of [['bounces (7.4)', {}], ['has a size (7.5)', { radius: 0.4 }], ['has a size (7.5)', { radius: 0.5 }]]) // it stays in its room, also if it's large
  for (const degrees of directions) {
    const seen = pictures(game, chosen, [thrown(30, degrees), ...seconds(10)]);
    assert.deepEqual(seen.flatMap(words).filter((text) => text === 'out'), []);
    for (const picture of seen) assert.ok(inRoom(ball(picture)) || Math.abs(outside(ball(picture))) < 1e-6 || game.startsWith('bounces'), `${game}, ${degrees}: ${ball(picture)}`);
  }
{ // the ball with a size can be sent against the tip that points into the room, and turns there, 0.4 m before it
  const seen = pictures('has a size (7.5)', { radius: 0.4 }, [thrown(6, (Math.atan2(0.217, 4.217) * 180) / Math.PI), ...seconds(1)]).map(ball);
  near(Math.min(...seen.map(([x, y]) => Math.hypot(x - 6.5, y - 3.5))), 0.4, 0.001);
  assert.ok(seen.at(-1)[0] < 6.3 && seen.at(-1)[1] < 2.5, `${seen.at(-1)}`);
}
