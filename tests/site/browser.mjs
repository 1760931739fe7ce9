// What the tests of the pages share: the built site, Chromium or Firefox, and a page with what goes wrong on it.
import fs from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import { after } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium, firefox } from 'playwright-core';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
export const build = path.resolve(process.env.COURSE_BUILD ?? path.join(root, 'build/default'));
export const site = path.join(build, 'site');
export const wrong = path.join(build, 'play/wrong'); // compiled only where there is a compiler for pages
export const address = (name, folder = site) => pathToFileURL(path.join(folder, name)).href;
const axe = fs.readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

// Each is started when a test wants it.
export const firefoxHere = process.env.FIREFOX ?? ['/usr/bin/firefox-esr', '/usr/bin/firefox'].find(fs.existsSync);
const engines = {
  chromium: () => chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium-headless-shell',
    // Without a crash reporter the headless shell does not outlive the endless recursion of a demo, as Chromium does.
    args: ['--no-sandbox', '--disable-gpu', '--enable-crash-reporter'],
  }),
  firefox: () => firefox.launch({ executablePath: firefoxHere, channel: 'moz-firefox' }), // as Debian has it, by WebDriver BiDi
};
const started = {};
export const browser = (engine = 'chromium') => (started[engine] ??= engines[engine]());
after(() => Promise.all(Object.values(started).map(async (each) => (await each).close())));

// A page of this context, and what goes wrong on it: what scripts say, and requests that fail, or are not for files.
export async function openIn(context, url) {
  const page = await context.newPage(), troubles = [];
  page.on('console', (message) => troubles.push(message.text()));
  page.on('pageerror', (error) => troubles.push(error.message));
  page.on('request', (request) => /^(file|data|about|blob):/.test(request.url()) || troubles.push(`asks for ${request.url()}`));
  page.on('requestfailed', (request) => troubles.push(`cannot read ${request.url()}`));
  await page.goto(url);
  return { page, troubles, context };
}

// The same in a context of its own, which is closed after the test.
export async function open(t, name, { folder = site, width = 1280, script = '', engine, ...more } = {}) {
  const context = await (await browser(engine)).newContext({ viewport: { width, height: 900 }, ...more });
  t.after(() => context.close());
  if (script) await context.addInitScript(script);
  return openIn(context, address(name, folder));
}

// What axe finds wrong, with the first elements for each.
export async function inaccessible(page, part = 'html') {
  await page.evaluate(axe);
  const { violations } = await page.evaluate((where) => window.axe.run(where, {
    preload: false,
    resultTypes: ['violations'],
    rules: { 'empty-table-header': { enabled: false } }, // it does not see a formula, and the site writes empty cells as td
  }), part);
  return violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map((node) => node.html).join(' | ')}`);
}

// A copy of a built site, or of the files that are wanted, gone in the end, for a test that changes its files.
export function copyOf(folder, isWanted = () => true) {
  const copy = fs.mkdtempSync(path.join(os.tmpdir(), 'site-'));
  fs.cpSync(folder, copy, { recursive: true, filter: isWanted });
  after(() => fs.rmSync(copy, { recursive: true }));
  return copy;
}
