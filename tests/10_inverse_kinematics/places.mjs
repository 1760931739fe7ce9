// places.mjs NATIVE: what moves or answers fills a third of each picture, which is high enough on a phone.
import assert from 'node:assert';
import { filled, film, heightOnPhone, placesOf } from '../play/places.mjs';

const program = process.argv[2];
for (const start of placesOf('10_inverse_kinematics')) {
  const pictures = film(program, start), part = filled(pictures), high = heightOnPhone(pictures);
  console.log(`${(100 * part).toFixed(0)} %, ${high.toFixed(0)} px: ${start || 'the opening'}`);
  assert.ok(part >= 1 / 3, `${start}: what moves fills ${(100 * part).toFixed(0)} % of the picture, a third is wanted`);
  assert.ok(high >= 196, `${start}: ${high.toFixed(0)} px high on a phone`);
}
