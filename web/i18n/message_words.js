// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the words of messages, which are larger than all other texts of the page. It loads them when the first message
// is to be shown, and only in the current language.
import { currentLanguage, writeAgain } from './catalogue.js';
import { load } from './locales.js';

/** @typedef {import('./sentences.js').Catalogue} Catalogue */

const kRetryMs = 10_000; // least time between a failed fetch and the next try
const kPatienceMs = 8_000; // a message waits so long for its words and is then shown without them, until they arrive

/** The catalogue while the first words are loading. @type {Catalogue} */
export const kLoading = {};
/** The catalogue if no words could be loaded. @type {Catalogue} */
export const kNoWords = {};

export class MessageWords {
  /**
   * @param {(language: string) => Promise<Catalogue>} fetch
   * @param {() => void} onChange  words have arrived or failed, so messages shown without them need writing again
   */
  constructor(fetch, onChange) {
    this.request_ = fetch;
    this.onChange_ = onChange;
    /** @type {Map<string, Catalogue>} */ this.there_ = new Map();
    /** @type {Map<string, Promise<void>>} */ this.loading_ = new Map();
    /** @type {Map<string, number>} */ this.failed_ = new Map(); // when its fetch failed, ms
    this.isMissed_ = false;
  }

  /**
   * The words in the current language or, until they arrive, in another. Code that shows them writes them again in its
   * `onLanguage` listener.
   * @returns {Catalogue}
   */
  get now() {
    const language = currentLanguage();
    const there = this.there_.get(language);
    if (there) return there;
    this.isMissed_ = true;
    if (Date.now() - (this.failed_.get(language) ?? -Infinity) >= kRetryMs) void this.load(language);
    const [other] = this.there_.values();
    return other ?? (this.loading_.has(language) ? kLoading : kNoWords);
  }

  /** @param {string} [language] @returns {Promise<void>}  settles once the words have loaded or failed */
  load(language = currentLanguage()) {
    const loading = this.loading_.get(language) ?? this.fetch_(language);
    this.loading_.set(language, loading);
    return loading;
  }

  /** @param {string} language */
  async fetch_(language) {
    const arrived = this.request_(language).then((catalogue) => {
      this.there_.set(language, catalogue);
      this.notify_();
    });
    try {
      await inTime(arrived);
    } catch {
      this.failed_.set(language, Date.now());
      this.loading_.delete(language);
      this.notify_();
    }
  }

  notify_() {
    if (!this.isMissed_) return;
    this.isMissed_ = false;
    this.onChange_();
  }
}

/** @param {Promise<void>} arrived  rejects if it takes too long */
async function inTime(arrived) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */ let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(reject, kPatienceMs);
  });
  await Promise.race([arrived, late]).finally(() => clearTimeout(timer));
}

export const messageWords = new MessageWords((language) => load(language, 'messages'), writeAgain);
