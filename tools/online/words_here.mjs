// What the book says of a terminal, and what it says of the same thing where the page does it. Chapters are written for both:
// here alone is what differs. What a page can't do (its own tests, bugs to hunt, programs and curves) keeps its command.

const code = (words) => `<code(?: class="long")?>${words}</code>`;

// [on the site, in the online edition], as HTML
export const here = [
  // The front page
  [/<a class="begin" href="(chapter_(\d\d)_\w+\.html)">.*?<\/a>/, (_, page, section) =>
    `<a class="begin" href="${page}#exercise-${Number(section)}.1">Begin here <small>your first line</small></a>`],
  [/You need school mathematics, some C\+\+, and three minutes to (<a href="[^"]*">)build it<\/a>\.\nEverything works without a network, and is free \(MIT licence\)\./,
    'You need school mathematics and some C++. There’s nothing to install: you write in the page, and it all works without a network after your first check.\nIt’s free (MIT licence), and for your own editor you can $1build it</a>.'],
  [new RegExp(`in ${code('exercises/')}, and ${code('./course check')} tells you`), 'in the page, and <em>Check</em> tells you'],

  // What to do in a box
  [new RegExp(`<strong>Open</strong> ${code('exercises/\\w+\\.cpp')} in your editor, and a terminal in the course’s folder\\.\nType ${code('./course check [\\d.]+')} to see how things stand:`),
    '<strong>Look.</strong> In the editor below is a function without its answer: how many pixels a second is so many a frame?\nPress <em>Check</em> to see how things stand; the first time, that loads a compiler:'],
  [new RegExp(`(<strong>Find</strong> .*?) in (?:${code('exercises/\\w+\\.cpp')}|the same file)`, 'g'), '$1 in the editor below'],
  [new RegExp(`Save, and type ${code('./course check [\\d.]+')}`, 'g'), 'Press <em>Check</em>'],
  [/Save, and check\b/g, 'Press Check'],
  [new RegExp(`Type ${code('./course check [\\d.]+ --picture')}, and you see`), 'Below the verdict you see'],
  [new RegExp(`<em>Change, save, look</em>(.*)\n${code('./course check \\d+ --watch')} .*\nStuck\\? ${code('./course hint [\\d.]+')} (gives you .*)\n${code('./course reset \\d+')} (starts you over, and keeps a copy of your) file\\.`),
    '<em>Change, check, look</em>$1\nStuck? <em>Hint 1</em>, below the editor, $2\n<em>Start again</em> $3 code.'],

  // A sketch to begin with
  [new RegExp(`${code('./course sketch \\w+ --from (\\w+) --watch')} puts it into a file of yours, and shows it again whenever you save\\.`, 'g'),
    '<a href="sketches.html#from=gallery/$1">open it</a> as a sketch of yours, and it runs again whenever you pause.'],

  // What a check prints: less than in a terminal, see Reader::page in tools/check/
  [/(<pre class="console"><code>)\$ \.\/course check [\d.]+\n([^]*?<\/code>)/g, (_, before, printed) =>
    before + printed.replace(' (-v shows all)', '').replace(/^Next: .*\n/m, '')],
];

export const asHere = (html) => here.reduce((text, [there, words]) => text.replace(there, words), html);
