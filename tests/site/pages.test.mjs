// The site where it's published: below a path of a server, with an address of its own.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { browser, copyOf, root, site } from './browser.mjs';

const folder = copyOf(site), below = '/frame-by-frame/';
const kinds = { html: 'text/html', css: 'text/css', js: 'text/javascript', svg: 'image/svg+xml', png: 'image/png', woff2: 'font/woff2', txt: 'text/plain' };
let address, context;
const server = http.createServer(({ url }, answer) => { // as GitHub Pages does
  const name = decodeURIComponent(new URL(url, address).pathname);
  const file = path.join(folder, name.endsWith('/') ? `${name.slice(below.length)}index.html` : name.slice(below.length));
  const there = name.startsWith(below) && fs.existsSync(file), shown = there ? file : path.join(folder, '404.html');
  answer.writeHead(there ? 200 : 404, { 'content-type': kinds[path.extname(shown).slice(1)] });
  answer.end(name.startsWith(below) ? fs.readFileSync(shown) : '');
});
before(async () => {
  await new Promise((ready) => server.listen(0, '127.0.0.1', ready));
  address = `http://127.0.0.1:${server.address().port}${below}`;
  execFileSync(path.join(root, 'tools/site/publish_at'), [folder, address]);
  context = await (await browser()).newContext();
});
after(() => (context.close(), server.close()));

async function visit(url) {
  const page = await context.newPage(), troubles = [];
  page.on('console', (message) => troubles.push(message.text()));
  page.on('pageerror', (error) => troubles.push(error.message));
  page.on('request', (request) => request.url().startsWith(address) || /^(data|blob):/.test(request.url()) || troubles.push(`asks for ${request.url()}`));
  page.on('response', (response) => response.ok() || response.url() === url || troubles.push(`${response.status()} ${response.url()}`));
  return { page, troubles, status: (await page.goto(url)).status() };
}

test('each page links to files that are there, by relative addresses', () => {
  for (const name of fs.readdirSync(folder).filter((each) => each.endsWith('.html'))) {
    const text = fs.readFileSync(path.join(folder, name), 'utf8').replace(/<base [^>]*>/, '');
    for (const [, link] of text.matchAll(/\s(?:href|src)="([^"#]+)/g)) {
      if (/^(https?|data|mailto):/.test(link)) continue;
      assert.ok(!link.startsWith('/') && !link.startsWith('..'), `${name}: ${link}`);
      assert.ok(fs.existsSync(path.join(folder, link.replaceAll('&amp;', '&'))), `${name}: ${link}`);
    }
  }
});

test('each page says what it is about; where it has a demo there is a picture of it, by its whole address', () => {
  for (const name of fs.readdirSync(folder).filter((each) => each.endsWith('.html'))) {
    const text = fs.readFileSync(path.join(folder, name), 'utf8'), meta = (what) => new RegExp(`<meta (?:name|property)="${what}" content="([^"]+)">`).exec(text)?.[1];
    assert.equal(meta('og:url'), address + (name === 'index.html' ? '' : name));
    assert.ok(meta('description').length > 30 && meta('og:title') && meta('og:description') === meta('description'), name);
    assert.equal(Boolean(meta('og:image')), text.includes('data-demo="') || text.includes('<img src="demos/'), name);
    if (!meta('og:image')) continue;
    if (name === 'chapter_08_nt_collisions.html') assert.match(meta('og:image'), /\/demos\/08_nt_collisions_[2-8]\.png$/, 'its best scene, as on its card');
    const png = fs.readFileSync(path.join(folder, meta('og:image').slice(address.length)));
    assert.deepEqual([png.toString('latin1', 1, 4), png.readUInt32BE(16)], ['PNG', 1280]);
  }
});

test('from the front page one click leads to all demos, which play', async () => {
  const { page, troubles } = await visit(address);
  await page.click('text=Play all');
  await page.waitForURL(`${address}play.html`);
  const demos = page.locator('figure.play');
  for (let i = 0; i < await demos.count(); i++) {
    await demos.nth(i).scrollIntoViewIfNeeded();
    await page.waitForFunction((at) => {
      const demo = document.querySelectorAll('figure.play')[at];
      return 'ready' in demo.dataset && demo.querySelector('canvas').clientHeight > 100;
    }, i);
  }
  assert.ok(await demos.count() >= 10);
  assert.deepEqual(troubles, []);
});

test('an address that leads nowhere, however deep, gets a page with a look and links that work', async () => {
  for (const lost of ['nowhere.html', 'no/such/folder/page.html']) {
    const { page, troubles, status } = await visit(address + lost);
    assert.equal(status, 404);
    assert.equal(await page.textContent('h1'), "This page isn't here");
    assert.deepEqual(troubles.filter((each) => !/status of 404/.test(each)), []);
    await page.click('main a');
    await page.waitForURL(`${address}index.html`);
  }
});
