// SPDX-License-Identifier: GPL-3.0-or-later
// The symbol of the typed text: its picture, how full it is, whether its modules can be printed and what would enlarge
// them.
import { isReplaced } from '../engine/client.js';
import { describeThrown, isFatal } from '../engine/engine_error.js';
import { onLanguage, text } from '../i18n/catalogue.js';
import { hintOf, sentenceOf } from '../i18n/messages.js';
import { byId, make } from '../dom/dom.js';
import { formatMm, formatNumber, formatPlain } from '../i18n/format.js';
import { asSentence } from '../i18n/sentences.js';
import { isWebAddress } from '../payloads/link.js';
import { tooSmall } from '../payloads/module_size.js';
import { drawLetters, drawSymbol } from './symbol_drawing.js';

/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {import('../engine/types.js').SymbolFacts} SymbolFacts */
/** @typedef {import('../engine/types.js').LetterFacts} LetterFacts */
/** @typedef {import('../i18n/catalogue.js').Key} Key */
/**
 * @typedef {{ text: string, key: Key, use: () => void }} Form  another way to write the same content, and the function
 *   that applies it
 */
/**
 * @typedef {{ symbolMm: number, largestMm: number }} Room  the symbol's edge as placed, and the edge that fits there
 *   at any rotation
 */
/** @typedef {{ severity: 'warning' | 'note', words: string, action?: { words: string, run: () => void } }} Line */
/** @typedef {{ content: string, letters: LetterFacts }} ShownLetters */
/** @typedef {{ content: string, settings: Settings, facts: SymbolFacts, shorter: { form: Form, facts: SymbolFacts }[] }} Shown */
/** @typedef {import('../engine/types.js').TextAdvice} TextAdvice */

/** What a button says that takes the corrected text, by the code of the advice. */
const kFixes = /** @type {Record<string, Key>} */ ({
  'link-unseen': 'code.link.trim',
  'link-quoted': 'code.link.trim',
  'link-ends': 'code.link.trim',
  'link-punctuation': 'code.link.trim',
  'link-spaces': 'code.link.encodeSpaces',
  'link-without-scheme': 'code.link.addScheme',
  'link-scheme-misspelt': 'code.link.addScheme',
  'link-other-letters': 'code.link.toAscii',
  'link-tracking': 'code.link.dropTracking',
});
const kShorter = /** @type {const} */ ({
  capitals: 'code.shorter.capitals',
  www: 'code.shorter.www',
  highlight: 'code.shorter.highlight',
});

const kPauseMs = 60;
const kLargestVersion = 40;

/**
 * @typedef {object} SymbolOptions
 * @property {(content: string) => Settings} settings   the chosen settings, with this text; throws an EngineFailure
 * @property {(settings: Settings) => Promise<SymbolFacts | { letters: LetterFacts }>} symbolOf
 * @property {(content: string) => Promise<TextAdvice>} adviceOn
 * @property {() => Form[]} otherForms                  from the builder
 * @property {(content: string) => void} onReplace      the user chose another text
 */

export class SymbolPanel {
  /** @param {SymbolOptions} options */
  constructor({ settings, symbolOf, adviceOn, otherForms, onReplace }) {
    this.settings_ = settings;
    this.symbolOf_ = symbolOf;
    this.adviceOn_ = adviceOn;
    this.otherForms_ = otherForms;
    this.onReplace_ = onReplace;
    this.picture_ = byId('symbol-picture', HTMLElement);
    this.facts_ = byId('symbol-facts', HTMLElement);
    this.lines_ = byId('symbol-advice', HTMLElement);
    this.content_ = '';
    this.advises_ = true;
    /** @type {'code' | 'text'} */ this.makes_ = 'code';
    /** @type {{ content: string } & TextAdvice} */ this.advised_ = { content: '', advice: [], shorter: [] };
    /** @type {Room | undefined} */ this.room_ = undefined;
    /** @type {Shown | undefined} */ this.shown_ = undefined;
    /** @type {LetterFacts | undefined} */ this.letters_ = undefined; // of a text alone
    /** @type {import('../engine/message.js').Message | undefined} */ this.problem_ = undefined;
    this.asked_ = 0;
    /** @type {ReturnType<typeof setTimeout> | undefined} */ this.pause_ = undefined;
    onLanguage(() => this.render_());
    this.render_();
  }

