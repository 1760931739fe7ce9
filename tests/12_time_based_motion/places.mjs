// places.mjs NATIVE: what moves or answers fills a third of each picture, which is high enough on a phone; and the film
// of the opening gives nothing away.
import assert from 'node:assert';
import { filled, film, heightOnPhone, placesOf } from '../play/places.mjs';

const program = process.argv[2], places = placesOf('12_time_based_motion');
assert.equal(places.length, 8);
for (const start of places) {
  const pictures = film(program, start, start === '' ? 'f' : undefined), part = filled(pictures), high = heightOnPhone(pictures);
  console.log(`${(100 * part).toFixed(0)} %, ${high.toFixed(0)} px: ${start || 'the opening'}`);
  assert.ok(part >= 1 / 3, `${start}: what moves fills ${(100 * part).toFixed(0)} % of the picture, a third is wanted`);
  assert.ok(high >= 196, `${start}: ${high.toFixed(0)} px high on a phone`);
}
{ // where your ship is then is told only after the reader asks for it, and the film's guess isn't near
  const opening = film(program, ''), guesses = opening.map(({ shapes }) => shapes.find(({ kind }) => kind === 'handle').points[0][0]);
  assert.ok(opening.every(({ readouts, shapes }) => readouts.length === 0 && !shapes.some(({ text }) => /off|at \d/.test(text))));
  assert.ok(new Set(guesses).size > 50 && guesses.every((x) => Math.abs(x - 333) > 50), `${Math.min(...guesses)}`);
  assert.ok(opening.every(({ shapes }) => !shapes.some(({ kind, colour }) => kind === 'area' && colour === 'orange')));
  assert.ok(film(program, '', 'f').at(-1).shapes.some(({ kind, colour }) => kind === 'area' && colour === 'orange'));
}
{ // left alone, the runner runs past every cactus in its film
  const run = film(program, 'The game: run and jump (12.4)'), said = run.map(({ shapes }) => shapes.map(({ text }) => text));
  assert.ok(!said.flat().includes('ouch') && said.at(-1).some((text) => /^2\d m$/.test(text)), said.at(-1).join());
}
