// What keeps a chapter readable, as numbers: node docs/voice.cjs CHAPTER.md... prints what is too much, `FILE:LINE: SENTENCE`.
// How a chapter should sound is in authors.md; a number only catches habits, without exceptions. A budget has them: anywhere in
// the chapter, `<!-- budget: longest listing 22, since it is one table of constants -->`, for as long as it is needed.
'use strict';
const fs = require('node:fs');

const formula = '\uE000'; // counts as one word
const withoutFormulas = (text) =>
  text.replace(/(`+)(?!`)[^]*?(?<!`)\1(?!`)|\\[^]|\$\$?((?:\\[^]|[^$\\])+?)\$\$?/g, (all, code, tex) =>
    tex === undefined ? all : formula + '\n'.repeat(tex.split('\n').length - 1));

// The lines outside of listings, without what a quote puts before them, and the listings. A fold's first line and its last are folded, too.
function read(chapter) {
  const lines = [], listings = [];
  let folds = 0, listing;
  chapter.split(/\r?\n/).forEach((line, at) => {
    const text = line.replace(/^[> ]+/, ''), fence = /^(`{3,}|~{3,})/.exec(text)?.[0];
    if (listing) {
      if (fence && fence.startsWith(listing.fence) && text.trim() === fence) listing = undefined;
      else listing.code.push(text);
    } else if (fence) {
      listings.push((listing = { number: at + 1, fence, code: [], folded: folds > 0 }));
      lines.push(listing);
    } else {
      if (text.startsWith('<details')) folds += 1;
      lines.push({ number: at + 1, text, folded: folds > 0 });
      if (text.includes('</details>')) folds -= 1;
    }
  });
  return lines;
}

// Budgets

const isTask = (text) => /<!-- demo:|\*Try it|\*\*Pencil|Your turn:|\*\*Your test|\*\*Finish /.test(text);
const standsForADemo = (text) => /^!\[.*\]\(\.\.\/\.\.\/demos\/|^\*Play it:\* /.test(text);
const wordsIn = (text) => text.split(/\s+/).filter((word) => /[A-Za-z0-9]|[^\0-\x7F]/.test(word)).length;
const share = (part, whole) => (whole === 0 ? 0 : Math.ceil((100 * part) / whole));

function budgets(chapter) {
  const worst = {};
  const most = (name, value, line) => {
    if (value > (worst[name]?.value ?? 0)) worst[name] = { value, line };
  };
  let prose = 0, code = 0, tests = 0, outputs = 0, words = 0, readingFrom = 1, firstBox, opening;
  for (const { number, text, code: listing, folded } of read(withoutFormulas(chapter))) {
    if (folded || text === '') continue;
    if (listing) {
      code += listing.length;
      most('longest listing', listing.length, number);
      if (listing[0]?.includes('$ ./course run')) most('output', (outputs += listing.length - 1), number);
      if (listing.some((line) => line.startsWith('TEST_CASE('))) most('tests', (tests += listing.length - 1), number);
      continue;
    }
    if (text.startsWith('## ')) outputs = 0;
    if (isTask(text)) {
      opening ??= { value: words, line: number };
      most('reading', words, readingFrom);
      words = 0;
      readingFrom = number;
    }
    if (/^#.*Your turn:/.test(text)) firstBox ??= number;
    const [, level, reading, doing] = /^\| *\d+\.\d+ *\|.*\| *(\w+) *\| *(?:(\d+) *\+ *)?(\d+)[^|\d]*\|$/.exec(text) ?? [];
    if (level) most('part', Number(reading ?? 0) + Number(doing), number);
    if (level === 'core') most('core box', Number(doing), number);
    if (text.startsWith('<!--') || standsForADemo(text)) continue;
    prose += 1;
    if (!/^[|#]/.test(text)) words += wordsIn(text);
  }
  most('reading', words, readingFrom);
  worst.opening = opening ?? { value: worst.reading?.value ?? 0, line: 1 }; // with nothing to do, all of it is one reading
  worst['first box'] = { value: firstBox ? share(firstBox - 1, chapter.trimEnd().split('\n').length) : 100, line: firstBox ?? 1 };
  worst.listings = { value: share(code, prose), line: 1 };
  const budget = (name, what, limit, remedy) => ({ name, what, limit, remedy, value: 0, line: 1, ...worst[name] });
  return [
    budget('first box', '% of the chapter before its first "Your turn" box', 20, 'let the reader write something sooner'),
    budget('listings', 'unfolded lines of code for 100 lines of prose', 40, 'fold code that the reader need not read to go on'),
    budget('longest listing', 'lines of the longest unfolded listing', 15, 'split it, or fold it'),
    budget('tests', 'unfolded lines of tests', 8, 'show one short test, and fold the others'),
    budget('output', 'unfolded lines of output in one part', 8, 'show the part that this is about, `./course run N PART`, or fold it'),
    budget('opening', 'words before the reader does something', 80, 'ask for a guess, or show the demo, sooner'),
    budget('reading', 'words between two things to do', 500, 'ask the reader to guess, to play or to write in between'),
    budget('part', 'minutes for one part, read and done', 45, 'split the exercise'),
    budget('core box', 'minutes for a core exercise', 20, 'split the exercise'),
  ];
}

function exceededBudgets(chapter) {
  const findings = [], exceptions = new Map();
  const find = (line, sentence) => findings.push({ line, sentence });
  chapter.split('\n').forEach((line, at) => {
    if (!line.includes('<!-- budget:')) return;
    const [, name, allowed] = /<!-- budget: ([a-z ]+?) (\d+), since \S.* -->/.exec(line) ?? [];
    if (name) exceptions.set(name, { allowed: Number(allowed), line: at + 1 });
    else find(at + 1, 'write an exception as `<!-- budget: longest listing 22, since ... -->`, with its reason.');
  });
  for (const { name, what, limit, remedy, value, line } of budgets(chapter)) {
    const exception = exceptions.get(name), allowed = exception?.allowed ?? limit;
    exceptions.delete(name);
    if (value > allowed)
      find(line, `${value} ${what}, where ${allowed} are the most: ${remedy}, or write \`<!-- budget: ${name} ${value}, since ... -->\` with a reason.`);
    else if (exception && value <= limit)
      find(exception.line, `this exception is no longer needed, for ${value} are within the budget; take it out.`);
  }
  for (const [name, { line }] of exceptions) find(line, `there is no budget called "${name}".`);
  return findings;
}

// Voice

const habits = [ // what is said too easily, and how often it may be, in a thousand words
  ['a "not" without a contraction', /\b(is|are|was|were|do|does|did|has|have|had|would|should|must|will|could) not\b|\bcannot\b/gi, 0.6],
  ['"begin", for "start"', /\bbeg[iau]n(s|ning)?\b/gi, 0.5],
  ['"way"', /\bway\b/gi, 0.8],
  ['an opening like "It is"', /^(That|This|It|There) (is|was|are)\b/gi, 0.8],
  ['"a box of 10 kg", for "a 10 kg box"', /\b\w+ of \d[\d.]* ?(m|kg|N|s|px|cm)\b(?!\/)/gi, 0.4],
  ['"in which"', /\b(in|at|to|by|from|with|about|of|on) which\b/gi, 0.3],
  ['"rest"', /\b(rests?|rested|at rest)\b/gi, 0.3],
  ['things that say where or how', /\b(say|says|said|tell|tells) (where|how|which|whether|what|when)\b/gi, 0.3],
  ['"you have done", for "you did"', /\byou have (just )?(taken|turned|added|left|put|asked|counted|divided|multiplied|forgotten|subtracted|thought|made|lost|used|chosen|set|moved|gone|found|kept|seen|said|had|written)\b/gi, 0.1],
  ['"is wanted"', /\b(is|are) wanted\b/gi, 0],
  ['"somebody", "whatever"', /\b(somebody|nobody|whoever|whatever)\b/gi, 0.3],
  ['"Your own 9.1"', /\bYour own \d+\.\d/gi, 0],
  ['"the verdict to reach"', /\bverdict (to reach is|turns green)\b/gi, 0],
  ['a standing heading', /^#+ (What you have built|What your function must do|What the program shows now|How it was judged|Further)$/gi, 0],
];
const contraction = /\b(\w+n['’]t|\w+['’](re|ll|ve|d|m)|(it|that|here|there|what|let|he|she|who|how|where)['’]s)\b/gi;
const count = (text, pattern) => text.match(pattern)?.length ?? 0;

function outOfVoice(chapter) {
  const lines = read(withoutFormulas(chapter)).filter(({ code }) => !code);
  const open = lines.map(({ number, text, folded }) => ({ number, text: folded || text.startsWith('![') ? '' : // a picture is seen
      text.replace(/<!--.*?-->|\b(which|all the|by the|on its) way\b/gi, '') }));
  const inAll = (pattern) => open.reduce((sum, { text }) => sum + count(text, pattern), 0);
  const words = inAll(/[a-z][\w'’-]*/gi), contractions = inAll(contraction), fewest = Math.floor((6 * words) / 1000);
  // All hints of an exercise are one fold; the answer to what a scene asks is none.
  const said = lines.filter(({ text }) => text !== ''), answersAScene = (at) => standsForADemo(said[at - 1]?.text ?? '');
  const folds = new Set(said.filter(({ text }, at) => text?.startsWith('<details') && !answersAScene(at)).map(({ number, text }) => /<summary>(\d+\.\d+), a hint/.exec(text)?.[1] ?? number));
  const findings = [];
  const limit = (line, value, what, most) => {
    if (value > most) findings.push({ line, sentence: `the voice: ${value} ${what}, where ${most} are the most.` });
  };
  limit(1, words, 'words in the open', 4725);
  limit(1, folds.size, 'folds', Math.max(25, 1 + 3 * said.filter(({ text }) => /^#.*Your turn:/.test(text)).length));
  limit(1, open.filter(({ text }) => /^- `|`yours`|`returned`|\d of \d+\*|If it (says|is) /i.test(text)).length, 'lines about wrong answers in the open', 12);
  if (contractions < fewest) findings.push({ line: 1, sentence: `the voice: ${contractions} contractions, where ${fewest} are the fewest.` });
  for (const [name, pattern, most] of habits) {
    const last = open.findLast(({ text }) => count(text, pattern) > 0)?.number ?? 1;
    limit(last, inAll(pattern), `times ${name}`, Math.max(most > 0 ? 1 : 0, Math.floor((most * words) / 1000)));
  }
  return findings;
}

module.exports = { budgets, exceededBudgets, outOfVoice };
if (require.main === module)
  for (const file of process.argv.slice(2)) {
    const chapter = fs.readFileSync(file, 'utf8');
    for (const { line, sentence } of [...exceededBudgets(chapter), ...outOfVoice(chapter)].sort((a, b) => a.line - b.line)) {
      console.log(`${file}:${line}: ${sentence}`);
      process.exitCode = 1;
    }
  }
