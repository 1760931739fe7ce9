// tasks.mjs NATIVE: what the chapter says of its demo: where things stop, slip and stick.
import assert from 'node:assert';
import { near, player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
// The pictures of a scene whose controls are so; what stands in one, as a number of this unit, too; and who is where.
const pictures = (game, chosen, keys) => demo.pictures(demo.values({ 'The game': game, ...chosen }), keys);
const words = ({ shapes }) => shapes.filter(({ kind }) => kind === 'words').map(({ text }) => text);
const told = (picture, unit) => words(picture).filter((text) => text.endsWith(unit)).map((text) => parseFloat(text.replace('−', '-')));
const glass = ({ shapes }) => shapes.find(({ kind, colour, material }) => kind === 'area' && colour === 'amber' && material === 'solid').points.reduce((sum, [x]) => sum + x / 4, 0);
const ball = (colour) => ({ shapes }) => shapes.findLast((each) => each.kind === 'discs' && each.colour === colour && each.material === 'solid').points[0];
const raised = (degrees) => [0, -6.5 + 9 * Math.cos((degrees * Math.PI) / 180), 9 * Math.sin((degrees * Math.PI) / 180)];
const pushed = (velocity) => [0, 0.9 * velocity, 1.3];

for (const velocity of [6, -6, 3.5]) { // it stops at the flag, and stays
  const seen = pictures('it stops (5.2)', {}, ['', pushed(velocity), ...seconds(4)]);
  near(glass(seen.at(-1)), told(seen.at(-1), ' m')[0]);
  near(told(seen.at(-1), ' m')[0], Math.sign(velocity) * velocity ** 2 / 4);
  assert.equal(glass(seen.at(-1)), glass(seen.at(-30)));
  assert.deepEqual(told(seen.at(-1), 'm/s'), [0]);
}
{ // without 5.2 it comes back from there
  const seen = pictures('it slows (5.1)', {}, ['', pushed(6), ...seconds(4)]);
  near(Math.max(...seen.map(glass)), told(seen.at(-1), ' m')[0]);
  near(glass(seen.at(-1)), 8, 0.1);
  assert.ok(told(seen.at(-1), 'm/s')[0] < -1.9);
}
for (const game of ['it slows (5.1)', 'it stops (5.2)']) // left alone, it's never seen at the flag
  for (const picture of pictures(game, {}, seconds(30))) {
    const [flag] = told(picture, ' m');
    assert.ok(Math.abs(glass(picture)) < 0.98 * Math.abs(flag) && flag * told(picture, 'm/s')[0] > 0);
  }
for (const mass of ['10 kg', '50 kg']) { // from 10° to 26° it stays, at 27° it slips
  const pin = (degrees) => words(pictures('you guess', { mass }, ['', raised(degrees), ...seconds(4)]).at(-1)).filter((text) => text.includes(': '));
  assert.deepEqual([pin(26), pin(27)], [[], [`${mass}: 27°`]]);
}
{ // left alone, it doesn't slip, however long the board goes up and down
  const seen = pictures('you guess', {}, seconds(30));
  assert.ok(seen.every((picture) => told(picture, '°').every((degrees) => degrees <= 20)));
  assert.equal(new Set(seen.flatMap((picture) => told(picture, 'kg'))).size, 2);
}
{ // normal force and pull are equal at 45°, and not where the board is left alone
  const newtons = (degrees) => told(pictures('normal force (5.3)', {}, ['', raised(degrees), ...seconds(2)]).at(-1), ' N');
  assert.deepEqual(newtons(45), [71, 71, 100]);
  assert.deepEqual(newtons(60), [50, 87, 100]);
  assert.ok(pictures('normal force (5.3)', {}, seconds(20)).every((picture) => told(picture, ' N')[0] > told(picture, ' N')[1] + 10));
}
{ // held at 26°; it slips at 27°, gets slower below 16.7°, and between the two goes on
  const slides = (...then) => pictures('it slides (5.4)', {}, ['', raised(27), ...seconds(1.5), ...then]);
  assert.ok(words(pictures('it slides (5.4)', {}, ['', raised(26), ...seconds(3)]).at(-1)).includes('held'));
  for (const [degrees, slower] of [[16, true], [18, false], [25, false]]) {
    const seen = slides(raised(degrees), ...seconds(0.9)), [before, after] = [seen.at(-36), seen.at(-1)].map((picture) => told(picture, 'm/s')[0]);
    assert.ok(before > 1 && (slower ? after < before : after > before), `${degrees}°: ${before}, then ${after}`);
  }
}
{ // the violet line is at 45° if mu_s is 1; one degree below it the box stays, one above it slips
  const seen = (mu_s, degrees) => pictures('critical angle (5.5)', { mu_s }, ['', raised(degrees), ...seconds(4)]);
  assert.ok(told(seen(1, 10)[0], '°').includes(45));
  const crate = ({ shapes }) => shapes.findLast(({ kind, colour }) => kind === 'area' && colour === 'wood').points[0];
  const moves = (degrees) => Math.hypot(...[0, 1].map((k) => crate(seen(1, degrees)[150])[k] - crate(seen(1, degrees).at(-1))[k])) > 0.5;
  assert.deepEqual([moves(44), moves(46)], [false, true]);
}
{ // the puck's path is as long as 5.1 says, borders and all; both end in one place along the axes only
  const seen = (x, y) => pictures('air hockey (5.6)', {}, ['', [0, x, y], ...seconds(6.2)]);
  const at = seen(-2, 4.7).map(ball('orange')), way = at.slice(2).reduce((sum, [x, y], i) => sum + Math.hypot(x - at[i + 1][0], y - at[i + 1][1]), 0);
  near(way, 18, 0.1);
  const end = (x, y) => words(seen(x, y).at(-1)).join();
  for (const [x, y] of [[8, 1.7], [-6, 7], [-8, 1.7], [-6, 0]]) assert.equal(end(x, y), 'in one place');
  for (const [x, y] of [[-2, 5.7], [-2, 4.7], [-2, 2], [-8, 7]]) assert.match(end(x, y), / m apart$/);
  assert.ok(!pictures('air hockey (5.6)', {}, seconds(60)).some((picture) => words(picture).includes('in one place')));
}
for (const [speed, time] of [[0.2, 2], [0.4, 1]]) // twice as fast, half as long
  assert.ok(words(pictures('stick and slip (5.8)', { 'pulled at': speed }, seconds(12)).at(-1)).includes(`stuck for ${time}.00 s`));
