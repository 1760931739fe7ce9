// A demo's picture: read from its row of numbers (tools/play/host/frame.hpp), and drawn. It knows of no page: docs/play.js
// has it draw on a canvas, tools/play/stills.cjs into an SVG.
(function () {
  'use strict';
  const kinds = ['discs', 'line', 'area', 'arrow', 'words', 'handle'], materials = ['flat', 'solid', 'glow'];
  const colours = ['ink', 'dim', 'line', 'blue', 'orange', 'green', 'amber', 'violet', 'pink'], paintOnly = ['wood', 'earth'];
  const stages = ['paper', 'felt', 'yard', 'night'];

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
    stage: stages[number()], ground: number(), low: point(), high: point(),
    shapes: list(() => ({ kind: kinds[number()], colour: [...colours, ...paintOnly][number()], size: number(), strength: number(), points: list(point), text: words(), material: materials[number()] })),
    readouts: list(() => ({ name: words(), unit: words(), value: number(), decimals: number() })) });

  // World to picture: metres, y up, all of it visible in so many pixels
  function viewOf({ low, high }, width) {
    const scale = width / (high[0] - low[0]);
    return { low, high, width, scale, height: scale * (high[1] - low[1]), onto: ([x, y]) => [(x - low[0]) * scale, (high[1] - y) * scale] };
  }

  // ---------------------------------------------------------------------------------------------------- solid things

  // What a body is painted with on a light page, and on a dark one or a dark stage. Nobody reads by these: they're brighter
  // than the colours of words, and most of them stay the same.
  const paints = {
    ink: ['#46515f', '#dfe5ec'], dim: ['#8a96a5', '#8a96a5'], line: ['#c3c8cf', '#4b5563'],
    blue: ['#2f7bf0', '#6aa6ff'], orange: ['#ef6a32', '#ff8a4f'], green: ['#18a578', '#2cc792'], amber: ['#f4b92f', '#f4b92f'],
    violet: ['#8657ee', '#b294ff'], pink: ['#dd4a94', '#ff6fb4'], wood: ['#8a5430', '#a3683e'], earth: ['#bd9768', '#54433a'],
  };
  const bytes = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
  const hexOf = (numbers) => `#${numbers.map((x) => Math.round(x).toString(16).padStart(2, '0')).join('')}`;
  const mixed = (hex, other, much) => hexOf(bytes(hex).map((x, i) => x + (bytes(other)[i] - x) * much));
  const both = (pair, other, much) => pair.map((hex) => mixed(hex, other, much));
  const black = ['#000000', '#000000'], white = ['#ffffff', '#ffffff'];

  // A shade goes from one colour to another: between two points, or from the middle of one circle to another's rim, in
  // parts of the width and height of what it fills. Its stops: where, which colour, how opaque.
  const across = (from, to, ...stops) => ({ from, to, stops });
  const around = (from, to, radius, ...stops) => ({ from, to, radius, stops });
  const fading = (pair, much) => around([0.5, 0.5], [0.5, 0.5], 0.5, [0.35, pair, much], [0.55, pair, 0.4 * much], [1, pair, 0]);

  // Each is made once for each paint.
  const kept = (make, known = {}) => (name) => (known[name] ??= make(paints[name]));
  // What's stamped at each place of a disc: circles, so many radii large and away from it.
  const ball = kept((paint) => [
    { away: [0.26, 0.34], radius: 1.3, shade: fading(black, 0.5) },
    { away: [0, 0], radius: 1, shade: around([0.33, 0.3], [0.45, 0.45], 0.56, [0, both(paint, '#ffffff', 0.92)], [0.16, both(paint, '#ffffff', 0.5)], [0.5, paint], [0.85, both(paint, '#000000', 0.33)], [1, both(paint, '#000000', 0.55)]) },
  ]);
  const lamp = kept((paint) => [
    { away: [0, 0], radius: 2.6, shade: fading(paint, 0.5) },
    { away: [0, 0], radius: 1, shade: around([0.5, 0.5], [0.5, 0.5], 0.5, [0, white], [0.45, both(paint, '#ffffff', 0.6)], [1, paint]) },
  ]);
  const body = kept((paint) => across([0, 0], [0.15, 1], [0, both(paint, '#ffffff', 0.38)], [0.45, paint], [1, both(paint, '#000000', 0.3)]));
  // Strokes, one upon the other: how wide, how far to the upper left, in widths of the bar; which colour, how opaque.
  const bar = kept((paint) => [[1.15, -0.42, black, 0.22], [1.18, 0, both(paint, '#000000', 0.55)], [0.96, 0, paint], [0.3, 0.2, both(paint, '#ffffff', 0.6)]]);
  const beam = kept((paint) => [[3.6, 0, paint, 0.14], [2, 0, paint, 0.25], [1, 0, paint], [0.4, 0, both(paint, '#ffffff', 0.7)]]);

  // A canvas's pen learns here what the one for an SVG does by itself: to fill with a shade, to stamp, and to draw a line in
  // one piece however many strokes lie upon each other.
  const brushOf = (pen, of) => pen.stamp ? pen : {
    shade: (shade, box) => gradient(pen, of, shade, box),
    stamp: (at, radius, circles) => {
      const { image, reach } = imageOf(circles, radius * (pen.getTransform?.().a ?? 1), of), far = reach * radius;
      for (const [x, y] of at) pen.drawImage(image, x - far, y - far, 2 * far, 2 * far);
    },
    tint: of,
    strokeWhole: () => pen.stroke(),
    fillAndStroke: () => (pen.fill(), pen.closePath(), pen.stroke()),
  };
  function gradient(pen, of, { from, to, radius, stops }, [x, y, width, height]) {
    const at = ([a, b]) => [x + a * width, y + b * height];
    const made = radius ? pen.createRadialGradient(...at(from), 0, ...at(to), radius * width) : pen.createLinearGradient(...at(from), ...at(to));
    for (const [where, pair, much = 1] of stops) made.addColorStop(where, of(pair) + Math.round(255 * much).toString(16).padStart(2, '0'));
    return made;
  }
  // The picture of a stamp, for radii up to √2 smaller than its own, so that few are kept, and none is drawn far too large.
  const images = new Map();
  function imageOf(circles, radius, of) {
    const size = 2 ** (Math.ceil(2 * Math.log2(radius)) / 2), key = `${size} ${of(['', 'dark'])}`;
    if (!images.has(circles)) images.set(circles, {});
    return (images.get(circles)[key] ??= stamped(circles, size, of));
  }
  function stamped(circles, size, of) {
    const reach = Math.max(...circles.map(({ away, radius }) => Math.hypot(...away) + radius)) + 1 / size, image = document.createElement('canvas'), pen = image.getContext('2d');
    image.width = image.height = Math.ceil(2 * reach * size);
    for (const { away: [x, y], radius, shade } of circles) {
      const r = radius * size, [a, b] = [x, y].map((part) => image.width / 2 + part * size);
      pen.fillStyle = gradient(pen, of, shade, [a - r, b - r, 2 * r, 2 * r]);
      pen.beginPath(), pen.arc(a, b, r, 0, 7), pen.fill();
    }
    return { image, reach: image.width / 2 / size };
  }

  const boxOf = (points) => {
    const [low, high] = [Math.min, Math.max].map((most) => [0, 1].map((k) => most(...points.map((point) => point[k]))));
    return [...low, high[0] - low[0], high[1] - low[1]];
  };
  const along = (pen, points) => {
    pen.beginPath();
    for (const point of points) pen.lineTo(...point);
  };
  const moved = (pen, x, y, work) => { pen.translate(x, y), work(), pen.translate(-x, -y); };
  function strokes(pen, brush, layers, width, strength, way) {
    for (const [much, away, pair, opaque = 1] of layers) {
      pen.globalAlpha = strength * opaque, pen.strokeStyle = pen.fillStyle = brush.tint(pair), pen.lineWidth = much * width;
      moved(pen, -0.8 * away * width, -away * width, () => (way(), brush.strokeWhole()));
    }
  }
  function paintBody(pen, brush, name, points, unit, strength) {
    pen.globalAlpha = 0.16 * strength, pen.fillStyle = brush.tint(black);
    moved(pen, 3.6 * unit, 4.5 * unit, () => (along(pen, points), pen.fill()));
    pen.globalAlpha = strength, pen.fillStyle = brush.shade(body(name), boxOf(points)), pen.strokeStyle = brush.tint(both(paints[name], '#000000', 0.5)), pen.lineWidth = 1.3 * unit;
    along(pen, points), brush.fillAndStroke();
  }
  function lampArea(pen, brush, name, points, unit, strength) {
    strokes(pen, brush, beam(name).slice(0, 2), 4 * unit, strength, () => along(pen, [...points, points[0]]));
    pen.globalAlpha = strength, pen.fillStyle = brush.tint(paints[name]);
    along(pen, points), pen.fill();
  }
  // Whether it has been drawn: words and handles are flat, and so is what's dotted.
  function drawMade(pen, brush, { kind, colour, size, strength, material }, at, { width, scale }, all) {
    const unit = width / 640, much = strength * all, solid = material === 'solid', thick = (size || 2) * unit;
    if (material === 'flat' || size < 0) return false;
    pen.setLineDash([]);
    pen.globalAlpha = much;
    if (kind === 'discs') brush.stamp(at, Math.max(size * scale, 1), (solid ? ball : lamp)(colour));
    else if (kind === 'line') strokes(pen, brush, (solid ? bar : beam)(colour), thick, much, () => along(pen, at));
    else if (kind === 'arrow' && !solid) strokes(pen, brush, beam(colour), thick, much, () => (pen.beginPath(), arrow(pen, ...at, (5 + 2 * size) * unit)));
    else if (kind === 'area') (solid ? paintBody : lampArea)(pen, brush, colour, at, unit, much);
    else return false;
    return true;
  }

  // ------------------------------------------------------------------------------------------------------- the stage

  const grounds = { // the colours of each, for its shades, and for whoever measures contrast
    felt: [['#185c46', '#185c46'], ['#134b39', '#134b39'], ['#0a2e22', '#0a2e22']],
    night: [['#0a0f1f', '#0a0f1f'], ['#1b2344', '#1b2344']],
    yard: [['#c9e2f4', '#1a2136'], ['#faf3e6', '#463c55'], ['#dcc199', '#43362f'], ['#c9a97c', '#2a221e']],
  };
  // Behind words, so that they're read over whatever lies below.
  const outlines = { felt: ['#072018', '#072018'], night: ['#0a0f1f', '#0a0f1f'], yard: ['#fffdf8', '#171b2b'] };
  const dark = ({ stage }) => stage === 'felt' || stage === 'night';
  const rows = { felt: ([middle, cloth, rim]) => [[0, 1, around([0.42, 0.36], [0.42, 0.36], 0.72, [0, middle], [0.6, cloth], [1, rim])]],
    night: ([high, low]) => [[0, 1, across([0, 0], [0, 1], [0, high], [1, low])]],
    yard: ([high, low, near, deep], ground) => [[0, ground, across([0, 0], [0, 1], [0, high], [1, low])], [ground, 1, across([0, 0], [0, 1], [0, near], [1, deep])]] };
  const stars = [[0.06, 0.1], [0.17, 0.3], [0.24, 0.07], [0.33, 0.2], [0.41, 0.44], [0.52, 0.09], [0.6, 0.27], [0.71, 0.13], [0.79, 0.38], [0.87, 0.08], [0.94, 0.24], [0.1, 0.55], [0.67, 0.6], [0.96, 0.62]];
  function setStage(pen, brush, { stage, ground }, { width, height, onto }, all) {
    if (!grounds[stage]) return;
    const horizon = Math.min(1, Math.max(0, onto([0, ground])[1] / height));
    pen.globalAlpha = all;
    for (const [from, to, shade] of rows[stage](grounds[stage], horizon)) {
      const box = [0, from * height, width, (to - from) * height];
      if (box[3] <= 0) continue;
      pen.fillStyle = brush.shade(shade, box);
      along(pen, [[0, 1], [2, 1], [2, 3], [0, 3]].map(([x, y]) => [box[0] + (x && box[2]), y === 1 ? box[1] : box[1] + box[3]])), pen.fill();
    }
    if (stage !== 'night') return;
    pen.globalAlpha = 0.5 * all, pen.fillStyle = brush.tint(white);
    pen.beginPath();
    for (const [x, y] of stars) pen.moveTo(x * width, y * height), pen.arc(x * width, y * height, width / 640, 0, 7);
    pen.fill();
  }

  // ----------------------------------------------------------------------------------------------------- the picture

  // `pen` is a canvas's, or has as much of one as is used here. `palettes`: the colours of the page and of a dark page by
  // name, and `of`, which takes one of a pair for light and dark. `held` says which handles are marked; without it there
  // are none.
  function draw(pen, picture, view, palettes, { font = '', strength: all = 1, held = null } = {}) {
    const palette = dark(picture) ? palettes.dark : palettes.page, of = dark(picture) ? ([, pair]) => palettes.of([pair, pair]) : palettes.of;
    const brush = brushOf(pen, of), { scale, onto } = view;
    if (pen.stamp) pen.of = of;
    pen.lineJoin = pen.lineCap = 'round';
    pen.font = font;
    pen.setLineDash([]);
    setStage(pen, brush, picture, view, all);
    let handles = 0;
    for (const shape of picture.shapes) {
      const { kind, colour, size, strength, points, text } = shape, at = points.map(onto);
      if (drawMade(pen, brush, shape, at, view, all)) continue;
      pen.globalAlpha = strength * all;
      pen.fillStyle = pen.strokeStyle = palette[colour] ?? of(paints[colour]);
      pen.lineWidth = Math.abs(size) || 2;
      pen.setLineDash(size < 0 ? [1, 6] : []);
      pen.beginPath();
      if (kind === 'discs') for (const [x, y] of at) pen.moveTo(x, y), pen.arc(x, y, Math.max(size * scale, 1), 0, 7);
      if (kind === 'line' || kind === 'area') for (const point of at) pen.lineTo(...point);
      if (kind === 'arrow') arrow(pen, ...at, 5 + 2 * size);
      if (kind === 'words') write(pen, text, at[0], outlines[picture.stage] && brush.tint(outlines[picture.stage]));
      if (kind === 'handle' && held) for (const [x, y] of at) handle(pen, x, y, palette, held(handles++));
      if (kind === 'discs' || kind === 'area') pen.fill();
      if (kind === 'line' || kind === 'arrow') pen.stroke();
    }
  }
  function write(pen, text, [x, y], outline) {
    if (outline) Object.assign(pen, { strokeStyle: outline, lineWidth: 3.5 }), pen.strokeText(text, x, y);
    pen.fillText(text, x, y);
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
  // Where a hand helps that isn't the reader's: a pale finger, of so many pixels.
  const finger = (at, { scale }, radius = 10, strength = 0.3) => ({ kind: 'discs', colour: 'ink', size: radius / scale, strength, points: [at], text: '', material: 'flat' });

  globalThis.demoPicture = { colours, paints, grounds, outlines, reader, aboutOf, frameOf, viewOf, draw, finger };
})();
