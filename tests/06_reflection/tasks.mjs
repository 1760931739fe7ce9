// tasks.mjs NATIVE: what the chapter says of its demo: what comes back, where the ball goes, which shots get there.
import assert from 'node:assert';
import { near, player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
// The pictures of a scene whose controls are so; what stands in one; where its ball is, and what it does from one to the next.
const pictures = (game, chosen, keys) => demo.pictures(demo.values({ 'The game': game, ...chosen }), keys);
const words = ({ shapes }) => shapes.filter(({ kind }) => kind === 'words').map(({ text }) => text);
const discs = (colour, material, all = 'discs') => ({ shapes }) => shapes.find((each) => each.kind === all && each.colour === colour && each.material === material);
const ball = (picture) => discs('ink', 'solid')(picture)?.points[0];
const logo = ({ shapes }) => shapes.find(({ kind, material }) => kind === 'discs' && material === 'glow').points[0];
const velocity = ([a, b], [x, y]) => [60 * (x - a), 60 * (y - b)];
const direction = ([x, y]) => Math.atan2(y, x) * 180 / Math.PI;
const from = (degrees, far = 4.4) => [0, far * Math.cos(degrees * Math.PI / 180), far * Math.sin(degrees * Math.PI / 180)];
// Velocities of a ball that's thrown, before it meets the wall and after that.
function thrown(seen) {
  const at = seen.map(ball), all = at.slice(1).map((to, i) => velocity(at[i], to)), last = all.findIndex(([x, y]) => Math.hypot(x, y + 5) > 1e-6 && Math.hypot(x, y) > 1e-6);
  return { met: last >= 0, after: all[last + 1] };
}
const angles = (picture) => words(picture).filter((text) => /^[\d.]+°$/.test(text)).map(parseFloat);

{ // the ball of the opening, and how far off a guess is
  const guess = (degrees) => pictures('you guess', {}, ['', from(degrees, 3), ...seconds(1.5)]);
  const { after } = thrown(guess(100).slice(2));
  near(after[0], -4.8);
  near(after[1], 1.4);
  const truth = direction([-4.8, 1.4]), aimed = ({ shapes }) => {
    const [[a, b], [x, y]] = shapes.find(({ kind, colour }) => kind === 'arrow' && colour === 'violet').points;
    return direction([x - a, y - b]);
  };
  for (const degrees of [100, 135, 170]) {
    const seen = guess(degrees).at(-1);
    assert.ok(Math.abs(aimed(seen) - degrees) < 12);
    assert.deepEqual(words(seen), [`${Math.abs(truth - aimed(seen)).toFixed(0)}° off`, '5.0 m/s']);
  }
  // left alone, it only wonders: no ball leaves the wall, and no guess is right
  for (const picture of pictures('you guess', {}, seconds(20))) {
    assert.ok(!words(picture).some((text) => /off|m\/s/.test(text)));
    assert.ok(Math.abs(((aimed(picture) - truth + 540) % 360) - 180) > 25);
  }
}
{ // put far outside, it comes back and stays; and the first corner comes soon
  const out = ([x, y]) => Math.max(1 - x, x - 15, 1 - y, y - 8);
  const seen = pictures('a screen (6.1)', {}, [...seconds(1), 'l', ...seconds(6)]), at = seen.map(logo);
  assert.ok(out(at[60]) > 1 && words(seen[60]).some((text) => text.endsWith('m out')));
  assert.ok(at.slice(180).every((each) => out(each) < 0.1));
  near(Math.hypot(...velocity(at.at(-2), at.at(-1))), 5);
  assert.ok(pictures('a screen (6.1)', {}, seconds(4)).some((picture) => words(picture).includes('into the corner!')));
}
{ // the angle out is the angle in; the ball's way turns by twice as much as the wall
  const first = thrown(pictures('a wall (6.2)', {}, seconds(1.5))).after;
  for (const turned of [0, 8, 10, -57]) {
    const seen = pictures('a wall (6.2)', {}, ['', from(37 + turned), ...seconds(1.5)]), { after } = thrown(seen.slice(2));
    near((direction(after) - direction(first) - 2 * turned) % 360, 0, 1e-6);
    const told = angles(seen.at(-1));
    assert.deepEqual(told, [...Array(2).fill(Math.abs(37 + turned)), ...(turned === 0 ? [] : [Math.abs(turned), 2 * Math.abs(turned)])]);
  }
}
for (const game of ['a wall (6.2)', 'rough wall (6.4)']) { // turned after the meeting, the wall gets a new throw
  const seen = pictures(game, { restitution: 1, mu_k: 0 }, [...seconds(1.5), from(40), ...seconds(1.5)]);
  assert.ok(thrown(seen.slice(0, 90)).met);
  assert.deepEqual(ball(seen[90]), ball(pictures(game, {}, [from(40)])[0]));
  const [one, other] = angles(seen.at(-1));
  near(one, 40, 0.01), near(other, 40, 0.01);
}
for (const swapped of [false, true]) { // the ball bounces; with the ends swapped it falls through the wall
  const ends = swapped ? [[0, 4, 1], [1, -4, -2]] : [[0, -4, -2], [1, 4, 1]];
  const seen = pictures('two ends (6.3)', {}, [...ends, ...seconds(1.5)]);
  const [foot, tip] = seen.at(-1).shapes.find(({ kind, colour }) => kind === 'arrow' && colour === 'violet').points;
  assert.equal(tip[1] < foot[1], swapped);
  assert.equal(thrown(seen.slice(2)).met, !swapped);
  if (swapped) assert.ok(seen.some((picture) => ball(picture)[1] < -2.5));
}
{ // dragged after the meeting, this wall gets a new throw, too; and one without a length has no normal
  const seen = pictures('two ends (6.3)', {}, [...seconds(1.5), [0, -4, -1], ...seconds(1.5)]);
  assert.ok(ball(seen[90])[1] > 4 && thrown(seen.slice(0, 90)).met && thrown(seen.slice(91)).met);
  assert.ok(words(pictures('two ends (6.3)', {}, [[0, 1, 1], [1, 1, 1], '']).at(-1)).includes('A point has no normal.'));
}
{ // with restitution 1 the ball leaves along the normal from a mu_k of 0.4 on, with 0.5 from 0.6 on
  const told = (restitution, mu_k) => angles(pictures('rough wall (6.4)', { restitution, mu_k }, ['']).at(-1));
  const out = (restitution, mu_k) => told(restitution, mu_k)[1];
  assert.deepEqual([out(1, 0.4), out(1, 0.3), out(0.5, 0.6), out(0.5, 0.5)], [0, 8.7, 0, 0.4]);
  assert.deepEqual(told(1, 0), [37, 37]);
  const { after } = thrown(pictures('rough wall (6.4)', { restitution: 1, mu_k: 0.4 }, seconds(1.5)));
  near(direction(after), 127, 1e-6);
}
{ // the box is turned, slowly and fast, and the ball keeps its speed
  const round = Array.from({ length: 600 }, (_, i) => from(i < 300 ? 20 + i / 10 : 50 + 2 * i));
  const at = pictures('turned box (6.5)', {}, round);
  assert.deepEqual([...new Set(at.flatMap(words))], ['5.00 m/s']);
  assert.ok(at.every((picture) => Math.hypot(...logo(picture)) < 5.5));
}
{ // the straight shot hits the ball in the way; over a cushion or two the target is reached
  const shot = (across, up) => words(pictures('bank shot (6.6)', { across, up }, [[-1, 0, 0], ...seconds(4)]).findLast((picture) => words(picture).length > 0));
  const ends = Object.fromEntries([-1, 0, 1].flatMap((across) => [-1, 0, 1].map((up) => [`${across} ${up}`, shot(across, up).join()])));
  assert.deepEqual(Object.keys(ends).filter((each) => ends[each] === 'there'), ['-1 1', '0 1', '1 -1']);
  assert.equal(ends['0 0'], 'blocked');
  // left alone, it never gets there
  const alone = new Set(pictures('bank shot (6.6)', {}, seconds(40)).flatMap(words));
  assert.deepEqual([...alone], ['blocked']);
}
{ // left alone, pinball scores; nobody at the flippers, and all three balls are lost in the end
  const score = (picture) => Number(words(picture).find((text) => /^\d+$/.test(text)));
  const alone = pictures('pinball (6.7)', {}, seconds(40)).map(score);
  assert.ok(Math.max(...alone) >= 1000, Math.max(...alone));
  assert.ok(alone.every((points, i) => i === 0 || points === 0 || (points >= alone[i - 1] && points - alone[i - 1] <= 220)));
  const shoot = [[-1, 3, 3], ...seconds(20)], played = pictures('pinball (6.7)', {}, Array(4).fill(shoot).flat());
  assert.ok(words(played.at(-1)).includes('the best so far') && score(played.at(-1)) > 0, words(played.at(-1)).join());
}
