// SPDX-License-Identifier: GPL-3.0-or-later
// Control over the page's workers. It is installed in the page before the page's own scripts
// (`page.addInitScript(holdWorkers)`).

/**
 * Wraps the page's workers. `window.workers` are the engine's workers. `window.skipped` names verbs that are answered
 * at once without doing anything. `window.failNext` answers the next call of a verb with an error. After
 * `window.freeze()` nothing reaches a worker until `window.thaw()` sends everything in order.
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
      else if (page.skipped.includes(message.verb))
        setTimeout(() => this.dispatchEvent(new MessageEvent('message', { data: { id: message.id } })));
      else if (waiting) {
        waiting.push(() => super.postMessage(message, transfer));
        // Otherwise the page would take an idle worker for dead.
        if (page.workers.includes(this))
          this.dispatchEvent(new MessageEvent('message', { data: { heard: message.id } }));
      } else super.postMessage(message, transfer);
    }
  };
};

/** Holds back all messages to workers until `thaw`. @param {import('@playwright/test').Page} page */
export const freeze = (page) => page.evaluate(() => /** @type {any} */ (window).freeze());

/**
 * Freezes at the moment when a changing text on the page matches the pattern, however fast the workers are.
 * @param {import('@playwright/test').Locator} text
 * @param {RegExp} pattern
 */
export const freezeAt = (text, pattern) =>
  text.evaluate(
    (element, { source }) =>
      new Promise((resolve) => {
        const look = () => {
          if (!new RegExp(source).test(element.textContent ?? '')) return;
          observer.disconnect();
          resolve(/** @type {any} */ (window).freeze());
        };
        const observer = new MutationObserver(look);
        observer.observe(element, { childList: true, characterData: true, subtree: true });
        look();
      }),
    { source: pattern.source },
  );

/** @param {import('@playwright/test').Page} page */
export const thaw = (page) => page.evaluate(() => /** @type {any} */ (window).thaw());

/**
 * Returns the newest worker's answer to a verb that the page itself does not use.
 * @param {import('@playwright/test').Page} page
 * @param {string} verb
 * @returns {Promise<any>}
 */
export const askWorker = (page, verb) =>
  page.evaluate(
    (asked) =>
      new Promise((resolve) => {
        const worker = /** @type {any} */ (window).workers.at(-1);
        const id = `test ${Math.random()}`;
        const listen = (/** @type {MessageEvent} */ { data }) => {
          if (data.id !== id) return;
          worker.removeEventListener('message', listen);
          resolve(data.value);
        };
        worker.addEventListener('message', listen);
        worker.postMessage({ id, verb: asked, args: [] });
      }),
    verb,
  );

/**
 * Makes the decoders find no text in the first attempts (`page.addInitScript(blindReaders, attempts)`).
 * @param {number} attempts
 */
export const blindReaders = (attempts) => {
  const Original = window.Worker;
  let begun = 0;
  window.Worker = class extends Original {
    /** @param {string | URL} url @param {WorkerOptions} [options] */
    constructor(url, options) {
      super(url, options);
      this.isReader = options?.name === 'reader';
    }

    /** @param {any} message @param {any} transfer */
    postMessage(message, transfer) {
      const { verb, args } = message;
      if (verb === 'engrave' || (verb === 'continueEngrave' && args[0])) begun += 1; // args: what was read
      if (!this.isReader || begun > attempts) super.postMessage(message, transfer);
      else setTimeout(() => this.dispatchEvent(new MessageEvent('message', { data: { id: message.id, texts: [''] } })));
    }
  };
};
