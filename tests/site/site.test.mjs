// Looks at every page of the built site as a reader would: on a phone and on a desk, by day and by night.
// The build has checked links already; this is what only a browser knows.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { address, browser, inaccessible, open, openIn, root, site } from './browser.mjs';

const pages = fs.readdirSync(site).filter((name) => name.endsWith('.html')).sort();
const chapters = pages.filter((name) => name.startsWith('chapter_'));

// All pages at night and where what makes them has changed; else the first few of each kind: chapter_…, source_…, index.
const few = Number(process.env.PAGES_OF_A_KIND ?? Infinity), kind = (name) => /^[a-z0-9]+/.exec(name)[0];
const isChosen = (name) => pages.filter((other) => kind(other) === kind(name)).indexOf(name) < few;

// In the page: what reaches beyond its edge, and cannot be scrolled to; or is cut off where it stands. What a student needs
// to write must be seen at once.
function overflowing() {
  const found = [];
  const scrolls = (box) => /auto|scroll/.test(getComputedStyle(box).overflowX);
  const say = (what, box) => found.push(`${what}: <${box.tagName.toLowerCase()} class="${box.className}"> ${box.textContent.trim().slice(0, 60)}`);
  if (document.documentElement.scrollWidth > innerWidth) found.push(`the page is ${document.documentElement.scrollWidth} wide`);
  for (const box of document.querySelectorAll('body *')) {
    if (box.closest('.katex-mathml, .hidden, svg, dialog:not([open])') || !box.checkVisibility()) continue;
    const style = getComputedStyle(box);
    if (box.matches(':is(.turn, blockquote) .table') && box.scrollWidth > box.clientWidth) say('too wide for its box', box);
    if (/hidden|clip/.test(style.overflowX) && box.scrollWidth > box.clientWidth + 1) say('cut off', box);
    const edge = box.getBoundingClientRect();
    if (edge.width === 0 || (edge.right <= innerWidth + 0.5 && edge.left >= -0.5) || box.matches('.skip')) continue;
    let outer = box.parentElement;
    while (outer && !scrolls(outer)) outer = outer.parentElement;
    if (!outer) say('beyond the edge', box);
  }
  return found;
}

// In the page: words that should have become something else.
function leftRaw() {
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const found = [];
  while (walker.nextNode()) {
    const node = walker.currentNode;
    if (node.parentElement.closest('code, pre, kbd, .katex, script, style, .memItemRight, .memname')) continue;
    if (/\$|\\[a-z]|\{\{|\uE000|\uE001|<\/?[a-z]+>|^#+ /.test(node.data)) found.push(node.data.trim());
  }
  return found;
}

// Among pages of code one is like the other, and they are long: axe looks at one. Those of structs and classes are made of
// what other pages have, too, and are looked at once.
const isOneOfMany = (name) => name.startsWith('source_') && name !== 'source_chapters_course_hpp.html';
const forAxe = (name, width) => !isOneOfMany(name) && (width === 1280 || !/^(struct|class)/.test(name));

// All pages on a phone by night and, but for those of code, on a desk by day; and these two the other way round as well.
const looked = (name, width, colours) =>
  (width === 390) === (colours === 'dark') ? width === 390 || !isOneOfMany(name) : ['index.html', chapters[0]].includes(name);
for (const width of [390, 1280])
  for (const colours of ['light', 'dark'])
    describe(`${width} px, ${colours}`, { concurrency: 2 }, () => {
      let context;
      before(async () => {
        context = await (await browser()).newContext({ viewport: { width, height: 900 }, colorScheme: colours });
      });
      after(() => context.close());
      for (const name of pages.filter((name) => isChosen(name) && looked(name, width, colours)))
        test(name, async () => {
          const { page, troubles } = await openIn(context, address(name));
          assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), colours);
          await page.evaluate(() => document.querySelectorAll('details').forEach((fold) => (fold.open = true)));
          assert.deepEqual(await page.evaluate(overflowing), []);
          assert.deepEqual(await page.evaluate(leftRaw), []);
          assert.deepEqual(troubles, []);
          if (forAxe(name, width)) assert.deepEqual(await inaccessible(page), []);
          await page.close();
        });
    });

describe('listings', () => {
  for (const name of chapters)
    test(`${name} shows what stands in the files, at the lines that it names`, async (t) => {
      const { page } = await open(t, name);
      const listings = await page.$$eval('figure.listing:has(.from)', (all) =>
        all.map((one) => [one.querySelector('.from').textContent, one.querySelector('pre').textContent]));
      assert.ok(listings.length > 0);
      for (const [place, text] of listings) {
        const [file, line] = place.split(':');
        const source = fs.readFileSync(path.join(root, file), 'utf8').split('\n').slice(Number(line) - 1)
          .filter((one) => !one.trim().startsWith('COURSE_FIELDS(')); // which the weave leaves out
        const lines = text.replace(/\n$/, '').split('\n');
        assert.deepEqual(lines, source.slice(0, lines.length), place);
      }
    });

  test('the pages of code show whole files', async (t) => {
    const { page } = await open(t, 'index.html');
    for (const name of pages.filter((one) => one.startsWith('source_'))) {
      await page.goto(address(name));
      const file = await page.textContent('h1');
      assert.equal((await page.textContent('pre')).trimEnd(), fs.readFileSync(path.join(root, file.trim()), 'utf8').trimEnd());
    }
  });

  test('a listing can be copied', async (t) => {
    const { page, context } = await open(t, chapters[0]);
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    const listing = page.locator('figure.listing').first();
    await listing.locator('.copy').click();
    await listing.getByText('Copied').waitFor();
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), await listing.locator('pre').textContent());
  });

  test('a name in a listing leads to its description', async (t) => {
    const { page } = await open(t, chapters[0]);
    const name = page.locator('pre a.code').first();
    const word = await name.textContent();
    await name.click();
    await page.waitForLoadState();
    assert.match(page.url(), /\/(namespace|struct|class)\w+\.html/);
    assert.ok((await page.textContent('main')).includes(word));
  });
});

