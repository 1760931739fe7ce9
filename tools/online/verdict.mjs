// The terminal's words as a page shows them: its colours as classes, its places as links and buttons.
import { make, makeButton } from './elements.mjs';

const colours = { 1: 'bold', 2: 'dim', 31: 'red', 32: 'green', 33: 'yellow' };

// [words, colour or '']
export function inColours(text) {
  let colour = '';
  return text.split(/\x1b\[(\d*)m/).map((part, at) => {
    if (at % 2 === 0) return [part, colour];
    colour = colours[part] ?? '';
    return ['', ''];
  }).filter(([words]) => words !== '');
}

// Words and places in them: { words }, { words, line } for one in the reader's file, { words, page } for a test.
export function withPlaces(text, section) {
  const places = new RegExp(String.raw`(?:exercises/)?\b${section}\.cpp:(\d+)(?::\d+)?|\btests/${section}/tests\.cpp:(\d+)`, 'g');
  const parts = [];
  let end = 0;
  for (const { 0: words, 1: line, 2: test, index } of text.matchAll(places)) {
    parts.push({ words: text.slice(end, index) });
    parts.push(test ? { words, page: `source_tests_${section}_tests_cpp.html#L${test}` } : { words, line: Number(line) });
    end = index + words.length;
  }
  return [...parts, { words: text.slice(end) }].filter(({ words }) => words !== '');
}

// As elements, and `go(line)` when a place in the reader's file is pressed.
export function asElements(text, section, go) {
  const place = ({ words, page, line }) =>
    page ? make('a', { textContent: words, href: page, target: '_blank' })
      : line ? makeButton(words, () => go(line), { className: 'place' })
        : words;
  return inColours(text.trimEnd()).map(([words, className]) => make('span', { className }, ...withPlaces(words, section).map(place)));
}

// The picture of a verdict, which is SVG; nothing if it can't be read.
export function asPicture(svg) {
  const { documentElement } = new DOMParser().parseFromString(svg, 'image/svg+xml');
  return documentElement.localName === 'svg' ? document.importNode(documentElement, true) : null;
}
