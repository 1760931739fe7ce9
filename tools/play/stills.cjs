// The pictures of a demo, for forges, paper and browsers without JavaScript: what its own program plays, drawn by the
// page's code, as SVGs of 640 px in the colours of figures, for light and dark pages. Each of them plays about four
// seconds, again and again, by CSS alone: forges run no scripts. What doesn't change is in it once; what does is there
// from one frame to another. Where nothing moves, or nothing may, it shows the moment that its demo names.
//
//   stills.cjs '' PROGRAM NAME START...       keeps one for each start as NAME.svg, NAME_2.svg, ...; prints what changed
//   stills.cjs --check PROGRAM NAME START...  only says what would
'use strict';
const { execFileSync } = require('node:child_process'), fs = require('node:fs'), path = require('node:path');
require('../../docs/draw.js');
const { reader, aboutOf, frameOf, viewOf, draw } = globalThis.demoPicture;
const root = path.join(__dirname, '../..'), width = 640; // [px]
const most = 90 * 1024; // what a picture may weigh [bytes]

// How many frames, how many steps of 1/64 s each of them lasts, and the unit of a disc's place for one frame [0.1 px]: the
// first of these that isn't too heavy. Their percentages and times are exact, so that no moment has two frames, or none.
const films = [[50, 5, 1], [50, 5, 10], [40, 6, 10], [32, 8, 10], [25, 8, 10], [20, 8, 10], [10, 8, 10], [8, 8, 10], [5, 8, 10]];

