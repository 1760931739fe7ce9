// In each box of an exercise an editor, made when the box comes near the view, and below it what the tests say. Until the
// first Check nothing of the compiler is loaded.
import { Answer } from './answer.mjs';
import { Box } from './box.mjs';
import { checks } from './checks.mjs';
import { make } from './elements.mjs';
import { tellOfNewer } from './keeping.mjs';
import { offerChanges, showScenes } from './scenes.mjs';
import { hinted, Store } from './store.mjs';
import { followTicks, showTicks } from './ticks.mjs';
import { whyNot } from './able.mjs';

const base = new URL('.', document.currentScript.src);
const section = document.body.dataset.section ?? location.pathname.match(/chapter_(\d\d_\w+?)(?:\.html)?$/)?.[1];
const boxes = [...document.querySelectorAll('.turn[data-exercise]')], hints = document.querySelectorAll('.turn .hint');

// Where the editor would be.
function tellWhyNot(place, exercise, why) {
  place.className = 'cannot';
  place.replaceChildren(`You can’t write here: ${why}. In a terminal, this does the same: `, make('code', {}, `./course check ${exercise}`));
}

// What all boxes share; read once, for the first of them.
let shared = null;
async function open() {
  const store = await opened, stubs = await (await fetch(new URL('stubs.json', base))).json();
  if (!stubs[section]) throw new Error(`stubs.json knows no section ${section}`);
  const answer = await Answer.open(store, section, stubs[section].stub);
  answer.addEventListener('states', () => showTicks(store));
  keepHints(answer);
  return { store, stubs, answer, section, checks };
}

// Hints are as they were left.
function keepHints(answer) {
  for (const hint of hints) {
    const name = `${hint.closest('.turn').dataset.exercise} ${hint.firstElementChild.textContent}`, kept = () => answer.record.hints?.[name];
    const keep = () => hint.open !== Boolean(kept()) && answer.change((record) => hinted(record, name, hint.open));
    if (kept() === false) hint.classList.add('seen');
    if (kept()) hint.open = true;
    keep();
    hint.addEventListener('toggle', keep);
  }
}

async function fill(place, exercise, name) {
  try {
    new Box(place, exercise, name, await (shared ??= open()));
  } catch (error) {
    console.error(error);
    tellWhyNot(place, exercise, error.name === 'TypeError' ? 'the files of the exercises can’t be loaded' : `this doesn’t work here (${error.message})`);
  }
}

const opened = whyNot() ? null : Store.open();
const near = new IntersectionObserver((all) => {
  for (const { target, isIntersecting } of all) {
    if (!isIntersecting) continue;
    near.unobserve(target);
    const box = target.closest('.turn');
    fill(target, box.dataset.exercise, box.querySelector('h3 code')?.textContent ?? '');
  }
}, { rootMargin: '50% 0px' });
for (const box of boxes) {
  const place = make('div', { className: 'answer', id: box.id.replace('exercise', 'code') });
  box.insertBefore(place, box.querySelector(':scope > .hints'));
  if (opened) near.observe(place);
  else tellWhyNot(place, box.dataset.exercise, whyNot());
}
for (const hint of hints) hint.addEventListener('toggle', () => hint.classList.add('seen'));
tellOfNewer();
if (opened) offerChanges();
opened?.then(followTicks).then(showScenes).catch(() => { /* said in each box */ });
