// Keeps the site, once a reader has checked something: then it needs no network. list_files.mjs puts a line above this one,
// with self.version: the checksum of files.json.
//
// A version is all files of the site as they belong together, in a cache of its own. A page has all its files of the version
// that it began with; when the site has a new one, it's taken whole in the meantime, and pages that are opened then have it.
// What's packed for the compiler has names by its content, and a cache that all versions share.
import { cacheOf } from './kept.mjs';

const root = new URL('.', location), own = cacheOf(root, version), packs = cacheOf(root, 'packs');
const lanes = 6; // files at once, as browsers ask a host for

const nameOf = (url) => decodeURIComponent(new URL(url).pathname.slice(root.pathname.length)) || 'index.html';
const addressOf = (name) => new URL(name, root);

// { name, cache, list } of other versions; one that isn't whole has no list.
async function others() {
  const names = (await caches.keys()).filter((name) => name.startsWith(cacheOf(root, '')) && ![own, packs].includes(name));
  return Promise.all(names.map(async (name) => {
    const cache = await caches.open(name);
    return { name, cache, list: await listIn(cache) };
  }));
}
const listIn = async (cache) => (await cache.match(addressOf('online/files.json')))?.json();

// Takes all files. What an earlier version has, too, comes from there, and what a stopped one has taken isn't asked for again.
async function take() {
  const answer = await fetched('online/files.json', version), { files } = await answer.clone().json();
  const cache = await caches.open(own), packed = await caches.open(packs), before = await others();
  const names = Object.keys(files).values();
  await Promise.all(Array.from({ length: lanes }, async () => {
    for (const name of names) {
      const to = name.endsWith('.gz') ? packed : cache;
      if (await to.match(addressOf(name))) continue;
      const same = before.find(({ list }) => list?.files[name] === files[name]);
      await to.put(addressOf(name), await same?.cache.match(addressOf(name)) ?? await fetched(name, files[name]));
    }
  }));
  await cache.put(addressOf('online/files.json'), answer);
}
async function fetched(name, integrity) {
  const response = await fetch(addressOf(name), { integrity, cache: 'no-cache' });
  if (!response.ok) throw new Error(`${name} can't be kept: ${response.status}`);
  return response.redirected ? new Response(response.body, response) : response; // as hosts do that call page.html `page`
}

// Which version a page began with is noted in that version's cache.
const note = (id) => addressOf(`client/${id}`);
const begin = async (cache, id) => cache.put(note(id), new Response());
async function versionOf(id) {
  const ours = await caches.open(own);
  if (await ours.match(note(id))) return ours;
  for (const { cache } of await others()) if (await cache.match(note(id))) return cache;
}

// Pages that are open when it comes have begun with an earlier version, and are told of this one, or have none yet.
async function takeOver() {
  await clients.claim();
  for (const client of await clients.matchAll({ includeUncontrolled: true })) {
    if (await versionOf(client.id)) client.postMessage('newer');
    else await begin(await caches.open(own), client.id);
  }
  await forget(await others());
}

// Versions that no page has open any more, and packs that are in none.
async function forget(versions) {
  const open = new Set((await clients.matchAll({ includeUncontrolled: true })).map(({ id }) => addressOf(`client/${id}`).href));
  const isOpen = async (cache) => (await cache.keys()).some(({ url }) => open.has(url));
  const lists = [await listIn(await caches.open(own))];
  for (const { name, cache, list } of versions) {
    if (list && await isOpen(cache)) lists.push(list);
    else await caches.delete(name);
  }
  const needed = new Set(lists.flatMap(({ files, later }) => [...Object.keys(files), ...later]));
  const packed = await caches.open(packs);
  for (const { url } of await packed.keys()) if (!needed.has(nameOf(url))) await packed.delete(url);
}

// Unless a newer one is on its way.
async function forgetEarlier() {
  const versions = await others(), isAnyComing = registration.installing || registration.waiting || versions.some(({ list }) => !list);
  if (versions.length > 0 && !isAnyComing) await forget(versions);
}

async function answer({ request, clientId, resultingClientId }) {
  const name = nameOf(request.url), ours = await caches.open(own);
  const isPage = request.mode === 'navigate', cache = isPage ? ours : await versionOf(clientId) ?? ours;
  const kept = await cache.match(addressOf(name)) ?? await cache.match(addressOf(`${name}.html`));
  if (isPage && kept) await begin(ours, resultingClientId);
  // A worker is no page, but the names of what it asks for have their version in them.
  return kept ?? await caches.match(addressOf(name)) ?? fetch(request);
}

addEventListener('install', (event) => event.waitUntil(take().then(() => skipWaiting())));
addEventListener('activate', (event) => event.waitUntil(takeOver()));
addEventListener('fetch', (event) => {
  if (event.request.method !== 'GET' || !event.request.url.startsWith(root.href)) return;
  event.respondWith(answer(event));
  if (event.request.mode === 'navigate') event.waitUntil(forgetEarlier());
});
