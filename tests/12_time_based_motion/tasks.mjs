// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import { near, player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
const rows = (game, chosen, keys) => demo.readouts(demo.values({ 'The game': game, ...chosen }), keys);
const filled = (actions) => [...actions, ...seconds(Math.ceil(actions.length / 60)).slice(actions.length)];
const after = (game, chosen, ...actions) => rows(game, chosen, filled(actions)).at(-1);
const pictures = (game, chosen, keys) => demo.pictures(demo.values({ 'The game': game, ...chosen }), keys);
const wait = (frames) => Array(frames).fill('');
const areas = ({ shapes }, colour, strength) => shapes.filter((each) => each.kind === 'area' && each.colour === colour && Math.abs(each.strength - strength) < 1e-6);
const said = ({ shapes }) => shapes.map(({ text }) => text).filter(Boolean);

{ // the opening: your ship is at 333 px of 800; a guess that's right, and one that's 100 px off
  const guess = (x) => after("who's first?", {}, [0, x, -150], 'f', ...wait(200));
  near(guess(800 * 60 / 144)['off by'], 0, 0.01), near(guess(433.3333)['off by'], 100, 0.01), near(guess(500).yours, 333.3333, 0.001);
  near(after("who's first?", {}, 'f')["your friend's ship"], 288, 0.001); // 144 frames of 2 px
}
{ // *New* is another pair, which stays in the picture; the last five guesses stay as dots
  const keys = Array.from({ length: 14 }, () => ['f', ...wait(420), 'n']).flat(), seen = pictures("who's first?", {}, keys), answers = [];
  for (let round = 0; round < 14; round++) {
    const last = seen[422 * round + 420], words = said(last), number = (pattern) => Number(pattern.exec(words.join('\n'))[1]);
    const own = number(/you: (\d+) frames/), other = number(/your friend: (\d+) frames/), each = number(/^(\d) px in each frame/m);
    assert.ok(own < other && each > 0, words.join());
    near(last.readouts.find(({ name }) => name === 'yours').value, 800 * own / other, 0.001);
    const dots = last.shapes.filter(({ colour, kind, material }) => kind === 'discs' && colour === 'amber' && material === 'glow').map(({ points: [[x]] }) => x);
    assert.equal(dots.length, Math.min(5, round + 1));
    near(dots[round % 5], 600, 0.001); // below the guess
    answers.push(`${own} ${other} ${each}`);
  }
  assert.ok(new Set(answers).size > 8, answers.join());
}
for (const delay of [10, 100, 300, 700]) { // each ship is where it was at 120 px/s when its frame ended; the pale ones aren't
  const seen = pictures('three screens (12.1)', { 'frame delay': delay }, wait(150)), row = Object.fromEntries(seen.at(-1).readouts.map(({ name, value }) => [name, value]));
  [['first ship', delay / 1000], ['second ship', 1 / 30], ['third ship', 1 / 144]].forEach(([name, frame], i) => {
    const frames = row[name] / 120 / frame;
    near(frames, Math.round(frames), 1e-4);
    assert.ok(row[name] < 300 + 1e-6 && row[name] > 300 - 120 * frame - 1e-6, `${name}: ${row[name]}`);
    const pale = areas(seen.at(-1), 'ink', 0.3).map(({ points: [[x]] }) => x), want = 2 * Math.round(frames);
    if (want < 640) assert.ok(pale.some((x) => Math.abs(x - want) < 1e-6), `${want}: ${pale}`);
  });
  assert.ok(row.apart <= 120 * Math.max(delay / 1000, 1 / 30) + 1e-6);
}
{ // the tab sleeps before the rings: one ship comes through all, and the other misses three; then the clock goes back
  const slept = pictures('a tab that sleeps (12.2)', {}, [...wait(70), 's', ...wait(340)]), row = Object.fromEntries(slept.at(-1).readouts.map(({ name, value }) => [name, value]));
  const rings = said(slept.at(-1)).filter((text) => /rings/.test(text));
  assert.deepEqual(rings, ['4 of 4 rings', '1 of 4 rings']);
  near(row.skipped, 2 - 0.25, 0.02), near(row['by the plain difference'] - row['by your clock'], 120 * (row.skipped + 1 / 60), 0.001); // the first frame takes no time
  near(after('a tab that sleeps (12.2)', {}, ...wait(240)).skipped, 2 - 0.25, 0.02); // by itself, too
  const back = after('a tab that sleeps (12.2)', {}, ...wait(60), 'b', ...wait(30));
  near(back['by the plain difference'], 180 - 3600 * 120, 65), near(back['by your clock'], 180, 65);
}
{ // whole steps: all jump as high, 69/64 m; one step a frame does not
  const top = (dt) => Math.max(...Array.from({ length: 2000 }, (_, n) => 6 * n * dt - 8 * dt * dt * n * (n + 1)));
  for (const rate of [10, 20, 60, 144]) {
    const row = after('whole steps (12.3)', { 'frames per second': rate }, 'j');
    for (const [which, dt] of [['first', 1 / rate], ['second', 1 / 30], ['third', 1 / 144]]) {
      near(row[`${which}, a step a frame`], top(dt), 1e-6), near(row[`${which}, in whole steps`], 69 / 64, 1e-6);
    }
  }
  near(after('whole steps (12.3)', {}, ...wait(120))['third, in whole steps'], 69 / 64, 1e-6); // by themselves, too
}
// Where the cactuses are, once more.
const chance = (seed, number) => {
  let mixed = Math.imul((Math.imul(seed, 7919) + number + 11) | 0, 2654435761 | 0) >>> 0;
  mixed = Math.imul(mixed ^ (mixed >>> 15), 2246822519 | 0) >>> 0;
  return ((mixed ^ (mixed >>> 13)) >>> 20) / 4096;
};
const cactus = (seed, number) => 6 + 9.75 * number + 3.25 * chance(seed, 2 * number);
for (const rate of [10, 60, 144]) // half a minute without a fall, by key or by pressing on the picture, at any frame rate
  for (const [round, press] of ['j', [-1, 2, 2]].entries()) {
    const keys = wait(30 * 60);
    if (round === 1) keys[0] = 'n';
    keys[1] = press; // it starts
    for (let number = 0; ; number++) {
      const frame = Math.round(60 * ((cactus(round, number) - 2.25) / 6 + 1.5 / rate)) + 1; // what's seen is a frame old
      if (frame >= keys.length) break;
      keys[frame] = press;
    }
    const row = rows('run and jump (12.4)', { 'frames per second': rate }, keys).at(-1);
    assert.ok(row.falls === 0 && row.score > 175, `${rate} a second, round ${round}: ${JSON.stringify(row)}`);
  }
{ // nobody jumps: it falls over the first cactus, again and again, as far away at any frame rate
  for (const rate of [10, 60, 144]) {
    const row = rows('run and jump (12.4)', { 'frames per second': rate }, ['j', ...seconds(20).slice(1)]).at(-1);
    assert.ok(row.falls >= 10 && row.best > cactus(0, 0) - 0.3 && row.best < cactus(0, 0) + 0.6, JSON.stringify(row));
  }
}
for (const half of [0.045, 0.1, 0.5]) { // a second after the target jumped: ours are as far at both screens, the others aren't
  const row = rows('two cameras (12.5)', { 'half-life': half }, Array(60).fill([-1, 4, 2])).at(-1), far = Math.sqrt(20);
  near(row['by half-life at 144: behind'], far * 2 ** (-1 / half), 0.001), near(row['by half-life: apart'], 0, 0.001);
  near(row['a tenth at 144: behind'], far * 0.9 ** 144, 0.001), near(row['a tenth: apart'], far * (0.9 ** 30 - 0.9 ** 144), 0.001);
}
{ // what half-life is as tight as a tenth a frame at 144? 0.0457 s, so the slider's nearest is 0.045 s
  const away = (half) => Math.max(...rows('two cameras (12.5)', { 'half-life': half }, seconds(10)).map((row) => Math.abs(row['by half-life at 144: behind'] - row['a tenth at 144: behind'])));
  const all = [0.03, 0.04, 0.045, 0.05, 0.06].map(away);
  assert.equal(Math.min(...all), all[2], `${all}`);
}
for (const [delay, thrown] of [[300, 16.2], [600, 16.2], [700, 16.1], [30, 16.02]]) { // 800 px at 50 px/s
  const row = rows('laps (12.6)', { 'frame delay': delay }, seconds(11)).at(-1);
  near(row['last lap, kept'], 16, 1e-6), near(row['last lap, thrown away'], thrown, 1e-6), near(row.laps, 5);
}
{ // a busy machine: 120 steps and 10 thoughts a second are too much from 7.92 ms a step on; half of it fits, in slow motion
  const load = (cost, time = 20) => rows('a busy machine (12.7)', { 'cost of a step': cost }, seconds(time)).at(-1);
  const light = load(4), nearly = load(7.5), over = load(9, 60), heavy = load(12, 60);
  for (const side of ["all that's due", 'with a budget']) near(light[`game time, ${side}`], light['real time'], 0.05);
  assert.ok(nearly["a frame takes, all that's due"] < 150 && nearly['a frame takes, with a budget'] < 17, JSON.stringify(nearly));
  assert.ok(over["a frame takes, all that's due"] > 900, JSON.stringify(over));
  assert.ok(heavy["a frame takes, all that's due"] > 900 && heavy['a frame takes, with a budget'] < 17, JSON.stringify(heavy));
  near(heavy['game time, with a budget'] / heavy['real time'], 60 / 130, 0.005); // a step or a thought a frame
}
for (const lost of [0, 30]) { // a friend: as far as the packets that have come say, a tenth of a second late
  const flight = (t) => [4 * Math.sin(1.1 * t), 2.2 * Math.sin(2 * t + 0.5)];
  const line = Array.from({ length: 200 }, (_, k) => ({ sent: k / 20, arrives: k === 0 ? 0 : k / 20 + 0.01 + 0.04 * chance(5, 2 * k + 1), lost: k > 0 && 100 * chance(5, 2 * k) < lost })).filter((each) => !each.lost);
  const nose = (picture) => picture.shapes.find(({ kind, colour, material }) => kind === 'area' && colour === 'blue' && material === 'solid').points[0];
  let checked = 0;
  pictures('a friend (12.8)', { lost }, wait(590)).forEach((picture, i) => {
    const time = (i + 1) / 60, then = time - 0.1, known = line.filter(({ arrives }) => arrives <= time);
    if (known.length < 2 || line.some(({ arrives }) => Math.abs(arrives - time) < 1e-6)) return;
    const after = known.findIndex(({ sent }) => sent > then), at = after < 0 ? known.length - 1 : Math.max(after, 1), [from, to] = known.slice(at - 1, at + 1);
    const part = (Math.max(0, Math.min(then, known.at(-1).sent + 0.25)) - from.sent) / (to.sent - from.sent);
    [0, 1].forEach((axis) => near(nose(picture)[axis], flight(from.sent)[axis] * (1 - part) + flight(to.sent)[axis] * part, 1e-6));
    const [newest] = known.slice(-1), orange = areas(picture, 'orange', 0.75)[0].points[0];
    [0, 1].forEach((axis) => near(orange[axis], flight(newest.sent)[axis], 1e-6));
    checked++;
  });
  assert.ok(checked > 450, `${checked}`);
}
{ // yours moves far more smoothly than the newest packet, until much is lost
  const most = (lost, name) => Math.max(...rows('a friend (12.8)', { lost }, seconds(20)).map((row) => row[`longest hop, ${name}`]));
  for (const lost of [0, 10, 30, 60]) console.log(`${lost} % lost: yours hops ${most(lost, 'yours').toFixed(2)} m, the newest packet ${most(lost, 'newest packet').toFixed(2)} m`);
  assert.ok(most(10, 'yours') < 0.15 && most(10, 'newest packet') > 0.6 && most(60, 'yours') > 0.6);
}
