// The compiler for pages is cut to a third: what no answer has ever called is taken out, and traps. A page that meets such a trap
// loads the whole one. Which functions are called is in called.txt, which train.mjs writes: the compiler's checksum, then a
// bit for each function in base 64; another training adds to it.
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import { countImports, section, withBodies, withSections } from '../play/wasm.mjs';

const list = new URL('called.txt', import.meta.url);
const checksum = (bytes) => createHash('sha256').update(bytes).digest('hex');

// The checksum of the compiler that it is about, and the bits; another compiler has none yet.
function known() {
  if (!fs.existsSync(list)) return { bits: Buffer.alloc(0) };
  const [of, ...lines] = fs.readFileSync(list, 'utf8').trim().split('\n');
  return { of, bits: Buffer.from(lines.join(''), 'base64') };
}

// Functions by their index, those that are imported first; beside those that were called before.
export function saveCalled(compiler, called) {
  const { of, bits: before } = known(), bits = Buffer.alloc(Math.max(before.length, 1 + (called.reduce((a, b) => Math.max(a, b), 0) >> 3)));
  if (of === checksum(compiler)) before.copy(bits);
  for (const index of called) bits[index >> 3] |= 1 << (index & 7);
  fs.writeFileSync(list, [checksum(compiler), ...bits.toString('base64').match(/.{1,120}/g), ''].join('\n'));
}
export function loadCalled(compiler) {
  const { of, bits } = known();
  if (of !== checksum(compiler)) throw new Error('called.txt is about another version of the compiler: run tools/online/train.mjs');
  return { has: (index) => Boolean(bits[index >> 3] & (1 << (index & 7))) };
}

const unreachable = Uint8Array.from([0, 0, 11]); // no locals, trap, end

export function cut(compiler, called) {
  let imported = 0;
  return withSections(compiler, (id, content) => {
    if (id === section.custom) return null; // names and the like
    if (id === section.imports) imported = countImports(content).functions;
    return id === section.code ? withBodies(content, (body, i) => (called.has(imported + i) ? body : unreachable)) : content;
  });
}
