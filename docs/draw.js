// A demo's picture: read from its row of numbers (tools/play/host/frame.hpp), and drawn. It knows of no page: docs/play.js
// has it draw on a canvas, tools/play/stills.cjs into an SVG.
(function () {
  'use strict';
  const kinds = ['discs', 'line', 'area', 'arrow', 'words', 'handle'];
  const colours = ['ink', 'dim', 'line', 'blue', 'orange', 'green', 'amber', 'violet', 'pink'];

  // Takes one thing after the other from a row.
  function reader(numbers) {
    let at = 0;
    const number = () => numbers[at++], list = (each) => Array.from({ length: number() }, each);
    const words = () => new TextDecoder().decode(Uint8Array.from(list(number))), point = () => [number(), number()];
    return { number, words, list, point, taken: () => numbers.slice(0, at) };
  }
  const aboutOf = ({ number, words, list, point }) => ({
    title: words(), low: point(), high: point(),
    controls: list(() => ({ name: words(), unit: words(), low: number(), high: number(), step: number(), value: number(), options: list(words), onlyWith: list(words) })),
    keys: list(() => ({ key: words(), meaning: words(), onlyWith: list(words) })) });
  const frameOf = ({ number, words, list, point }) => ({
    shapes: list(() => ({ kind: kinds[number()], colour: colours[number()], size: number(), strength: number(), points: list(point), text: words() })),
    readouts: list(() => ({ name: words(), unit: words(), value: number(), decimals: number() })) });

  // World to picture: metres, y up, all of it visible in so many pixels
  function viewOf({ low, high }, width) {
    const scale = width / (high[0] - low[0]);
    return { scale, height: scale * (high[1] - low[1]), onto: ([x, y]) => [(x - low[0]) * scale, (high[1] - y) * scale] };
  }

  // `pen` is a canvas's, or has as much of one as is used here. `held` says which handles are marked; without it there are none.
  function draw(pen, shapes, { scale, onto }, palette, { font = '', strength: all = 1, held = null } = {}) {
    pen.lineJoin = pen.lineCap = 'round';
    pen.font = font;
    let handles = 0;
    for (const { kind, colour, size, strength, points, text } of shapes) {
      const at = points.map(onto);
      pen.globalAlpha = strength * all;
      pen.fillStyle = pen.strokeStyle = palette[colour];
      pen.lineWidth = Math.abs(size) || 2;
      pen.setLineDash(size < 0 ? [1, 6] : []);
      pen.beginPath();
      if (kind === 'discs') for (const [x, y] of at) pen.moveTo(x, y), pen.arc(x, y, Math.max(size * scale, 1), 0, 7);
      if (kind === 'line' || kind === 'area') for (const point of at) pen.lineTo(...point);
      if (kind === 'arrow') arrow(pen, ...at, 5 + 2 * size);
      if (kind === 'words') pen.fillText(text, ...at[0]);
      if (kind === 'handle' && held) for (const [x, y] of at) handle(pen, x, y, palette, held(handles++));
      if (kind === 'discs' || kind === 'area') pen.fill();
      if (kind === 'line' || kind === 'arrow') pen.stroke();
    }
  }
  function arrow(pen, [x, y], [a, b], head) {
    const turn = Math.atan2(b - y, a - x);
    pen.moveTo(x, y), pen.lineTo(a, b);
    for (const side of [2.6, -2.6]) pen.moveTo(a, b), pen.lineTo(a + head * Math.cos(turn + side), b + head * Math.sin(turn + side));
  }
  function handle(pen, x, y, { paper }, marked) {
    pen.beginPath();
    pen.arc(x, y, marked ? 8 : 6, 0, 7);
    const colour = pen.fillStyle;
    pen.fillStyle = paper;
    pen.fill(), pen.stroke();
    pen.fillStyle = colour;
    if (marked) pen.beginPath(), pen.arc(x, y, 4, 0, 7), pen.fill();
  }

  globalThis.demoPicture = { colours, reader, aboutOf, frameOf, viewOf, draw };
})();
