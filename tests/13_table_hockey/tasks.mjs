// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import { execFileSync } from 'node:child_process';
import { aboutOf, frameOf, line, near, printedRow, reader } from '../play/rows.mjs';

const run = (words, input) => execFileSync(process.argv[2], words, { input, maxBuffer: 1 << 30 }).toString().trim().split('\n').map(printedRow);
const about = aboutOf(reader(run(['--picture', ''], '')[0]));

// The picture after each frame of 1/60 s. In each, somebody does so: `keys` are held, `at` is where the pointer is, and
// `handle` what it holds, `tap` is where a finger was, and `press` is a key.
function played(chosen, frames) {
  const value = ({ name, options, value: first }, keys) => keys.includes(name) ? 1 : name in chosen ? options.indexOf(chosen[name]) : first;
  const lines = frames.map(({ keys = [], at, handle = -1, tap, press }) =>
    line([1 / 60, 0, ...(at ?? tap ?? [0, 0]), at ? 1 : 0, tap ? 1 : 0, handle >= 0 ? 1 : 0, handle, about.keys.findIndex(({ key }) => key === press)], about.controls.map((each) => value(each, keys))));
  return run([], `${lines.join('\n')}\n`).map((row) => frameOf(reader(row)));
}
const times = (count, frame = {}) => Array.from({ length: count }, (_, i) => (typeof frame === 'function' ? frame(i) : frame));
const ball = (colour) => ({ shapes }) => shapes.find((each) => each.kind === 'discs' && each.material === 'solid' && each.colour === colour).points[0];
const blue = ball('blue'), orange = ball('orange'), disc = ball('amber');
// The score as a reader sees it: which of a digit's seven bars glow, each by its place, says which one it is.
const bars = ['012456', '25', '02346', '02356', '1235', '01356', '013456', '025', '0123456', '012356'];
const centres = [[0, 2], [-1, 1], [1, 1], [0, 0], [-1, -1], [1, -1], [0, -2]].map((at) => at.map((z) => 0.034 * z));
const goals = ({ shapes }) => ['blue', 'orange'].map((colour, i) => {
  const lit = shapes.filter((each) => each.kind === 'line' && each.material === 'glow' && each.colour === colour && each.points[0][1] > 0.6);
  const middles = lit.map(({ points: [from, to] }) => [(from[0] + to[0]) / 2 - [-0.16, 0.16][i], (from[1] + to[1]) / 2 - 0.735]);
  return bars.indexOf(middles.map((at) => centres.findIndex((centre) => Math.hypot(at[0] - centre[0], at[1] - centre[1]) < 0.01)).sort().join(''));
});
const words = ({ shapes }) => shapes.map(({ text }) => text).filter(Boolean).join();
const at = (got, want, by = 0.012) => got.forEach((x, k) => near(x, want[k], by)); // a step more or less
const two = { 'The game': 'two players' }, begins = { keys: ['orange left'] };

