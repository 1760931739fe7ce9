// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import fs from 'node:fs';
import { player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
// The pictures of a scene whose controls are so, for so many seconds; what stands in one, as a number.
const pictures = (game, chosen, keys = seconds(7)) => demo.pictures(demo.values({ 'The game': game, ...chosen }), keys);
const words = ({ shapes }) => shapes.filter(({ kind }) => kind === 'words').map(({ text }) => text);
const told = (picture, unit) => words(picture).filter((text) => text.endsWith(` ${unit}`)).map((text) => Number(text.replace('−', '-').split(' ')[0]));
const shell = ({ shapes }) => shapes.filter(({ kind, colour, size, material }) => kind === 'discs' && colour === 'ink' && size === 1.2 && material === 'solid').at(-1)?.points[0] ?? [0, 0];
const range = (angle, height = 0) => told(pictures('range (4.3)', { angle, 'muzzle above the ground': height }, ['']).at(-1), 'm')[0];
const angles = (from, to) => Array.from({ length: to - from + 1 }, (_, i) => from + i);
const best = (among, value) => among.map((one) => [value(one), one]).reduce((one, other) => (other[0] > one[0] ? other : one))[1];

{ // the ring aims, and F fires: the flags say how far; 45° is the best on level ground, 37° on a cliff of 25 m
  const shot = (angle, height) => {
    const at = (far) => [0, far * Math.cos((angle * Math.PI) / 180), height + far * Math.sin((angle * Math.PI) / 180)];
    return told(pictures('you guess', { 'muzzle above the ground': height }, ['', at(14), at(15), 'f', ...seconds(8)]).at(-1), 'm').at(-1);
  };
  for (const [height, farthest] of [[0, 45], [25, 37]])
    for (const aside of [-4, 4]) assert.ok(shot(farthest, height) > shot(farthest + aside, height));
  assert.equal(shot(30, 0), 54.1);
}
{ // without 4.2 the game notices the ground too late
  assert.ok(pictures('it flies (4.1)', { angle: 60 }).some((picture) => words(picture).some((text) => /^[1-9].* m too deep$/.test(text))));
}
{ // straight up takes twice as long as 30°
  const time = (angle) => told(pictures('it lands (4.2)', { angle }).at(-1), 's')[0];
  assert.equal(time(90), 2 * time(30));
}
{ // two angles for 50 m; from 25 m the high one has to change less; and the shell lands at the flag
  const nearest = (from, to, height) => best(angles(from, to), (angle) => -Math.abs(range(angle, height) - 50));
  assert.deepEqual([nearest(0, 45, 0), nearest(45, 90, 0)], [27, 63]);
  assert.deepEqual([nearest(-45, 30, 25), nearest(30, 90, 25)], [-6, 69]);
  const landed = pictures('range (4.3)', { angle: 60 }, seconds(5)).map(shell).find(([, y], i) => i > 60 && Math.abs(y) < 1e-9);
  assert.ok(Math.abs(landed[0] - range(60)) < 0.05);
}
{ // below 0° the highest point stays at the muzzle
  const top = (angle) => told(pictures('apex (4.4)', { angle }, ['']).at(-1), 'm')[0];
  assert.deepEqual([top(-45), top(0), top(90)], [25, 25, 56.3]);
}
{ // the shell keeps to the dots: at each fifth of a second it's at one
  const seen = pictures('dotted arc (4.5)', { angle: 60 }, seconds(3)), start = seen.findIndex((picture) => shell(picture)[1] > 0);
  const { points } = seen.at(-1).shapes.find(({ kind, colour }) => kind === 'discs' && colour === 'blue');
  for (const k of [1, 5, 10]) {
    const [x, y] = shell(seen[start - 1 + 12 * k]);
    assert.ok(Math.hypot(x - points[k][0], y - points[k][1]) < 1e-6, `dot ${k}`);
  }
}
{ // exact steps are close first
  for (const rate of [2, 5, 30]) {
    const seen = pictures('frame loops (4.9)', { 'frames per second': rate }, seconds(5));
    const far = (name) => Number(seen.map((picture) => words(picture).find((text) => text.startsWith(`${name}: `))).find(Boolean).split(' ').at(-2));
    const right = told(seen[0], 'm')[0], off = (name) => Math.abs(far(name) - right);
    assert.ok(off('exact steps') < Math.min(off('explicit Euler'), off('semi-implicit Euler')) / 5, `${rate}`);
  }
}
{ // a target out of reach: the cannon stays, and points where it did; 31 m up it's too high, and 62 m out too far
  const reach = (x, y) => pictures('it aims (4.8)', {}, ['', [0, x, y]]).at(-1), gone = (x, y) => words(reach(x, y)).includes('out of reach');
  assert.deepEqual([gone(5, 30), gone(5, 32), gone(61.5, 0.5), gone(63, 0.5)], [false, true, false, true]);
  const barrel = ({ shapes }) => JSON.stringify(shapes.find(({ kind, colour }) => kind === 'area' && colour === 'ink').points);
  const [near, far] = pictures('it aims (4.8)', {}, ['', [0, 94, 48]]);
  assert.equal(barrel(far), barrel(near));
}
{ // in air: against 19 m/s it lands behind the cannon, with 29 m/s it gets past the grey ball; without drag no wind does anything
  const far = (chosen) => told(pictures('in air (4.10)', { angle: 45, drag: 0.025, wind: 0, ...chosen }, seconds(4)).at(-1), 'm').at(-1);
  assert.deepEqual([-18, -19, 28, 29].map((wind) => [far({ wind }) < 0, far({ wind }) > 62.5]), [[false, false], [true, false], [false, false], [false, true]]);
  assert.equal(far({}), 30.6);
  assert.deepEqual([-30, 30].map((wind) => far({ drag: 0, wind })), [62.5, 62.5]);
}
{ // in wind, which has no scene: the text's two angles, 39° and 51°, by formula; as many degrees throw farthest
  const range = (wind) => (angle) => {
    const [x, y] = [Math.cos, Math.sin].map((part) => 25 * part((angle * Math.PI) / 180)), time = (2 * y) / 10;
    return x * time + (wind / 2) * time ** 2;
  };
  const [, against, along] = /Of all angles it's (\d+)°, and (\d+)° with that wind behind you/.exec(fs.readFileSync(new URL('../../chapters/04_trajectories/README.md', import.meta.url), 'utf8'));
  assert.deepEqual([-2, 2].map((wind) => best(angles(0, 90), range(wind))), [Number(against), Number(along)]);
}
