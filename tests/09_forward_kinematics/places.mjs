// places.mjs NATIVE: what moves or answers fills a third of each picture, which is high enough on a phone; and
// the opening gives nothing away.
import assert from 'node:assert';
import { filled, film, heightOnPhone, hullArea, placesOf } from '../play/places.mjs';

assert.equal(hullArea([[0, 0], [2, 0], [1, 1], [2, 2], [0, 2], [1, 0.5]]), 4);

const program = process.argv[2], section = '09_forward_kinematics';
for (const start of placesOf(section)) {
  const pictures = film(program, start, start === '' ? 'f' : undefined), part = filled(pictures), high = heightOnPhone(pictures);
  console.log(`${(100 * part).toFixed(0)} %, ${high.toFixed(0)} px: ${start || 'the opening'}`);
  assert.ok(part >= 1 / 3, `${start}: what moves fills ${(100 * part).toFixed(0)} % of the picture, a third is wanted`);
  assert.ok(high >= 196, `${start}: ${high.toFixed(0)} px high on a phone`);
}
{ // the arm and how far off the guess is are seen only after the reader asks for them
  const opening = film(program, '');
  assert.ok(opening.every(({ shapes, readouts }) => readouts.length === 0 && !shapes.some(({ kind, material }) => kind === 'line' && material === 'solid')));
  assert.ok(film(program, '', 'f').at(-1).shapes.some(({ text }) => /^\d.* m off$/.test(text)));
}
