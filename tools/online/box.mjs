// One exercise's editor: its piece of the section's file, or the whole file; Check, and what came out; Start again; and
// the reader's answers as files.
import { Code } from './code.mjs';
import { download, asZip, read } from './files.mjs';
import { make, makeButton } from './elements.mjs';
import { findPiece } from './pieces.mjs';
import { showProgress } from './progress.mjs';
import { keepModule } from './scenes.mjs';
import { asElements, asPicture } from './verdict.mjs';

const linesIn = (text) => text.split('\n').length - 1;
let made = 0;

export class Box {
  constructor(place, exercise, name, shared) {
    Object.assign(this, { place, exercise, ...shared, wholeFile: false, piece: undefined });
    this.build(`Your code for ${exercise} ${name}`);
    this.show();
    this.answer.addEventListener('text', ({ detail }) => detail !== this && this.show());
    this.answer.addEventListener('note', ({ detail }) => this.say(detail));
  }

  build(label) {
    const keys = make('p', { className: 'keys', id: `answer-keys-${++made}`, textContent: 'Ctrl+Enter checks. Tab indents; to leave with it, press Escape first.' });
    this.toggle = makeButton('The whole file', () => this.showWhole(!this.wholeFile, true));
    this.note = make('p', { className: 'note', hidden: true });
    this.note.setAttribute('role', 'status');
    const frame = make('div', { className: 'frame' });
    this.checkButton = makeButton('Check', () => (this.checking ? this.checks.stop() : this.check()), { className: 'check' });
    this.bar = make('progress', { hidden: true });
    this.step = make('p', { className: 'step', hidden: true });
    this.bar.setAttribute('aria-label', 'Loading the compiler');
    this.verdict = make('div', { className: 'verdict' });
    this.verdict.setAttribute('role', 'status');
    this.picture = make('div', { className: 'drawn' });
    this.place.replaceChildren(
      make('div', { className: 'head' }, make('span', {}, 'exercises/', make('wbr'), `${this.section}.cpp`), this.toggle),
      frame, keys,
      make('div', { className: 'row' }, this.checkButton, makeButton('Start again', () => this.startAgain()), this.buildMenu()),
      this.note, this.step, this.bar, this.verdict, this.picture);
    this.code = new Code(frame, { label, describedBy: keys.id, typed: (text) => this.typed(text), check: () => this.check() });
    this.code.whenEntered(() => this.offerThrow());
  }

  typed(text) {
    this.answer.type(this.piece ? this.piece.before + text + this.piece.after : text, this);
  }

  // In an untouched exercise typing replaces its `throw`.
  offerThrow() {
    const { stub } = this.answer.record, [words] = this.code.text.match(/throw course::NotYet\{.*?\};/s) ?? [];
    if (!words || this.code.text !== findPiece(stub, this.exercise, stub)?.body) return;
    const at = this.code.text.indexOf(words);
    this.code.offer(at, at + words.length);
  }

  // Words below the editor, and perhaps something to press; '' takes them away.
  say(words, ...more) {
    this.note.hidden = !words;
    this.note.replaceChildren(words, ...more);
  }

  // What the answer is now. Without its piece, an exercise shows the whole file.
  show() {
    const { text, record } = this.answer, found = findPiece(text, this.exercise, record.stub);
    const piece = this.wholeFile ? null : found, isOther = this.piece === undefined || Boolean(piece) !== Boolean(this.piece);
    const shown = piece ? piece.body : text, linesBefore = piece ? linesIn(piece.before) : 0;
    this.piece = piece;
    if (isOther) this.code.begin(shown, linesBefore);
    else this.code.set(shown, linesBefore);
    this.place.classList.toggle('whole', !piece);
    this.toggle.textContent = this.wholeFile ? `Only ${this.exercise}` : 'The whole file';
    this.toggle.hidden = !found;
    if (isOther) this.markBroken();
    if (!found && isOther) this.say(`There’s no one line “// ${this.exercise}” in your file, so here’s all of it.`);
  }
  showWhole(wholeFile, focus) {
    const line = linesIn(this.piece?.before ?? '') + 1;
    this.wholeFile = wholeFile;
    this.show();
    if (focus) this.code.go(wholeFile ? line : 1, 1);
  }

  // The line that didn't compile, where it still says what it said.
  markBroken() {
    const { line, words } = this.broken ?? {}, isThere = this.answer.text.split('\n')[line - 1] === words;
    this.code.markBroken(isThere ? line - linesIn(this.piece?.before ?? '') : 0);
  }

  // To a place in the file, as compilers count.
  go(line, column) {
    const inPiece = this.piece && line - linesIn(this.piece.before);
    if (this.piece && (inPiece < 1 || inPiece > linesIn(this.code.text) + 1)) this.showWhole(true);
    this.code.go(this.piece ? inPiece : line, column);
  }

