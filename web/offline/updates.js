// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps the page on this device, and says when a newer one is there.

const kCheckEveryMs = 60 * 60 * 1000;

/**
 * Registers the service worker. A new version is fetched quietly; it takes over when the user says so, or once no window
 * of the page is open.
 * @param {(reload: () => void) => void} onNewVersion  `reload` changes to it
 */
export async function keepOffline(onNewVersion) {
  const workers = navigator.serviceWorker;
  if (!workers) return;  // as in a private window: the page works, as long as there is a network
  /** @type {ServiceWorkerRegistration | undefined} */ let registration;
  try {
    registration = await workers.register('service_worker.js', { updateViaCache: 'none' });
  } catch {
    return;  // storage may be switched off
  }
  if (!registration) return;  // as extensions do that block service workers
  let known = Boolean(workers.controller);  // else the first version takes over, which is no news
  const kept = registration;
  const offer = () => onNewVersion(() => reloadInto(kept));
  if (kept.waiting && known) offer();
  kept.addEventListener('updatefound', () => {
    const coming = kept.installing;
    coming?.addEventListener('statechange', () => {
      if (coming.state === 'installed' && workers.controller) offer();
    });
  });
  workers.addEventListener('controllerchange', () => {
    if (known) offer();  // another window has changed to it
    known = true;
  });
  checkNowAndThen(kept);
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

/** A page that stays open for days hears of new versions, too. @param {ServiceWorkerRegistration} registration */
function checkNowAndThen(registration) {
  let checked = Date.now();
  document.addEventListener('visibilitychange', () => {
    if (document.visibilityState !== 'visible' || Date.now() - checked < kCheckEveryMs) return;
    checked = Date.now();
    registration.update().catch(() => {});  // no network: next time
  });
}
