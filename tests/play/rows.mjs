// The rows of numbers that a demo writes, as tools/play/host/frame.hpp puts them together.

/// Takes one thing after the other from a row.
export function reader(numbers) {
  let at = 0;
  const number = () => numbers[at++], list = (each) => Array.from({ length: number() }, each);
  const words = () => String.fromCharCode(...list(number)), point = () => [number(), number()];
  return { number, words, list, point, all: () => numbers.slice(0, at) };
}

export const aboutOf = ({ number, words, list, point }) => ({
  title: words(), low: point(), high: point(),
  controls: list(() => ({ name: words(), unit: words(), low: number(), high: number(), step: number(), value: number(), options: list(words), onlyWith: list(words) })),
  keys: list(() => ({ key: words(), meaning: words(), onlyWith: list(words) })) });

export const pictureOf = ({ number, words, list, point }) => ({
  shapes: list(() => ({ kind: number(), colour: number(), size: number(), strength: number(), points: list(point), text: words() })),
  readouts: list(() => ({ name: words(), unit: words(), value: number(), decimals: number() })) });

/// One line of input, for one frame: dt, a step, the pointer, whether it is inside and pressed, handle, key, controls.
export const line = (input, values) => [...input, ...values].map((x) => x.toPrecision(17)).join(' ').replace(/\.0+(?= |$)/g, '');

/// A row as the demo without a page prints it.
export const printedRow = (text) => text.trim().split(' ').map((word) => {
  const [, sign, whole, fraction, power] = /^(-?)0x([01])\.?([0-9a-f]*)p([+-]\d+)$/.exec(word);
  return (sign ? -1 : 1) * parseInt(whole + fraction, 16) * 2 ** (Number(power) - 4 * fraction.length);
});
