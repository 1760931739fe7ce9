// Finishes the site's pages: node finish.cjs KATEX.JS LUNR.JS PAGES.JSON typesets formulas, colours code and links its
// names, keeps a number and its unit on one line, and makes the search's index; the answer is JSON again.
// A formula that KaTeX cannot read, or only with a warning, is named with its place in the book, and nothing is written.
'use strict';
const fs = require('node:fs');
const [katexFile, lunrFile, input] = process.argv.slice(2);
const katex = require(katexFile), lunr = require(lunrFile);
const { pages, names } = JSON.parse(fs.readFileSync(input, 'utf8'));

const entities = { amp: '&', lt: '<', gt: '>', quot: '"', nbsp: '\u00A0' };
const unescaped = (html) => html.replace(/&(amp|lt|gt|quot|nbsp);/g, (_, name) => entities[name]);
const escaped = (text) => text.replace(/[&<>"]/g, (sign) => `&${Object.keys(entities).find((name) => entities[name] === sign)};`);

// Formulas

let bad = 0;
const typeset = new Map(); // many formulas are there more than once
function formula(tex, display = '', from) {
  const key = display + tex;
  if (!typeset.has(key)) {
    try {
      typeset.set(key, katex.renderToString(unescaped(tex), { displayMode: Boolean(display), output: 'htmlAndMathml', strict: 'error' }));
    } catch (error) {
      bad += 1;
      console.error(`${from}: the formula $${unescaped(tex)}$ cannot be read: ${error.message}`);
      return '';
    }
  }
  return typeset.get(key);
}

// A formula with the comma behind it in its last unbreakable piece: a browser would begin a line with it otherwise.
// A screen reader passes over the pieces, and reads the comma behind the formula's MathML.
const withMark = (html, mark) =>
  html.replace(/(?=<\/span><\/span><\/span>$)/, `<span class="mark">${mark}</span>`).replace('</math>', `</math>${mark}`);

// Code

const words = (text) => new Set(text.split(' '));
const string = /"(?:\\[^]|[^"\\\n])*"|'(?:\\[^]|[^'\\\n])*'/, number = /\.?\d(?:'?[\w.])*/, word = /[A-Za-z_]\w*(?:::[A-Za-z_]\w*)*/;
const languages = {
  cpp: {
    comment: /\/\/.*|\/\*[^]*?\*\//,
    string: new RegExp(`R"(?<fence>\\w*)\\([^]*?\\)\\k<fence>"|${string.source}`),
    macro: /^[ \t]*#(?:\\\n|(?!\/\/).)*/,
    keyword: words('alignas alignof auto break case catch class concept const const_cast consteval constexpr constinit continue decltype default delete do dynamic_cast else enum explicit extern false final for friend goto if inline mutable namespace new noexcept nullptr operator override private protected public reinterpret_cast requires return sizeof static static_assert static_cast struct switch template this throw true try typedef typename union using virtual volatile while'),
    type: words('bool char double float int long short signed unsigned void'),
  },
  gnuplot: { comment: /#.*/, string, macro: /@\w+/, keyword: words('do else for from if while with'), type: words('') },
};
for (const language of Object.values(languages))
  language.pieces = new RegExp(`(?<comment>${language.comment.source})|(?<string>${language.string.source})|(?<macro>${language.macro.source})|${number.source}|(?<![\\w.]|->|::)(?<word>${word.source})|\\w+`, 'gm');

// Where a name leads that a page of this section says: to what its own header declares, or what all share, or a type
// that one section alone has. "wall::Touch" says itself whose it is.
const types = new Map();
for (const [name, found] of Object.values(names).flatMap(Object.entries))
  if (/^(struct|class)/.test(found.address)) types.set(name, types.has(name) ? undefined : found);
const own = (name, space) => (Object.hasOwn(names[space] ?? {}, name) ? names[space][name] : undefined);
function declared(name, space) {
  const at = name.lastIndexOf('::');
  return at < 0 ? own(name, space) ?? own(name, 'course') ?? types.get(name) : own(name.slice(at + 2), name.slice(0, at));
}

// A function where it is called, anything else where it is not: a variable may have a function's name. Of
// "wall::Touch::share" it is the type that leads somewhere.
function linked(word, space, called) {
  for (let name = word; name; name = name.slice(0, Math.max(0, name.lastIndexOf('::')))) {
    const found = declared(name, space);
    if (found && (name.includes('::') || found.function === called)) return `<a class="code" href="${found.address}">${name}</a>${word.slice(name.length)}`;
  }
  return word;
}

function coloured(code, language, space) {
  const { pieces, keyword, type } = languages[language];
  let html = '', from = 0;
  for (const found of code.matchAll(pieces)) {
    const [piece] = found, { word } = found.groups, end = found.index + piece.length;
    const kind = keyword.has(piece) ? 'keyword' : type.has(piece) ? 'type' : ['comment', 'string', 'macro'].find((one) => found.groups[one] !== undefined);
    html += escaped(code.slice(from, found.index));
    if (kind) html += piece.split('\n').map((line) => `<span class="${kind}">${escaped(line)}</span>`).join('\n');
    else html += word && language === 'cpp' ? linked(word, space, /^\s*\(/.test(code.slice(end, end + 9))) : piece;
    from = end;
  }
  return html + escaped(code.slice(from));
}

function listing(code, language, numbered, space) {
  const html = coloured(unescaped(code), language, space).replace(/\n$/, '');
  const lines = numbered ? html.split('\n').map((line, at) => `<span class="line" id="L${at + 1}">${line}</span>`).join('\n') : html;
  return `<pre class="code${numbered}"><code>${lines}\n</code></pre>`;
}

// Text

// The spaces in "7.2 N s", "(3, 4) m" and "310 000".
const quantity = /\d\)?\s(?:N\ss|px|[mk]?m|k?g|m?s|N|J|Hz|rad|%|kB|MB|GB)(?![A-Za-z0-9])|\d (?=\d{3}(?!\d))/g;
const unbroken = (text) => text.replace(quantity, (found) => found.replace(/\s/g, '\u00A0'));

// What is empty is no heading of a column.
const tables = (html) => html.replace(/<t[hd] align="\w+">/g, (cell) => cell.replace('align', 'class')).replace(/<th([^>]*)><\/th>/g, '<td$1></td>');

// The hints of an exercise are a row of chips, and what a hint is about is seen once it is open.
const chips = (html) => html
  .replace(/<summary>(Hint \d+)(: [^]*?)<\/summary>/g, '<summary>$1<span>$2</span></summary>')
  .replace(/(?:<details class="hint">[^]*?<\/details>\s*)+/g, (row) => `<div class="hints">${row.trimEnd()}</div>\n`);

const pieces = /<span class="math( display)?" data-from="([^"]*)">([^<]*)<\/span>([,.;:!?)]*)|<pre class="code( numbered)?" data-language="(\w+)"><code>([^<]*)<\/code><\/pre>|<code(?: class="long")?>([^<]*)<\/code>|<(\/?)(a|h1|h2|h3|summary|pre)\b[^>]*>|<[^>]*>|[^<]+/g;
function finished({ html, space }) {
  const seen = new Set(); // names that are links already, in this part of the page
  let within = 0; // elements in which names are no links
  return chips(tables(html)).replace(pieces, (all, display, from, tex, mark, numbered, language, code, name, end, tag) => {
    if (tex !== undefined) return display ? formula(tex, display, from) + mark : mark ? withMark(formula(tex, display, from), mark) : formula(tex, display, from);
    if (code !== undefined) return listing(code, language, numbered ?? '', space);
    if (name !== undefined) {
      const found = within === 0 && !seen.has(name) && own(name, space);
      if (found) seen.add(name);
      return found ? `<a class="code" href="${found.address}">${all}</a>` : all;
    }
    if (tag) within += end ? -1 : 1;
    if (tag === 'h2') seen.clear();
    return all.startsWith('<') ? all : unbroken(all);
  });
}

