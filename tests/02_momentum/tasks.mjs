// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import { near, player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
// The pictures of a scene whose controls are so; what stands in one, and the numbers with a unit among that.
const pictures = (game, chosen, keys) => demo.pictures(demo.values({ 'The game': game, ...chosen }), keys);
const words = ({ shapes }) => shapes.filter(({ kind }) => kind === 'words').map(({ text }) => text);
const numbers = (picture, unit) => words(picture).map((text) => new RegExp(`(?:^| )(−?[\\d.]+) ${unit}$`).exec(text)?.[1]).filter(Boolean).map((text) => Number(text.replace('−', '-')));
const last = (game, chosen, keys) => pictures(game, chosen, keys).at(-1);
const masses = (a, b, more = {}) => ({ 'mass of A': a, 'mass of B': b, ...more });

{ // the carts leave as the arrows say, and roll through each other as long as these are those before
  const after = (a, b) => numbers(last('you guess', {}, ['', [0, 4 + 0.28 * a, 3], [1, 8 + 0.28 * b, 3], ...seconds(1)]), 'm/s').slice(-2);
  assert.deepEqual(after(4, -2), [4, -2]);
  assert.deepEqual(after(-3.2, 2.8), [-3.2, 2.8]);
  assert.ok(pictures('you guess', {}, seconds(30)).every((picture) => !words(picture).some((text) => text.includes('−3.2'))));
}
{ // the same net force: equal masses tie, and others don't; straight up, or against each other, nothing moves
  const pull = (a, b, ropes) => pictures('ropes (2.1)', masses(a, b), ['', [0, 1.8 + 0.075 * ropes[0], 0.33 + 0.075 * ropes[1]], [1, 1.8 + 0.075 * ropes[2], 0.33 + 0.075 * ropes[3]], ...seconds(3)]);
  const times = (a, b) => numbers(pull(a, b, [8, 6, -2, 10]).findLast((picture) => numbers(picture, 's').length === 2), 's');
  assert.equal(...times(3, 3));
  const [light, heavy] = times(2, 3);
  near(heavy / light, Math.sqrt(3 / 2), 0.02);
  for (const ropes of [[0, 28, 0, 28], [-25, 5, 25, -2]]) {
    const seen = pull(2, 3, ropes);
    assert.equal(numbers(seen.at(-1), 'N')[0], 0);
    assert.deepEqual(seen.at(-1).shapes, seen[3].shapes);
  }
  near(7.5 / 2.5, 6 / 2), near(5 / 2.5, 6 / 3);
}
{ // both are right in two places: where the carts come from, so that they roll on through each other, and where they bounce
  const sums = (a, b) => {
    const at = [0, 7 + (2.45 / 6) * a, 4.3 + (2.45 / 6) * b], seen = last('drag the point', {}, ['', at, at, '']);
    return [...numbers(seen, 'N s'), ...numbers(seen, 'J')];
  };
  for (const [a, b] of [[4, -2], [-3.2, 2.8]]) assert.deepEqual(sums(a, b), [2, 22]);
  for (const [a, b] of [[-2, 4], [0.4, 0.4], [2, 2.8]]) assert.notDeepEqual(sums(a, b), [2, 22]);
  const seen = last('drag the point', {}, ['']).shapes, line = seen.find(({ kind, colour }) => kind === 'line' && colour === 'violet').points;
  const ellipse = seen.find(({ kind, colour }) => kind === 'line' && colour === 'orange').points;
  const side = ([x, y]) => (line[1][0] - line[0][0]) * (y - line[0][1]) - (line[1][1] - line[0][1]) * (x - line[0][0]) > 0;
  assert.equal(ellipse.filter((point, i) => i > 0 && side(point) !== side(ellipse[i - 1])).length, 2);
  for (const picture of pictures('drag the point', {}, seconds(20))) assert.notDeepEqual([...numbers(picture, 'N s'), ...numbers(picture, 'J')], [2, 22]);
}
{ // twice as heavy as B, A stops dead; heavier, and it rolls on
  const after = (a, b) => numbers(last('rubber (2.2)', masses(a, b), seconds(1.5)), 'm/s');
  assert.deepEqual(after(2, 3), [-3.2, 2.8]);
  assert.equal(after(6, 3)[0], 0), assert.equal(after(4, 2)[0], 0);
  assert.ok(after(6.5, 3)[0] > 0 && after(5.5, 3)[0] < 0);
}
{ // its point never leaves the line of momentum; as clay, 1 and 2 kg lose all, and 10 and 0.5 kg little more than a tenth
  for (const restitution of [0, 0.25, 0.5, 0.75, 1])
    for (const picture of pictures('rubber to clay (2.3)', { restitution }, seconds(2))) assert.deepEqual(numbers(picture, 'N s'), [2]);
  const lost = (a, b, restitution = 0) => numbers(last('rubber to clay (2.3)', masses(a, b, { restitution }), seconds(1.5)), '%')[0];
  assert.deepEqual([lost(1, 2), lost(10, 0.5), lost(2, 3, 1)], [100, 11, 0]);
  assert.deepEqual(numbers(last('rubber to clay (2.3)', { restitution: 0.5 }, seconds(1.5)), 'm/s'), [-1.4, 1.6]);
}
{ // momentum changes at a wall; in three hits the light cart turns the heavy one around
  const seen = pictures('between walls (2.5)', {}, seconds(4)), momenta = new Set(seen.map((picture) => numbers(picture, 'N s')[0]));
  assert.ok(momenta.has(2) && momenta.size > 1);
  assert.ok(words(last('between walls (2.5)', masses(0.5, 10), seconds(4))).includes('3 hits, and B turns'));
}
{ // as many leave as were lifted, and of those between none moves; of three, the third one never stops
  const rest = [4, 5, 6, 7, 8], moved = (lifted) => {
    const balls = pictures('cradle (2.6)', { lifted }, seconds(2.1)).map(({ shapes }) => shapes.find(({ kind, material }) => kind === 'discs' && material === 'solid').points.map(([x], i) => x - rest[i]));
    return rest.map((_, i) => [Math.min(...balls.map((each) => each[i])), Math.max(...balls.map((each) => each[i]))]);
  };
  for (const [count, lifted] of [[1, 'one ball'], [2, 'two balls'], [3, 'three balls']])
    moved(lifted).forEach(([left, right], i) => {
      assert.equal(left < -1, i < count, `ball ${i} of ${lifted}: ${left}`);
      assert.equal(right > 1, i >= 5 - count, `ball ${i} of ${lifted}: ${right}`);
      if (i >= count && i < 5 - count) assert.ok(right - left < 0.01, `ball ${i} of ${lifted} moves`);
    });
}
