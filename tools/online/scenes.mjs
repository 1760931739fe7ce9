// A page's scenes run on the reader's functions, once a file of theirs has been compiled here: the module that it became is kept, by
// its section's name, until it's compiled again. In a database of its own, which may be lost.
import { make } from './elements.mjs';
import { asPromise } from './store.mjs';

let database;
async function modules(mode) {
  database ??= (() => {
    const request = indexedDB.open('frame-by-frame-modules', 1);
    request.onupgradeneeded = () => request.result.createObjectStore('modules');
    return asPromise(request);
  })();
  return (await database).transaction('modules', mode).objectStore('modules');
}

// bytes: null where nothing of a section is the reader's any more
export async function keepModule(section, bytes) {
  const kept = await modules('readwrite');
  await asPromise(bytes ? kept.put(bytes, section) : kept.delete(section));
  await showScenes();
}

// All of them, by their sections' names; null for none.
export async function keptModules() {
  const kept = await modules('readonly'), [names, all] = await Promise.all([asPromise(kept.getAllKeys()), asPromise(kept.getAll())]);
  return names.length > 0 ? Object.fromEntries(names.map((name, at) => [name, all[at]])) : null;
}

// docs/play.js runs a demo on what stands in `playable` as the reader's.
export async function showScenes() {
  const answers = await keptModules();
  const figures = [...document.querySelectorAll('.play')];
  for (const demo of new Set(figures.map(({ dataset }) => dataset.demo))) {
    const mine = `${demo}/mine`, isTheirs = Boolean(answers?.[demo]);
    if (!self.playable || (!isTheirs && !self.playable[mine])) continue;
    self.playable[mine] = isTheirs ? answers : null;
    for (const figure of figures) if (figure.dataset.demo === demo) figure.dispatchEvent(new Event('play-again'));
  }
}

// Beside each scene a link to its code, in the page about sketches.
export function offerChanges() {
  for (const figure of document.querySelectorAll('.play:not(.suspects *)')) {
    const link = make('a', { textContent: 'Change it', href: 'sketches.html', onclick: () => (link.href = `sketches.html#from=${encodeURIComponent(sceneOf(figure))}`) });
    figure.append(make('p', { className: 'change' }, link));
  }
}
// The one that the reader has chosen in it.
function sceneOf(figure) {
  const { demo } = figure.dataset;
  return demo.startsWith('sketch_') ? `gallery/${demo.slice(7)}` : `${demo}/${figure.querySelector('fieldset :checked + span')?.textContent ?? ''}`;
}
