// The online edition without a network, and when the site changes under a page that is open; as it is built, in Chromium.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { describe, test } from 'node:test';
import { browser, build, copyOf, root, site } from '../site/browser.mjs';
import { folder as first, manifestIn, scriptsIn } from './built.mjs';
import { inBox, saved } from './served.mjs';
import { serve } from './server.mjs';

const eight = 'chapter_08_nt_collisions.html', nine = 'chapter_09_forward_kinematics.html', newSentence = 'A sentence that is new.';
const notStarted = '· 8.1 decompose, core: not started';

// The same with another sentence in a chapter, other words in a stub, and another pack for section 8.
function makeSecond() {
  const pages = copyOf(site), packs = copyOf(path.join(build, 'online/packs')), out = copyOf(packs, (name) => name === packs);
  const change = (folder, name, ...how) => {
    const file = path.join(folder, name), text = fs.readFileSync(file, 'utf8'), changed = text.replace(...how);
    assert.notEqual(changed, text, name);
    fs.writeFileSync(file, changed);
  };
  change(pages, eight, '<main id="site-text" tabindex="-1">', (begin) => `${begin}<p>${newSentence}</p>`);
  const { file } = JSON.parse(fs.readFileSync(path.join(packs, 'manifest.json'))).sections['08_nt_collisions'], other = '08_nt_collisions-000000000000.gz';
  fs.renameSync(path.join(packs, file), path.join(packs, other));
  change(packs, 'manifest.json', file, other);
  execFileSync('node', [path.join(root, 'tools/online/make_site.mjs'), pages, packs, out]);
  const stubs = path.join(scriptsIn(out), 'stubs.json');
  change(out, stubs, 'which way does the line from a to b point', 'which way does the newer line point');
  execFileSync('node', [path.join(root, 'tools/online/list_files.mjs'), out]);
  return out;
}

// A host of its own, below a path, and a reader's browser.
async function visit(t) {
  const shown = { folder: first }, asked = [], host = await serve(() => shown.folder, asked, '/some/path');
  const context = await (await browser()).newContext({ viewport: { width: 1280, height: 900 } });
  context.setDefaultTimeout(120_000); // a busy machine compiles slowly
  t.after(() => context.close());
  const page = await context.newPage(), failed = [];
  page.on('requestfailed', (request) => failed.push(request.url()));
  page.on('response', (response) => response.ok() || failed.push(`${response.status()} ${response.url()}`));
  const go = async (name, exercise) => {
    await page.goto(`${host}/${name}#exercise-${exercise}`);
    const box = inBox(page, exercise);
    await box.code.waitFor();
    return box;
  };
  return { shown, asked, host, context, page, failed, go };
}
const keeps = (page) => page.evaluate(() => caches.keys());
const isKept = (page) => page.waitForFunction(() => navigator.serviceWorker.controller);
const says = async (box) => (await box.check(), (await box.verdict.textContent()).split('\n')[0]);
// With all that the page loads later than its start.
async function readThrough(page) {
  await page.evaluate(async () => {
    for (let y = 0; y < document.body.scrollHeight; y += innerHeight) {
      scrollTo(0, y);
      await new Promise(requestAnimationFrame);
    }
  });
  await page.waitForLoadState('networkidle');
}

describe('without a network', () => {
  test('all goes on after the first check: this page, others, and checks in each section; nothing is kept before it', async (t) => {
    const { shown, asked, page, failed, go } = await visit(t);
    const box = await go(eight, '8.1');
    await readThrough(page);
    assert.deepEqual(await keeps(page), []);
    assert.deepEqual(await page.evaluate(() => navigator.serviceWorker.getRegistrations().then((all) => all.length)), 0);
    assert.deepEqual(asked.filter((name) => /\.gz$|checker|worker/.test(name)), []);
    assert.equal(await says(box), notStarted);
    await isKept(page);
    const whole = manifestIn(first).wholeCompiler.file;
    assert.deepEqual(asked.filter((name) => name.includes(whole)), [], 'is not needed');
    const twice = Object.values(manifestIn(first)).filter(({ file }) => asked.filter((name) => name === `online/${file}`).length > 1);
    assert.deepEqual(twice, [], 'is loaded once');

    shown.folder = null;
    await page.reload();
    await box.code.waitFor();
    assert.equal(await says(box), notStarted);
    assert.equal(await says(await go(nine, '9.1')), '· 9.1 two_links, core: not started');
    await readThrough(page);
    await page.getByRole('button', { name: 'Search' }).click();
    await page.getByRole('searchbox').fill('elbow');
    await page.locator('#site-results a').first().waitFor();
    assert.deepEqual(failed, []);
    await page.goto(page.url().replace(/chapter_.*/, ''));
    await page.getByRole('link', { name: 'Go on' }).waitFor();
  });

  test('two copies of the site on one host know nothing of each other', async (t) => {
    const shown = { folder: first }, asked = [];
    const outer = fs.mkdtempSync(path.join(build, 'two-'));
    t.after(() => fs.rmSync(outer, { recursive: true }));
    fs.symlinkSync(first, path.join(outer, 'one'));
    fs.symlinkSync(first, path.join(outer, 'two'));
    const host = await serve(() => shown.folder && outer, asked);
    const context = await (await browser()).newContext();
    context.setDefaultTimeout(120_000);
    t.after(() => context.close());
    const page = await context.newPage();
    await page.goto(`${host}/one/${eight}#exercise-8.1`);
    await says(inBox(page));
    await isKept(page);
    assert.ok((await keeps(page)).every((name) => name.startsWith('frame-by-frame /one/ ')), String(await keeps(page)));
    asked.length = 0;
    await page.goto(`${host}/two/${eight}#exercise-8.1`);
    assert.equal(await page.evaluate(() => navigator.serviceWorker.controller), null);
    assert.ok(asked.includes('two/site.js'));
  });

  test('a page says what it has not got', async (t) => {
    const { shown, host, page, go } = await visit(t), box = await go(eight, '8.1');
    shown.folder = null;
    await box.check();
    const missing = (what) => `This couldn’t be checked: ${what} isn’t kept in this browser yet, and the server can’t be reached. Are you online? Your code is kept; try again.`;
    assert.equal(await box.verdict.textContent(), missing('the compiler'));
    shown.folder = first;
    const check = (section) => page.evaluate(async ([base, section]) => {
      const { Checker } = await import(`${base}checker.js`);
      self.checker ??= new Checker(base);
      return self.checker.check({ section, exercise: '', text: '' }).then(({ text }) => text, ({ message }) => message);
    }, [`${host}/${scriptsIn(first)}/`, section]);
    assert.match(await check('08_nt_collisions'), /is empty/);
    shown.folder = null;
    assert.equal(await check('09_forward_kinematics'), 'what tests section 9 isn’t kept in this browser yet, and the server can’t be reached');
  });
});

