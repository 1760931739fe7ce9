// A section's file in pieces: above the function of each exercise is a line of its own, as `// 8.1 core`, and from there
// on the file is that exercise's. Text goes in, text comes out.

const marker = /^\/\/ (\d+\.\d+) \w+\n/gm;

// What follows each exercise's line, up to the next exercise: [number, its line, the rest]. First, without a number and a
// line, what stands above them all.
function sequence(text) {
  const found = [...text.matchAll(marker)];
  const end = (at) => found[at + 1]?.index ?? text.length;
  return [['', '', text.slice(0, end(-1))],
    ...found.map(({ 0: line, 1: number, index }, at) => [number, line, text.slice(index + line.length, end(at))])];
}

// What stands below a function of a stub, and belongs to none: helpers of the next one, the end of the namespace.
function belowEach(stub) {
  return new Map(sequence(stub).map(([number, , rest]) => {
    const end = rest.search(/^}\n/m);
    return [number, number === '' || end < 0 ? '' : rest.slice(end + 2)];
  }));
}

// A file as number → {line, body, below}, in its order, which together are the file; nothing if a number is there twice.
function split(text, stub) {
  const below = belowEach(stub), pieces = new Map();
  for (const [number, line, rest] of sequence(text)) {
    if (pieces.has(number)) return null;
    const kept = below.get(number) ?? '', at = rest.endsWith(kept) ? rest.length - kept.length : rest.length;
    pieces.set(number, { line, body: rest.slice(0, at), below: rest.slice(at) });
  }
  return pieces;
}

// The piece of one exercise, without its last line break: before + body + after is the whole file. Nothing if the line
// above it is gone, or there twice.
export function findPiece(text, number, stub) {
  const pieces = split(text, stub);
  if (!pieces?.has(number)) return null;
  let before = '';
  for (const [each, { line, body, below }] of pieces) {
    if (each !== number) {
      before += line + body + below;
      continue;
    }
    before += line;
    const kept = body.replace(/\n$/, '');
    return { before, body: kept, after: text.slice(before.length + kept.length) || '\n' };
  }
}

// The file with this exercise as it is in the stub; nothing if one of the two has no such piece.
export function startedAgain(text, number, stub) {
  const piece = findPiece(text, number, stub), given = findPiece(stub, number, stub);
  return piece && given && piece.before + given.body + piece.after;
}

// The file as it should be when the stub that it began with is replaced by a newer one: what was never changed follows,
// what was changed stays. Nothing if the file's pieces can't be found.
export function follow(text, stub, newer) {
  const yours = split(text, stub), old = split(stub, stub), fresh = split(newer, newer);
  if (!yours || [...old.keys()].some((number) => !yours.has(number))) return null;
  const isChanged = (number) => yours.get(number)?.body !== old.get(number)?.body || yours.get(number)?.below !== old.get(number)?.below;
  const pieces = [...fresh].map(([number, piece]) => {
    const mine = yours.get(number);
    if (!mine || !isChanged(number)) return piece;
    return { ...piece, body: mine.body, below: mine.below === old.get(number)?.below ? piece.below : mine.below };
  });
  const gone = [...yours].filter(([number]) => !fresh.has(number) && isChanged(number)).map(([, { line, body }]) => `\n${line}${body}`);
  const last = pieces.pop();
  return [...pieces, { ...last, body: last.body + gone.join('') }].map(({ line, body, below }) => line + body + below).join('');
}
