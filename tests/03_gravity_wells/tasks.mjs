// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import { execFileSync } from 'node:child_process';
import { frameOf, line, near, player, printedRow, reader, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
// The pictures of a scene whose controls are so; what stands in one, and a number with its unit among that.
const pictures = (game, chosen, keys) => demo.pictures(demo.values({ 'The game': game, ...chosen }), keys);
const words = ({ shapes }) => shapes.filter(({ kind }) => kind === 'words').map(({ text }) => text);
const numbers = (picture, unit) => words(picture).map((text) => new RegExp(`(?:^| )(−?[\\d.]+) ${unit}$`).exec(text)?.[1]).filter(Boolean).map((text) => Number(text.replace('−', '-')));
const after = (picture, name) => Number(words(picture).find((text) => text.startsWith(`${name} `))?.split(' ')[1]);

{ // 10 m/s is the circle; half of that comes near the hole, one and a half times as much never comes back
  const flown = (push, time) => pictures('you guess', {}, ['', [0, 8, 0.4 * push], ...seconds(time)]);
  const circle = flown(10, 5).at(-1);
  for (const far of ['nearest', 'farthest']) near(after(circle, far), 8, 0.05);
  near(after(flown(5, 2.2).at(-1), 'nearest'), 1.14, 0.05);
  assert.ok(flown(15, 6).some((picture) => words(picture).includes('escaped')));
  assert.ok(pictures('you guess', {}, seconds(30)).every((picture) => !words(picture).includes('10.0 m/s')));
}
{ // five bursts keep the ship beyond 4 m; four do not, in whatever directions, and not if the last one comes later
  const ways = { Up: [0, 1e6], Left: [-1e6, 0], Down: [0, -1e6], Right: [1e6, 0] };
  const nearest = (presses) => {
    const keys = seconds(5);
    for (const [time, way] of presses) keys[Math.round(time * 60)] = [-1, ...ways[way]];
    return Math.min(...pictures('ship and hole (3.1)', {}, keys).slice(8).map((picture) => after(picture, 'nearest')));
  };
  const inTurn = (all) => all.map((way, at) => [0.1 + 0.3 * at, way]); // as fast as one can press without hurry
  const up = (count) => Array(count).fill('Up');
  assert.ok(nearest(inTurn(up(5))) >= 7.8, `five bursts: ${nearest(inTurn(up(5)))} m`);
  const all = Object.keys(ways);
  const fours = all.flatMap((a, i) => all.slice(i).flatMap((b, j) => all.slice(i + j).flatMap((c, k) => all.slice(i + j + k).map((d) => [a, b, c, d]))));
  assert.equal(fours.length, 35);
  for (const four of fours) assert.ok(nearest(inTurn(four)) < 4, `${four}: ${nearest(inTurn(four))} m`);
  for (const way of all)
    for (let time = 2; time < 4; time += 0.5) assert.ok(nearest([...inTurn(up(3)), [time, way]]) < 4, `${way} after ${time} s`);
  assert.ok(pictures('ship and hole (3.1)', {}, seconds(30)).every((picture) => !words(picture).some((text) => /^[4-9] bursts/.test(text))));
}
{ // the clock stops when the ball is on the ground; two throws are 2.5 s apart, from any height
  const time = (thrown, height) => {
    const last = pictures('falling (3.2)', { throw: thrown }, ['', [0, 0, height], ...seconds(7.5)]).findLast((picture) => words(picture).includes('0.0 s left') && numbers(picture, 's').length > 0);
    const { points } = last.shapes.find(({ kind, colour, size }) => kind === 'discs' && colour === 'orange' && size === 0.6);
    near(points[0][1], 0.6, 1e-9);
    return numbers(last, 's').at(-1);
  };
  for (const height of [8, 5]) near(time(2, height) - time(-2, height), 2.5, 0.011);
  assert.ok(time(0, 8) > time(0, 5) + 0.5);
}
{ // at each frame rate it lands exactly on the ground, and as fast; some presses in time, and it's slow enough
  const press = [-1, 0, 5];
  const landing = (rate, burns) => pictures('landing (3.3)', { 'frames per second': rate }, ['', press, ...seconds(4.4), ...Array(burns).fill(press), ...seconds(2)]).findLast((picture) => words(picture).some((text) => /landed|too fast/.test(text)));
  for (const rate of [1, 4, 60]) {
    const hard = landing(rate, 0);
    assert.ok(words(hard).includes('too fast: 6.3 m/s'), words(hard).join());
    assert.equal(hard.shapes.find(({ kind, colour, size }) => kind === 'discs' && colour === 'amber' && size === 0.17).points.at(-1)[1], 0);
  }
  assert.match(words(landing(60, 6)).join(), /^landed at 1\.\d m\/s$/);
}
{ // a turn takes 5 s at 8 m, and half of that at 5 m, not at 4 m
  const turn = (radius) => numbers(pictures('circles (3.4)', {}, ['', [0, radius, 0], ...seconds(6)]).at(-1), 's').at(-1);
  near(turn(8), 5.03, 0.03);
  near(turn(5), turn(8) / 2, 0.05);
  assert.ok(turn(4) < 2);
  assert.ok(pictures('circles (3.4)', {}, seconds(30)).every((picture) => !words(picture).some((text) => /^2\.[45]\d s$/.test(text))));
}
{ // through a wide blur it comes out as fast as it went in, and through a small one faster; its orbit doesn't close
  const speeds = (epsilon) => {
    const picture = pictures('softened (3.6)', { 'softened by': epsilon }, seconds(3)).find((each) => words(each).some((text) => text.startsWith('out')));
    return ['in:', 'out:'].map((name) => after(picture, name));
  };
  for (const wide of [2, 3, 5]) near(speeds(wide)[0], speeds(wide)[1], 0.3);
  assert.ok(speeds(0.5)[1] > speeds(0.5)[0] + 5);
  const ends = pictures('softened (3.6)', { push: 8 }, seconds(9)).at(-1).shapes.filter(({ colour, material }) => colour === 'amber' && material === 'glow').map(({ points: [[x, y]] }) => (180 / Math.PI) * Math.atan2(y, x));
  near(ends[0], -44, 2); // as the answer's table has it
}
{ // explicit Euler gains energy, and with another integrator in flight it doesn't go away
  const values = (integrator) => demo.values({ 'The game': 'four integrators (3.7)', 'steps per second': 20, push: 8, integrator });
  const frames = (integrator, time) => seconds(time).map(() => `${line([1 / 60, 0, 0, 0, 0, 0, 0, -1, -1], values(integrator))}\n`).join('');
  for (const other of ['semi-implicit Euler', 'leapfrog', 'Runge-Kutta']) {
    const rows = execFileSync(process.argv[2], { input: frames('explicit Euler', 2) + frames(other, 20), maxBuffer: 1 << 30 }).toString().trim().split('\n');
    const energy = rows.map((row) => numbers(frameOf(reader(printedRow(row))), 'J')[0]);
    assert.equal(energy[0], -68);
    assert.ok(energy[119] > -30, `${energy[119]}`);
    for (const each of energy.slice(120)) near(each, energy[119], 8);
  }
}
{ // in equal times, equal areas
  for (const eccentricity of [0.2, 0.5, 0.7]) {
    const areas = pictures('Kepler (3.8)', { eccentricity }, ['']).at(-1).shapes.filter(({ kind, colour }) => kind === 'area' && colour === 'green');
    const [one, other] = areas.map(({ points }) => Math.abs(points.reduce((sum, [x, y], i) => sum + (x * points[(i + 1) % points.length][1] - y * points[(i + 1) % points.length][0]) / 2, 0)));
    near(one / other, 1, 0.05);
  }
}
{ // the machine lands again and again, and never too fast or beside the pad; with all keys up, the lander crashes
  const ends = pictures('lander (3.9)', {}, seconds(90)).flatMap(words).filter((text) => /landed|too fast|beside/.test(text));
  assert.ok(ends.every((text) => text.startsWith('landed at')), ends.find((text) => !text.startsWith('landed at')));
  const still = pictures('lander (3.9)', {}, ['', [-1, 24, 12], ...seconds(6)]).flatMap(words);
  assert.ok(still.includes('too fast: 7.2 m/s'), [...new Set(still)].join());
}
