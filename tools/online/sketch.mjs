// Sketches in a page: a scene's code beside its picture, which follows at each pause of typing, once the reader has asked for the
// compiler. Each is kept as answers are, under the name sketches/NAME.
import { Answer } from './answer.mjs';
import { checks } from './checks.mjs';
import { Code } from './code.mjs';
import { make, makeButton } from './elements.mjs';
import { download } from './files.mjs';
import { showProgress } from './progress.mjs';
import { keptModules } from './scenes.mjs';
import { sharedPage } from './share.mjs';
import { Store } from './store.mjs';
import { asElements } from './verdict.mjs';
import { whyNot } from './able.mjs';

const pause = 700; // from the last key to the next picture [ms]
const base = new URL('.', document.currentScript.src), place = document.getElementById('sketch');
const titleOf = (text) => text.match(/^SKETCH\([\w:]+, "(.*)"\)/m)?.[1] ?? 'without a title';

class Sketching {
  constructor(store, scenes) {
    Object.assign(this, { store, scenes, module: null, timer: null, ran: false, running: null, again: false });
    this.build();
  }

  build() {
    this.list = make('select', { ariaLabel: 'Which sketch', onchange: () => (location.hash = this.list.value) });
    const frame = make('div', { className: 'frame' });
    this.step = make('p', { className: 'step', hidden: true });
    this.bar = make('progress', { hidden: true, ariaLabel: 'Loading the compiler' });
    this.said = make('div', { className: 'verdict' });
    this.said.setAttribute('role', 'status');
    this.figure = make('figure');
    place.replaceChildren(
      make('div', { className: 'answer' }, make('div', { className: 'row' }, this.list, makeButton('Run', () => this.run(), { className: 'check' }), makeButton('New sketch', () => this.begin(this.scenes.new)),
        makeButton('Share as a page', () => this.share(), { title: 'One file with your scene in it, to send to a friend' }), makeButton('Download the code', () => this.download()))),
      make('div', { className: 'beside' }, make('div', { className: 'answer whole' }, frame), make('div', { className: 'answer shown' }, this.step, this.bar, this.said, this.figure)));
    this.showNothing();
    this.code = new Code(frame, { label: 'Your sketch', typed: (text) => this.typed(text), check: () => this.run() });
  }

  // The one that the address names, or the newest, or a first one.
  async open() {
    const hash = self.linkedId(), [, section, scene] = hash.match(/^from=([^/]+)\/(.*)/) ?? [], names = (await this.kept()).map(([name]) => name);
    if (this.scenes[section]?.[scene]) return this.begin(this.scenes[section][scene]);
    const name = names.find((each) => each === hash) ?? names.at(-1);
    return name ? this.show(name) : this.begin(this.scenes.new);
  }
  // Those that are kept, [name, text].
  async kept() {
    return (await this.store.all()).filter(({ name }) => name.startsWith('sketches/')).map(({ name, text }) => [name.slice(9), text]);
  }
  async begin(text) {
    const names = (await this.kept()).map(([name]) => name);
    let number = 1;
    while (names.includes(`sketch_${number}`)) ++number;
    await this.show(`sketch_${number}`, text);
    await this.answer.change();
    await this.listAll();
  }
  async show(name, stub = '') {
    await this.answer?.save();
    this.name = name;
    this.answer = await Answer.open(this.store, `sketches/${name}`, stub || (await this.store.read(`sketches/${name}`))?.stub || '');
    this.answer.addEventListener('text', ({ detail }) => detail !== this && this.code.set(this.answer.text, 0));
    this.code.begin(this.answer.text, 0);
    this.said.replaceChildren();
    this.showNothing();
    history.replaceState(null, '', `#${name}`);
    await this.listAll();
    if (this.ran) await this.run();
  }
  async listAll() {
    this.list.replaceChildren(...(await this.kept()).map(([name, text]) => make('option', { value: name, textContent: `${name}: ${titleOf(text)}` })));
    this.list.value = this.name;
  }

  typed(text) {
    this.answer.type(text, this);
    clearTimeout(this.timer);
    if (this.ran) this.timer = setTimeout(() => this.run(), pause);
  }

  // What's typed while it is compiled is compiled next.
  run() {
    this.again = true;
    return (this.running ??= this.runAll().finally(() => (this.running = null)));
  }
  async runAll() {
    this.ran = true; // the compiler has been asked for
    try {
      while (this.again) {
        this.again = false;
        await this.answer.save();
        await this.take(await checks.run('sketch', { text: this.answer.text, progress: (now) => showProgress(this, now) }));
      }
    } catch (error) {
      this.module = null;
      this.said.textContent = `This couldn’t be compiled: ${error.message}. Are you online? Your code is kept; try again.`;
    }
    this.step.hidden = this.bar.hidden = true;
  }
  async take({ module, text, place: at }) {
    this.said.replaceChildren(...(text ? asElements(text, 'sketch', (line) => this.code.go(line, at?.column ?? 1)) : []));
    this.code.markBroken(at?.line ?? 0);
    this.module = module; // none where it isn't what's written
    if (!module) return;
    await this.load(module);
    Object.assign(self.playable, { sketch: module, 'sketch/mine': await keptModules() });
    await this.listAll();
    // A new one each time, since its controls may be others.
    const figure = make('figure', { className: 'play' }, make('figcaption'));
    Object.assign(figure.dataset, { demo: 'sketch', mine: '' });
    this.put(figure);
    await self.playFigure(figure);
  }
  put(figure) {
    this.figure.replaceWith(figure);
    this.figure = figure;
  }
  showNothing() {
    this.put(make('figure', { className: 'nothing', textContent: 'Press Run, and your scene is here.' }));
  }

  // Our functions of the sections that it calls.
  async load(module) {
    const names = WebAssembly.Module.imports(await WebAssembly.compile(module)).filter(({ module: from }) => from === 'yours').map(({ name }) => parseInt(name, 10));
    this.sections = Object.keys(this.scenes).filter((section) => names.includes(parseInt(section, 10)));
    await Promise.all(this.sections.filter((section) => !self.playable[`ours/${section}/mine`]).map((section) => new Promise((done, failed) => {
      const script = make('script', { src: new URL(`ours_${section}.js`, base).href, onload: done, onerror: () => failed(new Error(`our functions of ${section} can’t be loaded`)) });
      document.head.append(script);
    })));
  }

  // What is written, and nothing that was.
  async share() {
    await this.run();
    if (!this.module) return;
    download(`${this.name}.html`, await sharedPage(this.scenes.page, titleOf(this.answer.text), this.module, this.sections), 'text/html');
    this.tell(`Saved as ${this.name}.html. It plays in any browser, without a network: send it to a friend.`);
  }
  download() {
    download(`${this.name}.cpp`, this.answer.text, 'text/x-c++src');
    this.tell(`Saved as ${this.name}.cpp, your code.`);
  }
  tell(words) {
    this.step.textContent = words;
    this.step.hidden = false;
  }
}

async function start() {
  const store = await Store.open(), scenes = await (await fetch(new URL('scenes.json', base))).json();
  const sketching = new Sketching(store, scenes);
  await sketching.open();
  addEventListener('hashchange', () => self.linkedId() !== sketching.name && sketching.open());
}
const why = whyNot();
if (why) place.replaceChildren(make('p', { className: 'cannot' }, `You can’t write here: ${why}. In a terminal, this does the same: `, make('code', {}, './course sketch moon --watch')));
else start().catch((error) => place.replaceChildren(make('p', { className: 'cannot' }, `This doesn’t work here: ${error.message}.`)));