  async check() {
    if (this.checking) return;
    this.checking = true;
    this.checkButton.textContent = 'Stop';
    this.verdict.replaceChildren();
    this.picture.replaceChildren();
    try {
      await this.answer.save();
      const { text } = this.answer;
      const result = await this.checks.run('check', { section: this.section, exercise: this.exercise, text, progress: (now) => this.hear(now) });
      this.verdict.replaceChildren(...asElements(result.text, this.section, (line) => this.go(line, result.place?.line === line ? result.place.column : 1)));
      this.broken = result.place && { line: result.place.line, words: text.split('\n')[result.place.line - 1] };
      this.markBroken();
      const picture = result.picture && asPicture(result.picture);
      if (picture) this.picture.append(picture);
      await this.answer.check(result.states, { number: this.exercise, state: result.states[this.exercise] ?? 'no verdict', mistake: result.mistake, text });
    } catch (error) {
      this.verdict.textContent = error.name === 'AbortError' ? 'Stopped.' : `This couldn’t be checked: ${error.message}. Are you online? Your code is kept; try again.`;
    }
    this.checking = false;
    this.checkButton.textContent = 'Check';
    this.step.hidden = this.bar.hidden = true;
  }
  hear(now) {
    if (now.module) this.playOn(now.module);
    showProgress(this, now);
  }

  // The page's scenes run on what was compiled, even if its tests turn out red.
  playOn(module) {
    keepModule(this.section, this.answer.text === this.answer.stub ? null : module).catch(console.error);
  }

  async startAgain() {
    const number = this.piece ? this.exercise : null, before = this.answer.text;
    await this.answer.startAgain(number);
    if (this.answer.text === before) return this.say(`${number ?? 'The whole file'} is as it was at the start: you haven’t changed it.`);
    this.say(`${number ?? 'The whole file'} is as it was at the start. Your code is kept. `,
      makeButton('Take it back', () => this.takeBack(before)));
    this.code.whenEntered(() => this.offerThrow());
  }
  async takeBack(text) {
    await this.answer.replace(text, 'before you took another back');
    this.say('It’s back.');
    this.code.focus();
  }

  // The reader's answers as files, and the copies that are kept.
  buildMenu() {
    const file = make('input', { type: 'file', multiple: true, accept: '.cpp,.zip', hidden: true, onchange: () => this.open(file) });
    const copies = make('ul', {}), menu = make('details', { className: 'answers' }, make('summary', { textContent: 'My answers' }),
      make('div', { className: 'row' }, makeButton('Download my answers', () => this.downloadAll()),
        makeButton('Download this file', () => download(`${this.section}.cpp`, this.answer.text, 'text/x-c++src')),
        makeButton('Open…', () => file.click()), file, makeButton('How it went', () => this.tellHowItWent())), copies);
    const list = () => copies.replaceChildren(...(menu.open ? this.answer.record.copies.map((copy) => this.entryOf(copy)) : []));
    menu.addEventListener('toggle', list);
    this.answer.addEventListener('states', list);
    return menu;
  }
  entryOf({ when, why, text }) {
    const time = new Date(when).toLocaleString([], { dateStyle: 'medium', timeStyle: 'short' });
    return make('li', {}, `${time}, ${why} `, makeButton('Take it back', () => this.takeBack(text)));
  }

  async downloadAll() {
    await this.answer.save();
    const begun = (await this.store.all()).filter(({ text, stub }) => text !== stub);
    if (begun.length === 0) this.say('There’s nothing yet: you haven’t changed any file.');
    else download('my-answers.zip', asZip(begun), 'application/zip');
  }
  // What a reader may send to whoever writes the book: no code, no name.
  async tellHowItWent() {
    await this.answer.save();
    try {
      const { text } = await this.checks.run('feedback', await this.store.all());
      if (text) download('feedback.txt', text, 'text/plain');
      this.say(text ? 'It’s in feedback.txt: checks, minutes, hints, mistakes; no code, no name. Nothing is sent.' : 'Nothing to tell: check something first.');
    } catch ({ message }) {
      this.say(`Not written: ${message}.`);
    }
  }
  async open(input) {
    const { answers, refused } = await read(input.files, this.stubs);
    input.value = '';
    const why = 'before you opened a file';
    for (const [name, text] of answers) {
      if (name === this.section) await this.answer.replace(text, why);
      else await this.answer.replaceIn(name, this.stubs[name].stub, text, why);
    }
    const taken = answers.length > 0 ? [`Opened: ${answers.map(([name]) => name).join(', ')}. What was there before is kept.`] : [];
    this.say([...taken, ...refused.map((why) => `${why}.`)].join(' '));
  }
}
