// What the reader has done: `./course check` writes progress.js, and by it each page marks the boxes of exercises, the
// contents, a chapter's table of exercises, and what else asks for a mark:
//   <span data-progress="7"></span>   becomes "2 of 6 done", or "Done"
//   <a data-go-on hidden></a>         becomes "Go on: 7.2", with its address
//   <li data-yours="7.2"></li>        says at its end that it's yours
// Without it nothing is marked, and all can be read.
(function () {
  'use strict';
  const all = (selector) => [...document.querySelectorAll(selector)];
  const make = (name, className, ...inside) => {
    const element = document.createElement(name);
    element.className = className;
    element.append(...inside);
    return element;
  };
  const sections = () => self.progress?.sections ?? [];
  const isDone = ({ done }) => done;

  // A tick and its word, of which there may be no room for all to see.
  const tick = (words, hidden = false) => make('span', 'done', '✓ ', hidden ? make('span', 'hidden', words) : words);

  // A box that is done shows its heading alone, until one opens it.
  function fold(box, folded) {
    box.classList.toggle('folded', folded);
    const button = box.querySelector('.unfold');
    button.setAttribute('aria-expanded', String(!folded));
    button.textContent = folded ? 'Show' : 'Hide';
    box.dispatchEvent(new Event('toggle')); // as other folds say it
  }
  function markBox(box, done) {
    const header = box.querySelector(':scope > header');
    if (done === Boolean(header)) return;
    if (!done) {
      header.replaceWith(header.firstElementChild);
      box.classList.remove('folded');
      return;
    }
    const heading = box.firstElementChild, button = make('button', 'unfold');
    button.type = 'button';
    button.addEventListener('click', () => fold(box, !box.classList.contains('folded')));
    const head = make('header', '');
    heading.replaceWith(head);
    head.append(heading, tick('Done'), button);
    fold(box, false);
  }
  function unfoldFor(id) {
    const box = id && document.getElementById(id)?.closest('.turn.folded');
    if (box) fold(box, false);
  }
  const linked = () => unfoldFor(self.linkedId());

  // The contents: each section's entry, and the parts of this page whose boxes are all done.
  const boxes = all('.turn[data-exercise]');
  function markContents(done) {
    for (const mark of all('#site-contents .done')) mark.remove();
    for (const { page, exercises } of sections()) {
      const count = exercises.filter(isDone).length, entry = document.querySelector(`#site-contents a[href="${page}"]`);
      if (count === exercises.length) entry?.append(tick('done', true));
      else if (count > 0) entry?.append(make('span', 'done', `${count}/${exercises.length}`, make('span', 'hidden', ' done')));
    }
    const headings = all('main h2[id]');
    for (const link of all('#site-contents .parts > li > a')) {
      const heading = document.getElementById(link.hash.slice(1)), next = headings[headings.indexOf(heading) + 1];
      const follows = (one, other) => Boolean(one.compareDocumentPosition(other) & Node.DOCUMENT_POSITION_FOLLOWING);
      const inside = boxes.filter((box) => follows(heading, box) && !(next && follows(next, box)));
      if (inside.length > 0 && inside.every(({ dataset }) => done.has(dataset.exercise))) link.append(tick('done', true));
    }
  }

  // A chapter's table of exercises, and whatever else asks for it
  function markOthers(done) {
    for (const fold of all('.others')) fold.hidden = !done.has(fold.dataset.exercise); // what else would be right
    for (const mark of all('td > .done')) mark.remove();
    for (const { number, function: name } of sections().flatMap(({ exercises }) => exercises).filter(isDone))
      for (const cell of all('main td:first-child')) // elsewhere 7.1 is a number like others
        if (cell.textContent === number && cell.nextElementSibling?.querySelector('code')?.textContent === name) cell.append(tick('done', true));
    for (const place of all('[data-progress]')) {
      const exercises = sections().find(({ number }) => number === place.dataset.progress)?.exercises ?? [], count = exercises.filter(isDone).length;
      place.replaceChildren(...(count === 0 ? [] : [tick(count === exercises.length ? 'Done' : `${count} of ${exercises.length} done`)]));
    }
    for (const place of all('[data-yours]')) {
      place.querySelector('.done')?.remove();
      if (done.has(place.dataset.yours)) place.append(tick('yours'));
    }
    for (const link of all('[data-go-on]')) {
      const next = self.progress?.next;
      link.hidden = !next;
      if (!next) continue;
      link.href = next.address;
      link.textContent = `Go on: ${next.number}`;
    }
  }

  function show() {
    self.progress = self.laidOver?.(self.progress) ?? self.progress; // by the online edition, which remembers by itself
    dispatchEvent(new Event('progress')); // for demos that play what is done
    const done = new Set(sections().flatMap(({ exercises }) => exercises.filter(isDone).map(({ number }) => number)));
    for (const box of boxes) markBox(box, done.has(box.dataset.exercise));
    markContents(done);
    markOthers(done);
  }
  function begin() {
    show();
    for (const box of boxes) if (box.querySelector('.unfold')) fold(box, true);
    linked();
  }
  begin();
  addEventListener('hashchange', linked);
  addEventListener('remembered', ({ detail }) => (detail.first ? begin() : show()));

  // Whoever comes back from a terminal may have done more. What is done now stays open: it is being read.
  addEventListener('focus', () => {
    const script = document.createElement('script');
    script.src = `progress.js?${Date.now()}`;
    script.onload = script.onerror = () => {
      script.remove();
      show();
    };
    document.head.append(script);
  });
})();
