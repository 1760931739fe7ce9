// tasks.mjs NATIVE: what the chapter asks at its demo can be done, and comes out as it says.
import assert from 'node:assert';
import { near, player, seconds } from '../play/rows.mjs';

const demo = player(process.argv[2]);
const pictures = (game, chosen, keys) => demo.pictures(demo.values({ 'The game': game, ...chosen }), keys);
const last = (game, chosen, ...keys) => pictures(game, chosen, keys).at(-1);
const wait = (frames) => Array(frames).fill('');
const said = ({ shapes }) => shapes.map(({ text }) => text).filter(Boolean);
/// The numbers that these words say in a picture, in order.
const numbers = (picture, pattern) => said(picture).map((text) => pattern.exec(text)).filter(Boolean).map(([, number]) => Number(number.replace('−', '-')));
const read = (picture, name) => picture.readouts.find((each) => each.name === name).value;
/// Where a ship of this colour has its nose, and where outlines have theirs.
const nose = ({ shapes }, colour) => shapes.find((each) => each.kind === 'area' && each.material === 'solid' && each.colour === colour).points[0];
const outlines = ({ shapes }, colour) => shapes.filter((each) => each.kind === 'line' && each.colour === colour && each.points.length === 8).map(({ points: [at] }) => at);

{ // the opening: your ship is at 333 px of 800; a guess that's right, and one that's 100 px off
  const guess = (x) => last("who's first?", {}, [0, x, -150], 'f', ...wait(200));
  const off = (x) => numbers(guess(x), /(\d+) px off$/)[0];
  assert.deepEqual([off(800 * 60 / 144), off(433.3333), off(0), off(800)], [0, 100, 333, 467]);
  assert.deepEqual(numbers(guess(500), /^at (\d+) px/), [333]);
  near(nose(guess(500), 'orange')[0], 333.3333, 0.001);
  near(nose(last("who's first?", {}, 'f', ...wait(59)), 'blue')[0], 288, 0.001); // 144 frames of 2 px
  assert.ok(said(last("who's first?", {}, 'f', ...wait(200), [0, 100, -150])).includes('yours, then?')); // a new guess
}
{ // *New* is another pair, which stays in the picture; the last five guesses stay as dots
  const keys = Array.from({ length: 14 }, () => ['f', ...wait(420), 'n']).flat(), seen = pictures("who's first?", {}, keys), answers = [];
  for (let round = 0; round < 14; round++) {
    const end = seen[422 * round + 420], [own] = numbers(end, /you: (\d+) frames/), [other] = numbers(end, /your friend: (\d+) frames/), [each] = numbers(end, /^(\d) px in each frame/);
    assert.ok(own < other && each > 0, said(end).join());
    near(nose(end, 'orange')[0], 800 * own / other, 0.001);
    const dots = end.shapes.filter(({ colour, kind, material }) => kind === 'discs' && colour === 'amber' && material === 'glow').map(({ points: [[x]] }) => x);
    assert.equal(dots.length, Math.min(5, round + 1));
    near(dots[round % 5], 600, 0.001); // below the guess
    answers.push(`${own} ${other} ${each}`);
  }
  assert.ok(new Set(answers).size > 8, answers.join());
}
for (const delay of [10, 100, 300, 700]) { // each ship is where it was at 120 px/s when its frame ended; the outlines aren't
  const end = last('three screens (12.1)', { 'frame delay': delay }, ...wait(150)), ghosts = outlines(end, 'ink').map(([x]) => x);
  [['orange', delay / 1000], ['green', 1 / 30], ['blue', 1 / 144]].forEach(([colour, frame], i) => {
    const [x] = nose(end, colour), frames = x / 120 / frame, want = 2 * Math.round(frames);
    near(frames, Math.round(frames), 1e-4);
    assert.ok(x < 300 + 1e-6 && x > 300 - 120 * frame - 1e-6, `${colour}: ${x}`);
    near(numbers(end, /^(\d+) px$/)[i], x, 0.51);
    if (want < 640) assert.ok(ghosts.some((at) => Math.abs(at - want) < 1e-6), `${want}: ${ghosts}`);
  });
}
{ // the tab sleeps before the rings: one ship comes through all, and the other misses three; then the clock goes back
  const tab = (...keys) => last('a tab that sleeps (12.2)', {}, ...keys), apart = (picture) => nose(picture, 'orange')[0] - nose(picture, 'blue')[0];
  const slept = tab(...wait(130), 's', ...wait(330));
  assert.deepEqual(numbers(slept, /^(\d) of 4 rings$/), [4, 1]);
  near(apart(slept), 120 * (2 - 0.25), 4.1);
  const alone = tab(...wait(330)); // by itself it sleeps for a second, and both come through
  assert.deepEqual(numbers(alone, /^(\d) of 4 rings$/), [4, 4]);
  near(apart(alone), 120 * (1 - 0.25), 4.1);
  const back = tab(...wait(100), 'b', ...wait(30));
  near(numbers(back, /^← it's at (−\d+) px$/)[0], -3600 * 120, 300);
  assert.ok(nose(back, 'blue')[0] > 100);
}
{ // whole steps: all jump as high, 69/64 m; one step a frame does not
  const top = (dt) => Math.max(...Array.from({ length: 2000 }, (_, n) => 6 * n * dt - 8 * dt * dt * n * (n + 1)));
  const marks = (picture) => picture.shapes.filter(({ kind, colour, material, points }) => kind === 'line' && colour === 'ink' && material === 'solid' && points.length === 2).map(({ points: [[, y]] }) => y);
  for (const rate of [10, 20, 60, 144]) {
    const end = last('whole steps (12.3)', { 'frames per second': rate }, 'j', ...wait(59));
    const want = [...[1 / rate, 1 / 30, 1 / 144].map(top), 69 / 64, 69 / 64, 69 / 64];
    marks(end).forEach((y, i) => near(y, want[i], 1e-6));
    numbers(end, /^(\d\.\d\d) m$/).forEach((high, i) => near(high, want[i], 0.00501));
    assert.deepEqual([marks(end).length, numbers(end, /^(\d\.\d\d) m$/).length], [6, 6]);
  }
  near(marks(last('whole steps (12.3)', {}, ...wait(80)))[5], 69 / 64, 1e-6); // by themselves, too
}
// Where the cactuses are, once more.
const chance = (seed, number) => {
  let mixed = Math.imul((Math.imul(seed, 7919) + number + 11) | 0, 2654435761 | 0) >>> 0;
  mixed = Math.imul(mixed ^ (mixed >>> 15), 2246822519 | 0) >>> 0;
  return ((mixed ^ (mixed >>> 13)) >>> 20) / 4096;
};
const cactus = (seed, number) => 6 + 9.75 * number + 3.25 * chance(seed, 2 * number);
const hurts = (seen) => seen.map((picture) => said(picture).includes('ouch')).filter((now, i, all) => now && !all[i - 1]).length;
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
    const seen = pictures('run and jump (12.4)', { 'frames per second': rate }, keys), [score] = numbers(seen.at(-1), /^(\d+) m$/);
    assert.ok(hurts(seen) === 0 && score > 175, `${rate} a second, round ${round}: ${score}`);
  }
for (const rate of [10, 60, 144]) { // nobody jumps: it falls over the first cactus, again and again, as far away at any frame rate
  const seen = pictures('run and jump (12.4)', { 'frames per second': rate }, ['j', ...seconds(20)]), [best] = numbers(seen.at(-1), /^best (\d+) m$/);
  assert.ok(hurts(seen) >= 10 && best > cactus(0, 0) - 0.8 && best < cactus(0, 0) + 1.1, `${hurts(seen)}: ${best}`);
}
{ // left alone, it jumps over all of them, for two minutes
  const seen = pictures('run and jump (12.4)', {}, seconds(120));
  assert.ok(hurts(seen) === 0 && numbers(seen.at(-1), /^(\d+) m$/)[0] > 700);
}
for (const half of [0.045, 0.1, 0.5]) { // a second after the target jumped: ours are as far at both screens, the others aren't
  const end = last('two cameras (12.5)', { 'half-life': half }, ...Array(60).fill([0, 4, 2])), far = Math.sqrt(20);
  near(read(end, 'by half-life at 144: behind'), far * 2 ** (-1 / half), 0.001), near(read(end, 'a tenth at 144: behind'), far * 0.9 ** 144, 0.001);
  near(numbers(end, /^by half-life: (\d.*) m apart/)[0], 0, 0.001);
  near(numbers(end, /^a tenth a frame: (\d.*) m apart/)[0], far * (0.9 ** 30 - 0.9 ** 144), 0.00501);
}
{ // what half-life is as tight as a tenth a frame at 144? 0.0457 s, so the slider's nearest is 0.045 s
  const away = (half) => Math.max(...pictures('two cameras (12.5)', { 'half-life': half }, seconds(10)).map((each) => Math.abs(read(each, 'by half-life at 144: behind') - read(each, 'a tenth at 144: behind'))));
  const all = [0.03, 0.04, 0.045, 0.05, 0.06].map(away);
  assert.equal(Math.min(...all), all[2], `${all}`);
}
{ // a busy machine: 120 steps and 10 thoughts a second are too much from 7.92 ms a step on; half of it fits, in slow motion
  const load = (cost, time = 20) => {
    const end = last('a busy machine (12.7)', { 'cost of a step': cost }, [-1, 0, 0], ...seconds(time));
    return { real: read(end, 'real time'), game: numbers(end, /^game (\d.*) s$/), work: numbers(end, /^(\d+) ms of work$/) };
  };
  const light = load(4), nearly = load(7.5), over = load(9, 60), heavy = load(12, 60);
  for (const game of light.game) near(game, light.real, 0.11);
  assert.ok(nearly.work[0] < 150 && nearly.work[1] < 17, JSON.stringify(nearly));
  assert.ok(over.work[0] > 900, JSON.stringify(over));
  assert.ok(heavy.work[0] > 900 && heavy.work[1] < 17, JSON.stringify(heavy));
  near(heavy.game[1] / heavy.real, 60 / 130, 0.005); // a step or a thought a frame
  const alone = pictures('a busy machine (12.7)', {}, seconds(20)); // it never freezes by itself
  assert.ok(alone.every((each) => numbers(each, /^(\d+) ms of work$/).every((work) => work < 40)));
}
for (const lost of [0, 30]) { // a friend: as far as the packets that have come say, a tenth of a second late
  const flight = (t) => [4 * Math.sin(1.1 * t), 1.7 * Math.sin(2 * t + 0.5)];
  const line = Array.from({ length: 200 }, (_, k) => ({ sent: k / 20, arrives: k === 0 ? 0 : k / 20 + 0.01 + 0.04 * chance(5, 2 * k + 1), lost: k > 0 && 100 * chance(5, 2 * k) < lost })).filter((each) => !each.lost);
  let checked = 0;
  pictures('a friend (12.8)', { lost }, wait(590)).forEach((picture, i) => {
    const time = (i + 1) / 60, then = time - 0.1, known = line.filter(({ arrives }) => arrives <= time);
    if (known.length < 2 || line.some(({ arrives }) => Math.abs(arrives - time) < 1e-6)) return;
    const after = known.findIndex(({ sent }) => sent > then), at = after < 0 ? known.length - 1 : Math.max(after, 1), [from, to] = known.slice(at - 1, at + 1);
    const part = (Math.max(0, Math.min(then, known.at(-1).sent + 0.25)) - from.sent) / (to.sent - from.sent);
    [0, 1].forEach((axis) => near(nose(picture, 'blue')[axis], flight(from.sent)[axis] * (1 - part) + flight(to.sent)[axis] * part, 1e-6));
    const [newest] = known.slice(-1);
    [0, 1].forEach((axis) => near(nose(picture, 'orange')[axis], flight(newest.sent)[axis], 1e-6));
    [0, 1].forEach((axis) => near(outlines(picture, 'ink')[0][axis], flight(time)[axis], 1e-6));
    checked++;
  });
  assert.ok(checked > 450, `${checked}`);
}
{ // yours moves far more smoothly than the newest packet, until much is lost
  const most = (lost, name) => Math.max(...pictures('a friend (12.8)', { lost }, seconds(20)).map((each) => numbers(each, new RegExp(`^${name} hops (\\d.*) m$`))[0]));
  for (const lost of [0, 10, 30, 60]) console.log(`${lost} % lost: yours hops ${most(lost, 'yours')} m, the newest packet ${most(lost, 'newest packet')} m`);
  assert.ok(most(10, 'yours') < 0.15 && most(10, 'newest packet') > 0.6 && most(60, 'yours') > 0.6);
}
