// The still pictures of a demo, for forges, paper and browsers without JavaScript: what its own program plays, drawn by the
// page's code, as SVGs of 640 px in the colours of figures, for light and dark pages.
//
//   stills.cjs '' PROGRAM NAME START...       keeps one for each start as NAME.svg, NAME_2.svg, ...; prints what changed
//   stills.cjs --check PROGRAM NAME START...  only says what would
'use strict';
const { execFileSync } = require('node:child_process'), fs = require('node:fs'), path = require('node:path');
require('../../docs/draw.js');
const { reader, aboutOf, frameOf, viewOf, draw } = globalThis.demoPicture;
const root = path.join(__dirname, '../..'), width = 640; // [px]

// Each colour as it is on a light page, and on a dark one; `line` is a faint `dim`.
const colours = {};
for (const [, first, light, dark, last] of fs.readFileSync(path.join(root, 'plots/style.gp'), 'utf8').matchAll(/^(\w+) .*"(#\w{6})".*# dark: (#\w{6}) +(\w+)/gm))
  colours[first === 'set' ? last : first.toLowerCase()] = { light, dark };
colours.line = { ...colours.dim, strength: 0.35 };

// One digit behind the point; never "-0.0".
const digits = (x) => (Math.round(10 * x) / 10 + 0).toFixed(1);
const escaped = (text) => text.replace(/[&<>]/g, (sign) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;' })[sign]);

// As much of a canvas's pen as docs/draw.js uses; what it draws becomes elements of an SVG.
class Pen {
  drawn = '';
  used = new Set();
  setLineDash(dash) { this.dash = dash; }
  beginPath() { this.path = '', this.radius = 0; }
  moveTo(x, y) { this.to('M', x, y); }
  lineTo(x, y) { this.to(this.path ? 'L' : 'M', x, y); }
  to(how, x, y) { this.path += `${how}${digits(x)} ${digits(y)}`; }
  arc(x, y, radius) { this.path += 'h0', this.radius = radius; } // a whole disc: a line without a length, whose round ends it is
  stroke(width = this.lineWidth) {
    const dashes = this.dash.length > 0 ? ` stroke-dasharray="${this.dash.join(' ')}"` : '';
    if (this.path) this.element('path', 'stroke', `fill="none" `, ` stroke-width="${digits(width)}"${dashes} d="${this.path}"/>`);
  }
  fill() {
    if (this.radius > 0) this.stroke(2 * this.radius);
    else if (this.path) this.element('path', 'fill', '', ` d="${this.path}Z"/>`);
  }
  fillText(text, x, y) { this.element('text', 'fill', '', ` x="${digits(x)}" y="${digits(y)}">${escaped(text)}</text>`); }
  element(name, paint, before, after) {
    const { light, dark, strength = 1 } = this.fillStyle, opacity = strength * this.globalAlpha;
    this.used.add(`[${paint}="${light}"] { ${paint}: ${dark} }\n`);
    this.drawn += `<${name} ${before}${paint}="${light}"${opacity < 1 ? ` ${paint}-opacity="${opacity.toFixed(2)}"` : ''}${after}\n`;
  }
}

function svgOf(about, shapes) {
  const view = viewOf(about, width), height = view.height.toFixed(0), pen = new Pen();
  draw(pen, shapes, view, colours);
  return `<?xml version="1.0" encoding="utf-8"?>
<svg width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" xmlns="http://www.w3.org/2000/svg" stroke-linecap="round" stroke-linejoin="round" font-family="Inter,Segoe UI,Helvetica,Arial,sans-serif" font-size="16" role="img">
<title>${escaped(about.title)}</title><style>
svg { color-scheme: light dark }
@media (prefers-color-scheme: dark) {
${[...pen.used].sort().join('')}}
</style>
${pen.drawn}</svg>
`;
}

// On another machine a sine may differ in its last bit, and so a number here by the last of its digits.
function showTheSame(one, other) {
  const number = /\d+(\.\d+)?/g, [these, those] = [one, other].map((text) => text.match(number).map(Number));
  return one.replace(number, '') === other.replace(number, '') && these.every((x, i) => Math.abs(x - those[i]) < 0.11);
}

// What a demo's own program plays from this start until its picture is taken
function play(program, start) {
  const rows = execFileSync(program, ['--picture', start], { timeout: 60000, encoding: 'utf8', stdio: 'pipe' }).trim().split('\n');
  const [about, frame] = rows.map((row) => reader(row.split(' ').map(Number)));
  return svgOf(aboutOf(about), frameOf(frame).shapes);
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

module.exports = { showTheSame, svgOf };
if (require.main === module)
  try {
    stills(...process.argv.slice(2));
  } catch (error) {
    process.stderr.write(error.stderr || `${error.message}\n`);
    process.exitCode = 1;
  }
