// SPDX-License-Identifier: GPL-3.0-or-later
// The content of the code: the text, the builders that write it, and the resulting symbol.
import { ContentPanel } from './content_panel.js';
import { SymbolPanel } from './symbol_panel.js';
import { TypingPause } from './typing_pause.js';
import { text } from '../i18n/catalogue.js';
import { byId } from '../dom/dom.js';
import { showStep } from './steps.js';

/** @typedef {import('../engine/types.js').Placement} Placement */
/** @typedef {import('../engine/types.js').SymbolFacts} SymbolFacts */
/**
 * @typedef {{ words: () => string, isWrong: boolean, first?: { text: string } }} Parts  state of a batch, with its
 *   first part if there is one
 */

/**
 * @typedef {object} CodeOptions
 * @property {(content: string) => import('../engine/types.js').Settings} settings  the chosen settings, with this text
 * @property {(settings: import('../engine/types.js').Settings) => Promise<SymbolFacts>} symbolOf
 * @property {(content: string) => Promise<import('../engine/types.js').TextAdvice>} adviceOn
 */

/**
 * @typedef {object} CodeListener
 * @property {(content: string) => void} onInput  the user has changed the text
 * @property {() => Promise<unknown>} onChange   the text has changed and typing has paused; not called while a builder
 *   lacks a field
 */

export class CodePanel {
  /** @param {CodeOptions} options */
  constructor({ settings, symbolOf, adviceOn }) {
    /** @type {CodeListener | undefined} */ this.listener_ = undefined;
    this.text_ = byId('text', HTMLTextAreaElement);
    this.content_ = '';
    this.plain_ = ''; // the text before a builder replaced it
    this.builderWrote_ = false;
    /** @type {Parts | undefined} */ this.parts_ = undefined;
    /** @type {Placement | undefined} */ this.placement_ = undefined;
    this.pause_ = new TypingPause(() => this.listener_?.onChange());
    this.builder_ = new ContentPanel({
      onPayload: (payload) => this.take_(payload),
      onPlain: () => this.restorePlain_(),
    });
    this.symbol_ = new SymbolPanel({
      settings,
      symbolOf,
      adviceOn,
      otherForms: () => this.otherForms_(),
      onReplace: (content) => this.replace_(content),
    });
    this.text_.addEventListener('input', () => {
      this.leaveBuilder();
      this.changed_(withLineBreaks(this.text_.value));
    });
    /** The text with which the page opens. */
    this.initialText = this.text_.value;
    this.set_(this.initialText);
    this.showPlaced(undefined);
  }

  /** @param {CodeListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  /** Shows a text. Leaves the textbox and the builder alone if they hold it already. @param {string} content */
  show(content) {
    if (content === this.content_) return;
    this.leaveBuilder();
    this.set_(content);
  }

  /** Closes the builder; the text stays. */
  leaveBuilder() {
    this.builder_.leave();
    this.builderWrote_ = false;
  }

  /** True while a required field of the builder is missing or wrong. */
  get incomplete() {
    return this.parts_ === undefined && this.builder_.incomplete;
  }

  /** Shows the parts of a batch, or a single code if there are none. @param {Parts | undefined} parts */
  showParts(parts) {
    this.parts_ = parts;
    this.symbol_.setAdvising(parts === undefined);
    this.showPlaced(this.placement_);
  }

  /** Shows which fields of the builder are missing or wrong. */
  reveal() {
    this.builder_.reveal();
  }

  /** Draws the symbol again after the settings or the engine have changed. */
  refresh() {
    this.symbol_.show(this.parts_ ? (this.parts_.first?.text ?? '') : this.content_);
  }

  /** @param {Placement | undefined} placement  the symbol's placement */
  showPlaced(placement) {
    this.placement_ = placement;
    this.symbol_.setRoom(placement);
    this.refresh();
    if (this.parts_)
      showStep('code', this.parts_.isWrong ? 'bad' : this.parts_.first ? 'done' : 'open', this.parts_.words);
    else if (this.incomplete) showStep('code', 'open', () => text('code.incomplete'));
    else if (placement)
      showStep('code', 'done', () =>
        text('page.codeState', { version: placement.version, modules: placement.modules }),
      );
    else showStep('code', 'open', () => '');
  }

  /** @param {string} content */
  set_(content) {
    this.content_ = content;
    if (this.text_.value !== content) this.text_.value = content;
    this.refresh();
  }

  /** @param {string} content */
  changed_(content) {
    this.set_(content);
    this.listener_?.onInput(content);
    this.pause_.forget();
    if (this.incomplete) showStep('code', 'open', () => text('code.incomplete'));
    else this.pause_.typed();
  }

  /** Applies the typed text now instead of after the pause. */
  async settle() {
    await this.pause_.settle();
  }

  /** @param {string} payload  from the builder */
  take_(payload) {
    if (!this.builderWrote_) this.plain_ = this.content_;
    this.builderWrote_ = true;
    this.changed_(payload);
  }

  restorePlain_() {
    this.builderWrote_ = false;
    this.changed_(this.content_ === '' ? this.plain_ : this.content_);
  }

  /** @param {string} content  the text that the user accepted */
  replace_(content) {
    this.leaveBuilder();
    this.changed_(content);
  }

  /**
   * Returns other forms in which the builder can write the same content.
   * @returns {import('./symbol_panel.js').Form[]}
   */
  otherForms_() {
    /** @type {[string, import('../i18n/catalogue.js').Key][]} */
    const forms = [
      ['mecard', 'code.shorter.mecard'],
      ['event', 'code.shorter.event'],
    ];
    return forms
      .map(([form, key]) => ({ text: this.builder_.payloadAs(form), key, use: () => this.builder_.writeAs(form) }))
      .filter((form) => form.text !== '' && form.text !== this.content_);
  }
}

/** Restores the CRLF line ends of cards and calendars, which a textbox does not keep. @param {string} typed */
const withLineBreaks = (typed) => (/^BEGIN:V/i.test(typed) ? typed.replace(/\r?\n/g, '\r\n') : typed);
