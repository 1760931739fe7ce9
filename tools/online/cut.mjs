// The compiler for pages is cut to a third: what no answer has ever called is taken out, and traps. A page that meets such a trap
// loads the whole one. Which functions are called is in called.txt, which train.mjs writes: the compiler's checksum, then a
// bit for each function in base 64; another training adds to it.
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import { countImports, Reader, section, withBodies, withSections } from './wasm.mjs';

const list = new URL('called.txt', import.meta.url);
const checksum = (bytes) => createHash('sha256').update(bytes).digest('hex');

// Functions by their index, those that are imported first; beside those that were called before.
export function saveCalled(compiler, called) {
  const known = fs.existsSync(list) && fs.readFileSync(list, 'utf8').startsWith(checksum(compiler)) ? loadCalled(compiler) : { has: () => false };
  const bits = new Uint8Array(countFunctions(compiler) + 7 >> 3), all = [...Array(8 * bits.length).keys()].filter(known.has);
  for (const index of [...all, ...called]) bits[index >> 3] |= 1 << (index & 7);
  const lines = Buffer.from(bits).toString('base64').match(/.{1,120}/g);
  fs.writeFileSync(list, [checksum(compiler), ...lines, ''].join('\n'));
}
function countFunctions(compiler) {
  let count = 0;
  withSections(compiler, (id, content) => {
    if (id === section.imports) count += countImports(content).functions;
    if (id === section.code) count += new Reader(content).number();
    return content;
  });
  return count;
}
export function loadCalled(compiler) {
  const [of, ...lines] = fs.readFileSync(list, 'utf8').trim().split('\n');
  if (of !== checksum(compiler)) throw new Error('called.txt is about another version of the compiler: run tools/online/train.mjs');
  const bits = Buffer.from(lines.join(''), 'base64');
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
