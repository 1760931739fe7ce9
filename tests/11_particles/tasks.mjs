// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import { player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
const pictures = (game, chosen, keys) => demo.pictures(demo.values({ 'The game': game, ...chosen }), keys);
const words = ({ shapes }) => shapes.filter(({ kind }) => kind === 'words').map(({ text }) => text);
// Lamps of slots that are taken; and sparks: a tail of two follows each, so that it's the first of three.
const taken = ({ shapes }) => shapes.filter(({ kind, colour, material }) => kind === 'discs' && ['blue', 'orange'].includes(colour) && material === 'flat').map(({ points }) => points.length);
const lights = ({ shapes }) => shapes.filter(({ material }) => material === 'light').flatMap(({ points }) => points);
const sparks = (picture) => lights(picture).filter((_, i) => i % 3 === 0);
const press = (x, y) => [-1, x, y];

{ // left alone, it never fills the pool; pressed again and again, all 150 slots are taken, and the others are lost
  assert.ok(pictures('a firework', {}, seconds(60)).every((picture) => words(picture).length === 0 && taken(picture)[0] < 150));
  const presses = Array.from({ length: 5 }, () => press(12, 8));
  const seen = pictures('a firework', {}, ['', ...presses, '']);
  assert.ok(taken(seen[0])[0] >= 44);
  assert.equal(taken(seen.at(-1))[0], 150);
  assert.match(words(seen.at(-1)).join(), /^lost [1-9]\d*$/);
  assert.equal(pictures('a firework', {}, ['', ...presses, ...seconds(0.2)]).at(-1).shapes.find(({ kind, colour }) => kind === 'discs' && colour === 'dim').points.length > 20, true);
}
{ // three sparks a press: amber first, then orange, pink and violet, and a lamp for each of eight shades
  const seen = pictures('colours (11.2)', {}, seconds(2.3));
  const colours = seen.map(({ shapes }) => shapes.find(({ material }) => material === 'light')?.colour);
  assert.deepEqual([...new Set(colours.filter(Boolean))], ['amber', 'orange', 'pink', 'violet']);
  const lit = seen.map(({ shapes }) => shapes.find(({ kind, material }) => kind === 'area' && material === 'solid')?.points[0][0]);
  assert.equal(new Set(lit.filter(Boolean)).size, 8);
}
{ // each lives for 1.5 s: twice a second are at most 9 to 12 at a time, of 60
  const twice = Array.from({ length: 300 }, (_, i) => (i % 30 === 0 ? press(12, 6) : ''));
  assert.match(words(pictures('three sparks (11.3)', {}, twice).at(-1)).join(), /^at most (9|10|11|12)$/);
}
{ // in the wind the ring stays round, and moves; the first try is square
  const middle = (points, k) => points.reduce((sum, point) => sum + point[k], 0) / points.length;
  const away = (points) => points.map(([x, y]) => Math.hypot(x - middle(points, 0), y - middle(points, 1)));
  const all = (wind) => lights({ shapes: pictures('a ring (11.4)', { wind }, seconds(1)).at(-1).shapes.slice(1) }).filter((_, i) => i % 3 === 0);
  const [still, blown] = [0, 3].map((wind) => all(wind).slice(60));
  assert.equal(still.length, 48);
  for (const points of [still, blown]) assert.ok(Math.max(...away(points)) - Math.min(...away(points)) < 0.01);
  assert.ok(middle(blown, 0) > middle(still, 0) + 0.4);
  const square = away(all(0).slice(0, 60));
  assert.ok(Math.max(...square) - Math.min(...square) > 1);
}
{ // a quarter of the disc has a quarter of yours, and about half of the mistake's
  const [yours, mistake] = words(pictures('a disc (11.5)', {}, seconds(1.5)).at(-1)).filter((text) => text.endsWith('in the middle')).map(parseFloat);
  assert.ok(yours > 17 && yours < 33 && mistake > 40, `${yours} and ${mistake}`);
}
{ // 30 a second are as many at 10 frames a second as at 144; one a frame aren't
  const count = (rate) => words(pictures('a trail (11.7)', { 'frames per second': rate }, seconds(4)).at(-1)).filter((text) => text.endsWith('sparks')).map(parseFloat);
  const [slow, fast] = [count(10), count(144)];
  assert.ok(fast[0] > 8 * slow[0] && Math.abs(fast[1] - slow[1]) < 15, `${slow} and ${fast}`);
}
{ // sparks stay above the floor and the roof, and come down along it
  const above = ([x, y]) => y - (x < 8 ? 0.3 : 0.3 + ((x - 8) * 5.8) / 16);
  const low = [0.5, 1, 1.5, 2].map((time) => {
    const last = sparks(pictures('with walls (11.8)', {}, ['', press(17, 9), ...seconds(time)]).at(-1));
    assert.ok(last.length > 10 && last.every((at) => above(at) > -1e-6));
    return last.reduce((sum, at) => sum + at[0], 0) / last.length;
  });
  assert.ok(low[3] < low[1] - 1, `${low}`);
}
{ // both pools hold as many, and only one has gaps
  const rows = pictures('without gaps (11.9)', {}, seconds(6)).map((picture) => picture.shapes.filter(({ kind, colour, material }) => kind === 'discs' && ['blue', 'orange'].includes(colour) && material === 'flat').map(({ points }) => points.map(([x]) => x)));
  const gaps = (row) => row.some((x, i) => i > 0 && x - row[i - 1] > 0.5);
  assert.ok(rows.every(([slots, packed]) => slots.length === packed.length));
  assert.ok(rows.some(([slots]) => gaps(slots)) && !rows.some(([, packed]) => gaps(packed)));
}
{ // the machine loses none of its 624 sparks; two rockets a second come to 900 points, eight lose most of theirs
  const ends = (keys) => words(pictures('a whole show (11.10)', {}, keys).at(-1)).find((text) => /shown/.test(text));
  assert.match(ends(seconds(24)), /^624 shown, 0 lost, [5-9]\d at one time$/);
  const fire = (every) => ends(Array.from({ length: 24 * 60 }, (_, i) => (i % every === 0 ? press(4 + ((i * 7) % 16), 5 + ((i * 3) % 5)) : '')));
  const [shown, lost] = fire(30).match(/\d+/g).map(Number), [, often] = fire(8).match(/\d+/g).map(Number);
  assert.ok(shown - 2 * lost >= 900 && often > 1000, `${shown}, ${lost}, ${often}`);
}
