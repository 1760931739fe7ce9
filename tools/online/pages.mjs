// What a page of the site gets in the online edition.
import { asHere } from './words_here.mjs';

// Nothing comes from another host, and of what may run only WebAssembly is compiled on the page. Formulas and the editor
// have styles of their own, and the site's icon is a `data:`.
const policy = [
  "default-src 'self'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self' 'unsafe-inline'",
  "img-src 'self' data: blob:",
  "object-src 'none'",
  "base-uri 'self'", // 404.html has one
  "form-action 'none'",
].join('; ');

const box = /<article class="turn"[^>]* data-exercise="([\d.]+)"[^>]*>[^]*?(?=<\/article>)/g;
const verdict = /<figure class="listing"><pre class="console"><code>\$ \.\/course check [^]*?<\/figure>\n/;
const later = /<blockquote>\n<p><strong>(?!Your test)[^]*?(?=<\/blockquote>)/g;
const hints = /<div class="hints">((?:<details class="hint">[^]*?<\/details>\s*)+)<\/div>\n/g;

// What we get is folded in a box, where the reader's own is to be; a box has the hints that follow it, or follow a later
// one of the same exercise. One without an editor has a link to it.
function asBoxes(html) {
  const rows = {};
  let exercise;
  const without = html.replace(new RegExp(`${box.source}|${hints.source}|${later.source}`, 'g'), (all, number, row) => {
    exercise = number ?? exercise;
    if (all.startsWith('<blockquote>')) return `${all}<p><a href="#code-${exercise}">Back to your code</a></p>\n`;
    if (row) rows[exercise] = (rows[exercise] ?? '') + row;
    return row ? '' : all;
  });
  return without.replace(box, (all, number) => all.replace(verdict, '<details><summary>What comes out</summary>\n$&</details>\n')
    + (rows[number] ? `<div class="hints">${rows[number]}</div>\n` : ''));
}

const script = (name) => `<script src="${name}" defer></script>\n`;
const style = (name) => `<link rel="stylesheet" href="${name}">\n`;

// What a page gets of this folder: the editor in its boxes, if it has exercises; a place for sketches, if it is the one about them; or
// else ticks for what is done.
function additions(html, file, folder) {
  const own = (name) => `${folder}/${name}`;
  if (file === 'sketches.html') return style('play.css') + style(own('editor.css')) + ['draw.js', 'answers.js', 'play.js', own('ticks.js'), own('sketch.js')].map(script).join('');
  return /class="turn"[^>]* data-exercise=/.test(html) ? style(own('editor.css')) + script(own('editor.js')) : script(own('ticks.js'));
}

// The same page in the online edition.
export function onlinePage(html, folder, file = '') {
  const charset = '<meta charset="utf-8">', end = '</head>', heading = '</h1>', root = '<html lang="en"';
  if (!html.includes(charset) || !html.includes(end)) throw new Error(`a page has no ${charset} or no ${end}: ${html.slice(0, 100)}`);
  const changed = file === 'sketches.html' ? html.replace(heading, `${heading}\n<div id="sketch"></div>`) : html;
  return asHere(asBoxes(changed)).replace(root, `${root} data-online`).replace(charset, `${charset}\n<meta http-equiv="Content-Security-Policy" content="${policy}">`).replace(end, additions(html, file, folder) + end);
}