describe('a new version', () => {
  const second = makeSecond();

  test('waits until the page is reloaded, and nothing typed is lost', async (t) => {
    const { shown, asked, context, page, failed, go } = await visit(t);
    const box = await go(eight, '8.1');
    await says(box);
    await isKept(page);
    await box.write('int mine; // 8.1');
    await saved(page, 'int mine;');

    const old = `online/${manifestIn(first).sections['08_nt_collisions'].file}`;
    const hasOld = () => page.evaluate(async (name) => Boolean(await caches.match(new URL(name, document.baseURI))), old);
    shown.folder = second;
    asked.length = 0;
    await page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
    await page.getByText('This book has a newer version').waitFor();
    const scripts = scriptsIn(second);
    assert.deepEqual(asked.filter((name) => !name.startsWith(`${scripts}/`) && !name.endsWith('.html')).sort(), ['online/08_nt_collisions-000000000000.gz', 'online/files.json', 'service_worker.js'], 'only what is new is loaded');
    asked.length = 0;
    const shownHere = () => page.evaluate(async () => (await fetch(location.pathname)).text());
    assert.ok(!(await shownHere()).includes(newSentence), 'this page’s files stay');
    await box.button('Check').click();
    await box.button('Stop').click(); // which ends its worker
    await box.write('int mine; // 8.1 once more');
    assert.match(await says(box), /^✗ 8\.1/);
    assert.deepEqual(asked.filter((name) => name !== 'service_worker.js'), [], 'nothing of the new version');
    assert.ok(await hasOld());
    const other = await context.newPage();
    await other.goto(page.url());
    await other.getByText(newSentence).waitFor();
    assert.ok(!(await shownHere()).includes(newSentence), 'though another page has the new one');
    await other.close();

    await page.reload();
    await page.getByText(newSentence).waitFor();
    await box.code.waitFor();
    assert.equal(await box.text(), 'int mine; // 8.1 once more');
    await box.button('The whole file').click();
    assert.match(await says(box), /^✗ 8\.1/);
    await page.reload();
    while ((await keeps(page)).length > 2) await page.waitForTimeout(50); // the new version, and packs
    while (await hasOld()) await page.waitForTimeout(50);
    assert.deepEqual(failed, []);
  });

  test('that comes before the first check is told, and is there after reloading', async (t) => {
    const { shown, page, go } = await visit(t), box = await go(eight, '8.1');
    await box.write('int mine; // 8.1');
    shown.folder = second;
    await box.check();
    assert.match(await box.verdict.textContent(), /^This couldn’t be checked: the site has changed since this page was opened: reload it\./);
    await page.reload();
    await box.code.waitFor();
    assert.equal(await box.text(), 'int mine; // 8.1');
    assert.match(await says(box), /^✗ 8\.1/);
  });
});

test('a site that is made ready for an address has its pages listed as they are then', (t) => {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'published-'));
  t.after(() => fs.rmSync(folder, { recursive: true }));
  fs.mkdirSync(path.join(folder, 'online'));
  for (const [name, text] of [['404.html', '<base href="404.html">'], ['service_worker.js', 'work();'], ['online/whole_compiler-1.gz', '']]) fs.writeFileSync(path.join(folder, name), text);
  const read = (name) => fs.readFileSync(path.join(folder, name), 'utf8'), checksum = (text) => `sha256-${createHash('sha256').update(text).digest('base64')}`;
  for (const below of ['one', 'one/two']) {
    execFileSync(path.join(root, 'tools/site/publish_at'), [folder, `https://host/${below}`]);
    assert.equal(read('404.html'), '<base href="/one/404.html">');
    assert.equal(read('online/files.json'), JSON.stringify({ files: { '404.html': checksum('<base href="/one/404.html">') }, later: ['online/whole_compiler-1.gz'] }));
    assert.equal(read('service_worker.js'), `self.version = '${checksum(read('online/files.json'))}';\nwork();`);
  }
});
