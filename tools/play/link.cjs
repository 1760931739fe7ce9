// Links a demo that plays functions of several sections:  link.cjs DEMO.wasm compiler and its words...
// It exports ours and the wrong one of each exercise that the page is asked for, and no others: what is exported stays
// in it. These may call others again, so it's linked until nothing new is asked for.
'use strict';
const fs = require('node:fs'), { spawnSync } = require('node:child_process');
const [linked, compiler, ...words] = process.argv.slice(2);
const askedFor = () => WebAssembly.Module.imports(new WebAssembly.Module(fs.readFileSync(linked))).filter(({ module }) => module === 'exercises');
for (let known = -1, asked = []; known < asked.length;) {
  known = asked.length;
  const exported = asked.flatMap(({ name }) => ['ours', 'wrong'].map((whose) => `-Wl,--export-if-defined=${whose} ${name}`));
  const { status } = spawnSync(compiler, [...words, ...exported, '-o', linked], { stdio: 'inherit' });
  if (status !== 0) process.exit(1);
  asked = askedFor();
}
