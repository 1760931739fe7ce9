// Typesets formulas with KaTeX: node formulas.cjs KATEX.JS FORMULAS.JSON writes the HTML of each, in order, as JSON.
// A formula that KaTeX cannot read, or only with a warning, is named with its place in the book, and nothing is written.
'use strict';
const fs = require('node:fs');
const [library, input] = process.argv.slice(2);
const katex = require(library);

let bad = 0;
const html = JSON.parse(fs.readFileSync(input, 'utf8')).map(({ tex, display, from }) => {
  try {
    return katex.renderToString(tex, { displayMode: display, output: 'htmlAndMathml', strict: 'error' });
  } catch (error) {
    bad += 1;
    console.error(`${from}: the formula $${tex}$ cannot be read: ${error.message}`);
    return '';
  }
});
if (bad === 0) process.stdout.write(JSON.stringify(html));
process.exitCode = bad === 0 ? 0 : 1;
