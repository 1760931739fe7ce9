// A demo's picture: read from its row of numbers (tools/play/host/frame.hpp), and drawn. It knows of no page: docs/play.js
// has it draw on a canvas, tools/play/stills.cjs into an SVG.
(function () {
  'use strict';
  const kinds = ['discs', 'line', 'area', 'arrow', 'words', 'handle', 'trail'], materials = ['flat', 'solid', 'glow', 'light', 'mist'], anchors = ['left', 'center', 'right'];
  const colours = ['ink', 'dim', 'line', 'blue', 'orange', 'green', 'amber', 'violet', 'pink'], paintOnly = ['wood', 'earth'];
  const stages = ['paper', 'felt', 'yard', 'night', 'hills', 'skyline', 'moon', 'workshop', 'squared'];

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
    shapes: list(() => ({ kind: kinds[number()], colour: [...colours, ...paintOnly][number()], size: number(), strength: number(), points: list(point), text: words(), material: materials[number()], anchor: anchors[number()], each: list(number) })),
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
  const spark = kept((paint) => [
    { away: [0, 0], radius: 2.4, shade: around([0.5, 0.5], [0.5, 0.5], 0.5, [0, both(paint, '#ffffff', 0.75)], [0.14, both(paint, '#ffffff', 0.45)], [0.3, paint, 0.6], [1, paint, 0]) },
  ]);
  const puff = kept((paint) => [{ away: [0, 0], radius: 1, shade: around([0.5, 0.5], [0.5, 0.5], 0.5, [0, paint, 0.8], [0.5, paint, 0.5], [1, paint, 0]) }]);
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
    adding: (on) => (pen.globalCompositeOperation = on ? 'lighter' : 'source-over'),
    letters: (font, height, anchor) => Object.assign(pen, { font: height ? font.replace(/^\d+px/, `600 ${height.toFixed(1)}px`) : font, textAlign: anchor }),
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
  const fillDots = (pen, at, radius) => {
    pen.beginPath();
    for (const [x, y] of at) pen.moveTo(x, y), pen.arc(x, y, radius, 0, 7);
    pen.fill();
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
  // Nested strokes, each from later on: towards its end it's brighter, and wider.
  function drawTrail(pen, brush, { colour, size, strength }, at, unit, all) {
    const parts = 5;
    pen.setLineDash([]), pen.strokeStyle = pen.fillStyle = brush.tint(paints[colour]);
    for (let i = 0; i < parts; i++) {
      const from = Math.floor((i * at.length) / parts / 16) * 16;
      pen.globalAlpha = 0.28 * strength * all, pen.lineWidth = ((i + 1) / parts) * size * unit;
      along(pen, at.slice(from)), brush.strokeWhole();
    }
  }
  // Each spark or puff by its own radius and strength, in steps, so that few stamps are made.
  function drawEach(pen, brush, { colour, each, strength, material }, at, { scale }, all) {
    const light = material === 'light';
    const alike = new Map();
    at.forEach((point, i) => {
      const radius = 2 ** (Math.round(2 * Math.log2(Math.max(each[2 * i] * scale, 0.7))) / 2), much = Math.ceil(6 * Math.min(1, each[2 * i + 1])) / 6, key = `${radius} ${much}`;
      if (much > 0) alike.has(key) ? alike.get(key).at.push(point) : alike.set(key, { radius, much, at: [point] });
    });
    brush.adding(light);
    for (const { radius, much, at: places } of alike.values()) pen.globalAlpha = much * strength * all, brush.stamp(places, radius, (light ? spark : puff)(colour));
    brush.adding(false);
  }
  // Whether it has been drawn: words and handles are flat, and so is what's dotted.
  function drawMade(pen, brush, shape, at, { width, scale }, all) {
    const { kind, colour, size, strength, material } = shape;
    const unit = width / 640, much = strength * all, solid = material === 'solid', thick = (size || 2) * unit;
    if (kind === 'trail') return drawTrail(pen, brush, shape, at, unit, all), true;
    if (material === 'flat' || kind === 'words' || size < 0) return false;
    pen.setLineDash([]);
    pen.globalAlpha = much;
    if (material === 'light' || material === 'mist') drawEach(pen, brush, shape, at, { scale }, all);
    else if (kind === 'discs') brush.stamp(at, Math.max(size * scale, 1), (solid ? ball : lamp)(colour));
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
    workshop: [['#e4e2dc', '#20242e'], ['#d8d3c8', '#2b2e38'], ['#dbbf95', '#4a3628'], ['#c9a87b', '#2c211b']],
    squared: [['#fdfcf8', '#161a22'], ['#fdfcf8', '#161a22']],
  };
  // Behind words, so that they're read over whatever lies below.
  const outlines = { felt: ['#072018', '#072018'], night: ['#0a0f1f', '#0a0f1f'], yard: ['#fffdf8', '#171b2b'], workshop: ['#fffdf8', '#171b2b'], squared: ['#fdfcf8', '#161a22'] };
  // Hills are a yard, a skyline and the moon are a night, with something before the sky: layers, the farther one first. Each
  // moves against the camera at its part of the ground's speed.
  const likeIts = { hills: 'yard', skyline: 'night', moon: 'night' }, ownOf = (stage) => likeIts[stage] ?? stage;
  const layers = { hills: [[0.25, ['#a9c6c4', '#262f4a']], [0.5, ['#86ac8a', '#1d2a38']]], skyline: [[0.1, ['#202a52', '#202a52']], [0.2, ['#0e142b', '#0e142b']]],
    moon: [[0.1, ['#3b4052', '#3b4052']], [0.2, ['#525868', '#525868']]] };
  const windows = ['#f5c542', '#f5c542'], craters = ['#565c6a', '#565c6a'], seams = ['#b9b2a4', '#3a3e49'], rules = ['#b4c7e4', '#2f3d57'];
  // What lies along the horizon: its colour, and how high it is, in parts of the width; all that's below, without that.
  const strips = { hills: [['#6f9a4b', '#33492f'], 1 / 80], skyline: [['#060914', '#060914']], moon: [['#787e8c', '#787e8c']] };
  const paper = ['#fdfcfa', '#14171d']; // of a plate on it
  const dark = ({ stage }) => ['felt', 'night'].includes(ownOf(stage));
  const whole = ([high, low]) => [[0, 1, across([0, 0], [0, 1], [0, high], [1, low])]];
  const upright = ([high, low, near, deep], ground) => [[0, ground, across([0, 0], [0, 1], [0, high], [1, low])], [ground, 1, across([0, 0], [0, 1], [0, near], [1, deep])]];
  const rows = { felt: ([middle, cloth, rim]) => [[0, 1, around([0.42, 0.36], [0.42, 0.36], 0.72, [0, middle], [0.6, cloth], [1, rim])]], night: whole, squared: whole, yard: upright, workshop: upright };
  const stars = [[0.06, 0.1], [0.17, 0.3], [0.24, 0.07], [0.33, 0.2], [0.41, 0.44], [0.52, 0.09], [0.6, 0.27], [0.71, 0.13], [0.79, 0.38], [0.87, 0.08], [0.94, 0.24], [0.1, 0.55], [0.67, 0.6], [0.96, 0.62]];
  const block = (pen, x, y, wide, high) => (along(pen, [[x, y], [x + wide, y], [x + wide, y + high], [x, y + high]]), pen.fill());
  function setStage(pen, brush, { stage, ground }, { width, height, scale, onto }, all) {
    const own = ownOf(stage);
    if (!grounds[own]) return;
    const horizon = Math.min(1, Math.max(0, onto([0, ground])[1] / height));
    pen.globalAlpha = all;
    for (const [from, to, shade] of rows[own](grounds[own], horizon)) {
      const box = [0, from * height, width, (to - from) * height];
      if (box[3] <= 0) continue;
      pen.fillStyle = brush.shade(shade, box);
      block(pen, ...box);
    }
    if (own === 'night') {
      pen.globalAlpha = 0.5 * all, pen.fillStyle = brush.tint(white);
      fillDots(pen, stars.map(([x, y]) => [x * width, y * height]), width / 640);
    }
    const about = { width, height, scale, origin: onto([0, 0]), base: horizon * height };
    layers[stage]?.forEach(([speed, pair], nearness) => {
      pen.globalAlpha = all, pen.fillStyle = brush.tint(pair);
      (stage === 'skyline' ? drawTown : drawHills)(pen, brush, { ...about, shift: (speed * about.origin[0]) / width, nearness }, all);
    });
    pen.globalAlpha = all;
    if (strips[stage] && horizon < 1) drawStrip(pen, brush, strips[stage], about);
    ({ moon: drawMoon, workshop: drawBoards, squared: drawSquares })[stage]?.(pen, brush, about, all);
  }
  function drawStrip(pen, brush, [pair, high], { width, height, base }) {
    pen.fillStyle = brush.tint(pair);
    block(pen, 0, base, width, high ? high * width : height - base);
  }
  // The Earth, and craters: those lie on the ground, and move as fast as it does; their row repeats.
  function drawMoon(pen, brush, { width, height, base, origin }, all) {
    brush.stamp([[0.84 * width, 0.16 * height]], width / 26, ball('blue'));
    pen.globalAlpha = 0.7 * all, pen.fillStyle = brush.tint(craters);
    const step = 0.19 * width, first = Math.floor(-origin[0] / step) - 1, round = Array.from({ length: 24 }, (_, i) => (i * Math.PI) / 12);
    for (let i = first; i * step + origin[0] < width + step; i++) {
      const k = ((i % 5) + 5) % 5, wide = (0.03 + 0.014 * ((3 * k) % 5)) * width, y = base + (0.2 + 0.15 * ((2 * k) % 5)) * (0.1 * width);
      if (y < height + wide) along(pen, round.map((turn) => [i * step + origin[0] + wide * Math.cos(turn), y + 0.2 * wide * Math.sin(turn)])), pen.fill();
    }
  }
  // A wall of wide boards, and a skirting on the floor
  function drawBoards(pen, brush, { width, base, origin }) {
    pen.fillStyle = brush.tint(seams);
    const step = width / 9;
    for (let x = ((origin[0] % step) + step) % step; x < width; x += step) block(pen, x, 0, width / 420, base);
    block(pen, 0, base - width / 90, width, width / 90);
  }
  // A square is a metre, or 10, or 100, so that it fills 14 px at least; each fifth line is a stronger one.
  function drawSquares(pen, brush, { width, height, scale, origin }, all) {
    const step = scale * Math.max(1, 10 ** Math.ceil(Math.log10(14 / scale)));
    pen.strokeStyle = pen.fillStyle = brush.tint(rules), pen.setLineDash([]);
    [width, height].forEach((size, k) => {
      for (let i = Math.ceil(-origin[k] / step); i * step + origin[k] < size; i++) {
        const at = i * step + origin[k];
        pen.globalAlpha = all * (i % 5 ? 0.6 : 1), pen.lineWidth = (i % 5 ? 1 : 1.8) * (width / 640);
        along(pen, k ? [[0, at], [width, at]] : [[at, 0], [at, height]]), pen.stroke();
      }
    });
  }
  function drawHills(pen, brush, { width, base, shift, nearness }) {
    const top = (x) => (nearness ? 0.05 + 0.025 * Math.sin(7 * x + 1) + 0.012 * Math.sin(17 * x) : 0.11 + 0.04 * Math.sin(4 * x) + 0.02 * Math.sin(11 * x + 2));
    const ridge = Array.from({ length: 41 }, (_, i) => [(i / 40) * width, base - width * top(i / 40 - shift)]);
    along(pen, [...ridge, [width, base], [0, base]]), pen.fill();
  }
  // Houses of one width, whose heights repeat; in the nearer row some windows are lit.
  const houses = [0.09, 0.15, 0.11, 0.2, 0.13, 0.07, 0.17, 0.1, 0.14, 0.19, 0.08, 0.12];
  function drawTown(pen, brush, { width, base, shift, nearness }, all) {
    const wide = nearness ? 0.07 : 0.05, first = Math.floor(-shift / wide), lit = [];
    for (let i = first; (i - 1) * wide + shift < 1; i++) {
      const tall = houses[((i % 12) + 12) % 12] * (nearness ? 0.75 : 1.15), left = (i * wide + shift) * width, top = base - tall * width;
      along(pen, [[left, top], [left + 1.02 * wide * width, top], [left + 1.02 * wide * width, base], [left, base]]), pen.fill();
      for (let k = 0; nearness && k < 12; k++) if ((7 * k + 5 * Math.abs(i)) % 11 < 2) lit.push([left + (0.2 + 0.3 * (k % 3)) * wide * width, top + (0.12 + 0.2 * Math.floor(k / 3)) * tall * width]);
    }
    if (lit.length === 0) return;
    pen.globalAlpha = 0.55 * all, pen.fillStyle = brush.tint(windows);
    fillDots(pen, lit, width / 400);
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
      if (kind === 'words') words(pen, brush, shape, at[0], picture, view, font);
      if (kind === 'handle' && held) for (const [x, y] of at) handle(pen, x, y, palette, held(handles++));
      if (kind === 'discs' || kind === 'area') pen.fill();
      if (kind === 'line' || kind === 'arrow') pen.stroke();
    }
  }
  // Words of a size are so high in a picture of 640 px; those without one are the page's.
  function words(pen, brush, { text, size, anchor = 'left', material }, [x, y], { stage }, { width }, font) {
    const height = size && Math.max(size * (width / 640), 11), outline = outlines[ownOf(stage)];
    brush.letters(font, height, anchor);
    const half = pen.measureText ? pen.measureText(text).width / 2 : 0.29 * height * [...text].length; // an SVG's pen can't
    if (material === 'solid') plate(pen, brush, [x, y - 0.3 * height], [half, 0.44 * height], outline ?? paper);
    write(pen, text, [x, y], outline && brush.tint(outline));
    brush.letters(font, 0, 'left');
  }
  // So wide and high to either side of its middle, with round corners
  function plate(pen, brush, [x, y], [wide, high], pair) {
    const ink = pen.fillStyle;
    Object.assign(pen, { fillStyle: brush.tint(pair), strokeStyle: brush.tint(pair), lineWidth: 1.2 * high });
    along(pen, [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => [x + a * wide, y + b * 0.6 * high])), brush.fillAndStroke();
    pen.fillStyle = ink;
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
  globalThis.demoPicture = { colours, paints, grounds, outlines, reader, aboutOf, frameOf, viewOf, draw };
})();
