// Compiles a reader's file of an earlier section:  earlier.cjs BROKEN.o OBJECT compiler and its words...
// One that doesn't compile must not keep the demo of a later section from playing: in its place is an object that says so.
'use strict';
const fs = require('node:fs'), { spawnSync } = require('node:child_process');
const [broken, object, compiler, ...words] = process.argv.slice(2);
if (spawnSync(compiler, [...words, '-o', object]).status !== 0) fs.copyFileSync(broken, object);
