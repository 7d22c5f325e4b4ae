// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the page on this device, and reports new versions.

const kCheckEveryMs = 60 * 60 * 1000;

/**
 * Registers the service worker. It fetches a new version in the background. The new version takes over when the user
 * agrees, or once no window of the page is open.
 * @param {(reload: () => void) => void} onNewVersion  `reload` switches to the new version
 */
export async function keepOffline(onNewVersion) {
  const workers = navigator.serviceWorker;
  if (!workers) return; // for example in a private window; the page then needs the network
  /** @type {ServiceWorkerRegistration | undefined} */ let registration;
  try {
    registration = await workers.register('service_worker.js', { updateViaCache: 'none' });
  } catch {
    return; // storage may be switched off
  }
  if (!registration) return; // some extensions block service workers this way
  let known = Boolean(workers.controller); // otherwise the first version takes over, which is no news
  const current = registration;
  const offer = () => onNewVersion(() => reloadInto(current));
  if (current.waiting && known) offer();
  current.addEventListener('updatefound', () => {
    const coming = current.installing;
    coming?.addEventListener('statechange', () => {
      if (coming.state === 'installed' && workers.controller) offer();
    });
  });
  workers.addEventListener('controllerchange', () => {
    if (known) offer(); // another window has switched to the new version
    known = true;
  });
  void workers.ready.then(keepOpened);
  checkNowAndThen(current);
}

/**
 * Lets the first service worker keep the files that this page opened before it: asks for them again. They come from the
 * browser's copies.
 */
function keepOpened() {
  const keep = () => {
    const files = performance.getEntriesByType('resource').map(({ name }) => name);
    for (const file of new Set(files))
      if (file.startsWith(location.origin)) fetch(file, { cache: 'force-cache' }).catch(() => {});
  };
  const { serviceWorker } = navigator;
  if (!serviceWorker.controller) serviceWorker.addEventListener('controllerchange', keep, { once: true });
}

/** @param {ServiceWorkerRegistration} registration */
function reloadInto(registration) {
  if (!registration.waiting) {
    location.reload();
    return;
  }
  navigator.serviceWorker.addEventListener('controllerchange', () => location.reload(), { once: true });
  registration.waiting.postMessage('activate');
}

/** Looks for new versions on a page that stays open for days. @param {ServiceWorkerRegistration} registration */
function checkNowAndThen(registration) {
  let checked = Date.now();
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState !== 'visible' || Date.now() - checked < kCheckEveryMs) return;
    checked = Date.now();
    registration.update().catch(() => {}); // no network: try again next time
  });
}