// Search. A script, since a page that was opened as a file may not fetch anything else.

// A formula as KaTeX writes it, in plain characters: "x²", "v_x", "a/b", "√2".
const plainFormula = (html) => html.match(/<math[^]*?(?=<annotation)/)[0]
  .replace(/<mn>(\d)<\/mn>(?=<\/msup>)/g, (_, digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'[digit])
  .replace(/<msub>(<m[ino]\b[^>]*>[^<]*<\/m[ino]>)/g, '$&_')
  .replace(/<msup>(<m[ino]\b[^>]*>[^<]*<\/m[ino]>)(?![⁰¹²³⁴-⁹])/g, '$&^')
  .replace(/<mfrac>(<(m\w+)\b[^>]*>(?:(?!<\2\b)[^])*?<\/\2>)/g, '$1/')
  .replace(/<msqrt>/g, '√')
  .replace(/(?<!<mrow>|[(,] ?<\/mo>)<mo\b[^>]*>([=+−≤≥≈→·×±⋅]|&lt;|&gt;)<\/mo>/g, ' $1 ')
  .replace(/<mspace\b|<\/mtd>|\u2061/g, ' $&').replace(/,<\/mo>/g, '$& ').replace(/⋅/g, '·')
  .replace(/<[^>]*>|[\u2061-\u2064\u200B]/g, '');
const plain = (html) =>
  unescaped(html.replace(/<span class="math( display)?" data-from="([^"]*)">([^<]*)/g, (_, display, from, tex) => plainFormula(formula(tex, display, from))).replace(/<\/(p|li|td|th|div|pre|summary|figcaption)>/g, ' ').replace(/<[^>]*>/g, ''))
    .replace(/\s+/g, ' ').trimStart();

// One document for each part of a page, from heading to heading.
function documents({ name, title, html }) {
  return html.replace(/<h1>[^]*?<\/h1>/, '').split(/(?=<h[23] id=")/).map((part) => {
    const [heading, id, inside] = part.match(/^<h[23] id="([^"]*)">([^]*?)<a class="anchor".*<\/h[23]>/) ?? [''];
    const other = /<p class="words" hidden>([^<]*)<\/p>/g, also = /<!-- also: ([^<>]*) -->/g; // what readers may type for what this part is about, or for a term
    return {
      page: title,
      part: heading && plain(inside).trimEnd(),
      address: `${name}.html${heading && `#${id}`}`,
      text: plain(part.slice(heading.length).replace(other, '')),
      words: [...part.matchAll(other)].map(([, one]) => one).join(' '),
      also: [...part.matchAll(also)].map(([, one]) => one).join(' '),
    };
  }).filter(({ part, text }) => part || text);
}

function searchIndex() {
  const found = pages.filter(({ kind }) => kind === 'chapter').flatMap(documents);
  for (const [space, inside] of Object.entries(names))
    for (const [name, { address, function: called }] of Object.entries(inside))
      found.push({ page: `Interface: ${space}`, part: called ? `${name}()` : name, address, text: '', words: '', also: '' });
  // Words end where letters and digits do: `time_of_impact(motion` is four.
  lunr.tokenizer.separator = /[^\p{L}\p{N}]+/u;
  const index = lunr(function () {
    this.ref('number');
    this.field('part', { boost: 5 });
    this.field('words', { boost: 12 });
    this.field('also');
    this.field('page', { boost: 2 });
    this.field('text');
    found.forEach((document, number) => this.add({ number, ...document }));
  });
  const shown = found.map(({ words, also, ...document }) => document); // what only the index needs is not sent along
  return `window.searchIndex = ${JSON.stringify({ documents: shown, index })};\n`;
}

const answer = { pages: pages.map(finished), index: bad === 0 && searchIndex() };
if (bad === 0) process.stdout.write(JSON.stringify(answer));
process.exitCode = bad === 0 ? 0 : 1;
