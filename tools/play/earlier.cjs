// Compiles a reader's file of an earlier section:  earlier.cjs SLUG OBJECT compiler and its words...
// One that doesn't compile must not keep the demo of a later section from playing: in the object's place is a word that says so.
// And two files may have a helper of the same name, since each was a program of its own: everything but what's in the section's
// namespace is made local, in the object's table of symbols (github.com/WebAssembly/tool-conventions, Linking.md).
'use strict';
const fs = require('node:fs'), { spawnSync } = require('node:child_process');
const weakOrLocal = 3, local = 2, elsewhere = 16, explicitName = 64; // flags of a symbol
const custom = 0, symbolTable = 8, kinds = { data: 1, section: 3 };

function makeLocal(bytes, namespace) {
  let at = 8; // behind the magic number and the version
  const number = () => {
    for (let value = 0, shift = 0; ; shift += 7) {
      value += (bytes[at] & 127) * 2 ** shift;
      if (bytes[at++] < 128) return value;
    }
  };
  const name = () => {
    const size = number();
    return bytes.toString('utf8', at, (at += size));
  };
  const each = (end, read) => {
    while (at < end) {
      const kind = bytes[at++], size = number(), next = at + size;
      read(kind, next);
      at = next;
    }
  };
  function symbol() {
    const kind = bytes[at++], place = at, flags = number(), isElsewhere = (flags & elsewhere) !== 0;
    if (kind === kinds.section) return number();
    if (kind !== kinds.data) number();
    const its = kind === kinds.data || !isElsewhere || flags & explicitName ? name() : '';
    if (kind === kinds.data && !isElsewhere) number(), number(), number();
    if (!isElsewhere && (flags & weakOrLocal) === 0 && !its.includes(namespace)) bytes[place] |= local;
  }
  each(bytes.length, (kind, end) => {
    if (kind !== custom || name() !== 'linking') return;
    number(); // its version
    each(end, (part) => {
      if (part === symbolTable) for (let left = number(); left > 0; left--) symbol();
    });
  });
  return bytes;
}

const [slug, object, compiler, ...words] = process.argv.slice(2);
if (spawnSync(compiler, [...words, '-o', object]).status === 0) fs.writeFileSync(object, makeLocal(fs.readFileSync(object), `${slug.length}${slug}`));
else fs.writeFileSync(object, 'broken\n');
