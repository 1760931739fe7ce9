// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import { near, player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]), { last } = demo;
const rows = (game, chosen, keys) => demo.readouts(demo.values({ 'The game': game, ...chosen }), keys);
const after = (game, chosen, ...actions) => rows(game, chosen, [...actions, ...seconds(Math.ceil(actions.length / 60) + 1).slice(actions.length)]).at(-1);
const place = (row) => [row['hand, to the right'], row['hand, up']];

{ // the opening: a guess that is right, and one that is 1 m off
  near(after('you guess', {}, [0, 3.116, 3.432], 'f')['off by'], 0, 0.001);
  near(after('you guess', {}, [0, 3.116, 2.432], 'f')['off by'], 1, 0.001);
  near(place(after('you guess', {}, 'f'))[0], 3.116);
  near(place(after('you guess', {}, 'f'))[1], 3.432);
}
{ // *New* bolts another arm to the table, which stays in the picture; the last five guesses stay as dots
  const shown = Array.from({ length: 40 }, () => ['f', 'n']).flat(), pictures = demo.pictures(demo.values({}), shown);
  const answers = pictures.filter((_, i) => i % 2 === 0).map(({ readouts }) => readouts.map(({ value }) => value));
  near(answers[0][0], 3.116);
  assert.ok(new Set(answers.map(String)).size > 30);
  for (const [x, y] of answers) assert.ok(x > 0 && x < 5 && y > 0 && y < 4, `${x}, ${y}`);
  const dots = ({ shapes }) => shapes.filter(({ kind, colour, material }) => kind === 'discs' && colour === 'amber' && material === 'glow').length;
  assert.deepEqual([0, 2, 4, 6, 8, 10, 78].map((i) => dots(pictures[i])), [1, 2, 3, 4, 5, 5, 5]);
  assert.ok(pictures[0].shapes.some(({ text }) => text === '3 m at 30°, then 2 m, bent by 45°'));
  for (const { shapes } of pictures.filter((_, i) => i % 2 === 1)) assert.ok(shapes.some(({ text }) => text === 'hand?'));
}
for (const rate of [4, 5]) { // one loop for each turn of the second motor: there the hand is closest to the origin
  rows('an arm that draws (9.1)', { 'second motor': rate }, seconds(9)).forEach((row, second) => {
    near(Math.hypot(...place(row)), Math.sqrt(13 + 12 * Math.cos(rate * (second + 1))), 1e-5);
  });
}
for (const row of rows('an arm that draws (9.1)', { 'second motor': -1 }, seconds(9))) { // the second link keeps its direction
  const [x, y] = place(row);
  near(Math.hypot(x - 2, y), 3, 1e-5);
}
{ // the arm that draws can be taken by its elbow and by its hand
  const still = { 'first motor': 0, 'second motor': 0 };
  const [x, y] = place(after('an arm that draws (9.1)', still, [0, 0, 3], [1, 4, 3]));
  near(x, 2, 1e-5);
  near(y, 3, 1e-5);
}
{ // the digger: place and slope move all of it; the teeth can reach the stone, by two sliders, and not by place alone
  const away = (chosen) => after('a digger (9.2)', chosen, '')['to the stone'];
  const alone = { place: [-5, 5, 0.5], slope: [-20, 20, 4], boom: [0, 90, 5], stick: [-150, 0, 5], bucket: [-120, 60, 10] };
  for (const [name, [from, to, by]] of Object.entries(alone))
    for (let at = from; at <= to; at += by) assert.ok(away({ [name]: at }) > 1, `${name} ${at}`);
  assert.ok(away({ place: -1.6, boom: 34 }) < 0.1);
}
{ // how the hand moves: the area is that of 3 m and 2 m, whatever the first angle is
  const game = 'how the hand moves (9.5)', area = (...actions) => after(game, {}, ...actions).area;
  near(area(''), 6);
  near(area([0, 3, -2], ''), 6);
  near(area([0, 2, -2.5], [1, 9, -2.5]), 0);
  near(after(game, { joint: 2 }, ...Array(18).fill('d')).area, 0); // from 90° to 0°, by keys
}
{ // pick up: the two numbers for the hand stay the same while the box is held, and only then
  const game = 'pick up (9.6)', path = [...Array(40)].map((_, i) => [2, 2.5 - 0.1 * i, 0.5 + 0.05 * i]);
  const local = (row) => [row["along the hand's x axis"], row['along its y axis']];
  const taken = after(game, {}, 't'), carried = after(game, {}, 't', ...path), left = after(game, {}, ...path);
  local(taken).forEach((number, i) => near(local(carried)[i], number, 1e-5));
  assert.ok(Math.hypot(...local(taken).map((number, i) => number - local(left)[i])) > 0.5);
  assert.ok(Math.abs(carried['box, up'] - taken['box, up']) > 0.3);
  near(left['box, up'], 0.5);
  // the hand can be dragged into the box, which reaches 0.5 m from its middle
  const [x, y] = local(after(game, {}, [0, 0, 1], [1, 2.5, 0.5], [2, 2.5, 0.5]));
  assert.ok(Math.hypot(x, y) < 0.5, `${x}, ${y}`);
}
{ // in the cab: the stone is grabbed, carried, and let go
  const idle = (frames) => Array(frames).fill('');
  const path = rows('in the cab (9.4)', { drive: 0.865, 'lift the boom': -0.5 }, [...idle(69), 'c', ...idle(50), 'c', ...idle(119)]);
  near(path[0]['stone, to the right'], 1.5);
  near(path[1]['to the stone'], 0, 1e-5);
  assert.ok(path[1]['stone, to the right'] > 2);
  near(path[3]['stone, up'], 0, 1e-5);
  assert.ok(path[3]['to the stone'] > 1);
}
{ // over the wall: never in the ground, in any round
  for (let rounds = 0; rounds < 20; ++rounds) {
    const row = after('over the wall (9.8)', {}, ...Array(rounds).fill('n'), '');
    assert.ok(row['lowest point of all'] >= 0 && row.poses > 20, JSON.stringify(row));
  }
}
{ // above the ground: pushed as hard as one likes, it never gets below, and never trembles
  const game = 'above the ground (9.7)';
  for (const handle of [0, 1, 2]) {
    const pushed = rows(game, {}, Array(240).fill([handle, 3, -9]));
    assert.ok(pushed.every((row) => row.lowest > -1e-6), JSON.stringify(pushed));
    near(pushed[2]['hand, up'], pushed[3]['hand, up'], 1e-6);
  }
  const keys = rows(game, { joint: 1 }, [...Array(60).fill('d'), ...Array(60).fill('')]);
  near(keys[1].lowest, 0, 1e-5);
  near(after(game, { joint: 1 }, ...Array(16).fill('u'))['hand, up'], 2 + 1.8 * Math.sin(Math.PI * 2 / 3) + 1.2, 1e-5); // over the top
}