describe('reading', () => {
  test('from page to page, forwards and back', async (t) => {
    const { page } = await open(t, 'index.html');
    const order = await page.$$eval('.card a', (links) => links.map((link) => link.getAttribute('href')));
    const turn = async (rel) => {
      const way = [];
      for (let link; (link = page.locator(`.turning a[rel=${rel}]`)), await link.count(); ) {
        await link.click();
        await page.waitForLoadState();
        way.push(path.basename(new URL(page.url()).pathname));
      }
      return way;
    };
    assert.deepEqual(order, chapters);
    const book = ['index.html', 'preface.html', ...chapters, 'notation_and_units.html', 'glossary.html', 'where_next.html'];
    await page.goto(address(book[1]));
    assert.deepEqual(await turn('next'), book.slice(2));
    assert.deepEqual(await turn('prev'), book.reverse().slice(1));
  });

  test('the front page begins the first section, and has a card for each', async (t) => {
    const { page } = await open(t, 'index.html');
    assert.match(await page.textContent('.begin'), /^Begin with 1 Motion \d+\u00a0min$/);
    for (const card of await page.locator('.card').all()) {
      assert.match(await card.textContent(), /^\d+ [\s\S]+\d+ \+ \d+\u00a0minutes\s*$/);
      await card.click({ position: { x: 5, y: 5 }, trial: true }); // all of it is its link
    }
    assert.deepEqual(await page.$$eval('.map a', (links) => links.map((link) => link.getAttribute('href')).sort()), chapters, 'the map has a link to each');
    assert.equal(await page.locator('.map .to-come a').count(), 0);
    const boxes = await page.$$eval('.map .node', (nodes) => nodes.map((node) => { const { left, top, right, bottom } = node.getBoundingClientRect(); return { left, top, right, bottom }; }));
    assert.ok(boxes.length >= chapters.length);
    for (const [i, a] of boxes.entries())
      for (const b of boxes.slice(i + 1)) assert.ok(a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top, 'two boxes of the map meet');
    await page.setViewportSize({ width: 390, height: 844 });
    assert.equal(await page.locator('.map').isVisible(), false);
    assert.deepEqual(await page.$$eval('.map-list a', (links) => links.map((link) => link.getAttribute('href'))), chapters, 'a phone shows a list');
    assert.ok(await page.locator('.map-list').isVisible());
    await page.setViewportSize({ width: 1280, height: 900 });
    assert.equal(await page.locator('#site-contents').isVisible(), false, 'they are in the menu');
    await page.getByRole('button', { name: 'Contents' }).click();
    await page.locator('#site-contents').getByRole('link', { name: 'Glossary' }).click();
    await page.waitForURL(/\/glossary\.html$/);
    await page.goto(address('index.html'));
    await page.locator('.begin').click();
    await page.waitForURL(new RegExp(`${chapters[0]}$`));
  });

  test('a chapter says how long it takes, and its entry is the one that is marked', async (t) => {
    const { page } = await open(t, 'index.html');
    for (const name of chapters) {
      await page.goto(address(name));
      assert.match(await page.textContent('.above'), /^\d+ minutes(, and \d+ for the other exercises)?$/);
      assert.equal(await page.getAttribute('#site-contents [aria-current=page]', 'href'), name);
    }
  });

  test('folds open and close; a link into one opens it', async (t) => {
    const { page } = await open(t, 'index.html');
    for (const name of [chapters[0], chapters.at(-1)]) { // all chapters have the same kinds
      await page.goto(address(name));
      const folds = page.locator('details:not(:has(> .lamps))'); // a game's functions are open, where there's room
      const number = await folds.count();
      assert.ok(number > 0);
      for (let i = 0; i < Math.min(number, 5); i += 1) {
        const fold = folds.nth(i);
        const inside = fold.locator(':scope > :not(summary)').first();
        if (!(await fold.isVisible())) continue;
        assert.equal(await inside.isVisible(), false);
        await fold.locator('summary').first().click();
        assert.equal(await inside.isVisible(), true);
        await fold.locator('summary').first().click();
        assert.equal(await inside.isVisible(), false);
      }
      await page.evaluate(() => {
        document.querySelector('details:not(:has(> .lamps)) > :not(summary)').id = 'within';
        location.hash = '#within';
      });
      await page.locator('#within').waitFor({ state: 'visible' });
    }
  });

  test('the choice of colours is remembered, on the next page as well; pictures follow', async (t) => {
    const { page } = await open(t, chapters[0]);
    const look = () => page.evaluate(() => [document.documentElement.dataset.theme, getComputedStyle(document.body).backgroundColor]);
    const picture = async () => {
      const png = await page.locator('.picture img').first().screenshot();
      return page.evaluate(async (data) => {
        const image = await createImageBitmap(await (await fetch(data)).blob());
        const pen = new OffscreenCanvas(image.width, image.height).getContext('2d');
        pen.drawImage(image, 0, 0);
        const pixels = pen.getImageData(0, 0, image.width, image.height).data.filter((_, i) => i % 4 === 1);
        return { paper: pixels[0], darkest: pixels.reduce((a, b) => Math.min(a, b)), lightest: pixels.reduce((a, b) => Math.max(a, b)) };
      }, `data:image/png;base64,${png.toString('base64')}`);
    };
    const light = await look();
    const onLight = await picture();
    assert.ok(onLight.paper > 240 && onLight.darkest < 80, 'dark ink on light paper');
    await page.getByRole('button', { name: 'Dark colours' }).click();
    const dark = await look();
    const onDark = await picture();
    assert.ok(onDark.paper < 40 && onDark.lightest > 180, 'light ink on dark paper');
    assert.equal(light[0], 'light');
    assert.equal(dark[0], 'dark');
    assert.notEqual(light[1], dark[1]);
    await page.reload();
    assert.deepEqual(await look(), dark);
    await page.goto(address('index.html'));
    assert.deepEqual(await look(), dark);
    assert.equal(await page.getAttribute('#site-theme', 'aria-pressed'), 'true');
  });

  test('on a phone, the contents come and go', async (t) => {
    const { page } = await open(t, 'index.html', { width: 390 });
    const contents = page.locator('#site-contents');
    assert.equal(await contents.isVisible(), false);
    await page.getByRole('button', { name: 'Contents' }).click();
    assert.equal(await contents.isVisible(), true);
    assert.deepEqual(await page.evaluate(overflowing), []);
    await page.keyboard.press('Escape');
    assert.equal(await contents.isVisible(), false);
    await page.getByRole('button', { name: 'Contents' }).click();
    assert.equal(await page.evaluate(() => document.activeElement.getAttribute('aria-current')), 'page');
    await page.mouse.click(380, 700);
    assert.equal(await contents.isVisible(), false, 'a tap outside closes them');
    await page.getByRole('button', { name: 'Contents' }).click();
    await contents.getByRole('link', { name: 'Errata' }).click();
    await page.waitForURL(/\/errata\.html$/);
    assert.equal(await contents.isVisible(), false);
  });

  test('the contents mark the part that is being read', async (t) => {
    const { page } = await open(t, chapters[0]);
    assert.equal(await page.locator('.parts [aria-current]').count(), 0);
    for (const at of [2, 1]) {
      const link = page.locator('#site-contents .parts a').nth(at);
      await page.evaluate((id) => document.getElementById(id).scrollIntoView(), (await link.getAttribute('href')).slice(1));
      await page.locator('.parts [aria-current=location]').waitFor();
      await page.waitForFunction((n) => document.querySelectorAll('#site-contents .parts a')[n].matches('[aria-current=location]'), at);
      assert.equal(await page.locator('.parts [aria-current]').count(), 1);
    }
    await page.evaluate(() => scrollTo(0, document.body.scrollHeight)); // past all headings at once
    await page.waitForFunction(() => [...document.querySelectorAll('#site-contents .parts a')].at(-1).matches('[aria-current=location]'));
    await page.evaluate(() => scrollTo(0, 0));
    await page.waitForFunction(() => !document.querySelector('.parts [aria-current]'));
  });

  test('the contents list what is in the part that is being read, and on a phone the bar names that part', async (t) => {
    const { page } = await open(t, chapters[0], { width: 390 });
    const bar = page.locator('#site-part'), home = page.locator('.book-name');
    assert.equal(await home.isVisible(), true);
    const part = page.locator('#site-contents .parts > li:has(ul)').nth(1), inside = part.locator('ul a');
    await page.evaluate((id) => document.getElementById(id).scrollIntoView(), (await inside.first().getAttribute('href')).slice(1));
    await bar.waitFor();
    assert.equal(await bar.textContent(), (await part.locator('> a').textContent()).trim());
    assert.equal(await home.isVisible(), false);
    assert.deepEqual(await page.evaluate(overflowing), []);
    await page.getByRole('button', { name: 'Contents' }).click();
    assert.equal(await inside.first().isVisible(), true);
    assert.equal(await page.locator('#site-contents .parts > li:has(ul)').first().locator('ul a').first().isVisible(), false, 'of other parts nothing');
    assert.ok((await page.$$eval('#site-contents .parts li', (items) => items.map(({ textContent }) => textContent))).every((words) => !/minutes/.test(words)));
  });

  test('no line begins with the comma behind a formula', async (t) => {
    const { page } = await open(t, chapters[1], { width: 390 });
    const [all, torn] = await page.evaluate(() => {
      document.querySelectorAll('details').forEach((fold) => (fold.open = true));
      const marks = [...document.querySelectorAll('.katex .mark')];
      return [marks.length, marks.filter((mark) => mark.getBoundingClientRect().left <= mark.closest('p, li, td, summary, figcaption')?.getBoundingClientRect().left).length];
    });
    assert.ok(all > 0);
    assert.equal(torn, 0);
    const heard = await page.$$eval('.katex:has(.mark)', (formulas) => formulas.map((formula) => [formula.querySelector('.katex-mathml').textContent.slice(-1), formula.querySelector('.mark').textContent.slice(-1)]));
    assert.ok(heard.every(([last, mark]) => last === mark), 'a screen reader reads it, too');
  });

  test('numbers and their unit are on one line', async (t) => {
    const { page } = await open(t, 'index.html', { width: 390 });
    for (const chapter of chapters) {
      await page.goto(address(chapter));
      const [all, torn] = await page.evaluate(() => {
        document.querySelectorAll('details').forEach((fold) => (fold.open = true));
        const words = document.createTreeWalker(document.querySelector('#site-text'), NodeFilter.SHOW_TEXT), found = [];
        while (words.nextNode())
          if (!words.currentNode.parentElement.closest('pre, code, .katex, .demo, .play'))
            for (const { index, 0: quantity } of words.currentNode.data.matchAll(/\d\)?\s(N\ss|kg|m\/s|N|J|m|s)(?![a-z])/gi)) {
              const range = document.createRange();
              range.setStart(words.currentNode, index), range.setEnd(words.currentNode, index + quantity.length);
              found.push([quantity, new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size]);
            }
        return [found.length, found.filter(([, lines]) => lines > 1).map(([quantity]) => quantity)];
      });
      assert.ok(all > 5, `${all} in ${chapter}`);
      assert.deepEqual(torn, [], chapter);
    }
  });

  test('a name that is a link many times is one stop of the key Tab', async (t) => {
    const { page } = await open(t, chapters[0]);
    const stops = await page.$$eval('pre a.code', (links) => links.filter((link) => link.tabIndex === 0).map((link) => link.href));
    assert.ok(stops.length > 0);
    assert.equal(new Set(stops).size, stops.length);
  });

  test('the first key leads past the contents', async (t) => {
    const { page } = await open(t, chapters[0]);
    await page.keyboard.press('Tab');
    assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Skip to the text');
    await page.keyboard.press('Enter');
    assert.equal(await page.evaluate(() => document.activeElement.id), 'site-text');
  });

  test('without scripts all can be read', async (t) => {
    for (const width of [390, 1280]) {
      const { page } = await open(t, chapters[0], { width, javaScriptEnabled: false });
      assert.equal(await page.locator('#site-contents').isVisible(), true);
      assert.equal(await page.locator('.katex').first().isVisible(), true);
      await page.emulateMedia({ colorScheme: 'dark' });
      assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(20, 23, 29)', 'dark, where the system is');
      for (const button of await page.locator('button').all()) assert.equal(await button.isVisible(), false);
      await page.goto(address('index.html'));
      const top = async (what) => (await page.locator(what).boundingBox()).y;
      assert.ok((await top('main')) < (await top('#site-contents')) && (await top('#site-contents')) < (await top('footer')), 'the contents are above the footer');
    }
  });

  test('an exercise is in a box', async (t) => {
    const { page } = await open(t, 'index.html');
    let boxes = 0;
    for (const name of chapters) {
      await page.goto(address(name));
      assert.equal(await page.locator('blockquote').filter({ hasText: /^\s*Your turn/ }).count(), 0, name);
      for (const heading of await page.locator('.turn > :first-child').all()) assert.match(await heading.textContent(), /^\s*Your turn: /);
      boxes += await page.locator('article.turn').count();
    }
    assert.ok(boxes > 0);
  });

  // Which folds are open: of code, of solutions, of hints.
  const openFolds = (page) => page.evaluate(() => {
    const folds = [...document.querySelectorAll('main details')];
    const summary = (fold) => fold.querySelector('summary').textContent;
    const kinds = {
      solutions: folds.filter((fold) => summary(fold).startsWith('Our solution of ')),
      hints: folds.filter((fold) => /^Hint \d+ of \d+: /.test(summary(fold))),
    };
    kinds.code = folds.filter((fold) => fold.querySelector('pre') && !kinds.solutions.includes(fold) && !kinds.hints.includes(fold));
    return Object.fromEntries(Object.entries(kinds).map(([kind, all]) => {
      const open = all.filter((fold) => fold.open).length;
      return [kind, all.length > 0 && open === all.length ? 'all' : open === 0 ? 'none' : 'some'];
    }));
  });

  test('two switches unfold all code and all solutions, by mouse and by keys, and are remembered', async (t) => {
    const { page } = await open(t, chapters[0]);
    const code = page.getByRole('button', { name: 'Unfold all code' }), solutions = page.getByRole('button', { name: 'Unfold all solutions' });
    assert.deepEqual(await openFolds(page), { code: 'none', solutions: 'none', hints: 'none' });
    await code.click();
    assert.equal(await code.getAttribute('aria-pressed'), 'true');
    assert.deepEqual(await openFolds(page), { code: 'all', solutions: 'none', hints: 'none' });
    await solutions.focus();
    await page.keyboard.press('Space');
    assert.deepEqual(await openFolds(page), { code: 'all', solutions: 'all', hints: 'none' });
    assert.deepEqual(await inaccessible(page, '#site-contents'), []);
    await code.click();
    assert.equal(await code.getAttribute('aria-pressed'), 'false');
    await page.goto(address(chapters[1]));
    assert.equal(await solutions.getAttribute('aria-pressed'), 'true');
    assert.deepEqual(await openFolds(page), { code: 'none', solutions: 'all', hints: 'none' });
    await solutions.click();
    await page.reload();
    assert.deepEqual(await openFolds(page), { code: 'none', solutions: 'none', hints: 'none' });
    await page.goto(address('index.html'));
    assert.equal(await page.locator('.switches').isVisible(), false, 'where nothing is folded');
  });

  test('on a phone the switches are in the menu', async (t) => {
    const { page } = await open(t, chapters[0], { width: 390 });
    await page.getByRole('button', { name: 'Contents' }).click();
    const code = page.getByRole('button', { name: 'Unfold all code' });
    assert.ok(await page.$eval('#site-contents', (menu) => menu.scrollHeight > menu.clientHeight && menu.getBoundingClientRect().bottom <= innerHeight));
    assert.ok((await code.boundingBox()).y > 48, 'below the bar, although the menu has been scrolled');
    await code.click();
    assert.equal((await openFolds(page)).code, 'all');
    assert.equal(await page.locator('#site-contents').isVisible(), true);
  });

  test('without scripts a fold opens, and there are no switches', async (t) => {
    const { page } = await open(t, chapters[0], { javaScriptEnabled: false });
    assert.equal(await page.locator('.switches').isVisible(), false);
    const fold = page.locator('main details').first(), inside = fold.locator(':scope > :not(summary)').first();
    assert.equal(await inside.isVisible(), false);
    await fold.locator('summary').click();
    assert.equal(await inside.isVisible(), true);
  });

  test('a line that is too long fades at the edge until one has scrolled to its end, and can be wrapped', async (t) => {
    const { page } = await open(t, chapters[0], { width: 390 });
    const listing = page.locator('main > figure.listing:has(pre.goes-on)').first();
    await page.evaluate(() => document.querySelectorAll('figure.listing').forEach((one, number) => (one.dataset.number = number)));
    const same = page.locator(`[data-number="${await listing.getAttribute('data-number')}"]`), code = same.locator('pre');
    const scrolls = () => code.evaluate((box) => box.scrollWidth > box.clientWidth);
    assert.equal(await scrolls(), true);
    assert.notEqual(await code.evaluate((box) => getComputedStyle(box).maskImage), 'none');
    await code.evaluate((box) => (box.scrollLeft = box.scrollWidth));
    await same.locator('pre:not(.goes-on)').waitFor();
    await code.evaluate((box) => (box.scrollLeft = 0));
    const wrap = same.getByRole('button', { name: 'Wrap' });
    await wrap.click();
    assert.equal(await scrolls(), false);
    assert.equal(await wrap.getAttribute('aria-pressed'), 'true');
    assert.equal(await code.evaluate((box) => box.matches('.goes-on')), false);
    await wrap.click();
    assert.equal(await scrolls(), true);
    // Where all lines fit, there is nothing to wrap.
    for (const short of await page.locator('main > figure.listing:not(:has(pre.goes-on))').all())
      assert.equal(await short.locator('.wrap').isVisible(), false);
  });

  test('on paper there is what is unfolded, and nothing that paper cannot do', async (t) => {
    const { page } = await open(t, chapters[8], { colorScheme: 'dark' });
    const pages = async () => (await page.pdf({ preferCSSPageSize: true })).toString('latin1').match(/\/Type\s*\/Page\b/g).length;
    const folded = await pages();
    await page.getByRole('button', { name: 'Unfold all code' }).click();
    const unfolded = await pages();
    assert.ok(folded > 5 && unfolded > folded, `${folded} pages, ${unfolded} with all code`);
    await page.emulateMedia({ media: 'print', colorScheme: 'dark' });
    for (const fold of await page.locator('main details.solution').all()) assert.equal(await fold.isVisible(), false, 'no solutions');
    assert.equal(await page.locator('main details[open]').first().isVisible(), true);
    for (const gone of ['.bar', '#site-contents', '.turning', '.tools'])
      assert.equal(await page.locator(gone).first().isVisible(), false, gone);
    assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), 'rgb(255, 255, 255)');
  });
});

