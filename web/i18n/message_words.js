// SPDX-License-Identifier: GPL-3.0-or-later
// The words of messages, which are more than all other texts of the page, are fetched when the first is to be told, and only
// in the language chosen (cut_language.js).
import { currentLanguage, writeAgain } from './catalogue.js';

/** @typedef {import('./catalogue.js').Language} Language */
/** @typedef {string | { one: string, other: string }} Forms  chosen by the value `count` */
/** @typedef {{ [L in Language]?: Forms }} Words */
/** @typedef {Words & { hint?: Words }} Entry */
/** @typedef {Record<string, Entry>} Catalogue  by the code of the message */

const kRetryMs = 10_000;    // what could not be fetched is not asked for again sooner
const kPatienceMs = 8_000;  // what has not come within this time is told without its words, until they come

/** What there is while the first words come. @type {Catalogue} */
export const kComing = {};
/** What there is when none could be fetched. @type {Catalogue} */
export const kNoWords = {};

export class MessageWords {
  /**
   * @param {Record<Language, () => Promise<{ catalogue: Catalogue }>>} fetches
   * @param {() => void} onChange  what was told without them can be told better
   */
  constructor(fetches, onChange) {
    this.fetches_ = fetches;
    this.onChange_ = onChange;
    /** @type {Map<Language, Catalogue>} */ this.there_ = new Map();
    /** @type {Map<Language, Promise<void>>} */ this.coming_ = new Map();
    /** @type {Map<Language, number>} */ this.failed_ = new Map();  // when
    this.isMissed_ = false;
  }

  /**
   * Those of the language chosen, else those of another until they come. Whoever tells something now tells it again with
   * `onLanguage`.
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

  /** @param {Language} [language] @returns {Promise<void>}  settled when they are there, or cannot be had */
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

/** @param {Promise<void>} arrived  rejected if it takes too long */
async function inTime(arrived) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */ let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(reject, kPatienceMs);
  });
  await Promise.race([arrived, late]).finally(() => clearTimeout(timer));
}

export const messageWords = new MessageWords({
  en: () => import('./message_catalogues.js?language=en'),
  de: () => import('./message_catalogues.js?language=de'),
}, writeAgain);
