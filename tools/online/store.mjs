// What the browser keeps of the reader's: one record for each section that was begun,
//   { name, text, stub, states: { '8.1': 'passed' }, copies: [{ when, why, text }], checked, hints: { '8.1 Hint 1…': true },
//     attempts: [{ number: '8.1', state, mistake, when }] }
// where `stub` is the one that the text began with, `checked` when it was last checked [ms since 1970], `hints` has whether those
// that were seen are open, and `attempts` has each check of something new.
import { follow } from './pieces.mjs';

const mostCopies = 50, mostAttempts = 500;

export const asPromise = (request) => new Promise((done, failed) => {
  request.onsuccess = () => done(request.result);
  request.onerror = () => failed(request.error);
});

// A record with a copy of this text, unless nothing in it is the reader's or there is such a copy.
function withCopy(record, text, why) {
  if (text === record.stub || record.copies.some((copy) => copy.text === text)) return record;
  return { ...record, copies: [{ when: Date.now(), why, text }, ...record.copies].slice(0, mostCopies) };
}

export const begun = (name, stub) => ({ name, text: stub, stub, states: {}, copies: [], checked: 0, hints: {}, attempts: [] });

// The reader typed this, in what was `base`. What was written in the meantime, in another tab, is kept as a copy.
export function typed(record, text, base) {
  const isOwn = record.text === base || record.text === text;
  return { ...(isOwn ? record : withCopy(record, record.text, 'typed in another tab')), text };
}

// Another text takes the place of this one, of which a copy is kept.
export function replaced(record, text, why) {
  return { ...(record.text === text ? record : withCopy(record, record.text, why)), text };
}

// The whole section once more, as the site has it now.
export const restarted = (record, stub) => ({ ...replaced(record, stub, 'before you started again'), stub, states: {} });

// A tick goes only when the exercise is checked and red: what can't be compiled wasn't tried.
const untried = ['does not compile', 'does not link', "can't be read", 'no verdict', 'not checked'];
export function checked(record, states) {
  const known = Object.entries(states).filter(([number, state]) => !(record.states[number] === 'passed' && untried.includes(state)));
  return { ...record, states: { ...record.states, ...Object.fromEntries(known) }, checked: Date.now() };
}

// A check of one exercise, for `feedback`: none of what's done, or of a text that was checked before.
export function attempted(record, { number, state, mistake, text }) {
  const { attempts = [], states, attemptedText } = record;
  if (states[number] === 'passed' || state === 'not started' || attemptedText === text) return record;
  const when = new Date().toISOString().replace(/\.\d+/, '');
  return { ...record, attemptedText: text, attempts: [...attempts, { number, state, mistake, when }].slice(-mostAttempts) };
}

export const hinted = (record, hint, isOpen) => ({ ...record, hints: { ...record.hints, [hint]: isOpen } });

// The site brings another stub.
export function renewed(record, stub) {
  const text = record.stub === stub ? null : follow(record.text, record.stub, stub);
  if (text === null) return record;
  return { ...replaced(record, text, 'before this page changed'), stub };
}

export class Store {
  constructor(database) {
    this.database = database;
    database.onversionchange = () => database.close();
  }

  // Fails where the browser keeps nothing.
  static async open() {
    const request = indexedDB.open('frame-by-frame', 1);
    request.onupgradeneeded = () => request.result.createObjectStore('sections', { keyPath: 'name' });
    return new Store(await asPromise(request));
  }

  sections(mode = 'readonly') {
    return this.database.transaction('sections', mode).objectStore('sections');
  }
  read(name) {
    return asPromise(this.sections().get(name));
  }
  all() {
    return asPromise(this.sections().getAll());
  }

  // Replaces a record by what `how` makes of it, with nothing in between; the new one.
  async change(name, how) {
    const sections = this.sections('readwrite');
    const written = new Promise((done, failed) => {
      sections.transaction.oncomplete = done;
      sections.transaction.onabort = () => failed(sections.transaction.error);
    });
    const request = sections.get(name);
    let record;
    request.onsuccess = () => sections.put(record = how(request.result));
    await written;
    return record;
  }
}

// Asks the browser to keep it even when room gets scarce. Some ask the reader, so only once something is there to keep.
export const keepForGood = () => navigator.storage?.persist?.().catch(() => false);
