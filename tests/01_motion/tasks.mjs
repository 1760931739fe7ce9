// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import { player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
// The pictures of a scene whose controls are so; what stands in one.
const pictures = (game, chosen, keys) => demo.pictures(demo.values({ 'The game': game, ...chosen }), keys);
const words = ({ shapes }) => shapes.filter(({ kind }) => kind === 'words').map(({ text }) => text);
const last = (game, chosen, keys) => words(pictures(game, chosen, keys).at(-1));
const press = [-1, 300, 200];

{ // the four frames alone don't tell the fifth; the rings do, where they should be; the helicopter's marks are even
  assert.ok(pictures('you guess', {}, seconds(30)).every((picture) => !words(picture).some((text) => ['82', '95'].includes(text))));
  const guessed = (fifth, sixth) => last('you guess', {}, ['', [0, fifth, 8], [1, sixth, 8], 'f', ...seconds(6)]);
  assert.deepEqual(guessed(82, 95).filter((text) => text === 'right').length, 2);
  for (const text of ['50', '55', '62', '71', '82', '95', '5 short', '3 too far']) assert.ok(guessed(77, 98).includes(text), text);
  const { points } = pictures('you guess', {}, seconds(3.5)).at(-1).shapes.find(({ kind, colour }) => kind === 'discs' && colour === 'blue');
  assert.deepEqual(points.map(([x], i) => i && x - points[i - 1][0]), [0, 4, 4, 4]);
}
{ // 640 px at 120 px/s take 5.33 s, and half of that at 60 frames a second; nobody is told before a touch
  const race = (rate, keys) => last('a speed (1.1)', { 'lower frame rate': rate }, keys);
  const both = race(60, ['', press, ...seconds(6)]);
  for (const text of ['120 px/s', '240 px/s', '5.33 s', '2.67 s']) assert.ok(both.includes(text), `${text}: ${both}`);
  assert.ok(!race(20, seconds(6)).some((text) => text.endsWith(' s')));
}
{ // it leaves the screen after 5.17 s, and comes back on the left; (135, 42.5) px/s takes it to the lamp
  const across = last('across the screen (1.2)', {}, ['', press, ...seconds(7)]);
  assert.ok(across.includes('5.17 s') && across.includes('(120, 0) px/s'), `${across}`);
  assert.ok(last('across the screen (1.2)', {}, ['', [0, 155, 122.5], '']).includes('in time'));
  assert.ok(pictures('across the screen (1.2)', {}, seconds(30)).every((picture) => !words(picture).includes('5.17 s') && !words(picture).includes('in time')));
}
{ // the missile's gaps grow while its engine runs, and not without; the helicopter's never do
  const gaps = (colour, burning, free) => {
    const seen = pictures('a chase (1.3)', {}, ['', ...Array(60 * burning).fill(press), ...seconds(free)]).at(-1);
    return seen.shapes.filter((shape) => shape.kind === 'words' && shape.colour === colour).map(({ text }) => Number(text));
  };
  assert.deepEqual(gaps('orange', 1.5, 0), [50, 70, 90, 110]);
  assert.deepEqual(gaps('orange', 1, 0.5).slice(2), [90, 100]);
  assert.deepEqual(gaps('orange', 1, 1.5).slice(-2), [100, 100]);
  assert.deepEqual(gaps('blue', 1, 0.5), [40, 40, 40, 40]);
}
{ // broken or not, at any time, the cross is on the path of the unbroken missile
  const flights = pictures('it breaks (1.4)', {}, ['', ...seconds(0.3), press, ...seconds(9), 'b', ...seconds(2)]);
  assert.ok(flights.some((picture) => words(picture).includes('1 kg')) && flights.some((picture) => words(picture).length === 0));
  for (const { shapes } of flights) {
    const [[left, y], [right]] = shapes.find(({ kind, colour, points }) => kind === 'line' && colour === 'blue' && points.length === 2).points;
    const t = ((left + right) / 2 - 1) / 13;
    assert.ok(Math.abs(1 + 15 * t - 5 * t * t - y) < 1e-6);
  }
}
{ // semi-implicit Euler is ahead, explicit Euler behind, and half a step halves both distances
  for (const [step, px] of [[1, 100], [0.5, 50], [0.25, 25], [0.05, 5]]) {
    const seen = pictures('three integrators (1.5)', { step }, seconds(3)).at(-1).shapes.filter(({ kind }) => kind === 'words');
    const far = (words, name) => assert.equal(seen.find(({ text }) => text === words)?.colour, seen.find(({ text }) => text === name).colour);
    far(`${px} px ahead`, 'semi-implicit Euler'), far(`${px} px behind`, 'explicit Euler');
  }
}
{ // the L balances at (1.1, 1.1); ball and cross may meet; a corner that's moved along a side moves the cross farther
  const spots = (...drags) => last('a plate (1.6)', {}, ['', [-1, 4, 3], ...drags, '']).map((text) => text.match(/-?[\d.]+/g).map(Number));
  assert.deepEqual(spots(), [[1.1, 1.1], [1.33, 1.33]]);
  const [ball, cross] = spots([1, 2, 0], [3, 3, 3], [5, 0, 2]);
  assert.deepEqual(ball, cross);
  const [here, there] = [spots([5, 0.2, 0.6]), spots([5, 0.8, 2.4])]; // on a straight line from the corner before to the one after
  assert.deepEqual(here[0], there[0]);
  assert.ok(there[1][1] - here[1][1] > 0.25);
  const line = Array.from({ length: 6 }, (_, i) => [i, i, 1]);
  assert.ok(last('a plate (1.6)', {}, ['', ...line, ...line, '']).some((text) => text.startsWith('no area')));
}
{ // the three sightings of the text; evenly, there's no acceleration; bent down, it's negative; they keep their order
  const found = (...drags) => last('three sightings (1.7)', {}, ['', [-1, 55, 5], ...drags, '']).filter((text) => text.includes('m/s'));
  assert.deepEqual(found(), ['2.0 m/s²', 'at 0 s: 3.0 m, 2.0 m/s']);
  assert.deepEqual(found([2, 40, 21]), ['0.0 m/s²', 'at 0 s: 1.0 m, 5.0 m/s']);
  assert.match(found([2, 40, 16])[0], /^−/);
  for (const drag of [[0, 99, 6], [2, -9, 6]]) assert.equal(found(drag, drag).length, 2);
  assert.ok(pictures('three sightings (1.7)', {}, seconds(30)).every((picture) => words(picture).some((text) => /^[1-9].* m\/s²$/.test(text))));
}
