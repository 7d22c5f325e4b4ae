// SPDX-License-Identifier: GPL-3.0-or-later
// Serves the page from this device. The build prepends the data of its version. Every version has its own cache. It has
// all files of the app before it is used, so that no page mixes two versions; articles, their pictures and most samples
// are added once they are opened.

/**
 * The build's data: each file of the app, relative to the folder of this script, with the hash of its content, and the
 * files that are kept once they are opened.
 * @typedef {{ version: string, files: [path: string, hash: string][], whenOpened: string[] }} Build
 */

/** The part of a service worker's scope used here. TypeScript declares it only when it does not declare the page's. */
const scope =
  /** @type {{ registration: ServiceWorkerRegistration, qreliefBuild: Build, clients: { claim: () => Promise<void> },
   *   skipWaiting: () => Promise<void>, addEventListener: (type: string, listener: (event: any) => void) => void }} */ (
    /** @type {unknown} */ (self)
  );

const { version, files, whenOpened } = scope.qreliefBuild;
const home = scope.registration.scope;
const kOurs = `qrelief ${home} `; // other pages of this origin have caches, too
const kCache = kOurs + version;
const kIndex = 'index.html';
const kHashed = /^assets\//; // files whose names contain a hash

/** The cache key of each file's address. For the app it contains the hash, so that every version finds an unchanged file. */
const keys = new Map(files.map(([path, hash]) => [new URL(path, home).href, `${new URL(path, home).href}?${hash}`]));
for (const path of whenOpened) keys.set(new URL(path, home).href, new URL(path, home).href);
keys.set(home, /** @type {string} */ (keys.get(new URL(kIndex, home).href)));

/** Fills the cache with every file: from an earlier version if unchanged, else from the network. */
async function fill() {
  const cache = await caches.open(kCache);
  await Promise.all(
    files.map(async ([path]) => {
      const address = new URL(path, home).href;
      const key = /** @type {string} */ (keys.get(address));
      const asked = path === kIndex ? home : address; // as the page was opened, so that the browser's copy will do
      const response = (await caches.match(key)) ?? (await fetchAnew(asked, kHashed.test(path)));
      await cache.put(key, response);
    }),
  );
}

/** @param {string} address @param {boolean} isHashed  its content cannot change, so the browser's copy will do */
async function fetchAnew(address, isHashed) {
  const response = await fetch(address, { cache: isHashed ? 'force-cache' : 'no-cache' });
  if (!response.ok) throw new Error(`${address} could not be fetched (status ${response.status})`);
  // A page must not be answered with a redirected response; some hosts redirect index.html.
  return response.redirected ? new Response(response.body, { headers: response.headers }) : response;
}

async function removeOtherVersions() {
  const names = await caches.keys();
  await Promise.all(
    names.filter((name) => name.startsWith(kOurs) && name !== kCache).map((name) => caches.delete(name)),
  );
}

/** @param {Request} request @param {string} key */
async function answer(request, key) {
  const cache = await caches.open(kCache);
  const kept = await cache.match(key);
  if (kept) return kept;
  const response = await fetch(request); // opened for the first time, or the browser has deleted the cache
  if (response.ok && !response.redirected) await cache.put(key, response.clone());
  return response;
}

scope.addEventListener('install', (event) => event.waitUntil(fill()));

scope.addEventListener('activate', (event) => event.waitUntil(removeOtherVersions().then(() => scope.clients.claim())));

scope.addEventListener('fetch', (event) => {
  const { origin, pathname } = new URL(event.request.url);
  const key = keys.get(origin + pathname);
  if (event.request.method === 'GET' && key) event.respondWith(answer(event.request, key));
});

scope.addEventListener('message', ({ data }) => {
  if (data === 'activate') void scope.skipWaiting();
});
