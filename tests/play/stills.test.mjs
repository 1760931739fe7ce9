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
const shape = (kind, colour, points, more = {}) => ({ kind, colour, size: 0, strength: 1, points, text: '', ...more });

test('a picture is its shapes in the colours of figures, without its handles', () => {
  const has = (shapes, ...parts) => parts.forEach((part) => assert.ok(stills.svgOf(about, shapes).includes(part), `${part} in ${stills.svgOf(about, shapes)}`));
  has([], 'width="640" height="320"', '<title>A&amp;B</title>');
  has([shape('line', 'blue', [[0, 0], [10, 5]], { size: -2 })],
    '<path fill="none" stroke="#2563eb" stroke-width="2.0" stroke-dasharray="1 6" d="M0.0 320.0L640.0 0.0"/>', '[stroke="#2563eb"] { stroke: #6ea8fe }');
  has([shape('line', 'orange', [[0, 0], [10, 0]])], 'stroke="#d9480f" stroke-width="2.0"');
  has([shape('discs', 'green', [[5, 2.5], [0, 5]], { size: 0.25, strength: 0.5 })], 'stroke="#0b8562" stroke-opacity="0.50" stroke-width="32.0" d="M320.0 160.0h0M0.0 0.0h0"/>');
  has([shape('discs', 'violet', [[0, 0]], { size: 0.001 })], 'stroke-width="2.0"');
  has([shape('area', 'line', [[0, 0], [10, 0], [10, 5]])], '<path fill="#66707f" fill-opacity="0.35" d="M0.0 320.0L640.0 320.0L640.0 0.0Z"/>'); // the page's colour of lines
  has([shape('arrow', 'amber', [[1, 1], [2, 1]], { size: 2 })], 'd="M64.0 256.0L128.0 256.0M128.0 256.0L120.3 260.6M128.0 256.0L120.3 251.4"/>');
  has([shape('words', 'ink', [[1, 1]], { text: '<' })], '<text fill="#1d2430" x="64.0" y="256.0">&lt;</text>');
  assert.ok(!stills.svgOf(about, [shape('handle', 'pink', [[3, 3]])]).includes('#c02672'));
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
  const words = (text) => [text.length, ...Buffer.from(text)].join(' ');
  fs.writeFileSync(at('demo'), `#!/bin/sh
[ "$2" != "wind: 9" ] || { echo "there is no control wind" >&2; exit 1; }
echo "${words('a ball')} 0 0 10 5 0 0 "
echo 1 4 0 0 1 1 1 1 \${#2} $(printf %s "$2" | od -An -tu1) 0
`, { mode: 0o755 });
  const program = fileURLToPath(new URL('../../tools/play/stills.cjs', import.meta.url));
  const run = (...more) => execFileSync(process.execPath, [program, ...more], { encoding: 'utf8' }).split('\n').map((line) => line.slice(line.lastIndexOf('/') + 1)).filter(Boolean);
  const keep = (...starts) => run('', at('demo'), at('07'), ...starts), check = (...starts) => run('--check', at('demo'), at('07'), ...starts);
  const kept = () => fs.readdirSync(folder).filter((name) => name.endsWith('.svg'));

  assert.deepEqual(check('', 'a: 1'), ['07.svg is not what its demo shows today.', '07_2.svg is not what its demo shows today.']);
  assert.deepEqual(kept(), []);
  assert.deepEqual(keep('', 'a: 1', 'b: 2'), ['07.svg', '07_2.svg', '07_3.svg']);
  assert.match(fs.readFileSync(at('07_3.svg'), 'utf8'), /<title>a ball<.*>b: 2<\/text>/s);
  assert.deepEqual(keep('', 'a: 1', 'b: 2'), []);
  assert.deepEqual(check('', 'c: 1'), ['07_2.svg is not what its demo shows today.', '07_3.svg has no place.']);
  assert.deepEqual(kept().length, 3);
  assert.deepEqual(keep('', 'c: 1'), ['07_2.svg', '07_3.svg']);
  assert.deepEqual(kept(), ['07.svg', '07_2.svg']);
  const { status, stderr } = spawnSync(process.execPath, [program, '', at('demo'), at('07'), 'wind: 9'], { encoding: 'utf8' });
  assert.deepEqual([status, stderr], [1, 'there is no control wind\n']);
});
