// The reader's text of one section, as this page has it: it is saved as it's typed, and other tabs hear of it.
// Events: `text`, when it changed (detail: who typed, or nothing), `states`, `note`, when there's something to say
// (detail: the words, or '' when they no longer hold).
import { attempted, begun, checked, keepForGood, renewed, replaced, restarted, typed } from './store.mjs';
import { startedAgain } from './pieces.mjs';

const pause = 300; // from the last key to saving [ms]

const elsewhere = 'This section is open in another tab. What you type there shows up here, and what’s replaced by it is kept under “My answers”.';

const keyOf = (name) => `unsaved/${name}`;
function leftBehind(name) {
  try {
    return JSON.parse(localStorage.getItem(keyOf(name)));
  } catch {
    return null;
  }
}

export class Answer extends EventTarget {
  // The section's record, in step with its stub, and with what a page could not save before it was closed.
  static async open(store, name, stub) {
    const left = leftBehind(name), record = await store.read(name) ?? begun(name, left?.stub ?? stub);
    const answer = new Answer(store, name, stub, record);
    if (left) await answer.change((now) => typed(now, left.text, left.base));
    if (answer.record.stub !== stub) await answer.change((now) => renewed(now, stub));
    return answer;
  }

  constructor(store, name, stub, record) {
    super();
    Object.assign(this, { store, name, stub, record, text: record.text, timer: null, saving: Promise.resolve(), told: false });
    this.channel = new BroadcastChannel('frame-by-frame');
    this.channel.onmessage = ({ data }) => data.name === name && this.hear(data.what);
    addEventListener('pagehide', () => this.leave());
    addEventListener('pageshow', ({ persisted }) => persisted && this.hear('saved'));
    document.addEventListener('visibilitychange', () => document.visibilityState === 'hidden' && this.leave(false));
  }

  get unsaved() {
    return this.text !== this.record.text;
  }
  say(name, detail) {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }
  tell(what) {
    this.channel.postMessage({ name: this.name, what });
  }

  type(text, who) {
    if (text === this.text) return;
    this.text = text;
    if (!this.told) this.tell('opened');
    this.told = true;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.save(), pause);
    this.say('text', who);
  }

  // What's unsaved, if anything, when all that was asked before is written.
  save() {
    clearTimeout(this.timer);
    return this.unsaved ? this.change() : this.saving;
  }

  // Changes the record, one change after the other, with what's unsaved in it, and tells other tabs.
  change(how = (record) => record) {
    this.saving = this.saving.then(() => this.apply(how)).catch(({ message }) =>
      this.say('note', `Your code isn’t saved: ${message}. Copy it to a safe place, and reload the page.`));
    return this.saving;
  }
  async apply(how) {
    const { name, text, unsaved } = this, { text: base, stub: begunWith } = this.record;
    this.record = await this.store.change(name, (record = begun(name, begunWith)) => how(unsaved ? typed(record, text, base) : record));
    if (this.text === text) this.take(this.record.text); // else somebody types, and what's here is newer
    if (!this.unsaved) this.forgetLeft();
    this.tell('saved');
    this.say('states');
    this.kept ??= keepForGood();
  }
  take(text) {
    if (text === this.text) return;
    this.text = text;
    this.say('text');
  }

  check(states, attempt) {
    return this.change((record) => checked(attempted(record, attempt), states));
  }
  // One exercise, or all, as they were given.
  startAgain(number) {
    if (!number) return this.change((record) => restarted(record, this.stub));
    return this.change((record) => replaced(record, startedAgain(record.text, number, record.stub) ?? record.text, 'before you started again'));
  }
  replace(text, why) {
    return this.change((record) => replaced(record, text, why));
  }
  // The same in another section.
  async replaceIn(name, stub, text, why) {
    await this.store.change(name, (record = begun(name, stub)) => replaced(record, text, why));
    this.channel.postMessage({ name, what: 'saved' });
  }

  async hear(what) {
    if (what === 'opened') {
      this.say('note', elsewhere);
      if (this.told) this.tell('here');
    }
    if (what === 'here') this.say('note', elsewhere);
    if (what === 'left') this.say('note', '');
    if (what !== 'saved') return;
    await this.saving;
    const record = await this.store.read(this.name);
    if (!record || this.unsaved) return;
    this.record = record;
    this.take(record.text);
    this.say('states');
  }

  // A page that goes away may not live to see its record written: what's unsaved is put where that takes no time.
  leave(forGood = true) {
    const { text: base, stub } = this.record;
    try {
      if (this.unsaved) localStorage.setItem(keyOf(this.name), JSON.stringify({ text: this.text, base, stub }));
    } catch { /* no room: then only the record */ }
    this.save();
    if (forGood && this.told) this.tell('left');
    if (forGood) this.told = false;
  }
  forgetLeft() {
    try {
      localStorage.removeItem(keyOf(this.name));
    } catch { /* keeps nothing, so nothing was kept */ }
  }
}
