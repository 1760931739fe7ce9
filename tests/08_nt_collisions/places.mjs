// places.mjs NATIVE: each picture is high enough on a phone, and the ghost of the opening doesn't roll the balls.
import assert from 'node:assert';
import { film, heightOnPhone, placesOf } from '../play/places.mjs';

const program = process.argv[2];
for (const start of placesOf('08_nt_collisions')) assert.ok(heightOnPhone(film(program, start)) >= 220, start);
assert.ok(film(program, '').every(({ readouts }) => !readouts.some(({ name }) => name === 'A off by')));
