// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import { near, player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]), { last } = demo;
const frames = (game, chosen, keys) => demo.readouts(demo.values({ 'The game': game, ...chosen }), keys);

{ // the two balls of the opening, and two guesses that are right
  const rolled = ['f', ...seconds(1.5).slice(1), ...seconds(0.5)];
  const guessed = [[0, -0.8 + 1.2, -0.6 - 1.6], [1, 1.6, 1.2], ...rolled];
  const seen = last({}, [...guessed, ...seconds(1)].slice(0, 120));
  near(seen['A, to the right'], 1.8, 1e-6);
  near(seen['A, up'], -2.4, 1e-6);
  near(seen['B, to the right'], 3.2, 1e-6);
  near(seen['B, up'], 2.4, 1e-6);
  near(seen['A off by'], 0, 0.01);
  near(seen['B off by'], 0, 0.01);
}
{ // *New* is another contact, and the last five guesses stay as dots, for each of the balls
  const round = ['f', ...Array(119).fill(''), 's'], pictures = demo.pictures(demo.values({}), Array(7).fill(round).flat());
  const after = (turn) => pictures[121 * turn + 119], dots = ({ shapes }) => shapes.filter(({ kind, size }) => kind === 'discs' && size === 0.1).length;
  assert.deepEqual([0, 1, 4, 5, 6].map((turn) => dots(after(turn))), [2, 4, 10, 10, 10]);
  const contacts = [0, 1, 2, 3, 4, 5, 6].map((turn) => after(turn).readouts.find(({ name }) => name === 'B, up').value);
  near(contacts[0], 2.4, 1e-6);
  assert.equal(new Set(contacts).size, 7);
}
{ // B straight ahead, above, behind, and where both components are the same
  const turned = (x, y) => last({ 'The game': 'contact that turns (8.1)' }, [[0, x, y], ...seconds(1).slice(1)]);
  near(turned(3, 0).normal, 5);
  near(turned(0, 3).normal, 0);
  assert.ok(turned(-3, 1).normal < 0);
  near(turned(3, -3).normal, turned(3, -3).tangential);
  near(last({ 'The game': 'contact that turns (8.1)' }, [[0, 3, 0], ...Array(18).fill('u'), ...seconds(1)].slice(0, 60)).normal, 0, 0.01);
}
for (const off of [0.3, -0.6, 0.9]) { // a right angle, as long as B rests
  const angle = (velocity) => last({ 'The game': 'equal balls (8.2)', 'off centre': off, 'velocity of B': velocity }, seconds(2))['angle between'];
  near(angle(0), 90, 1e-3);
  assert.ok(Math.abs(angle(-2) - 90) > 5);
}
{ // put into each other, they get free
  const seen = frames('equal balls (8.2)', {}, ['o', ...seconds(2).slice(1)]);
  assert.ok(seen[1].distance > 1.5);
}
for (const restitution of [1, 0.5, 0]) { // what never changes, and what does
  for (const chosen of [{ 'mass of A': 2, 'mass of B': 7 }, { 'off centre': -0.3, 'velocity of B': -3 }]) {
    const [before, after] = frames('masses (8.3)', { restitution, ...chosen }, seconds(2));
    near(after['momentum, to the right'], before['momentum, to the right'], 1e-5);
    near(after['momentum, up'], before['momentum, up'], 1e-5);
    assert.equal(after.lost < 1e-5, restitution === 1);
    near(after.lost, before['kinetic energy'] - after['kinetic energy'], 1e-5);
  }
}
near(last({ 'The game': 'masses (8.3)', restitution: 1, 'off centre': 0, 'mass of A': 2, 'mass of B': 2 }, seconds(2))['A, to the right'], 0, 1e-6);
{ // the break shot: nothing is lost with 1
  const lost = (restitution) => last({ 'The game': 'break shot (8.3)', restitution }, ['f', ...seconds(2).slice(1)]).lost;
  near(lost(1), 0, 1e-5);
  assert.ok(lost(0.5) > lost(0.9) && lost(0.9) > 1);
}
{ // only in frames, a slow ball is caught and some fast ones get through; between frames none does
  const hit = (contact, speed) => {
    const seen = frames('between frames (8.4)', { contact, speed, restitution: 1 }, seconds(9));
    return seen.some((each) => each['B, to the right'] > 0.1);
  };
  const speeds = Array.from({ length: 19 }, (_, i) => 10 + 5 * i);
  const missed = speeds.filter((speed) => !hit('only in frames (8.3)', speed));
  console.log(`only in frames, B is missed at ${missed.join(', ')} m/s`);
  assert.equal(missed[0], 65);
  assert.deepEqual(speeds.filter((speed) => !hit('between frames (8.4)', speed)), []);
}
{ // ten balls dropped on one place: they get free of each other, within half a second
  const dropped = frames('pushed apart (8.5)', {}, [...seconds(0.5), 'n', ...seconds(6)]);
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
