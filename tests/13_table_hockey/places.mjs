// places.mjs NATIVE: what moves fills a third of each picture, which is high enough on a phone; it plays before anybody
// does.
import assert from 'node:assert';
import { filled, film, heightOnPhone, placesOf } from '../play/places.mjs';

const program = process.argv[2], all = ['', 'The game: two players', 'The game: machine against machine', 'The well: on'];
for (const start of new Set([...all, ...placesOf('13_table_hockey')])) {
  const pictures = film(program, start), part = filled(pictures), high = heightOnPhone(pictures);
  console.log(`${(100 * part).toFixed(0)} %, ${high.toFixed(0)} px: ${start || 'the opening'}`);
  assert.ok(part >= 1 / 3, `${start}: what moves fills ${(100 * part).toFixed(0)} % of the picture, a third is wanted`);
  assert.ok(high >= 220, `${start}: ${high.toFixed(0)} px high on a phone`);
  const hits = pictures.filter(({ shapes }) => shapes.some(({ kind, material }) => kind === 'discs' && material === 'glow'));
  assert.ok(hits.length > 10, `${start}: nobody hits the disc`);
}
