// SPDX-License-Identifier: GPL-3.0-or-later
// Loads the words of messages, which are larger than all other texts of the page. It loads them when the first message
// is to be shown, and only in the current language (cut_language.js).
import { currentLanguage, writeAgain } from './catalogue.js';

/** @typedef {import('./languages.js').Language} Language */
/** @typedef {import('./sentences.js').Catalogue} Catalogue */

const kRetryMs = 10_000; // least time between a failed fetch and the next try
const kPatienceMs = 8_000; // a message waits so long for its words and is then shown without them, until they arrive

/** The catalogue while the first words are loading. @type {Catalogue} */
export const kComing = {};
/** The catalogue if no words could be loaded. @type {Catalogue} */
export const kNoWords = {};

export class MessageWords {
  /**
   * @param {Record<Language, () => Promise<{ catalogue: Catalogue }>>} fetches
   * @param {() => void} onChange  words have arrived or failed, so messages shown without them need writing again
   */
  constructor(fetches, onChange) {
    this.fetches_ = fetches;
    this.onChange_ = onChange;
    /** @type {Map<Language, Catalogue>} */ this.there_ = new Map();
    /** @type {Map<Language, Promise<void>>} */ this.coming_ = new Map();
    /** @type {Map<Language, number>} */ this.failed_ = new Map(); // when its fetch failed, ms
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
    if (Date.now() - (this.failed_.get(language) ?? -Infinity) >= kRetryMs) void this.come(language);
    const [other] = this.there_.values();
    return other ?? (this.coming_.has(language) ? kComing : kNoWords);
  }

  /** @param {Language} [language] @returns {Promise<void>}  settles once the words have arrived or failed */
  come(language = currentLanguage()) {
    const coming = this.coming_.get(language) ?? this.fetch_(language);
    this.coming_.set(language, coming);
    return coming;
  }

  /** @param {Language} language */
  async fetch_(language) {
    const arrived = this.fetches_[language]().then(({ catalogue }) => {
      this.there_.set(language, catalogue);
      this.tellAgain_();
    });
    try {
      await inTime(arrived);
    } catch {
      this.failed_.set(language, Date.now());
      this.coming_.delete(language);
      this.tellAgain_();
    }
  }

  tellAgain_() {
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

export const messageWords = new MessageWords(
  { en: () => import('./message_catalogues.js?language=en'), de: () => import('./message_catalogues.js?language=de') },
  writeAgain,
);