describe('search', () => {
  const search = async (page, words) => {
    if (!(await page.locator('#site-search').isVisible())) await page.keyboard.press('/');
    await page.locator('#site-words').fill(words);
    await page.locator('#site-found:not(:empty)').waitFor();
    return page.$$eval('#site-results a', (links) => links.map((link) => link.getAttribute('href')));
  };

  test('finds words inside each part of each chapter', async (t) => {
    const { page, troubles } = await open(t, 'index.html');
    for (const name of chapters) {
      await page.goto(address(name));
      // Of each part, up to the next heading, be it in a box: the longest words of its prose, whatever the part is about.
      const parts = await page.$$eval('main h2[id]', (headings) =>
        headings.map((heading) => {
          let words = '';
          for (let next = heading.nextElementSibling; next && !next.matches('h2, h3, :has(h3)'); next = next.nextElementSibling)
            if (next.tagName === 'P') words += ` ${next.textContent}`;
          return [heading.id, [...new Set(words.match(/\b[a-z]{5,}\b/g))].sort((a, b) => b.length - a.length).slice(0, 4).join(' ')];
        }));
      for (const [id, word] of parts.filter(([, one]) => one)) {
        const found = await search(page, word);
        assert.ok(found.includes(`${name}#${id}`), `"${word}" leads to ${found}`);
        await page.keyboard.press('Escape');
      }
    }
    assert.deepEqual(troubles, []);
  });

  test('forgives an ending, a half-written word and a slip of the pen, and asks for all words', async (t) => {
    const { page } = await open(t, 'index.html');
    const errata = (found) => found.includes('errata.html');
    assert.deepEqual((await search(page, 'erratum'))[0], 'errata.html');
    assert.ok(errata(await search(page, 'errat')));
    assert.ok((await search(page, 'rolling')).includes('preface.html'), 'it says "roll to a stop"');
    assert.ok((await search(page, 'argument joules')).includes('notation_and_units.html'), 'std::invalid_argument is three words');
    assert.deepEqual(await search(page, 'lamotte'), ['preface.html']);
    assert.deepEqual(await search(page, 'xylophone'), []);
    assert.equal(await page.textContent('#site-found'), 'Nothing found.');
    assert.ok(errata(await search(page, 'errata xylophone')), 'what has most of the words');
    assert.match(await page.textContent('#site-found'), /^No place has all these words/);
    const both = await search(page, 'LaMothe joules');
    for (const place of ['notation_and_units.html', 'preface.html']) assert.ok(both.includes(place), `one of the two words: ${place}`);
    assert.match((await search(page, 'require_range'))[0], /^namespacecourse\.html#/, 'a function of an interface');
  });

  // What readers type, and the place that must come first: a part, by the beginning of its address.
  const questions = {
    'how to bounce off a wall': 'chapter_07_segment_intersection.html#a-ball-in-a-room',
    'the normal of a wall': 'chapter_06_reflection.html#which-way-a-wall-faces',
    'ball in a box': 'chapter_07_segment_intersection.html#a-ball-in-a-room',
    'collision response': 'chapter_07_segment_intersection.html#a-ball-in-a-room',
    'collision detection': 'chapter_07_segment_intersection.html#a-ball-with-a-size',
    'collision': 'chapter_08_nt_collisions.html#towards-and-past',
    'elastic collision': 'chapter_02_momentum.html#',
    'conservation of momentum': 'chapter_02_momentum.html#',
    'coefficient of restitution': 'chapter_02_momentum.html#from-rubber-to-clay',
    'infinite mass': 'chapter_02_momentum.html#how-heavy-is-a-wall',
    'resultant force': 'chapter_02_momentum.html#tug-of-war',
    "newton's cradle": 'chapter_02_momentum.html#newtons-cradle',
    'time of impact': 'chapter_07_segment_intersection.html#a-ball-with-a-size',
    'circle vs line': 'chapter_07_segment_intersection.html#a-ball-with-a-size',
    'tunneling': 'chapter_07_segment_intersection.html',
    'fast objects go through walls': 'chapter_07_segment_intersection.html',
    'cross product': 'chapter_07_segment_intersection.html#where-two-lines-cross',
    'determinant': 'chapter_07_segment_intersection.html#where-two-lines-cross',
    'gravitational force': 'chapter_03_gravity_wells.html#the-pull',
    'orbital speed': 'chapter_03_gravity_wells.html#falling-around',
    'how long does a fall take': 'chapter_03_gravity_wells.html#near-the-ground',
    'softening': 'chapter_03_gravity_wells.html#through-the-middle',
    'runge kutta': 'chapter_03_gravity_wells.html#four-integrators',
    "kepler's equation": 'chapter_03_gravity_wells.html#keplers-clock',
    'coefficient of friction': 'chapter_05_inclined_planes.html#hold-or-slide',
    'normal force': 'chapter_05_inclined_planes.html#what-presses',
    'braking distance': 'chapter_05_inclined_planes.html#a-puck-slows-down',
    'angle of repose': 'chapter_05_inclined_planes.html#the-critical-angle',
    'air hockey': 'chapter_05_inclined_planes.html#on-the-table',
    'stick slip': 'chapter_05_inclined_planes.html#stick-and-slip',
    'bounce off the edge of the screen': 'chapter_06_reflection.html#off-the-edges',
    'reflect a vector': 'chapter_06_reflection.html#off-a-slanted-wall',
    'perpendicular vector': 'chapter_06_reflection.html#which-way-a-wall-faces',
    'rough wall': 'chapter_06_reflection.html#rubber-and-sandpaper',
    'rotated rectangle': 'chapter_06_reflection.html#tilt-your-head',
    'bank shot': 'chapter_06_reflection.html#bank-shots',
    'line of centres': 'chapter_08_nt_collisions.html#towards-and-past',
    'pool balls at right angles': 'chapter_08_nt_collisions.html#equal-balls',
    'break shot': 'chapter_08_nt_collisions.html#the-break-shot',
    'swept circle': 'chapter_08_nt_collisions.html#between-two-frames',
    'penetration depth': 'chapter_08_nt_collisions.html#a-crowd',
    'spatial hashing': 'chapter_08_nt_collisions.html#a-thousand-balls',
    'where do two lines cross': 'chapter_07_segment_intersection.html#where-two-lines-cross',
    'do two segments intersect': 'chapter_07_segment_intersection.html#do-they-meet',
    'floating point precision': 'chapter_07_segment_intersection.html#a-sign-you-can-trust',
    'orient2d': 'chapter_07_segment_intersection.html#a-sign-you-can-trust',
    'center of mass': 'chapter_01_motion.html#a-missile-breaks-in-two',
    'centroid of a polygon': 'chapter_01_motion.html#where-a-plate-balances',
    'fixed timestep': 'chapter_12_time_based_motion.html#the-same-jump',
    'symplectic euler': 'chapter_01_motion.html#one-frame-at-a-time',
    'what is the game loop': 'chapter_01_motion.html#across-the-screen',
    'constant acceleration': 'chapter_01_motion.html#a-missile-gets-faster',
    'pixels per second': 'chapter_01_motion.html#your-first-line',
    'object pool': 'chapter_11_particles.html#a-place-in-the-pool',
    'spawn a particle': 'chapter_11_particles.html#a-place-in-the-pool',
    'color over lifetime': 'chapter_11_particles.html#a-life-and-its-colours',
    'random numbers': 'chapter_11_particles.html#random-numbers',
    'random point in a circle': 'chapter_11_particles.html#a-filled-disc',
    'firework': 'chapter_11_particles.html#a-filled-disc',
    'spawn rate': 'chapter_11_particles.html#how-many-in-this-frame',
    'swap and pop': 'chapter_11_particles.html#a-pool-that-never-searches',
    'smoke behind a rocket': 'chapter_11_particles.html#a-trail',
    'spiral of death': 'chapter_12_time_based_motion.html#too-much-to-do',
    'frame rate independent damping': 'chapter_12_time_based_motion.html#half-of-whats-left',
    'snapshot interpolation': 'chapter_12_time_based_motion.html#a-friend-on-the-line',
    'half-life': 'chapter_12_time_based_motion.html#half-of-whats-left',
  };
  test('answers what readers ask in their own words', async (t) => {
    const { page } = await open(t, 'index.html');
    const wrong = [];
    for (const [question, place] of Object.entries(questions)) {
      const found = await search(page, question);
      if (!found[0]?.startsWith(place)) wrong.push(`"${question}" leads to ${found.slice(0, 3)}`);
    }
    assert.deepEqual(wrong, []);
  });

  test('works with the keyboard alone, and shows the words found', async (t) => {
    const { page } = await open(t, 'index.html', { width: 390 });
    assert.deepEqual(await search(page, 'lamothe'), ['preface.html']);
    assert.equal(await page.textContent('#site-results mark'), 'LaMothe');
    assert.deepEqual(await inaccessible(page, 'dialog'), []);
    await page.keyboard.press('Escape');
    assert.equal(await page.locator('#site-search').isVisible(), false, 'Escape closes, though there are words');
    await search(page, 'the wall');
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('ArrowDown');
    const focused = () => page.evaluate(() => [...document.querySelectorAll('#site-results a')].indexOf(document.activeElement));
    assert.equal(await focused(), 1);
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('ArrowUp');
    assert.equal(await page.evaluate(() => document.activeElement.id), 'site-words');
    await search(page, 'lamothe');
    await page.keyboard.press('Enter');
    await page.waitForURL(/\/preface\.html$/);
    assert.equal(await page.locator('#site-search').isVisible(), false);
  });
});
