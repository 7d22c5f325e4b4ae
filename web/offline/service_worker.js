// SPDX-License-Identifier: GPL-3.0-or-later
// Serves the page from this device. The build prepends the data of its version. Every version has its own cache, which
// is complete before it is used, so that no page mixes two versions.

/**
 * The build's data: each file, relative to the folder of this script, with the hash of its content.
 * @typedef {{ version: string, files: [path: string, hash: string][] }} Build
 */

/** The part of a service worker's scope used here. TypeScript declares it only when it does not declare the page's. */
const scope =
  /** @type {{ registration: ServiceWorkerRegistration, qreliefBuild: Build, clients: { claim: () => Promise<void> },
   *   skipWaiting: () => Promise<void>, addEventListener: (type: string, listener: (event: any) => void) => void }} */ (
    /** @type {unknown} */ (self)
  );

const { version, files } = scope.qreliefBuild;
const home = scope.registration.scope;
const kOurs = `qrelief ${home} `; // other pages of this origin have caches, too
const kCache = kOurs + version;
const kIndex = 'index.html';

/** The cache key of each file's address. It contains the hash, so that every version finds an unchanged file. */
const keys = new Map(files.map(([path, hash]) => [new URL(path, home).href, `${new URL(path, home).href}?${hash}`]));
keys.set(home, /** @type {string} */ (keys.get(new URL(kIndex, home).href)));

/** Fills the cache with every file: from an earlier version if unchanged, else from the network. */
async function fill() {
  const cache = await caches.open(kCache);
  await Promise.all(
    files.map(async ([path]) => {
      const address = new URL(path, home).href;
      const key = /** @type {string} */ (keys.get(address));
      const response = (await caches.match(key)) ?? (await fetchAnew(address));
      await cache.put(key, response);
    }),
  );
}

/** @param {string} address */
async function fetchAnew(address) {
  const response = await fetch(address, { cache: 'no-cache' });
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
  return (await cache.match(key)) ?? fetch(request); // browsers may delete a cache
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
