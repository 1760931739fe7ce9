// Whether what a picture says by its colours is seen: on each stage, by day and by night, and by eyes without red or green.
import assert from 'node:assert';
import { test } from 'node:test';
import '../../docs/draw.js';
import stills from '../../tools/play/stills.cjs';

const { paints, grounds, outlines } = globalThis.demoPicture, { colours } = stills;
const bytes = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
const linear = (hex) => bytes(hex).map((x) => (x / 255 <= 0.04045 ? x / 255 / 12.92 : ((x / 255 + 0.055) / 1.055) ** 2.4));
const bright = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
const contrast = (one, other) => {
  const [low, high] = [bright(linear(one)), bright(linear(other))].sort((a, b) => a - b);
  return (high + 0.05) / (low + 0.05);
};
// The darkened edge of a body, as docs/draw.js has it.
const edge = (hex) => `#${bytes(hex).map((x) => Math.round(x * 0.45).toString(16).padStart(2, '0')).join('')}`;
const themes = ['light', 'dark'], hasDay = (stage) => !['felt', 'night'].includes(stage), themeOn = (stage, theme) => (hasDay(stage) ? theme : 'dark');

// Machado, Oliveira and Fernandes 2009, for eyes without one kind of cones.
const eyes = {
  all: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  'no red': [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
  'no green': [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
};
const seenBy = (eye, hex) => eyes[eye].map((row) => Math.min(1, Math.max(0, row.reduce((sum, x, k) => sum + x * linear(hex)[k], 0))));
function lab([r, g, b]) {
  const f = (t) => (t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16 / 116);
  const [x, y, z] = [(0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505, bright([r, g, b]), (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089].map(f);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}
const apart = (eye, one, other) => Math.hypot(...lab(seenBy(eye, one)).map((x, k) => x - lab(seenBy(eye, other))[k]));

test('words are read on each stage, over whatever lies below them', () => {
  for (const [stage, outline] of Object.entries(outlines))
    themes.forEach((theme, k) => {
      for (const name of hasDay(stage) ? ['ink'] : ['ink', 'dim', 'blue', 'orange', 'green', 'pink'])
        assert.ok(contrast(colours[name][themeOn(stage, theme)], outline[k]) >= 4.5, `${name} on ${stage}, ${theme}: ${contrast(colours[name][themeOn(stage, theme)], outline[k]).toFixed(2)}`);
    });
});

test('what is solid is seen by its paint or by its edge, and an arrow by its colour', () => {
  for (const [stage, shades] of Object.entries(grounds))
    themes.forEach((theme, k) => {
      const own = themeOn(stage, theme);
      for (const shade of shades) {
        for (const name of ['ink', 'blue', 'orange', 'amber', 'violet', 'pink', ...(stage === 'felt' ? [] : ['dim'])])
          assert.ok(Math.max(contrast(paints[name][themes.indexOf(own)], shade[k]), contrast(edge(paints[name][themes.indexOf(own)]), shade[k])) >= 3, `${name} on ${stage}, ${theme}`);
        if (!hasDay(stage)) for (const name of ['ink', 'orange', 'green', 'pink', 'amber']) assert.ok(contrast(colours[name].dark, shade[k]) >= 3, `an arrow: ${name} on ${stage}`);
      }
    });
});

// What differs in a picture by its colour, and hasn't words beside it
const pairs = [['orange', 'blue', 'ball A and ball B; one of a thousand'], ['ink', 'amber', 'the cue ball'], ['ink', 'blue', 'the post'], ['dim', 'violet', 'a stone that is held'],
  ['ink', 'violet', 'a bucket that is closed'], ['wood', 'violet', 'a box that is held'], ['orange', 'pink', 'the wall and the load']];
test('two colours that mean different things differ for every eye', () => {
  for (const [one, other, what] of pairs)
    for (const eye of Object.keys(eyes))
      themes.forEach((theme, k) => {
        const far = apart(eye, paints[one][k], paints[other][k]);
        console.log(`${far.toFixed(0)}: ${what}, ${theme}, ${eye}`);
        assert.ok(far >= 20, `${what}, ${theme}, ${eye}: ${far.toFixed(1)}`);
      });
});
test('two arrows, too, though they have words beside them', () => {
  for (const eye of Object.keys(eyes)) {
    const far = apart(eye, colours.pink.dark, colours.green.dark);
    console.log(`${far.toFixed(0)}: pink and green arrows, ${eye}`);
    assert.ok(far >= 15);
  }
});
