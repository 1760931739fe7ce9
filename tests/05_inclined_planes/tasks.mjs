// tasks.mjs NATIVE: what the chapter says of its demo: where things stop, slip, come back and stick.
import assert from 'node:assert';
import { near, player, seconds } from '../play/rows.mjs';

const { last } = player(process.argv[2]);
const raised = (count) => Array(count).fill('u');

for (const velocity of [6, -6, 3.5]) { // pushed at once: it stops at the flag, and stays
  const seen = last({ 'The game': 'it stops (5.2)', velocity }, ['f', ...seconds(4)]);
  assert.equal(seen['puck is at'].toFixed(2), seen['stops at (5.1)'].toFixed(2));
  assert.equal(seen.velocity, 0);
}
{ // without 5.2 it comes back from there
  const seen = last({ 'The game': 'it slows (5.1)' }, ['f', ...seconds(4)]);
  near(seen['puck is at'], 8, 0.1);
  assert.ok(seen.velocity < 0);
}
for (const mass of [10, 50]) { // from 10° to 26° it stays, at 27° it slips
  const values = { 'The game': 'it slides (5.4)', mass };
  assert.equal(last(values, [...raised(16), ...seconds(3)]).speed, 0);
  assert.ok(last(values, [...raised(17), ...seconds(1)]).speed > 0.5);
}
{ // lowered to 16° while it slides, it gets slower again, and stops
  const keys = [...raised(17), ...seconds(1), ...Array(11).fill('d')], values = { 'The game': 'it slides (5.4)' };
  assert.ok(last(values, [...keys, ...Array(32).fill('')]).speed > last(values, [...keys, ...Array(32).fill(''), ...seconds(1)]).speed);
}
near(last({ 'The game': 'critical angle (5.5)', mu_s: 1 }, seconds(1))['critical angle (5.5)'], 45);
{ // normal force and pull are equal at 45°
  const seen = last({ 'The game': 'normal force (5.3)' }, [...raised(35), ...seconds(1)]);
  near(seen['normal force'], seen.pull);
}
{ // half as fast at 37°; from 26° it does not come back
  const values = { 'The game': 'up and back (5.7)', mu_k: 0.45 };
  const seen = last(values, [...raised(27), 'f', ...seconds(6)]);
  assert.equal(seen['came back at'].toFixed(2), seen['back (5.7)'].toFixed(2));
  near(seen['came back at'], 3, 0.02);
  const stays = last(values, [...raised(16), 'f', ...seconds(6)]);
  assert.equal(stays['box is at'].toFixed(2), stays['up (5.7)'].toFixed(2));
}
{ // the puck's path is as long as 5.1 says, borders and all
  const seen = last({ 'The game': 'air hockey (5.6)' }, ['f', ...seconds(8)]);
  assert.equal(seen['puck has slid'].toFixed(2), seen['stops after (5.1)'].toFixed(2));
  assert.equal(seen['its speed'], 0);
}
near(last({ 'The game': 'stick and slip (5.8)' }, seconds(12))['stuck last time for'], 2, 0.01);
near(last({ 'The game': 'stick and slip (5.8)', 'pulled at': 0.4 }, seconds(12))['stuck last time for'], 1, 0.01);