// Each colour as it is on a light page, and on a dark one; `line` is a faint `dim`.
const colours = {};
for (const [, first, light, dark, last] of fs.readFileSync(path.join(root, 'plots/style.gp'), 'utf8').matchAll(/^(\w+) .*"(#\w{6})".*# dark: (#\w{6}) +(\w+)/gm))
  colours[first === 'set' ? last : first.toLowerCase()] = { light, dark };
colours.line = { ...colours.dim, strength: 0.35 };
const darkColours = Object.fromEntries(Object.entries(colours).map(([name, { dark, strength }]) => [name, { light: dark, dark, strength }]));
const palettes = { page: colours, dark: darkColours, of: ([light, dark]) => ({ light, dark }) };

// Upwards where it's half of one: a sine's last bit, which differs between machines, changes nothing then.
const rounded = (x) => Math.round(10 * x + 1e-4); // [0.1 px]
const digits = (tenths) => String(tenths / 10);
const escaped = (text) => text.replace(/[&<>]/g, (sign) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;' })[sign]);

// Gradients, and the pictures that are stamped: markers, so that many balls are one short path. Each is kept once a film.
class Sheet {
  made = new Map();
  styles = '';
  keep(letter, kind, inside) {
    const key = kind + inside;
    if (!this.made.has(key)) this.made.set(key, { id: `${letter}${this.made.size}`, kind, inside });
    return this.made.get(key).id;
  }
  shade({ from, to, radius, stops }, of) {
    const [[x1, y1], [x2, y2]] = [from, to], kind = radius ? `radialGradient fx="${x1}" fy="${y1}" cx="${x2}" cy="${y2}" r="${radius}"` : `linearGradient x1="${x1}" y1="${y1}" x2="${x2}" y2="${y2}"`;
    return this.keep('g', kind, stops.map(([where, pair, much = 1]) => `<stop offset="${where}" ${this.stop(of(pair), much)}/>`).join(''));
  }
  stop({ light, dark }, much) {
    const faint = much < 1 ? ` stop-opacity="${Number(much.toFixed(2))}"` : '';
    if (light === dark) return `stop-color="${light}"${faint}`;
    const name = `s${light.slice(1)}${dark.slice(1)}`, style = `.${name}{stop-color:${light}}`;
    if (!this.styles.includes(style)) this.styles += `${style}@media (prefers-color-scheme: dark) { .${name}{stop-color:${dark}} }\n`;
    return `class="${name}"${faint}`;
  }
  stamp(circles, radius, of) {
    const circle = ({ away, radius: r, shade }) => `<circle ${['cx', 'cy'].map((name, k) => (away[k] ? `${name}="${digits(rounded(away[k] * radius))}" ` : '')).join('')}r="${digits(rounded(r * radius))}" fill="url(#${this.shade(shade, of)})"/>`;
    return this.keep('m', 'marker overflow="visible" markerUnits="userSpaceOnUse"', circles.map(circle).join(''));
  }
  defsWith(shared) {
    const one = ({ id, kind, inside }) => `<${kind.replace(' ', ` id="${id}" `)}>${inside}</${kind.split(' ')[0]}>\n`;
    const all = [...this.made.values()].map(one).join('') + [...shared].map(([path, id]) => `<path id="${id}" d="${path}"/>\n`).join('');
    return all && `<defs>\n${all}</defs>\n`;
  }
}

// As much of a canvas's pen as docs/draw.js uses. What it draws becomes parts, each with its look: a dot, a line, a text;
// one part for each dot, and for each piece of a long line, which may stay where it is while the line gets longer.
class Pen {
  parts = [];
  shift = [0, 0]; // a look's own, so that strokes upon each other share their path
  constructor(sheet) { this.sheet = sheet; }
  translate(x, y) { this.shift = this.shift.map((z, k) => z + [x, y][k]); }
  tint(pair) { return this.of(pair); }
  shade(shade) { return { url: `url(#${this.sheet.shade(shade, this.of)})` }; }
  stamp(at, radius, circles) {
    const id = this.sheet.stamp(circles, radius, this.of), faint = (this.globalAlpha < 1 ? `;opacity:${Number(this.globalAlpha.toFixed(2))}` : '') + this.blend;
    for (const point of at) this.part(JSON.stringify([`fill:none;marker-start:url(#${id});marker-mid:url(#${id})${faint}`, '']), [point], { stamped: true });
  }
  blend = '';
  adding(on) { this.blend = on ? ';mix-blend-mode:screen' : ''; }
  type = '';
  letters(font, height, anchor) {
    this.type = (height ? `;font-size:${height.toFixed(0)}px;font-weight:600` : '') + { left: '', center: ';text-anchor:middle', right: ';text-anchor:end' }[anchor];
  }
  setLineDash(dash) { this.dash = dash; }
  beginPath() { this.lines = [], this.radius = 0; }
  moveTo(x, y) { this.lines.push([[x, y]]); }
  lineTo(x, y) { this.lines.length > 0 ? this.lines.at(-1).push([x, y]) : this.moveTo(x, y); }
  arc(x, y, radius) { this.radius = radius; }
  stroke(lineWidth = this.lineWidth) {
    const dashes = this.dash.length > 0 ? `;stroke-dasharray:${this.dash.join(' ')}` : '', look = this.look('stroke', `;fill:none;stroke-width:${digits(rounded(lineWidth))}${dashes}`);
    const pale = look.includes('opacity'), dots = this.radius > 0 && this.lines.flat(); // what is pale and overlaps is one part
    if (pale && dots && dots.some(([x, y], i) => i > 0 && Math.hypot(x - dots[i - 1][0], y - dots[i - 1][1]) < lineWidth)) return this.part(look, dots, { dots });
    for (const line of this.lines)
      if (line.length < 9 || dashes || pale) this.part(look, line);
      else line.slice(1).forEach((point, i) => this.part(look, [line[i], point]));
  }
  // In pieces which may stay where they are while it gets longer, but not in as many as there are points.
  strokeWhole() {
    const look = this.look('stroke', `;fill:none;stroke-width:${digits(rounded(this.lineWidth))}`);
    for (const line of this.lines) for (let i = 0; i === 0 || i < line.length - 1; i += 16) this.part(look, line.slice(i, i + 17));
  }
  fill() {
    if (this.radius > 0) this.stroke(2 * this.radius); // a whole disc: a line without a length, whose round ends it is
    else for (const line of this.lines) this.part(this.look('fill'), line, { closed: 'z' });
  }
  fillAndStroke() {
    const [light, dark] = ['light', 'dark'].map((theme) => `stroke:${this.strokeStyle[theme]}`), [own] = JSON.parse(this.look('fill'));
    for (const line of this.lines) this.part(JSON.stringify([`${own};${light};stroke-width:${digits(rounded(this.lineWidth))}`, dark]), line, { closed: 'z' });
  }
  strokeText() { this.outlined = true; } // the words that come next
  fillText(text, x, y) {
    const [own, dark] = JSON.parse(this.look('fill')), outline = (theme) => (this.outlined ? `;stroke:${this.strokeStyle[theme]}` : '');
    this.part(JSON.stringify([`${own}${this.type}${outline('light')}${this.outlined ? `;stroke-width:${this.lineWidth};paint-order:stroke` : ''}`, `${dark}${outline('dark')}`]), [[x, y]], { text: escaped(text) });
    this.outlined = false;
  }
  look(paint, more = '') {
    const { url, light = url, dark = url, strength = 1 } = this.fillStyle, opacity = strength * this.globalAlpha;
    const [x, y] = this.shift.map((z) => digits(rounded(z))), moved = `${x}${y}` === '00' ? '' : `;transform:translate(${x}px,${y}px)`;
    return JSON.stringify([`${paint}:${light}${more}${opacity < 1 ? `;${paint}-opacity:${Number(opacity.toFixed(2))}` : ''}${moved}`, `${paint}:${dark}`]);
  }
  part(look, line, { text = '', closed = '', dots = false, stamped = false } = {}) {
    const at = line.map((point) => point.map((x) => rounded(x)));
    this.parts.push({ look, at, text, closed, dots, stamped, key: `${look}${at}${text}` });
  }
}

// All parts of all frames, what is behind first. A part that is in one frame and in the next is the same one: `from` the
// first of its frames, so many `frames` long.
function partsOf(pictures, unit, sheet) {
  const first = {};
  let before = [];
  pictures.forEach((picture, frame) => {
    const pen = new Pen(sheet), places = new Map(), now = [];
    draw(pen, picture, viewOf(picture, width), palettes);
    before.forEach(({ key }, place) => places.has(key) ? places.get(key).push(place) : places.set(key, [place]));
    let place = -1, last = first;
    for (const part of pen.parts) {
      const next = places.get(part.key)?.find((each) => each > place);
      if (next === undefined) last = last.next = Object.assign(part, { from: frame, frames: 1, next: last.next });
      else last = before[place = next], last.frames++;
      now.push(last);
    }
    before = now;
  });
  const parts = [];
  for (let each = first.next; each; each = each.next) {
    if (each.at.length === 1 && !each.text && each.frames === 1) each.at = [each.at[0].map((tenths) => Math.round(tenths / unit) * unit)];
    parts.push(each);
  }
  return parts;
}

// What begins where the one before ends goes on from there. A point is left out on the straight way to the next one.
function pathOf(together) {
  const parts = together.flatMap((part) => (part.dots ? part.at.map((point) => ({ at: [point], closed: '' })) : [part]));
  const away = ({ at: [[x, y]] }, { at: [[u, v]] }) => Math.abs(x - u) + Math.abs(y - v);
  const { stamped } = parts[0], dots = parts[0].at.length === 1 && (!stamped || parts.length > 64); // a few balls keep their order
  for (let i = 1; i < parts.length && dots; i++) { // the nearest one comes next, for short numbers
    let next = i;
    for (let k = i; k < parts.length; k++) if (away(parts[k], parts[i - 1]) < away(parts[next], parts[i - 1])) next = k;
    [parts[i], parts[next]] = [parts[next], parts[i]];
  }
  const lines = [];
  if (stamped) lines.push({ points: [...parts.map(({ at: [point] }) => point), parts.at(-1).at[0]], closed: '' }); // no stamp at the end
  else for (const { at: [start, ...rest], closed } of parts) {
    if (`${start}` !== `${lines.at(-1)?.points.at(-1)}`) lines.push({ points: [start], closed });
    const { points } = lines.at(-1);
    for (const point of rest) {
      const [x, y] = points.at(-1), [a, b] = points.at(-2) ?? [], [u, v] = point;
      if (points.length > 1 && (x - a) * (v - y) === (y - b) * (u - x) && (x - a) * (u - x) + (y - b) * (v - y) >= 0) points.pop();
      points.push(point);
    }
  }
  let text = '', at = [0, 0];
  const to = (how, [x, y], [a, b] = at) => {
    at = [x, y];
    return how === 'l' && y === b ? `h${digits(x - a)}` : how === 'l' && x === a ? `v${digits(y - b)}` : `${how}${digits(x - a)}${y < b ? '' : ' '}${digits(y - b)}`;
  };
  for (const { points: [start, ...rest], closed } of lines) {
    text += to(text ? 'm' : 'M', start) + (rest.map((point) => to('l', point)).join('') || 'h0') + closed;
    if (closed) at = start;
  }
  return text;
}

// Parts that lie side by side and have one look and one time are one element.
function elementsOf(parts) {
  const elements = [];
  let block = new Map(), look;
  for (const part of parts) {
    if (part.look !== look || part.text) block = new Map();
    look = part.look;
    const time = `${part.from} ${part.frames}`, known = block.get(time);
    if (known) known.parts.push(part);
    else block.set(time, elements[elements.push({ look, from: part.from, frames: part.frames, parts: [part] }) - 1]);
  }
  return elements;
}

// Paths that lie upon each other in several strokes, as those of bars do, and are in it once: by their name.
function sharedBy(elements) {
  const uses = new Map(), shared = new Map(), moved = new Set;
  for (const { path, look } of elements) {
    uses.set(path, (uses.get(path) ?? 0) + 1);
    if (look.includes('transform')) moved.add(path);
  }
  for (const [path, count] of uses) if (moved.has(path) && (count - 1) * path.length > 8 * count + 20) shared.set(path, `p${shared.size}`);
  return shared;
}

// `still` is the number of the picture which the film begins with. A frame lasts so many steps of 1/64 s.
function filmOf(about, pictures, still = 0, [, steps, unit] = [1, 1, 1]) {
  const height = viewOf(pictures[still], width).height.toFixed(0), sheet = new Sheet, count = pictures.length, seconds = (frames) => `${(frames * steps) / 64}s`;
  const looks = new Map(), lasts = new Set(), begins = new Set();
  const named = (look) => looks.get(look) ?? looks.set(look, `c${looks.size}`).get(look);
  let drawn = '', group = '';
  const timed = ({ from, frames }) => {
    if (frames === count) return '';
    const begin = (from - still + count) % count;
    lasts.add(frames), begins.add(begin);
    return `f${frames} b${begin}${begin === 0 || begin + frames > count ? '' : ' h'}`;
  };
  const elements = elementsOf(partsOf(pictures, unit, sheet));
  for (const element of elements) element.path = element.parts[0].text ? '' : pathOf(element.parts);
  const shared = sharedBy(elements);
  for (const element of elements) {
    const { path, look } = element, { text, at: [[x, y]] } = element.parts[0], time = timed(element);
    if (time !== group) drawn += (group && '</g>\n') + (time && `<g class="${time}">`), group = time;
    drawn += text ? `<text class="${named(look)}" x="${digits(x)}" y="${digits(y)}">${text}</text>` : shared.has(path) ? `<use class="${named(look)}" href="#${shared.get(path)}"/>` : `<path class="${named(look)}" d="${path}"/>`;
    if (!group) drawn += '\n';
  }
  const sorted = (numbers) => [...numbers].sort((one, other) => one - other), style = [...looks].map(([look, name]) => [name, ...JSON.parse(look)]);
  const film = lasts.size === 0 ? '' : `.h { visibility: hidden }
${sorted(lasts).map((frames) => `@keyframes f${frames} { 0% { visibility: visible } ${(100 * frames) / count}% { visibility: hidden } }
.f${frames}{animation:f${frames} ${seconds(count)} step-end infinite}
`).join('')}${sorted(begins).map((begin) => `.b${begin}{animation-delay:${seconds(begin && begin - count)}}\n`).join('')}@media (prefers-reduced-motion: reduce) { g { animation: none !important } }
`;
  return `<?xml version="1.0" encoding="utf-8"?>
<svg width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" xmlns="http://www.w3.org/2000/svg" stroke-linecap="round" stroke-linejoin="round" font-family="Inter,Segoe UI,Helvetica,Arial,sans-serif" font-size="16" role="img">
<title>${escaped(about.title)}</title><style>
svg { color-scheme: light dark; background: #fdfcfa }
@media (prefers-color-scheme: dark) { svg { background: #14171d } }
${style.map(([name, light]) => `.${name}{${light}}\n`).join('')}@media (prefers-color-scheme: dark) {
${style.map(([name, , dark]) => `.${name}{${dark}}\n`).join('')}}
${film}${sheet.styles}</style>
${sheet.defsWith(shared)}${drawn}${group && '</g>\n'}</svg>
`;
}

// On another machine a sine may differ in its last bit, and so a number here by the last of its digits.
function showTheSame(one, other) {
  const number = /\d+(\.\d+)?/g, [these, those] = [one, other].map((text) => text.match(number).map(Number));
  return one.replace(number, '') === other.replace(number, '') && these.every((x, i) => Math.abs(x - those[i]) < 0.11);
}

// What a demo's own program plays from this start: up to its picture, and on.
function play(program, start) {
  const run = (words, input) => execFileSync(program, words, { input, timeout: 60000, encoding: 'utf8', stdio: 'pipe', maxBuffer: 1 << 30 }).trim().split('\n').map((row) => row.split(' ').map(Number));
  const [described, [time, ...values]] = run(['--picture', start], ''), about = aboutOf(reader(described));
  const taken = Math.ceil(64 * time), frame = [1 / 64, 0, 0, 0, 0, 0, 0, -1, -1, ...values].join(' ');
  const shown = run([], `${frame}\n`.repeat(taken + 256)).map((row) => frameOf(reader(row)));
  let picture;
  for (const film of films) {
    const [count, each] = film, before = Math.min(Math.floor((taken - 1) / each), count - 1);
    const pictures = Array.from({ length: count }, (_, i) => shown[taken - 1 + each * (i - before)]);
    picture = filmOf(about, pictures, before, film);
    if (picture.length <= most) break;
  }
  return picture;
}

function stills(check, program, name, ...starts) {
  const file = (at) => `${name}${at === 0 ? '' : `_${at + 1}`}.svg`;
  const say = (at, trouble) => console.log(path.relative(root, file(at)) + (check ? ` ${trouble}.` : ''));
  starts.forEach((start, at) => {
    const picture = play(program, start);
    if (fs.existsSync(file(at)) && showTheSame(fs.readFileSync(file(at), 'utf8'), picture)) return;
    if (!check) fs.writeFileSync(file(at), picture);
    say(at, 'is not what its demo shows today');
  });
  for (let at = starts.length; fs.existsSync(file(at)); at++) {
    if (!check) fs.rmSync(file(at));
    say(at, 'has no place');
  }
}

module.exports = { showTheSame, filmOf, colours };
if (require.main === module)
  try {
    stills(...process.argv.slice(2));
  } catch (error) {
    process.stderr.write(error.stderr || `${error.message}\n`);
    process.exitCode = 1;
  }
