// Makes the search's index with lunr: node search-index.cjs LUNR.JS DOCUMENTS.JSON writes a script that sets
// `searchIndex`. A script, since a page that was opened as a file may not fetch anything else.
'use strict';
const fs = require('node:fs');
const [library, input] = process.argv.slice(2);
const lunr = require(library);
const documents = JSON.parse(fs.readFileSync(input, 'utf8'));

// Words end where letters and digits do: `time_of_impact(motion` is four.
lunr.tokenizer.separator = /[^\p{L}\p{N}]+/u;
const index = lunr(function () {
  this.ref('number');
  this.field('part', { boost: 5 });
  this.field('words', { boost: 12 });
  this.field('page', { boost: 2 });
  this.field('text');
  documents.forEach((document, number) => this.add({ number, ...document }));
});
// What only the index needs is not sent along.
for (const document of documents) delete document.words;
process.stdout.write(`window.searchIndex = ${JSON.stringify({ documents, index })};\n`);
