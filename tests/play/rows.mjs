// What the tests of demos share: a demo without a page is told what its player does, and its rows of numbers are read.
import assert from 'node:assert';
import { execFileSync } from 'node:child_process';
import '../../docs/draw.js';

export const { reader, aboutOf, frameOf } = globalThis.demoPicture;

/// One line of input, for one frame: dt, a step, the pointer, whether it is inside, pressed and down, handle, key, controls.
export const line = (input, values) => [...input, ...values].map((x) => x.toPrecision(17)).join(' ').replace(/\.0+(?= |$)/g, '');

/// A row as the demo without a page prints it.
export const printedRow = (text) => text.trim().split(' ').map(Number);

/// As many frames as last so many seconds, without a key.
export const seconds = (count) => Array(60 * count).fill('');

/// A readout, which shows two digits behind the point.
export const near = (got, want, by = 0.005) => assert.ok(Math.abs(got - want) < by, `${got}, not ${want}`);

/// A demo that was built without a page.
export function player(native) {
  const run = (words, input) => execFileSync(native, words, { input, maxBuffer: 1 << 30 }).toString().trim().split('\n');
  const about = aboutOf(reader(printedRow(run(['--picture', ''], '')[0])));
  const demo = {
    /// Its controls as they are at first, but for these.
    values: (chosen) => about.controls.map(({ name, value, options }) => (name in chosen ? (options.length > 0 ? options.indexOf(chosen[name]) : chosen[name]) : value)),
    /// The picture after each of these keys, as in `readouts`.
    pictures(values, keys) {
      const at = (key) => about.keys.findIndex((each) => each.key === key);
      const input = (key) => (Array.isArray(key) ? [key[1], key[2], 1, 1, 1, key[0], -1] : [0, 0, 0, 0, 0, -1, at(key)]);
      return run([], keys.map((key) => `${line([1 / 60, 0, ...input(key)], values)}\n`).join('')).map((row) => frameOf(reader(printedRow(row))));
    },
    /// A frame for each of these keys, with '' for none, of 1/60 s; the readouts after the last one in each second.
    /// In the place of a key, [handle, x, y] drags a handle there.
    readouts(values, keys) {
      const shown = demo.pictures(values, keys).filter((_, frame) => frame % 60 === 59);
      return shown.map(({ readouts }) => Object.fromEntries(readouts.map(({ name, value }) => [name, value])));
    },
    /// The last ones of these readouts, with these controls.
    last: (chosen, keys) => demo.readouts(demo.values(chosen), keys).at(-1),
  };
  return demo;
}
