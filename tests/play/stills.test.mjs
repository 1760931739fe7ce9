// A demo's still pictures: how the code that draws on a page's canvas draws them, and which are kept.
import assert from 'node:assert';
import { execFileSync, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import stills from '../../tools/play/stills.cjs';

const about = { title: 'A&B', low: [0, 0], high: [10, 5] };
const shape = (kind, colour, points, more = {}) => ({ kind, colour, size: 0, strength: 1, points, text: '', material: 'flat', ...more });
const picture = (shapes, stage = 'paper') => ({ stage, ground: 0, low: about.low, high: about.high, shapes });
const filmOf = (pictures, ...more) => stills.filmOf(about, pictures.map((each) => (Array.isArray(each) ? picture(each) : each)), ...more);

test('a picture is its shapes in the colours of figures, without its handles', () => {
  const has = (shapes, ...parts) => parts.forEach((part) => assert.ok(filmOf([shapes]).includes(part), `${part} in ${filmOf([shapes])}`));
  has([], 'width="640" height="320"', '<title>A&amp;B</title>');
  has([shape('line', 'blue', [[0, 0], [10, 5]], { size: -2 })], '.c0{stroke:#2563eb;fill:none;stroke-width:2;stroke-dasharray:1 6}', '.c0{stroke:#6ea8fe}', '<path class="c0" d="M0 320l640-320"/>');
  has([shape('line', 'orange', [[0, 0], [10, 0]])], '{stroke:#d9480f;fill:none;stroke-width:2}', 'd="M0 320h640"');
  has([shape('discs', 'green', [[5, 2.5], [0, 5]], { size: 0.25, strength: 0.5 })], '{stroke:#0b8562;fill:none;stroke-width:32;stroke-opacity:0.5}', 'd="M320 160h0m-320-160h0"/>');
  has([shape('discs', 'violet', [[0, 0]], { size: 0.001 })], 'stroke-width:2}');
  has([shape('area', 'line', [[0, 0], [10, 0], [10, 5]])], '{fill:#66707f;fill-opacity:0.35}', 'd="M0 320h640v-320z"/>'); // the page's colour of lines
  has([shape('arrow', 'amber', [[1, 1], [2, 1]], { size: 2 })], 'd="M64 256h64l-7.7 4.6m7.7-4.6l-7.7-4.6"/>');
  has([shape('words', 'ink', [[1, 1]], { text: '<' })], '<text class="c0" x="64" y="256">&lt;</text>');
  has([shape('line', 'ink', [...Array(20)].map((_, i) => [i / 2, 0]))], 'd="M0 320h608"/>'); // twenty points on a line are two
  assert.ok(!filmOf([[shape('handle', 'pink', [[3, 3]])]]).includes('#c02672'));
  assert.doesNotMatch(filmOf([[shape('line', 'ink', [[0, 0], [1, 1]])], [shape('line', 'ink', [[0, 0], [1, 1]])]]), /class="f|keyframes/);
});

test('what is solid or glows has the same shades on each machine, and a path of many balls stays short', () => {
  const made = (material, kind, colour, points, more = {}) => shape(kind, colour, points, { material, ...more });
  const balls = filmOf([[made('solid', 'discs', 'blue', [[1, 1], [2, 2], [3, 2]], { size: 0.5 })]]);
  assert.match(balls, /<marker id="m\d" [^>]*><circle [^>]*\/><circle r="32" fill="url\(#g\d\)"\/><\/marker>/);
  assert.match(balls, /\.c0\{fill:none;marker-start:url\(#m\d\);marker-mid:url\(#m\d\)\}/);
  assert.ok(balls.includes('d="M64 256l64-64h64h0"'), balls); // no marker at its end, which is there twice
  const bar = filmOf([[made('solid', 'line', 'dim', [[0, 0], [4, 1], [8, 2.5], [9, 4.5]], { size: 10 })]]);
  assert.equal(bar.match(/<use class="c\d" href="#p0"\/>/g).length, 4, 'four strokes, one path');
  assert.match(bar, /transform:translate\(3\.4px,4\.2px\)/); // its shadow
  assert.match(filmOf([[made('solid', 'area', 'amber', [[0, 0], [4, 0], [4, 3]])]]), /fill:url\(#g\d\);stroke:#7a5d18;stroke-width:1\.3/);
  assert.equal(filmOf([[made('glow', 'line', 'pink', [[0, 0], [4, 1]], { size: 3 })]]).match(/stroke-opacity/g).length, 2, 'a halo of two strokes');
  assert.ok(filmOf([[made('solid', 'line', 'ink', [[0, 0], [10, 5]], { size: -2 })]]).includes('stroke-dasharray:1 6'), 'dots are flat');
  for (const film of [balls, bar]) well(film), assert.doesNotMatch(film, /NaN|undefined/);
});

test('a stage lies below all, and a dark one has the colours of a dark page on a light one, too', () => {
  const words = [shape('words', 'ink', [[1, 1]], { text: 'a' })];
  for (const stage of ['felt', 'night']) {
    const film = filmOf([picture(words, stage)]);
    assert.match(film, /\.c\d\{fill:#e3e8f0;stroke:/, stage);
    assert.ok(!film.includes('#1d2430'), stage);
    assert.ok(film.indexOf('M0 0h640v320h-640z') < film.indexOf('<text'));
  }
  const yard = filmOf([picture(words, 'yard'), picture([], 'yard')]);
  assert.match(yard, /\.c\d\{fill:#1d2430;stroke:/);
  assert.match(yard, /prefers-color-scheme: dark/);
});

// What is seen in a frame of a film, or when nothing may move: elements without a time, and groups whose time it is.
const drawn = (film) => film.replace(/<defs>.*<\/defs>\n/s, '');
const seenIn = (film, frame, count) => [...drawn(film).matchAll(/^(?:<g class="f(\d+) b(\d+)( h)?">(.*)<\/g>|<(?:path|text|use) .*)$/gm)]
  .filter(([, frames, begin]) => !frames || (frame - begin + count) % count < frames)
  .map(([all, , , , inside]) => (inside ?? all).replaceAll('/>', '/>\n').replaceAll('</text>', '</text>\n').trim()).join('\n');
const still = (film) => drawn(film).replaceAll(/<g class="[^"]* h">.*<\/g>\n/g, '').replaceAll(/<\/?(?:g|svg)[^>]*>/g, '').replace(/^.*<\/style>/s, '').replaceAll('/>', '/>\n').replaceAll('</text>', '</text>\n').replaceAll('\n\n', '\n').trim();
const well = (svg) => {
  const open = [];
  for (const [, end, name, alone] of svg.replace(/^<\?.*\?>/, '').matchAll(/<(\/?)(\w+)(?: [\w:-]+="[^"<]*")*(\/?)>/g)) end ? assert.equal(open.pop(), name) : alone || open.push(name);
  assert.deepEqual(open, []);
  assert.equal(svg.replaceAll(/<\?.*?\?>|<\/?\w+(?: [\w:-]+="[^"<]*")*\/?>/g, '').match(/[<]|&(?!amp;|lt;|gt;)/), null);
};

test('a film has what stays once, and of the rest in each frame what that frame has; it begins with the still', () => {
  const wall = shape('line', 'dim', [[0, 0], [10, 0]]), ball = (x) => shape('discs', 'orange', [[x, 1]], { size: 0.5 });
  const way = (count) => shape('line', 'blue', [...Array(count + 9)].map((_, i) => [i / 4, (i % 2) / 4]));
  const pictures = [...Array(10)].map((_, i) => [wall, way(i), ball(i), ...(i > 5 ? [shape('words', 'ink', [[1, 3]], { text: 'late' })] : [])]);
  const film = filmOf(pictures, 3, [10, 8, 1]);
  well(film);
  for (const once of ['h640"', 'late</text>', 'M0 320l16-16']) assert.equal(film.split(once).length, 2, once); // also the beginning of the way
  assert.match(film, /\.f1\{animation:f1 1\.25s step-end infinite\}/);
  assert.match(film, /\.b7\{animation-delay:-0\.375s\}/);
  assert.ok(film.includes('@media (prefers-reduced-motion: reduce) { g { animation: none !important } }'));
  assert.equal(still(film), seenIn(film, 0, 10));
  pictures.forEach((each, i) => { // each piece of each picture
    const seen = seenIn(film, (i - 3 + 10) % 10, 10), alone = filmOf([each]);
    assert.ok(seen.includes(`"M${64 * i} 256h0"`), seen);
    assert.equal(seen.includes('late'), i > 5);
    const length = (text) => [...text.matchAll(/l(-?[\d.]+)/g)].reduce((sum, [, x]) => sum + Number(x), 0);
    assert.equal(length(seen), length(alone));
    assert.equal(seen.match(/h0"/g).length, 1);
  });
});

test('every kept picture is light, has no script, stays still if it should, and then shows its first frame', () => {
  const folder = fileURLToPath(new URL('../../demos/', import.meta.url)), names = fs.readdirSync(folder).filter((name) => name.endsWith('.svg'));
  assert.ok(names.length > 50);
  for (const name of names) {
    const film = fs.readFileSync(path.join(folder, name), 'utf8'), [, frames, part] = /keyframes f(\d+) .* (\S+)% /.exec(film) ?? [], count = (100 * frames) / part;
    assert.ok(film.length <= 90 * 1024, name);
    assert.doesNotMatch(film, /<script|<animate|javascript:|href(?!="#p\d+")|\son\w+=|NaN|undefined/i, name);
    assert.ok(film.includes('@media (prefers-reduced-motion: reduce) { g { animation: none !important } }'), `${name} has nothing that moves`);
    assert.equal(still(film), seenIn(film, 0, count), name);
    well(film);
  }
});

test('two pictures are the same if their numbers differ by a tenth of a pixel at most', () => {
  const same = (one, other) => assert.ok(stills.showTheSame(one, other)), different = (one, other) => assert.ok(!stills.showTheSame(one, other));
  same('<path d="M1.0 20.0"/>', '<path d="M1.1 19.9"/>');
  same('M9.9h0', 'M10.0h0');
  different('M1.0 20.0', 'M1.2 20.0');
  different('M1.0 20.0', 'L1.0 20.0');
  different('M1.0 20.0', 'M1.0 20.0h0');
  different('M1.0', 'M-1.0');
});

test('one is kept for each start, and none without a place; with --check nothing is touched', (t) => {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'stills-')), at = (name) => path.join(folder, name);
  t.after(() => fs.rmSync(folder, { recursive: true }));
  fs.writeFileSync(at('demo'), `#!${process.execPath}
const [, , , start] = process.argv, words = (text) => [text.length, ...Buffer.from(text)];
if (start === 'wind: 9') console.error('there is no control wind'), process.exit(1);
if (start !== undefined) console.log([...words('a ball'), 0, 0, 10, 5, 1, ...words('a'), 0, 0, 9, 1, 0, 0, 0, 0].join(' ') + '\\n0.5 ' + (start.split(': ')[1] ?? 0));
else for (const line of require('fs').readFileSync(0, 'utf8').trim().split('\\n')) console.log([0, 0, 0, 0, 10, 5, 1, 4, 0, 0, 1, 1, 1, 1, ...words(line.split(' ')[9]), 0, 0, 0, 0].join(' '));
`, { mode: 0o755 });
  const program = fileURLToPath(new URL('../../tools/play/stills.cjs', import.meta.url));
  const run = (...more) => execFileSync(process.execPath, [program, ...more], { encoding: 'utf8' }).split('\n').map((line) => line.slice(line.lastIndexOf('/') + 1)).filter(Boolean);
  const keep = (...starts) => run('', at('demo'), at('07'), ...starts), check = (...starts) => run('--check', at('demo'), at('07'), ...starts);
  const kept = () => fs.readdirSync(folder).filter((name) => name.endsWith('.svg'));

  assert.deepEqual(check('', 'a: 1'), ['07.svg is not what its demo shows today.', '07_2.svg is not what its demo shows today.']);
  assert.deepEqual(kept(), []);
  assert.deepEqual(keep('', 'a: 1', 'b: 2'), ['07.svg', '07_2.svg', '07_3.svg']);
  assert.match(fs.readFileSync(at('07_3.svg'), 'utf8'), /<title>a ball<.*>2<\/text>/s);
  assert.deepEqual(keep('', 'a: 1', 'b: 2'), []);
  assert.deepEqual(check('', 'c: 3'), ['07_2.svg is not what its demo shows today.', '07_3.svg has no place.']);
  assert.deepEqual(kept().length, 3);
  assert.deepEqual(keep('', 'c: 3'), ['07_2.svg', '07_3.svg']);
  assert.deepEqual(kept(), ['07.svg', '07_2.svg']);
  const { status, stderr } = spawnSync(process.execPath, [program, '', at('demo'), at('07'), 'wind: 9'], { encoding: 'utf8' });
  assert.deepEqual([status, stderr], [1, 'there is no control wind\n']);
});