  /** The symbol of the current text; undefined until the engine has answered, or if the text has none. */
  get current() {
    return this.shown_?.content === this.content_ ? this.shown_.facts : undefined;
  }

  /** @param {string} content */
  show(content) {
    this.content_ = content;
    clearTimeout(this.pause_);
    this.pause_ = setTimeout(() => void this.ask_(), kPauseMs);
  }

  /**
   * @param {boolean} advises  whether to advise on the text and on shorter forms
   * @param {'code' | 'text'} makes
   */
  setAdvising(advises, makes) {
    this.advises_ = advises;
    this.makes_ = makes;
    this.render_();
  }

  /** @param {Room | undefined} room */
  setRoom(room) {
    this.room_ = room;
    this.render_();
  }

  async ask_() {
    this.asked_ += 1;
    const [asked, content] = [this.asked_, this.content_];
    const isNewest = () => asked === this.asked_;
    try {
      const advised = await this.adviceOn_(content);
      if (!isNewest()) return;
      this.advised_ = { content, ...advised };
      const settings = this.settings_(content);
      const facts = content === '' ? undefined : await this.symbolOf_(settings);
      if (!isNewest()) return;
      this.letters_ = facts && 'letters' in facts ? facts.letters : undefined;
      this.shown_ = facts && !('letters' in facts) ? { content, settings, facts, shorter: [] } : undefined;
      this.problem_ = undefined;
      this.render_();
      if (this.shown_ && this.advises_) await this.findShorter_(this.shown_, isNewest);
    } catch (thrown) {
      if (!isNewest() || isReplaced(thrown) || isFatal(thrown)) return; // the new engine is asked again
      this.shown_ = this.letters_ = undefined;
      this.problem_ = describeThrown(thrown);
      this.render_();
    }
  }

  /** @param {Shown} code @param {() => boolean} isNewest */
  async findShorter_(code, isNewest) {
    const { settings, facts } = code;
    const ofLink = this.advised_.shorter.map((shorter) => ({
      text: shorter.text,
      key: kShorter[shorter.form],
      use: () => this.onReplace_(shorter.text),
    }));
    const shorter = [];
    for (const form of [...ofLink, ...this.otherForms_()]) {
      const symbol = await this.symbolOf_({ ...settings, text: form.text });
      if (!isNewest() || 'letters' in symbol) return;
      const least = Math.min(facts.size, ...shorter.map((known) => known.facts.size));
      if (symbol.size < least) shorter.push({ form, facts: symbol });
    }
    this.shown_ = { ...code, shorter };
    if (shorter.length > 0) this.render_();
  }

  render_() {
    const facts = this.shown_?.facts,
      letters = this.letters_;
    if (letters) {
      this.picture_.replaceChildren(drawLetters(letters, text('code.letters.picture', { text: this.content_ })));
      this.facts_.replaceChildren(...this.letterLines_(letters));
    } else if (facts) {
      this.picture_.replaceChildren(drawSymbol(facts.rows, text('code.symbol.picture', { size: facts.size })));
      this.facts_.replaceChildren(...factLines(facts));
    } else {
      this.picture_.replaceChildren();
      const problem =
        this.problem_ && [sentenceOf(this.problem_), hintOf(this.problem_)].filter(Boolean).map(asSentence).join(' ');
      this.facts_.replaceChildren(
        make('p', { text: problem ?? text(this.makes_ === 'text' ? 'code.letters.none' : 'code.symbol.none') }),
      );
    }
    this.picture_.classList.toggle('empty', !facts && !letters);
    this.facts_.classList.toggle('wrong', this.problem_ !== undefined);
    this.lines_.replaceChildren(...this.advice_().map(makeLine));
  }

  /** Says how large the letters are. @param {LetterFacts} letters */
  letterLines_({ size, capital }) {
    if (!this.room_) return [make('p', { text: text('code.letters.unplaced') })];
    const { symbolMm } = this.room_;
    const words = text('code.letters.facts', {
      width: formatMm(symbolMm),
      capital: formatMm((capital * symbolMm) / size),
    });
    return [make('p', { className: 'symbol-name', text: words })];
  }

