// What the reader has done here, as the store knows it, laid over what progress.js says: docs/done.js shows it.
import { offerChanges, showScenes } from './scenes.mjs';
import { Store } from './store.mjs';

// The same shape as progress.js has it (tools/site/progress_script.cpp), with the states of these records, and where to go
// on: in the section that was checked last, of those with something left to do, or else in the first.
export function laidOver(progress, records) {
  const known = progress?.file ?? progress; // what was laid over it before no longer counts
  const recordOf = ({ page }) => records.find(({ name }) => page === `chapter_${name}.html`);
  const stateOf = (section, { number }) => recordOf(section)?.states[number];
  const sections = (known?.sections ?? []).map((section) => ({
    ...section,
    exercises: section.exercises.map((exercise) => ({ ...exercise, done: stateOf(section, exercise) ? stateOf(section, exercise) === 'passed' : exercise.done })),
  }));
  if (!records.some(({ checked }) => checked)) return { ...known, sections, file: known };
  const when = (section) => recordOf(section)?.checked ?? 0;
  const open = sections.filter(({ exercises }) => exercises.some(({ done }) => !done)).sort((a, b) => when(b) - when(a))[0];
  return { ...known, sections, file: known, next: open && placeToGoOn(open, (exercise) => stateOf(open, exercise) ?? '') };
}

// The first exercise that isn't done, or the one it needs.
function placeToGoOn({ page, exercises }, stateOf) {
  const first = exercises.find(({ done }) => !done);
  const { number, function: name } = exercises.find((one) => stateOf(first) === `needs ${one.number} ${one.function}`) ?? first;
  return { number, function: name, address: `${page}#exercise-${number}` };
}

// Reads the store, and shows it; the first time, boxes that are done are folded, as done.js does it.
let shown = false;
export async function showTicks(store) {
  const records = await store.all();
  self.laidOver = (known) => laidOver(known, records);
  dispatchEvent(new CustomEvent('remembered', { detail: { first: !shown } }));
  shown = true;
}

// Other tabs say when they saved something.
export function followTicks(store) {
  const channel = new BroadcastChannel('frame-by-frame');
  channel.onmessage = ({ data }) => data.what === 'saved' && showTicks(store);
  return showTicks(store);
}

// For a page without exercises.
export function start() {
  offerChanges();
  return Store.open().then(followTicks).then(showScenes).catch(() => { /* a browser that keeps nothing: nothing is done */ });
}
