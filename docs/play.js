// Demos: each <figure class="play" data-demo="07_segment_intersection"> becomes a picture that one can play with.
// Its world is C++, compiled to WebAssembly: ours, or the reader's. This file shows it, and tells it what the reader does; docs/draw.js draws.
(function () {
  'use strict';
  const { colours, reader, aboutOf, frameOf, viewOf } = demoPicture;
  const { AnswerInstance, callFrame, readReply, fuelPerSecond } = courseAnswers;
  const longestFrame = 0.1; // [s] of the reader's code: more counts as an endless loop
  const glow = 0.3; // of a lamp, after its function was called [s]
  const still = matchMedia('(prefers-reduced-motion: reduce)');
  const playable = (self.playable ??= {});
  const make = (name, attributes, ...inside) => {
    const element = Object.assign(document.createElement(name), attributes);
    element.append(...inside);
    return element;
  };

  // A button that's quiet: a picture in place of its word.
  const icons = { Pause: 'M5 3h3v10H5zM9 3h3v10H9z', Play: 'M5 3l8 5-8 5z', Step: 'M4 3l6 5-6 5zM11 3h2v10h-2z', Reset: 'M8 3a5 5 0 1 0 5 5h-2a3 3 0 1 1-3-3v2l4-3-4-3z' };
  function showAs(button, name) {
    button.ariaLabel = button.title = name;
    const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg'), path = document.createElementNS(svg.namespaceURI, 'path');
    svg.setAttribute('viewBox', '0 0 16 16'), svg.setAttribute('aria-hidden', 'true'), path.setAttribute('d', icons[name]);
    svg.append(path), button.replaceChildren(svg);
    return button;
  }

  // What's compiled, each made ready once: base64 of gzip, because a page from disk may read scripts and nothing else; or bytes.
  const ofTexts = new Map(), ofBytes = new WeakMap();
  async function unpack(text) {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
  }
  function compile(packed) {
    const isText = typeof packed === 'string', compiled = isText ? ofTexts : ofBytes;
    if (!compiled.has(packed)) compiled.set(packed, (async () => WebAssembly.compile(isText ? await unpack(packed) : packed))());
    return compiled.get(packed);
  }

  // What stops a demo: `said` makes a sentence of it, given the exercise that it happened in.
  class Stopped extends Error {
    constructor(said) { super('stopped'); this.said = said; }
  }

  const failedCheck = (who, words) => `${who} was stopped by a check of the library that it uses: ${words}.`;
  const lastOf = (printed) => printed.slice(-1000);
  // What such a check has printed last; '' if none has.
  function checkIn(printed) {
    const line = printed.trimEnd().split('\n').at(-1), at = line.lastIndexOf(' failed: ');
    return at < 0 ? '' : line.slice(at + 9).replace(/ \([^(]*: \d+\)$/, '');
  }

  // The system's functions, of which a page has none: 52 is "not supported". Only what's printed as an error is heard.
  function quiet(memory, hear = () => {}) {
    const write = (fd, parts, count, written) => {
      if (fd !== 2) return 52;
      const view = new DataView(memory());
      let size = 0;
      for (let at = parts; count-- > 0; at += 8) {
        const length = view.getUint32(at + 4, true);
        hear(new TextDecoder().decode(new Uint8Array(memory(), view.getUint32(at, true), length)));
        size += length;
      }
      view.setUint32(written, size, true);
      return 0;
    };
    return new Proxy({}, { get: (_, name) => (name === 'fd_write' ? write : () => 52) });
  }

  // Why ours stands in for this function from the start; '' if it needn't. The reader's of an earlier section play once they're done.
  const notDone = 'not done yet', isDone = (number) => (self.progress?.sections ?? []).some(({ exercises }) => exercises.some((one) => one.number === number && one.done));
  function whyOurs(called, section, file) {
    const number = called.split(' ')[0];
    if (parseInt(number, 10) !== section && !isDone(number)) return notDone;
    return !file ? 'not written' : file.module ? '' : `${file.name}.cpp doesn't compile`;
  }

  // The reader's files of these sections, as modules that answer calls. `packed` has each by its section's name, or null where it
  // doesn't compile.
  async function filesOf(packed, sections) {
    const files = new Map();
    for (const [name, file] of Object.entries(packed)) {
      const section = parseInt(name, 10);
      if (sections.has(section)) files.set(section, { name, module: file && await compile(file), instance: null, calls: 0, printed: '' });
    }
    return files;
  }

  // The exercises that a module asks the page for.
  const askedBy = (module) => WebAssembly.Module.imports(module).filter(({ module: from }) => ['exercises', 'yours'].includes(from)).map(({ name }) => name);
  const sectionsOf = (names) => new Set(names.map((name) => parseInt(name, 10)));

  // Our functions where they aren't linked with what calls them: `playable` has a script of each section's.
  const oursApart = () => Object.assign({}, ...Object.entries(playable).filter(([name]) => name.startsWith('ours/')).map(([, file]) => file));

  // A world: a demo of this section that runs. Each call of an exercise comes through here, and goes on to the reader's function, or to ours.
  // packed: the reader's files, or null where all are ours. Those whose names are in `broken` are one of our wrong answers, where the demo has one.
  async function instantiate(module, packed, section, broken, sketch) {
    const isSketch = Number.isNaN(section), nobody = isSketch ? sketch : 'The demo'; // stopped outside of the reader's functions
    const called = new Map(), fallen = new Map(); // what was called, and when last; what ours stand in for, and why
    const imported = WebAssembly.Module.imports(module), theirs = await filesOf(packed ?? {}, sectionsOf(askedBy(module)));
    const asksAgain = [...theirs.values()].flatMap((file) => (file.module ? askedBy(file.module) : [])); // the reader's own, of earlier sections
    const names = [...new Set([...askedBy(module), ...asksAgain])].sort((a, b) => a.localeCompare(b, 'en', { numeric: true }));
    const files = await filesOf(packed ?? {}, sectionsOf(names)), apart = await filesOf(oursApart(), sectionsOf(names));
    for (const name of asksAgain) broken.delete(name); // ours with a bug is linked with the demo alone
    const catches = imported.some(({ kind }) => kind === 'tag');
    let running = null, clock = 0, exports, answer, printed = ''; // running: which of the reader's functions
    let trouble; // what ends this world, even where a reader's function catches it
    const text = (from) => {
      const bytes = new Uint8Array(exports.memory.buffer);
      return new TextDecoder().decode(bytes.slice(from, bytes.indexOf(0, from)));
    };
    const stop = (said) => { throw (trouble ??= new Stopped(said)); };
    const lost = 'A position is infinite, or not a number (NaN): which function returned it, or which Vec2 did you never set?';
    const endless = (who) => `${who} gave no answer: look for a loop that never ends.`;
    function thrown(type, what) {
      const kind = text(type), words = text(what), [, known] = /^St\d+(\w+)$/.exec(kind) ?? [];
      stop((who) => kind === 'assert' ? failedCheck(who, words)
        : known === 'invalid_argument' && who === nobody && /nan|inf/.test(words) ? lost
        : known === 'invalid_argument' ? `${who} refused its input: ${words}.`
        : `${who} threw ${known ? `std::${known}` : kind === 'i' ? 'a number' : 'something'}${words && `: ${words}`}.${catches ? '' : ' In a page no `catch` can take that.'}`);
    }
    function call(name, values) {
      called.set(name, clock);
      const ours = exports[`ours ${name}`];
      return (broken.has(name) ? exports[`wrong ${name}`] : ours ?? stop(() => `${name} can't be played: ${fallen.get(name)}.`))(...values);
    }

    // For calls from this memory: the reader's function answers, and how many bytes, or ours from a module of its own; -1 for one that's
    // linked with what calls.
    function caller(name, memory) {
      const [number] = name.split(' '), [section, place] = number.split('.').map(Number), theirs = files.get(section), ours = apart.get(section);
      return (at, size) => {
        if (trouble) throw trouble;
        called.set(name, clock);
        const values = new Uint8Array(memory(), at, size);
        const answered = packed && !broken.has(name) && !fallen.has(name) ? ask(theirs, name, place - 1, values) : -1;
        return answered < 0 && ours ? ask(ours, name, place - 1, values) : answered;
      };
    }
    const asked = (memory) => ({
      yours: new Proxy({}, { get: (_, name) => caller(name, memory) }),
      play: { thrown, take: (to) => new Uint8Array(memory()).set(answer, to) },
    });
    function ask(file, name, index, values) {
      const before = running;
      running = name;
      const { kind, value, words: [what, more] } = readReply(reply(file, callFrame(++file.calls, index, values)));
      if (kind === 'missing') fallen.set(name, 'not written');
      else if (kind === 'not yet') fallen.set(name, needs(name, more));
      else if (kind === 'refused') stop((who) => `${who} refused its input: ${what}.`);
      else if (kind === 'threw') stop((who) => `${who} threw ${what === 'int' ? `the number ${more}` : more ? `${what}: ${more}` : what}.`);
      else if (kind === 'no memory') stop((who) => `${who} asks for more memory than there is.`);
      running = before;
      return kind === 'result' ? (answer = value).length : -1;
    }
    function needs(name, inner) {
      const other = names.find((each) => each.endsWith(` ${inner}`));
      return !other || other === name ? 'not started' : `needs ${other.split(' ')[0]}`;
    }
    // From an instance that stays as long as the world does.
    function reply(file, frame) {
      const memory = () => file.instance.memory;
      try {
        if (!file.instance) {
          file.instance = new AnswerInstance(file.module, quiet(memory, (words) => (file.printed = lastOf(file.printed + words))), packed && asked(memory));
          file.instance.greet(longestFrame);
        }
        const answered = file.instance.answer(frame, longestFrame);
        if (!trouble) return answered;
      } catch (error) {
        trouble ??= error;
      }
      throw trouble;
    }
    const memory = () => exports.memory.buffer;
    const imports = { ...asked(memory), exercises: {}, env: {}, wasi_snapshot_preview1: quiet(memory, (words) => (printed = lastOf(printed + words))) };
    for (const { module: from, name, kind } of imported) {
      if (from === 'exercises') imports.exercises[name] = (...values) => call(name, values);
      if (kind === 'tag') imports.env[name] = new WebAssembly.Tag({ parameters: ['i32'] });
      else if (from === 'env') imports.env[name] = () => stop((who) => `${who} uses ${name}, which doesn't exist in a page.`);
    }
    exports = (await WebAssembly.instantiate(module, imports)).exports;
    function lookWhoseTheyAre() {
      for (const name of packed ? names : []) {
        const why = whyOurs(name, section, files.get(parseInt(name, 10)));
        if (why) fallen.set(name, why);
        else if (fallen.get(name) === notDone) fallen.delete(name);
      }
    }
    lookWhoseTheyAre();
    function refuel() {
      for (const { instance } of [...files.values(), ...apart.values()]) if (instance) instance.spent = 0;
      if (exports.fuel) exports.fuel.value = BigInt(fuelPerSecond * longestFrame); // of a sketch
    }

    // The numbers that a call left in memory
    const read = (address) => reader(new Float64Array(exports.memory.buffer, address));
    return {
      called,
      fallen,
      names,
      lookWhoseTheyAre,
      ofMany: isSketch ? names.length > 0 : new Set(names.map((name) => parseInt(name, 10))).size > 1,
      canBreak: (name) => `wrong ${name}` in exports && !asksAgain.includes(name),
      calledWithin: (name, seconds) => clock - called.get(name) < seconds,
      initialize() {
        refuel();
        if (packed || apart.size > 0) exports.ask_reader();
        exports._initialize(); // the demo's own constants may call exercises
      },
      begin() {
        refuel();
        return aboutOf(read(exports.begin()));
      },
      control: (i, value) => exports.control(i, value),
      frame(dt, step, hand) {
        running = null;
        clock += step ? 1 : dt; // after a step only what it has called glows
        refuel();
        const seen = frameOf(read(exports.frame(dt, step, hand.x, hand.y, hand.inside, hand.pressed, hand.down, hand.handle, hand.key)));
        if (seen.shapes.some(({ points }) => points.some(([x, y]) => !isFinite(x + y)))) stop(() => lost);
        return seen;
      },
      // Whatever went wrong, in one sentence.
      sentence(error) {
        const file = files.get(parseInt(running, 10)), who = running ?? nobody;
        running = null;
        if (error instanceof Stopped) return error.said(who);
        const { instance = null, printed: heard } = file ?? { printed };
        if (instance?.isOutOfFuel || exports.fuel?.value < 0n) return endless(who);
        if (error instanceof RangeError || /recursion/.test(error.message) || instance?.stackIsFull || exports.__stack_pointer.value < 4096) return `${who} called itself, again and again, until the stack was full. When does it stop?`;
        if (checkIn(heard)) return failedCheck(who, checkIn(heard));
        return `${who} crashed: ${error.message}.`;
      },
    };
  }

  // Without a minus before a zero.
  const digits = (value, decimals) => (Number(value.toFixed(decimals)) + 0).toFixed(decimals).replace('-', '−');

  let figures = 0;
  async function play(figure) {
    const name = figure.dataset.demo, section = parseInt(name, 10), isSketch = Number.isNaN(section), id = ++figures;
    const mine = () => playable[`${name}/mine`], trouble = () => playable[`${name}/trouble`];
    let world, about, picture, running = !still.matches, visible = false, failed = false, last = 0, waiting = false, starts = 0;
    const broken = new Set(figure.dataset.bug ? [figure.dataset.bug] : []); // functions that have a bug here
    let whose = 'mine' in figure.dataset && (mine() || trouble()) ? 'yours' : 'ours';
    const hand = { x: 0, y: 0, inside: false, pressed: false, down: false, handle: -1, chosen: -1, key: -1 };
    const canvas = make('canvas', { tabIndex: 0 }), pen = canvas.getContext('2d');
    canvas.setAttribute('role', 'img');
    const button = (text, onclick) => make('button', { type: 'button', textContent: text, onclick });
    const pause = showAs(button('', () => run(!running)), 'Pause'), step = showAs(button('', one), 'Step'), again = showAs(button('', restart), 'Reset');
    const sentence = make('p'), alarm = make('div', { className: 'trouble', hidden: true }, sentence, button('Restart', restart));
    sentence.setAttribute('role', 'alert');
    // What the page calls them: a friend, who was sent it, isn't the one who wrote it.
    const nameOf = 'shared' in figure.dataset ? { ours: 'The book’s', yours: 'Mine', sketch: 'My sketch' } : { ours: 'Ours', yours: figure.dataset.yours ?? 'Yours', sketch: 'Your sketch' };
    const small = (side) => nameOf[side].toLowerCase();
    const sides = ['ours', 'yours'].map((side) => Object.assign(button(nameOf[side], () => (whose = side, restart())), { value: side }));
    const choose = make('span', { className: 'whose' }, ...sides), buttons = make('div', { className: 'buttons' }), quiet = make('div', { className: 'quiet' }, pause, step, again), holds = make('div', { className: 'holds' });
    choose.setAttribute('role', 'group');
    choose.setAttribute('aria-label', 'Whose code');
    const answers = make('p', { className: 'answers' }), lamps = make('ul', { className: 'lamps' });
    const functions = make('details', { open: !matchMedia('(max-width: 40rem)').matches }, make('summary', { textContent: `Functions in this game, ${small('yours')} and ${small('ours')}` }), lamps);
    const controls = make('div', { className: 'controls' }), readouts = make('dl'), keys = make('p', { className: 'keys' });
    const caption = figure.querySelector('figcaption');
    const seen = make('div', {}, make('div', { className: 'stage' }, canvas, alarm), holds, make('div', { className: 'rows' }, buttons, quiet, choose), readouts, answers, keys);
    const board = make('div', { className: 'board' }, seen, controls), result = make('p', { className: 'hidden' }); // for those who hear it
    result.setAttribute('aria-live', 'polite');
    const paper = figure.querySelector(':scope > img'); // what is printed
    figure.replaceChildren(...[caption, board, result, paper].filter(Boolean));
    const ownKeys = [], shownOf = []; // what is shown for each of the demo's own keys, and for each control
    const values = [], dials = []; // of the controls: they outlive a restart; what shows them
    const lifted = new Set(); // keys that were held until now: a tap is down for one frame

    function fail(words) {
      failed = true;
      sentence.textContent = words;
      alarm.hidden = false;
      label();
      draw();
    }
    function attempt(work) {
      try {
        return work();
      } catch (error) {
        fail(world.sentence(error));
      }
    }

    // The code beside it, and a switch that takes a line of that away
    for (const code of document.querySelectorAll(`[data-of="${figure.id}"]`)) {
      const label = code.querySelector('label'), lever = label.querySelector('input'), listing = code.querySelector('pre code');
      listing.innerHTML = listing.innerHTML.split('\n').map((line, at) => (at === Number(code.dataset.line) ? `<span class="taken">${line}</span>` : line)).join('\n');
      label.hidden = lever.checked = false;
      lever.addEventListener('change', () => {
        broken[lever.checked ? 'add' : 'delete'](code.dataset.breaks);
        restart();
      });
    }

    async function restart() {
      const start = ++starts;
      world = undefined;
      failed = false;
      alarm.hidden = true;
      choose.hidden = (!mine() && !trouble()) || figure.closest('.suspects') !== null;
      if (choose.hidden) whose = 'ours';
      for (const side of sides) side.setAttribute('aria-pressed', String(side.value === whose));
      answers.textContent = '';
      if (choose.hidden && 'mine' in figure.dataset && !isSketch) howToPlayOnes();
      if (whose === 'yours' && trouble()) return fail(trouble());
      const fresh = await instantiate(await compile(playable[name]), whose === 'yours' ? mine() : null, section, broken, nameOf.sketch);
      if (start !== starts) return; // another one has overtaken this one
      world = fresh;
      Object.assign(hand, { handle: -1, chosen: -1, key: -1, pressed: false, down: false });
      attempt(() => (world.initialize(), (about = world.begin())));
      if (!about) return;
      if (keys.childElementCount === 0) describe();
      if (isSketch) caption.textContent = about.title, (choose.hidden ||= !world.ofMany);
      attempt(() => values.forEach((value, i) => world.control(i, value)));
      hangLamps();
      frame(0);
      if (keys.childElementCount === 0) nameKeys();
      run(running);
    }
    const jumps = ({ meaning }) => meaning === 'Jump'; // where somebody does, the space bar is for that, and doesn't pause
    let pauses;
    const shortName = (key) => ({ ArrowUp: '↑', ArrowDown: '↓', ArrowLeft: '←', ArrowRight: '→', ' ': 'space' })[key] ?? key;
    function nameKeys() {
      const named = (key, meaning) => {
        const words = make('span', {}, make('kbd', { textContent: key }), ` ${meaning}`);
        keys.append(words, ' ');
        return words;
      };
      const own = [...about.keys.map(({ key }) => key), ...about.controls.filter(isHeld).map(({ unit }) => unit)];
      if (!own.includes(' ')) pauses = named('space', 'pause');
      if (!own.includes('.')) named('.', 'step');
      if (!own.includes('r')) named('r', 'reset');
      if (handles().length > 0) named('h', 'next handle'), named('arrow keys', 'move it');
      about.keys.forEach((each, i) => ownKeys[i].push(named(jumps(each) ? 'space' : shortName(each.key), each.meaning.toLowerCase())));
      about.controls.forEach((control, i) => isHeld(control) && shownOf[i].push(named(shortName(control.unit), control.name)));
      showWhatCounts();
    }

    // Everything that about says, as elements; once
    function describe() {
      for (const setting of figure.dataset.start?.split(', ') ?? []) begins(...setting.split(': '));
      about.controls.forEach((control, i) => {
        values[i] = control.value;
        const made = isHeld(control) ? holder(control, i) : control.options.length > 0 ? choice(control, i) : slider(control, i);
        shownOf[i] = [made];
        if (isHeld(control)) holds.append(made);
        else controls.append(i === 0 && choosesGames(control) ? make('details', {}, make('summary', { textContent: 'More games' }), made) : made);
      });
      about.keys.forEach(({ meaning }, i) => (ownKeys[i] = [button(meaning, () => press(i))], buttons.append(...ownKeys[i])));
      showWhatCounts();
    }
    // A place is for one game, and the others are folded away. A choice is one of games if what else there is depends on it.
    const choosesGames = ({ options }) => [...about.controls, ...about.keys].some(({ onlyWith }) => onlyWith.some((each) => options.includes(each)));
    // What changes nothing in the mode that is chosen is not shown.
    const counts = ({ onlyWith }) => onlyWith.length === 0 || about.controls.some(({ options }, i) => onlyWith.includes(options[values[i]]));
    function showWhatCounts() {
      about.controls.forEach((control, i) => shownOf[i].forEach((shown) => (shown.hidden = !counts(control))));
      about.keys.forEach((key, i) => ownKeys[i].forEach((shown) => (shown.hidden = !counts(key))));
      if (pauses) pauses.hidden = about.keys.some((key) => jumps(key) && counts(key));
      const game = about.controls.findIndex(choosesGames);
      canvas.setAttribute('aria-label', game < 0 ? about.title : `${about.title} Here: ${about.controls[game].options[values[game]]}`);
      fit();
    }
    // Beside the picture is room for controls; where there's one at most, it has that room itself, unless it's too high.
    function fit() {
      const few = about.controls.filter((control, i) => counts(control) && !isHeld(control) && !(i === 0 && choosesGames(control))).length < 2;
      board.classList.toggle('wide', few && picture && picture.high[0] - picture.low[0] > 1.5 * (picture.high[1] - picture.low[1]));
    }
    function begins(title, chosen) {
      const control = about.controls.find((each) => each.name === title), { options = [] } = control ?? {};
      const value = options.length > 0 ? options.indexOf(chosen) : Number(chosen);
      if (!control || !(value >= control.low && value <= control.high)) throw new Error(`the demo ${name} has no "${title}: ${chosen}"`);
      control.value = value;
    }
    function set(i, value) {
      values[i] = value;
      world?.control(i, value);
      showWhatCounts();
      rest();
    }
    function slider({ name: title, unit, low, high, step: each, value }, i) {
      const shown = make('output'), input = make('input', { type: 'range', min: low, max: high, step: each, value });
      const decimals = Math.max(0, Math.ceil(-Math.log10(each) - 1e-9));
      const show = () => (shown.textContent = `${Number(input.value).toFixed(decimals)} ${unit}`.replace('-', '−'));
      input.oninput = () => (show(), set(i, Number(input.value)));
      dials[i] = (now) => (input.value = now, show());
      show();
      return make('label', {}, make('span', { textContent: title }), input, shown);
    }
    function choice({ name: title, value, options }, i) {
      const buttons = make('div'), group = make('fieldset', {}, make('legend', { textContent: title }), buttons);
      options.forEach((option, at) => {
        const input = make('input', { type: 'radio', name: `play-${id}-${i}`, checked: at === value, onchange: () => set(i, at) });
        buttons.append(make('label', {}, input, make('span', { textContent: option })));
      });
      return group;
    }

    // Keys that act while they're held, several at once: the reader's own, and a button for each.
    const isHeld = ({ step: each }) => each === 0;
    function hold(i, down) {
      if (!down) return values[i] && (running ? lifted.add(i) : turn(i, 0));
      lifted.delete(i);
      if (values[i]) return;
      turn(i, 1);
      rest();
    }
    function lift() {
      for (const i of lifted) turn(i, 0);
      lifted.clear();
    }
    const heldBy = (event) => (about?.controls ?? []).findIndex((each) => isHeld(each) && each.unit.toLowerCase() === event.key.toLowerCase() && counts(each));
    function holder({ name: title }, i) {
      const it = button(title);
      const byKey = (down) => (event) => [' ', 'Enter'].includes(event.key) && (event.preventDefault(), hold(i, down));
      it.addEventListener('pointerdown', (event) => event.button === 0 && (it.setPointerCapture(event.pointerId), hold(i, true)));
      for (const end of ['pointerup', 'pointercancel', 'blur']) it.addEventListener(end, () => hold(i, false));
      it.addEventListener('keydown', byKey(true)), it.addEventListener('keyup', byKey(false));
      it.addEventListener('contextmenu', (event) => event.preventDefault()); // a finger that stays asks for one
      dials[i] = (now) => it.setAttribute('aria-pressed', String(Boolean(now)));
      dials[i](0);
      return it;
    }

    // A lamp for each function, where a demo plays those of several sections: it glows for a while when it was called.
    // Some can be given a bug, and lose it again, while the game goes on.
    let hung = []; // each with what it shows now
    function hangLamps() {
      world.ofMany ? answers.after(functions) : functions.remove();
      hung = !world.ofMany ? [] : world.names.map((called) => {
        const [number, words] = called.split(' '), mark = make('small'), it = make('li', {}, make('i'), make('span', {}, `${number} `, make('code', { textContent: words }), ' ', mark));
        if (world.canBreak(called)) it.append(breaker(called));
        return { called, it, mark };
      });
      lamps.replaceChildren(...hung.map(({ it }) => it));
    }
    function breaker(called) {
      const it = button('', () => {
        if (!broken.delete(called)) broken.add(called);
        name();
        hung.forEach(light);
      });
      const name = () => it.setAttribute('aria-label', `${(it.textContent = broken.has(called) ? 'Mend' : 'Break')} ${called}`);
      name();
      return it;
    }
    function light(lamp) {
      const why = world.fallen.get(lamp.called), whoseItIs = broken.has(lamp.called) ? 'wrong' : whose === 'ours' || why !== undefined ? 'ours' : 'yours', lit = world.calledWithin(lamp.called, glow);
      const said = whoseItIs === 'wrong' ? 'with a bug' : small(whoseItIs) + (whoseItIs === 'ours' && why ? `: ${why}` : '');
      if (lamp.said !== said) lamp.mark.textContent = lamp.said = said, lamp.it.dataset.whose = whoseItIs;
      if (lamp.lit !== lit) lamp.it.classList.toggle('lit', (lamp.lit = lit));
    }

    // The world goes on by so much, and is as it was if that went wrong.
    function advance(dt, one_step = false) {
      if (!world || failed) return null;
      const seen = attempt(() => world.frame(Math.min(dt, 0.1), one_step, hand));
      hand.pressed = false;
      hand.key = -1;
      lift();
      return seen;
    }
    function frame(dt, one_step) {
      const seen = advance(dt, one_step);
      if (seen) show(seen);
    }
    function show(seen) {
      picture = seen;
      const { low, high } = seen, shape = String((high[0] - low[0]) / (high[1] - low[1]));
      if (canvas.style.aspectRatio !== shape) canvas.style.aspectRatio = shape, fit();
      if (seen.readouts.map(({ name: title }) => title).join() !== [...readouts.querySelectorAll('dt')].map((each) => each.textContent).join())
        readouts.replaceChildren(...seen.readouts.map(({ name: title, unit }) => make('div', {}, make('dt', { textContent: title }), make('dd', {}, make('b'), ` ${unit}`))));
      readouts.querySelectorAll('b').forEach((shown, i) => (shown.textContent = digits(seen.readouts[i].value, seen.readouts[i].decimals)));
      hung.forEach(light);
      tellResult(seen.shapes);
      if (whose === 'yours' && !world.ofMany) tellWhose();
      draw();
    }
    // What stands in the picture, once it has stood there for a second and a reader has done something
    let stands = '', telling, touched = false;
    const tellSoon = () => (clearTimeout(telling), (telling = setTimeout(() => (result.textContent = stands), 1000)));
    for (const kind of ['pointerdown', 'keydown']) figure.addEventListener(kind, () => (touched = true, tellSoon()));
    function tellResult(shapes) {
      const words = shapes.filter(({ kind, material }) => kind === 'words' && material === 'solid').map(({ text }) => text).join(', ');
      if (words !== stands) stands = words, touched && tellSoon();
    }
    const command = make('code', { textContent: `./course play ${figure.dataset.exercise ?? section} --mine` });
    const howToPlayOnes = () => answers.append(...('online' in document.documentElement.dataset ? ['This is our code, until you press Check.'] : ['This is our code. To play with yours, type ', command]));
    function tellWhose() {
      const number = (exercise) => exercise.split(' ')[0], sorted = world.names.filter((each) => world.called.has(each));
      const yours = sorted.filter((each) => !world.fallen.has(each)).map(number), ours = sorted.filter((each) => world.fallen.has(each));
      const told = (yours.length > 0 ? `${nameOf.yours}: ${yours.join(', ')}. ` : '') + (ours.length > 0 ? `${nameOf.ours}: ${ours.map((each) => `${number(each)} (${world.fallen.get(each)})`).join(', ')}.` : '');
      if (answers.textContent !== told) answers.textContent = told;
    }

    function turn(i, value) {
      values[i] = value;
      dials[i]?.(value);
      attempt(() => world?.control(i, value));
    }
    const view = () => viewOf(picture, canvas.clientWidth);
    let palettes = null, font; // as the page's style says, looked up when that may have changed
    function look() {
      const probe = figure.appendChild(make('i'));
      probe.style.forcedColorAdjust = 'none'; // a picture keeps its colours: they mean something
      const colour = (words) => (probe.style.color = words, getComputedStyle(probe).color);
      const all = () => Object.fromEntries([...colours, 'paper'].map((each) => [each, colour(`var(--${each})`)]));
      const page = all(), theme = colour('light-dark(#000, #fff)') === colour('#fff') ? 1 : 0;
      probe.style.colorScheme = 'dark';
      palettes = { page, dark: all(), of: (pair) => pair[theme] };
      font = `14px ${getComputedStyle(probe).fontFamily}`;
      probe.remove();
    }
    function draw() {
      if (!picture || !canvas.clientWidth) return;
      if (!palettes) look();
      const width = Math.round(canvas.clientWidth * devicePixelRatio), height = Math.round(canvas.clientHeight * devicePixelRatio);
      if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
      pen.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
      pen.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
      demoPicture.draw(pen, picture, view(), palettes, {
        font,
        strength: failed ? 0.35 : 1,
        held: (index) => index === hand.handle || index === hand.chosen,
      });
    }

    // Time: it stands still out of sight, and when the reader says so
    function label() {
      const name = running ? 'Pause' : 'Play';
      if (pause.title !== name) showAs(pause, name);
      pause.disabled = step.disabled = failed;
    }
    function run(on) {
      running = on;
      label();
      if (waiting) return;
      waiting = true;
      requestAnimationFrame(tick);
    }
    function tick(now) {
      waiting = false;
      if (!running || failed || !visible) return (last = 0);
      const dt = last ? Math.max(0, now - last) / 1000 : 0;
      frame(dt);
      last = now;
      run(true);
    }
    function one() {
      run(false);
      frame(0, true);
    }
    const rest = () => { if (!running) frame(0); };

    // What the reader does
    function press(key) {
      hand.key = key;
      rest();
    }
    const handles = () => (picture?.shapes ?? []).filter(({ kind }) => kind === 'handle').flatMap(({ points }) => points);
    function near({ clientX, clientY, pointerType }) {
      const box = canvas.getBoundingClientRect(), x = clientX - box.left, y = clientY - box.top, { scale, onto } = view();
      const away = handles().map((point) => Math.hypot(onto(point)[0] - x, onto(point)[1] - y)), least = Math.min(...away);
      return { x: picture.low[0] + x / scale, y: picture.high[1] - y / scale, handle: least < (pointerType === 'mouse' ? 14 : 26) ? away.indexOf(least) : -1 };
    }
    let tap = false; // a finger is on the picture, and may yet scroll the page: it presses when it is lifted
    canvas.addEventListener('pointerdown', (event) => {
      if (!picture || event.button !== 0) return;
      const at = near(event);
      tap = event.pointerType === 'touch' && at.handle < 0;
      Object.assign(hand, at, { chosen: -1, pressed: !tap, down: !tap, inside: true });
      canvas.setPointerCapture(event.pointerId);
      rest();
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!picture) return;
      const { x, y, handle: nearest } = near(event);
      Object.assign(hand, { x, y, inside: event.pointerType === 'mouse' || event.buttons > 0 });
      canvas.style.cursor = hand.handle >= 0 ? 'grabbing' : nearest >= 0 ? 'grab' : '';
      rest();
    });
    for (const end of ['pointerup', 'pointercancel'])
      canvas.addEventListener(end, (event) => {
        const lifted = end === 'pointerup';
        Object.assign(hand, { handle: -1, down: false, inside: lifted && event.pointerType === 'mouse', pressed: hand.pressed || (lifted && tap) });
        tap = false;
        rest();
      });
    canvas.addEventListener('pointerleave', () => (hand.inside = hand.handle >= 0));
    // A finger scrolls the page, unless it begins on a handle.
    canvas.addEventListener('touchstart', (event) => {
      const [{ clientX, clientY }] = event.changedTouches;
      if (picture && near({ clientX, clientY, pointerType: 'touch' }).handle >= 0) event.preventDefault();
    }, { passive: false });
    canvas.addEventListener('keydown', (event) => {
      if (!about || event.ctrlKey || event.metaKey || event.altKey) return;
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      const own = about.keys.findIndex((each) => (each.key === event.key || (event.key === ' ' && jumps(each))) && counts(each));
      if (heldBy(event) >= 0) hold(heldBy(event), true);
      else if (own >= 0) press(own);
      else if (event.key === ' ') failed || run(!running);
      else if (event.key === '.') failed || one();
      else if (event.key === 'r') restart();
      else if (event.key === 'h') hand.chosen = (hand.chosen + 2) % (handles().length + 1) - 1, failed || draw();
      else if (way && hand.chosen >= 0) {
        const [x, y] = handles()[hand.chosen], far = (picture.high[0] - picture.low[0]) / 60;
        Object.assign(hand, { x: x + way[0] * far, y: y + way[1] * far, handle: hand.chosen });
        frame(0);
        hand.handle = -1;
      } else return;
      event.preventDefault();
    });

    canvas.addEventListener('keyup', (event) => heldBy(event) >= 0 && hold(heldBy(event), false));
    canvas.addEventListener('blur', () => about?.controls.forEach((each, i) => isHeld(each) && hold(i, false)));

    new IntersectionObserver((changes) => (visible = changes.at(-1).isIntersecting) && run(running)).observe(canvas);
    new ResizeObserver(draw).observe(canvas);
    const restyle = () => (palettes = null, draw());
    new MutationObserver(restyle).observe(document.documentElement, { attributeFilter: ['data-theme'] });
    addEventListener('beforeprint', () => (figure.style.colorScheme = 'light', restyle()));
    addEventListener('afterprint', () => (figure.style.colorScheme = '', restyle()));
    addEventListener('progress', () => world && (world.lookWhoseTheyAre(), hung.forEach(light)));
    figure.addEventListener('play-again', () => (whose = 'yours', restart()));
    await restart();
    if (isSketch && 'mine' in figure.dataset && document.activeElement === document.body) canvas.focus({ preventScroll: true, focusVisible: false }); // so that it hears keys
    figure.dataset.ready = '';
  }

  // `./course play 7 --mine --watch` writes the reader's code anew: a page that has it looks once a second.
  function lookForNews(name) {
    const stamp = () => JSON.stringify(['', '/mine', '/trouble'].map((part) => playable[name + part]));
    const before = stamp();
    const script = make('script', { src: `demos/${name}_mine.js?${Date.now()}` });
    script.onload = script.onerror = () => {
      script.remove();
      if (stamp() !== before)
        for (const figure of document.querySelectorAll(`.play[data-demo="${name}"]`)) figure.dispatchEvent(new Event('play-again'));
    };
    document.head.append(script);
  }

  // The same demo twice, and in one of them a function has a bug: which one, and why?
  function suspect(place) {
    const figures = place.querySelectorAll('.play'), guilty = String(Math.floor(Math.random() * 2)), { bug, cause } = place.dataset;
    const form = place.querySelector('form'), said = form.querySelector('[role=status]'), told = place.querySelector('.told');
    figures[guilty].dataset.bug = bug;
    form.addEventListener('input', () => (said.textContent = ''));
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      const { which, why } = Object.fromEntries(new FormData(form)), found = which === guilty && why === cause;
      said.textContent = found ? 'Yes, that’s it.' : which !== guilty ? 'No, that one runs on our code as it is. Change something in both, and look again.' : 'Yes, that one. But not because of that: what would it look like then?';
      told.hidden = !found;
    });
    place.hidden = false;
  }
  for (const place of document.querySelectorAll('.suspects')) if (playable[place.querySelector('.play').dataset.demo]) suspect(place);

  const all = [...document.querySelectorAll('.play')].filter(({ dataset }) => playable[dataset.demo]);
  for (const figure of all) play(figure);
  self.playFigure = play; // for one that comes later
  for (const name of new Set(all.map(({ dataset }) => dataset.demo)))
    if (`${name}/trouble` in playable) setInterval(() => document.hidden || lookForNews(name), 1000);
})();