  /** @returns {Line[]} */
  advice_() {
    if (this.letters_) return this.letterSizeLines_(this.letters_);
    if (!this.advises_) return this.sizeLines_(true);
    const advice = this.advised_.content === this.content_ ? this.advised_.advice : [];
    const ofText = advice.map(({ severity, message, fixed }) => ({
      severity,
      words: sentenceOf(message),
      ...(fixed ? { action: { words: text(kFixes[message.code]), run: () => this.onReplace_(fixed) } } : {}),
    }));
    const shorter = (this.shown_?.shorter ?? []).map(({ form, facts }) => this.shorterLine_(form, facts));
    return [...ofText, ...this.sizeLines_(shorter.length > 0), ...shorter];
  }

  /** @param {Form} form @param {SymbolFacts} symbol @returns {Line} */
  shorterLine_(form, symbol) {
    const current = /** @type {Shown} */ (this.shown_);
    const percent = Math.round((current.facts.size / symbol.size - 1) * 100);
    return {
      severity: 'note',
      words: text(form.key, { version: symbol.version, percent }),
      action: { words: text('code.shorter.use'), run: form.use },
    };
  }

  /** @param {LetterFacts} letters @returns {Line[]} */
  letterSizeLines_({ leastMm }) {
    if (!this.room_ || leastMm === null || this.room_.symbolMm >= leastMm) return [];
    return [{ severity: 'warning', words: text('code.letters.small', { needed: formatMm(Math.ceil(leastMm)) }) }];
  }

  /** @param {boolean} hasShorter @returns {Line[]} */
  sizeLines_(hasShorter) {
    if (!this.shown_ || !this.room_) return [];
    const {
      facts,
      settings: { nozzleMm = NaN, maxSizeMm = Infinity, size },
    } = this.shown_;
    const { symbolMm, largestMm } = this.room_;
    if (facts.leastModuleMm === null) return [];
    const small = tooSmall(facts.size, symbolMm, facts.leastModuleMm);
    if (!small) return [];
    const problem = text('code.symbol.small', {
      symbol: formatMm(symbolMm),
      module: formatMm(small.moduleMm),
      nozzle: `${formatPlain(nozzleMm)}\u00a0mm`,
      least: `${formatPlain(facts.leastModuleMm)}\u00a0mm`,
    });
    const needed = formatMm(small.neededMm);
    const isChosen = typeof size === 'number' || symbolMm >= maxSizeMm; // the chosen size is too small, not the place
    const full = !isChosen && small.neededMm > largestMm;
    const larger = text(full ? 'code.symbol.otherPlace' : 'code.symbol.larger', { needed });
    const shorter =
      small.printable === undefined ? '' : ` ${text('code.symbol.shorten', { modules: small.printable })}`;
    const link = !hasShorter && isWebAddress(this.content_) ? ` ${text('code.shorter.link')}.` : '';
    return [{ severity: 'warning', words: `${problem} ${larger}${shorter}${link}` }];
  }
}

/** @param {SymbolFacts} facts */
function factLines({ version, ecc, size, bytes, room }) {
  const total = bytes + room;
  const meter = make('meter');
  Object.assign(meter, { min: 0, max: total, value: bytes });
  meter.setAttribute('aria-label', text('code.symbol.fill'));
  const used = text('code.symbol.bytes', { count: total, used: formatNumber(bytes), total: formatNumber(total) });
  const left =
    version === kLargestVersion
      ? text('code.symbol.last')
      : room === 0
        ? text('code.symbol.full')
        : text('code.symbol.room', { count: room });
  return [
    make('p', { className: 'symbol-name', text: text('code.symbol.facts', { version, ecc, size }) }),
    meter,
    make('p', { text: used }),
    make('p', { text: left }),
  ];
}

/** @param {Line} line */
function makeLine({ severity, words, action }) {
  const item = make('li', { className: severity }, make('span', { text: asSentence(words) }));
  if (action) {
    const button = make('button', { className: 'quiet', text: action.words });
    button.type = 'button';
    button.addEventListener('click', action.run);
    item.append(button);
  }
  return item;
}