{ // keys that are held move the mallets, both at once, at 2.5 m/s; let go, they stop
  const [up] = played(two, [...times(6, { keys: ['blue up', 'orange left', 'orange down'] }), ...times(30)]).slice(-1), far = 0.25 / Math.SQRT2;
  at(blue(up), [-0.5, 0.25]), at(orange(up), [0.5 - far, -far]);
  const [right] = played({}, times(60, { keys: ['blue right'] })).slice(-1);
  at(blue(right), [-0.08, 0]); // as far as its own half goes
}
{ // the pointer leads the left mallet by itself, and stays behind at the line; keys have precedence until it moves again
  const way = [...times(40, { at: [0.5, 0.3] }), ...times(12, { at: [0.5, 0.3], keys: ['blue down'] }), ...times(30, { at: [0.5, 0.3] })];
  const seen = played({}, way);
  at(blue(seen[39]), [-0.08, 0.3], 1e-6), at(blue(seen[81]), [-0.08, -0.2]);
  at(blue(played({}, [...way, ...times(40, { at: [-0.7, 0.1] })]).at(-1)), [-0.7, 0.1], 1e-6);
}
{ // a finger, which is never over the picture without touching it, drags the mallet or sends it somewhere; let go, it stays
  const dragged = played({}, [...times(40, { at: [-0.8, 0.4], handle: 0 }), ...times(60)]);
  at(blue(dragged.at(-1)), [-0.8, 0.4], 1e-6);
  at(blue(played({}, [{ tap: [-0.3, -0.2] }, ...times(40)]).at(-1)), [-0.3, -0.2], 1e-6);
  for (const { shapes } of dragged) assert.equal(shapes[0].kind, 'handle', 'under the mallet, where it is grabbed');
}
{ // with two players a pointer leads what it holds, and nothing else
  const [held] = played(two, [...times(40, { at: [-0.8, 0.4], handle: 0 }), ...times(40, { at: [0.7, -0.4], handle: 1 })]).slice(-1);
  at(blue(held), [-0.8, 0.4], 1e-6), at(orange(held), [0.7, -0.4], 1e-6);
  at(blue(played(two, [begins, ...times(40, { at: [-0.8, 0.4] })]).at(-1)), [-0.5, 0]);
}
{ // until somebody comes, a beginner plays, and whoever comes begins a match
  const alone = played({}, times(240)), come = played({}, [...times(200), ...times(40, { keys: ['blue up'] })]);
  assert.ok(new Set(alone.slice(60).map((picture) => blue(picture).join())).size > 60);
  assert.match(words(alone.at(-1)), /take over/), assert.equal(words(come.at(-1)), '');
  at(disc(come.at(-1)), [0, 0], 1e-6), assert.ok(Math.hypot(...disc(alone.at(-1))) > 0.1);
}
{ // a match of the beginner: to five, then the table rests, and another one begins
  const seen = played({}, times(60 * 240)), last = seen.findIndex((picture) => Math.max(...goals(picture)) === 5);
  assert.ok(last > 0 && /blue wins|orange wins/.test(words(seen[last])) && Math.max(...seen.flatMap(goals)) === 5);
  at(disc(seen[last + 200]), [0, 0], 1e-6), assert.deepEqual(goals(seen[last + 250]), [0, 0]);
  assert.ok(seen.flatMap(goals).every((each) => each >= 0), 'a digit that can be read');
}
// Somebody who swings about without looking scores, too, in one way or another, and the score counts.
const pointing = (reach, beat) => (i) => ({ at: [-0.85 + reach * Math.abs(Math.sin(i / 9)), 0.3 * Math.sin(i / beat)] });
const pressing = (beat, other) => (i) => ({ keys: [Math.sin(i / beat) > 0 ? 'blue right' : 'blue left', Math.sin(i / other) > 0 ? 'blue up' : 'blue down'] });
for (const [how, leads] of [
  ['by pointer', [pointing(0.3, 7), pointing(0.4, 37), pointing(0.5, 37)]],
  ['by keys', [pressing(6, 2.7), pressing(6, 5.1), pressing(4, 7)]],
]) {
  const all = leads.map((lead) => played({}, times(60 * 40, lead))), scored = all.map((seen) => seen.findIndex((picture) => goals(picture)[0] > 0));
  const which = scored.findIndex((first) => first > 0), seen = all[which], first = scored[which];
  assert.ok(which >= 0, how);
  console.log(`${how}: a goal after ${(first / 60).toFixed(1)} s, ${goals(seen.at(-1)).join(' : ')} after 40 s`);
  const lamp = ({ shapes }) => shapes.find((each) => each.kind === 'line' && each.colour === 'orange' && each.points[0][0] > 1.1).size;
  assert.ok(lamp(seen[first]) > 9 && lamp(seen[first - 1]) < 4, 'the lamp of the goal');
  assert.deepEqual(goals(played({}, [...times(first + 1, leads[which]), { press: 'n' }]).at(-1)), [0, 0]);
}
{ // the well bends the way of a serve
  const serve = (well) => disc(played({ ...two, 'The well': well }, [begins, ...times(60 * 1.7)]).at(-1));
  const [straight, bent] = ['off', 'on'].map(serve);
  near(Math.atan2(straight[1], straight[0]), (35 * Math.PI) / 180, 0.01);
  assert.ok(Math.hypot(...straight) - Math.hypot(...bent) > 0.1, `${straight} and ${bent}`);
}
{ // two machines play by themselves, and score
  const seen = played({ 'The game': 'machine against machine' }, times(60 * 180));
  console.log(`two machines: ${goals(seen.at(-1)).join(' : ')} after three minutes`);
  assert.ok(goals(seen.at(-1))[0] + goals(seen.at(-1))[1] >= 2);
}
