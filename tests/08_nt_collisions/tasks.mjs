// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import { near, player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]), { last } = demo;
const pictures = (game, chosen, keys) => demo.pictures(demo.values({ 'The game': game, ...chosen }), keys);
const frames = (game, chosen, keys) => demo.readouts(demo.values({ 'The game': game, ...chosen }), keys);
const words = ({ shapes }) => shapes.filter(({ kind }) => kind === 'words').map(({ text }) => text);
const numbers = (picture, unit) => words(picture).filter((text) => text.endsWith(unit)).map((text) => parseFloat(text.replace('−', '-')));
const arrow = ({ shapes }, colour) => shapes.find((each) => each.kind === 'arrow' && each.colour === colour).points;
const direction = ([[a, b], [x, y]]) => Math.atan2(y - b, x - a) * 180 / Math.PI;

{ // the two balls of the opening: left alone, no arrow says where they go; with guesses that are right, nothing is off
  const truth = [direction([[0, 0], [1.8, -2.4]]), direction([[0, 0], [3.2, 2.4]])];
  for (const picture of pictures('you guess', {}, seconds(10))) {
    assert.ok(!words(picture).some((text) => /off|m\/s/.test(text)));
    ['orange', 'blue'].forEach((colour, i) => assert.ok(Math.abs(direction(arrow(picture, colour)) - truth[i]) > 30));
  }
  const seen = pictures('you guess', {}, [[0, -0.8 + 1.2, -0.6 - 1.6], [1, 1.6, 1.2], 'f', ...seconds(2)]).at(-1);
  assert.deepEqual(numbers(seen, '° off'), [0, 0]);
  assert.deepEqual(numbers(seen, 'm/s'), [3, 4]);
}
{ // *New* is another contact, and the last five guesses stay as dots, for each of the balls
  const round = ['f', ...Array(119).fill(''), 's'], seen = pictures('you guess', {}, Array(7).fill(round).flat());
  const after = (turn) => seen[121 * turn + 119], dots = ({ shapes }) => shapes.filter(({ kind, size }) => kind === 'discs' && size === 0.1).length;
  assert.deepEqual([0, 1, 4, 5, 6].map((turn) => dots(after(turn))), [2, 4, 10, 10, 10]);
  assert.equal(new Set([0, 1, 2, 3, 4, 5, 6].map((turn) => String(numbers(after(turn), 'm/s')))).size, 7);
}
{ // B straight ahead, above, behind, and where both components are the same
  const turned = (x, y) => numbers(pictures('contact that turns (8.1)', {}, [[0, x, y], ...seconds(1)]).at(-1), 'm/s');
  near(turned(3, 0)[0], 5);
  near(turned(0, 3)[0], 0);
  assert.ok(turned(-3, 1)[0] < 0);
  near(turned(3, -3)[0], turned(3, -3)[1]);
  // left alone, B is never there, and no number is told
  for (const picture of pictures('contact that turns (8.1)', {}, seconds(10))) {
    assert.deepEqual(numbers(picture, 'm/s'), []);
    const angle = direction(arrow(picture, 'pink'));
    assert.ok(angle > 10 && angle < 75);
  }
}
// A is dragged until B is so much higher, in the sum of both radii
const comes = (off, reach = 1) => [[0, -5.8, -off * reach], ...seconds(1.5)];
for (const off of [0.3, -0.6, 0.9]) { // a right angle, as long as B rests
  const angle = (velocity) => numbers(pictures('equal balls (8.2)', { 'velocity of B': velocity }, comes(off)).at(-1), '°')[0];
  near(angle(0), 90, 0.05);
  assert.ok(Math.abs(angle(-2) - 90) > 5);
}
assert.deepEqual(numbers(pictures('equal balls (8.2)', {}, comes(0)).at(-1), '°'), []); // head on, A stops
assert.ok(pictures('equal balls (8.2)', {}, seconds(10)).every((picture) => numbers(picture, '°').length === 0));
{ // put into each other, they get free
  const seen = pictures('equal balls (8.2)', {}, ['o', ...seconds(1)]);
  assert.ok(numbers(seen[0], 'm apart')[0] < 1 && numbers(seen.at(-1), 'm apart')[0] > 1.5);
}
const reach = (a, b) => 0.42 * (Math.cbrt(a) + Math.cbrt(b));
for (const restitution of [1, 0.5, 0]) { // what never changes, and what does
  for (const [chosen, off] of [[{ 'mass of A': 2, 'mass of B': 7 }, 0.6], [{ 'velocity of B': -3 }, -0.3]]) {
    const { 'mass of A': a = 2, 'mass of B': b = 3 } = chosen;
    const [before, after] = frames('masses (8.3)', { restitution, ...chosen }, [...comes(off, reach(a, b)), ...seconds(0.5)]);
    near(after['momentum, to the right'], before['momentum, to the right'], 1e-5);
    near(after['momentum, up'], before['momentum, up'], 1e-5);
    assert.equal(after.lost < 1e-5, restitution === 1);
    near(after.lost, before['kinetic energy'] - after['kinetic energy'], 1e-5);
  }
}
{ // head on, A stops if B weighs the same
  const ball = ({ shapes }) => shapes.find(({ kind, colour, material }) => kind === 'discs' && colour === 'orange' && material === 'solid').points[0];
  const goes_on = (mass) => {
    const seen = pictures('masses (8.3)', { restitution: 1, 'mass of A': 2, 'mass of B': mass }, comes(0)).slice(-2).map(ball);
    return seen[1][0] - seen[0][0];
  };
  near(goes_on(2), 0, 1e-9);
  assert.ok(goes_on(1.5) > 0.001 && goes_on(2.5) < -0.001);
}
{ // the break shot: nothing is lost with 1; left alone, nothing is told
  const lost = (restitution) => numbers(pictures('break shot (8.3)', { restitution }, ['f', ...seconds(2)]).at(-1), 'J lost')[0];
  assert.equal(lost(1), 0);
  assert.ok(lost(0.5) > lost(0.9) && lost(0.9) > 1);
  assert.ok(pictures('break shot (8.3)', {}, seconds(5)).every((picture) => numbers(picture, 'J lost').length === 0));
}
{ // only in frames, a slow ball is caught and some fast ones get through; between frames none does
  const said = (contact, speed) => new Set(pictures('between frames (8.4)', { contact, speed }, seconds(9)).flatMap(words).filter((text) => /caught|through/.test(text)));
  const speeds = Array.from({ length: 19 }, (_, i) => 10 + 5 * i);
  const missed = speeds.filter((speed) => said('only in frames (8.3)', speed).has('through!'));
  console.log(`only in frames, B is missed at ${missed.join(', ')} m/s`);
  assert.equal(missed[0], 65);
  for (const speed of speeds) assert.deepEqual([...said('between frames (8.4)', speed)], ['caught'], `${speed} m/s`);
}
{ // ten balls dropped on one place: they get free of each other, within half a second
  const away = [0, -6, 0];
  const dropped = frames('pushed apart (8.5)', {}, [away, ...seconds(0.5).slice(1), 'n', ...seconds(6)]);
  assert.equal(dropped.at(-1).balls, 50);
  assert.ok(dropped[0]['deepest overlap'] < 0.005, `${dropped[0]['deepest overlap']}`);
  console.log('dropped', dropped.map((each) => each['deepest overlap']));
  const through = [...Array(120)].map((_, i) => [0, -6 + 0.1 * i, 0]);
  console.log('through', frames('pushed apart (8.5)', {}, [...through, ...seconds(2)]).map((each) => each['deepest overlap']));
}
{ // a thousand balls: few close pairs, and the kinetic energy stays
  const seen = frames('a thousand (8.6)', { balls: 1000 }, seconds(3));
  assert.equal(seen[0]['pairs in all'], 499500);
  console.log('close', seen.map((each) => each['close pairs']));
  assert.ok(seen.every((each) => each['close pairs'] < 100));
  near(seen[2]['kinetic energy'], seen[0]['kinetic energy'], 1e-4);
}
