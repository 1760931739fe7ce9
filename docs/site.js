// What the pages do: colours, contents on a phone, copying, folds, search. Everything can be read without it.
(function () {
  'use strict';
  const root = document.documentElement;
  const one = (selector) => document.querySelector(selector);
  const all = (selector) => [...document.querySelectorAll(selector)];

  // What the reader has chosen is kept, where the browser keeps anything for files; elsewhere it lasts for the page.
  function keep(name, value) {
    try {
      localStorage.setItem(name, value);
    } catch { /* then not */ }
  }
  function kept(name) {
    try {
      return localStorage.getItem(name);
    } catch {
      return null;
    }
  }

  // Light or dark
  const theme = one('#site-theme');
  function colour(name) {
    root.dataset.theme = name;
    theme.setAttribute('aria-pressed', String(name === 'dark'));
  }
  colour(root.dataset.theme);
  theme.addEventListener('click', () => {
    colour(root.dataset.theme === 'dark' ? 'light' : 'dark');
    keep('theme', root.dataset.theme);
  });

  // Contents, where there is no room for them beside the text
  const menu = one('#site-menu');
  function showContents(shown) {
    root.classList.toggle('contents-shown', shown);
    menu.setAttribute('aria-expanded', String(shown));
  }
  menu.addEventListener('click', () => {
    showContents(!root.classList.contains('contents-shown'));
    if (root.classList.contains('contents-shown')) one('#site-contents [aria-current]')?.focus();
  });
  document.addEventListener('click', ({ target }) => {
    if (target.closest('#site-contents a') || !target.closest('#site-contents, #site-menu')) showContents(false);
  });
  document.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || !root.classList.contains('contents-shown')) return;
    showContents(false);
    menu.focus();
  });
  const here = one('#site-contents [aria-current]');
  if (here) here.closest('nav').scrollTop = here.offsetTop - 100;

  // The part that is being read: the last one whose heading has been passed. Where the contents are hidden, the bar says it.
  const part = one('#site-part');
  const parts = all('#site-contents .parts a').map((link) => ({ link, heading: document.getElementById(link.hash.slice(1)) }));
  function markPart() {
    const passed = parts.filter(({ heading }) => heading.getBoundingClientRect().top < innerHeight / 3).at(-1);
    for (const { link } of parts) {
      if (link === passed?.link) link.setAttribute('aria-current', 'location');
      else link.removeAttribute('aria-current');
    }
    part.textContent = passed?.link.closest('.parts > li').firstElementChild.firstChild.textContent ?? '';
  }
  if (parts.length > 0) {
    // All that is above the line a third down the window counts as seen, so that a jump past a heading is noticed.
    const observer = new IntersectionObserver(markPart, { rootMargin: '1000000px 0px -66% 0px' });
    for (const { heading } of parts) observer.observe(heading);
  }

  // Listings can be copied, and long lines wrapped. Whatever scrolls sideways can be scrolled with the keyboard.
  function newButton(name, words, act) {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = name;
    button.textContent = words;
    button.addEventListener('click', () => act(button));
    return button;
  }
  const wraps = new Map();
  for (const listing of all('pre')) {
    const tools = document.createElement('span');
    tools.className = 'tools';
    const wrap = newButton('wrap', 'Wrap', () => {
      wrap.setAttribute('aria-pressed', String(listing.classList.toggle('wrapped')));
      reachByKeys();
    });
    wrap.setAttribute('aria-pressed', 'false');
    wraps.set(listing, wrap);
    tools.append(wrap, newButton('copy', 'Copy', async (button) => {
      button.textContent = (await copy(listing.textContent)) ? 'Copied' : 'Not copied';
      setTimeout(() => (button.textContent = 'Copy'), 2000);
    }));
    const caption = listing.parentElement.querySelector(':scope > figcaption');
    if (caption) caption.append(tools);
    else listing.before(tools);
    listing.addEventListener('scroll', () => fade(listing), { passive: true });
  }
  // Lines that go on beyond the right edge fade there, until one has scrolled to their end.
  function fade(listing) {
    listing.classList.toggle('goes-on', listing.scrollLeft + listing.clientWidth < listing.scrollWidth - 1);
  }
  async function copy(text) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch { /* not allowed for files in some browsers: the old way */ }
    const area = document.createElement('textarea');
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand('copy');
    area.remove();
    return done;
  }
  function reachByKeys() {
    for (const box of all('pre, .table, .katex-display')) {
      const scrolls = box.scrollWidth > box.clientWidth + 1; // one pixel is rounding
      for (const [name, value] of [['tabindex', '0'], ['role', 'group'], ['aria-label', 'Scrolls sideways']]) {
        if (scrolls) box.setAttribute(name, value);
        else box.removeAttribute(name);
      }
      if (!box.matches('pre') || box.clientWidth === 0) continue; // in a closed fold nothing has a width
      wraps.get(box).hidden = !scrolls && !box.matches('.wrapped');
      fade(box);
    }
  }
  reachByKeys();
  addEventListener('resize', reachByKeys);

  // In code one name is a link many times: the key Tab stops at the first of them.
  const stopsAt = new Set();
  for (const link of all('pre a.code')) {
    if (stopsAt.has(link.href)) link.tabIndex = -1;
    stopsAt.add(link.href);
  }
  document.addEventListener('toggle', reachByKeys, true);

  // Two switches unfold all code, and all solutions. What is unfolded is printed, and nothing else.
  for (const button of all('[data-unfolds]')) {
    const kind = button.dataset.unfolds;
    const folds = all('main details').filter((fold) =>
      fold.matches('.solution') ? kind === 'solutions' : kind === 'code' && !fold.matches('.hint') && fold.querySelector('pre'));
    const unfold = (open) => {
      button.setAttribute('aria-pressed', String(open));
      for (const fold of folds) fold.open = open;
    };
    button.hidden = folds.length === 0;
    if (folds.length > 0) button.parentElement.hidden = false;
    if (kept(kind) === 'unfolded') unfold(true);
    button.addEventListener('click', () => {
      unfold(button.getAttribute('aria-pressed') === 'false');
      keep(kind, button.getAttribute('aria-pressed') === 'true' ? 'unfolded' : 'folded');
    });
  }

  // Where a link leads stays in view while what's above it grows, until the reader scrolls.
  let landed = null, at;
  const placeNow = () => ({ page: scrollY, target: landed.getBoundingClientRect().top });
  function land() {
    if (!landed) return;
    landed.scrollIntoView();
    at = placeNow();
  }
  new ResizeObserver(land).observe(one('main'));
  addEventListener('scroll', () => {
    if (!landed) return;
    const { page, target } = placeNow(); // the browser itself scrolls to the same place
    if (page !== at.page && Math.abs(target - at.target) > 1) landed = null;
  }, { passive: true });

  // A fold opens for a link into it.
  function openFor(id) {
    const target = id && document.getElementById(id);
    if (!target) return;
    for (let fold = target.closest('details'); fold; fold = fold.parentElement.closest('details')) fold.open = true;
    landed = target;
    land();
  }
  const linked = () => openFor(self.linkedId());
  addEventListener('hashchange', linked);
  if (location.hash) linked();

  // Search. Its library and index are read when they are first wanted.
  const dialog = one('#site-search'), words = one('#site-words'), found = one('#site-found'), results = one('#site-results');
  function script(address) {
    return new Promise((done, failed) => {
      const element = document.createElement('script');
      element.src = address;
      element.onload = done;
      element.onerror = () => failed(new Error(`${address} is missing`));
      document.head.append(element);
    });
  }
  let index = null;
  async function load() {
    await script('lunr.js');
    await script('search-index.js');
    lunr.tokenizer.separator = /[^\p{L}\p{N}]+/u;
    index = lunr.Index.load(searchIndex.index);
  }
  let loading = null;
  function openSearch() {
    loading ??= load().catch(() => (found.textContent = 'The index cannot be read.')).then(search);
    dialog.showModal();
    words.select();
  }
  one('#site-find').addEventListener('click', openSearch);
  document.addEventListener('keydown', (event) => {
    const writing = event.target.closest('input, textarea, select, [contenteditable]') && !event.target.closest('dialog:not([open])');
    if (event.key === '/' && !writing && !event.ctrlKey && !event.metaKey && !event.altKey) {
      event.preventDefault();
      openSearch();
    }
  });
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog || event.target.closest('a')) dialog.close();
  });

  // The words asked for, without `how`, `the` and their like, and in the book's spelling.
  const british = { behavior: 'behaviour', center: 'centre', centered: 'centred', centers: 'centres', color: 'colour', colors: 'colours', meter: 'metre', meters: 'metres', modeling: 'modelling', neighbor: 'neighbour', tunneling: 'tunnelling', traveling: 'travelling' };
  function split(text) {
    const all = (text.toLowerCase().match(/[\p{L}\p{N}]+/gu) ?? []).map((word) => british[word] ?? word);
    const telling = index ? all.filter((word) => lunr.stopWordFilter(word)) : all;
    return telling.length > 0 ? telling : all;
  }

  // Where a word stands, as a stem or as the beginning of a word; or, if it stands nowhere, one with a slip of the pen.
  function places(term) {
    const found = index.query((query) => {
      query.term(term, { boost: 10 });
      query.term(term, { wildcard: lunr.Query.wildcard.TRAILING, usePipeline: false });
    });
    return found.length > 0 || term.length < 5 ? found : index.query((query) => query.term(term, { editDistance: 1 }));
  }

  // Parts that have the most of the words, the best first: the book's text before the names of interfaces, unless just
  // such a name was asked for.
  function matches(terms) {
    const scores = new Map();
    for (const term of terms)
      for (const { ref, score } of places(term)) {
        const before = scores.get(ref) ?? { words: 0, score: 0 };
        scores.set(ref, { words: before.words + 1, score: before.score + score });
      }
    const most = Math.max(0, ...[...scores.values()].map(({ words }) => words));
    const hits = [...scores].filter(([, { words }]) => words === most).sort((a, b) => b[1].score - a[1].score)
      .map(([ref]) => searchIndex.documents[ref]);
    const asked = words.value.trim().replace('()', ''), isName = (hit) => hit.page.startsWith('Interface: ');
    const rank = (hit) => (!isName(hit) ? 1 : asked.includes('_') && hit.part.replace('()', '') === asked ? 0 : 2);
    return { all: most === terms.length, hits: hits.sort((a, b) => rank(a) - rank(b)) };
  }

  // The piece of the text with the most of the words, and the words marked.
  function excerpt(text, terms) {
    const length = 180;
    const stems = terms.map((term) => term.slice(0, Math.max(4, term.length - 3)));
    const pattern = new RegExp(`(?<![\\p{L}\\p{N}])(?:${stems.join('|')})[\\p{L}\\p{N}]*`, 'giu');
    const hits = [...text.matchAll(pattern)];
    const within = (hit) => hits.filter(({ index }) => index >= hit.index && index < hit.index + length - 60);
    const different = (hit) => new Set(within(hit).map(([word]) => word.slice(0, 4).toLowerCase())).size;
    const best = hits.reduce((a, b) => (different(b) > different(a) ? b : a), hits[0]);
    const from = Math.max(0, text.lastIndexOf(' ', Math.max((best?.index ?? 0) - 50, 0)));
    const to = from + length < text.length ? text.lastIndexOf(' ', from + length) : text.length;
    const paragraph = document.createElement('p');
    let at = from;
    if (from > 0) paragraph.append('…');
    for (const hit of hits.filter(({ index }) => index >= from && index < to)) {
      const mark = document.createElement('mark');
      mark.textContent = hit[0];
      paragraph.append(text.slice(at, hit.index), mark);
      at = hit.index + hit[0].length;
    }
    paragraph.append(text.slice(at, Math.max(at, to)) + (to < text.length ? ' …' : ''));
    return paragraph;
  }

  function search() {
    const terms = split(words.value);
    results.replaceChildren();
    found.textContent = '';
    if (!index || terms.length === 0) return;
    const { all, hits } = matches(terms);
    const number = hits.length === 1 ? 'One place' : `${hits.length} places`;
    found.textContent = hits.length === 0 ? 'Nothing found.' : all ? number : `No place has all these words. ${number} with most of them:`;
    for (const hit of hits.slice(0, 30)) {
      const link = document.createElement('a');
      link.href = hit.address;
      link.textContent = hit.part || hit.page;
      const where = document.createElement('small');
      where.textContent = hit.part ? hit.page : '';
      const item = document.createElement('li');
      item.append(link, ' ', where);
      if (hit.text) item.append(excerpt(hit.text, terms));
      results.append(item);
    }
  }
  words.addEventListener('input', search);
  words.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') {
      event.preventDefault();
      results.querySelector('a')?.click();
    } else if (event.key === 'Escape') {
      event.preventDefault(); // which would only empty the field
      dialog.close();
    }
  });
  dialog.addEventListener('keydown', (event) => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (!step) return;
    const stops = [words, ...results.querySelectorAll('a')];
    const next = stops[stops.indexOf(document.activeElement) + step];
    if (!next) return;
    event.preventDefault();
    next.focus();
  });
})();
