// What a player does where nothing moves without one: a ghost on the page, until the reader takes over (docs/play.js), and in
// the pictures of these places (tools/play/stills.cjs). For each time since it started [s]: `handle`, which is held, and
// `at`, the point where [m]; `press`, a key. By section, and by how a place starts its demo.
(function () {
'use strict';

// From one time to another along straight lines, through these points
const drag = (handle, from, to, ...way) => (t) => {
  if (t < from || t >= to) return {};
  const x = (way.length - 1) * (1 - Math.cos(Math.PI * (t - from) / (to - from))) / 2, leg = Math.floor(x);
  return { handle, at: [0, 1].map((k) => way[leg][k] + (x - leg) * (way[leg + 1][k] - way[leg][k])) };
};
// Once, or so many times a second, a power of two, up to another time
const press = (key, from, to = from + 1 / 64, each = 1) => (t) => (t >= from && t < to && (each * (t - from)) % 1 === 0 ? { press: key } : {});
// Where a picture moves by its demo's own key, and the page waits for a reader to press it
const onPageOnly = (hand) => Object.assign(hand, { onPageOnly: true });
const all = (...hands) => (t) => Object.assign({}, ...hands.map((hand) => hand(t)));
const circle = Array.from({ length: 65 }, (_, i) => [2 * Math.cos(0.6435 + i * Math.PI / 32), 2 * Math.sin(0.6435 + i * Math.PI / 32)]);

globalThis.demoHands = {
  '08_nt_collisions': {
    '': all(drag(0, 0, 1.9, [1.2, -0.6], [-0.2, 1.3], [1.2, -0.6]), drag(1, 2, 3.9, [2, 0], [1, -1.7], [2, 0])), // it only wonders, too
    'The game: break shot (8.3), restitution: 0.9': onPageOnly(all(drag(0, 0, 1.2, [-2, 0.2], [-2.3, 1.1], [-2, 0.2]), press('f', 1.5))),
    'The game: contact that turns (8.1)': drag(0, 0, 3.9, ...circle),
    'The game: pushed apart (8.5)': drag(0, 0, 3.9, [-6, 0], [0, 3], [6, 0], [0, -3], [-6, 0]),
  },
};
})();
