// SPDX-License-Identifier: GPL-3.0-or-later
// A hold of the page's workers: runs in the page before its own scripts (`page.addInitScript(holdWorkers)`).

/**
 * `window.workers` are the module's; `window.skipped` names verbs that are answered at once, with nothing done;
 * `window.failNext` answers the next call of a verb with an error; after `window.freeze()` nothing reaches a worker until
 * `window.thaw()` lets it all, in its order.
 */
export const holdWorkers = () => {
  const page = /** @type {any} */ (window);
  page.workers = [];
  page.skipped = [];
  /** @type {(() => void)[] | undefined} */ let waiting;
  page.freeze = () => void (waiting ??= []);
  page.thaw = () => {
    const all = waiting ?? [];
    waiting = undefined;
    all.forEach((send) => send());
  };
  /** @type {Map<string, object>} */ const failing = new Map();
  page.failNext = (/** @type {string} */ verb, /** @type {object} */ error) => failing.set(verb, error);
  const Original = window.Worker;
  page.Worker = class extends Original {
    /** @param {string | URL} url @param {WorkerOptions} [options] */
    constructor(url, options) {
      super(url, options);
      if (options?.name === 'qrelief') page.workers.push(this);
    }

    /** @param {any} message @param {any} transfer */
    postMessage(message, transfer) {
      const error = failing.get(message.verb);
      failing.delete(message.verb);
      if (error) this.dispatchEvent(new MessageEvent('message', { data: { id: message.id, error } }));
      else if (page.skipped.includes(message.verb)) setTimeout(() => this.dispatchEvent(new MessageEvent('message', { data: { id: message.id } })));
      else if (waiting) waiting.push(() => super.postMessage(message, transfer));
      else super.postMessage(message, transfer);
    }
  };
};

/** Nothing reaches a worker until it is thawed. @param {import('@playwright/test').Page} page */
export const freeze = (page) => page.evaluate(() => /** @type {any} */ (window).freeze());

/**
 * Freezes in the moment in which a text that changes on the page reads as it should, however fast the workers are.
 * @param {import('@playwright/test').Locator} text
 * @param {RegExp} pattern
 */
export const freezeAt = (text, pattern) => text.evaluate((element, { source }) => new Promise((resolve) => {
  const look = () => {
    if (!new RegExp(source).test(element.textContent ?? '')) return;
    observer.disconnect();
    resolve(/** @type {any} */ (window).freeze());
  };
  const observer = new MutationObserver(look);
  observer.observe(element, { childList: true, characterData: true, subtree: true });
  look();
}), { source: pattern.source });

/** @param {import('@playwright/test').Page} page */
export const thaw = (page) => page.evaluate(() => /** @type {any} */ (window).thaw());

/**
 * What the newest worker answers to a verb that the page itself does not ask for.
 * @param {import('@playwright/test').Page} page
 * @param {string} verb
 * @returns {Promise<any>}
 */
export const askWorker = (page, verb) => page.evaluate((asked) => new Promise((resolve) => {
  const worker = /** @type {any} */ (window).workers.at(-1);
  const id = `test ${Math.random()}`;
  const listen = (/** @type {MessageEvent} */ { data }) => {
    if (data.id !== id) return;
    worker.removeEventListener('message', listen);
    resolve(data.value);
  };
  worker.addEventListener('message', listen);
  worker.postMessage({ id, verb: asked, args: [] });
}), verb);

/**
 * Readers that find nothing in what was carved by some of the presets (`page.addInitScript(blindReaders, presets)`).
 * @param {string[]} presets
 */
export const blindReaders = (presets) => {
  const Original = window.Worker;
  window.Worker = class extends Original {
    /** @param {string | URL} url @param {WorkerOptions} [options] */
    constructor(url, options) {
      super(url, options);
      this.isReader = options?.name === 'reader';
    }

    /** @param {any} message @param {any} transfer */
    postMessage(message, transfer) {
      const { value } = /** @type {HTMLSelectElement} */ (document.getElementById('preset'));
      if (!this.isReader || !presets.includes(value)) super.postMessage(message, transfer);
      else setTimeout(() => this.dispatchEvent(new MessageEvent('message', { data: { id: message.id, texts: [''] } })));
    }
  };
};
