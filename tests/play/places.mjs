// What is seen at the places of a demo, played as its film is.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import { fileURLToPath } from 'node:url';
import { aboutOf, frameOf, line, printedRow, reader } from './rows.mjs';

const beats = 250; // of 1/64 s: a film

/// How the places of this section's chapter start its demo, in their order.
export function placesOf(section) {
  const chapter = fs.readFileSync(fileURLToPath(new URL(`../../chapters/${section}/README.md`, import.meta.url)), 'utf8');
  return [...new Set([...chapter.matchAll(/^<!-- demo: [a-z]\w*(?: mine)?(?:, ([^|\n]*\S))? \|/gm)].map(([, start]) => start ?? ''))];
}

/// The pictures of a place's film; then, if `answer` is one of its demo's keys, those of a second more after it's pressed.
export function film(program, start, answer) {
  const run = (words, input) => execFileSync(program, words, { input, maxBuffer: 1 << 30 }).toString().trim().split('\n').map(printedRow);
  const [described, [, ...values]] = run(['--picture', start], ''), about = aboutOf(reader(described));
  const lines = Array.from({ length: beats + (answer ? 64 : 0) }, (_, i) => {
    const key = i === beats ? about.keys.findIndex((each) => each.key === answer) : -1;
    return `${line([1 / 64, 0, 0, 0, 0, 0, 0, -1, key], values)}\n`;
  });
  return run([], lines.join('')).map((row) => frameOf(reader(row)));
}

const cross = ([a, b], [x, y], [u, v]) => (x - a) * (v - b) - (y - b) * (u - a);
function half(points) {
  const way = [];
  for (const point of points) {
    while (way.length > 1 && cross(way.at(-2), way.at(-1), point) <= 0) way.pop();
    way.push(point);
  }
  return way.slice(0, -1);
}
/// The area of the smallest hull around these points.
export function hullArea(points) {
  const sorted = [...points].sort(([a, b], [x, y]) => a - x || b - y), hull = [...half(sorted), ...half(sorted.reverse())];
  return hull.reduce((sum, [x, y], i) => sum + (x * hull[(i + 1) % hull.length][1] - y * hull[(i + 1) % hull.length][0]) / 2, 0);
}

/// Which part of its picture a film fills: the hull of what isn't the same in all of its frames, and of all handles.
export function filled(pictures) {
  const { low, high } = pictures[0], keyOf = (shape) => JSON.stringify(shape);
  const stays = pictures.map(({ shapes }) => new Set(shapes.map(keyOf))).reduce((all, some) => new Set([...all].filter((each) => some.has(each))));
  const moving = pictures.flatMap(({ shapes }) => shapes.filter((each) => each.kind === 'handle' || (each.kind !== 'words' && !stays.has(keyOf(each)))));
  const around = ({ kind, size, points }) => points.flatMap(([x, y]) => kind === 'discs' ? [[x - size, y], [x + size, y], [x, y - size], [x, y + size]] : [[x, y]]);
  const inside = (point) => point.map((z, k) => Math.min(high[k], Math.max(low[k], z)));
  return hullArea(moving.flatMap(around).map(inside)) / ((high[0] - low[0]) * (high[1] - low[1]));
}

/// How high its picture is on a phone, where it's 350 px wide.
export const heightOnPhone = ([{ low, high }]) => (350 * (high[1] - low[1])) / (high[0] - low[0]);
