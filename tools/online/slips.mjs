// Slips of a typing hand: one token of a file is gone, doubled, swapped with the next, misspelt, another one's; or what's like it
// stands there, and the file still compiles.

// The same numbers each time for one seed (mulberry32).
export function dice(seed) {
  return (below) => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return Math.floor((((t ^ (t >>> 14)) >>> 0) / 2 ** 32) * below);
  };
}

const token = /\/\/.*|"(?:\\.|[^"\\])*"|[A-Za-z_]\w*|\d[\w.]*|::|->|<=|>=|==|!=|&&|\|\||[^\s\w]|\s+/g;

const pairs = ['+ -', '* /', '< >', '<= >=', '&& ||', '0 1', '1 2', 'x y', 'min max', 'sin cos', 'start end', 'true false', 'first second'].map((pair) => pair.split(' '));
const alike = new Map(pairs.flatMap(([one, other]) => [[one, other], [other, one]]));

export function slip(text, roll) {
  const tokens = text.match(token), all = [...tokens.keys()].filter((i) => /\S/.test(tokens[i]) && !tokens[i].startsWith('//'));
  const i = all[roll(all.length - 1)], next = all[all.indexOf(i) + 1], other = all[roll(all.length)];
  const likes = all.filter((each) => alike.has(tokens[each])), like = likes[roll(likes.length)];
  const slips = [
    () => (tokens[i] = ''),
    () => (tokens[i] += ` ${tokens[i]}`),
    () => ([tokens[i], tokens[next]] = [tokens[next], tokens[i]]),
    () => (tokens[i] = tokens[i].length > 1 ? tokens[i].slice(0, -1) : `${tokens[i]}${tokens[i]}`),
    () => (tokens[i] = tokens[other]),
    ...Array(5).fill(() => (tokens[like] = alike.get(tokens[like]))),
  ];
  slips[roll(slips.length)]();
  return tokens.join('');
}
