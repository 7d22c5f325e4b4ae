// SPDX-License-Identifier: GPL-3.0-or-later
// The content of the code: the text, the builders that write it, and the resulting symbol.
import { ContentPanel } from './content_panel.js';
import { SymbolPanel } from './symbol_panel.js';
import { TypingPause } from './typing_pause.js';
import { localise, text } from '../i18n/catalogue.js';
import { byId } from '../dom/dom.js';
import { formatMm } from '../i18n/format.js';
import { showStep } from './steps.js';

/** @typedef {import('../engine/types.js').Placement} Placement */
/**
 * @typedef {{ words: () => string, isWrong: boolean, first?: { text: string } }} Parts  state of a batch, with its
 *   first part if there is one
 */

/**
 * @typedef {object} CodeOptions
 * @property {(content: string) => import('../engine/types.js').Settings} settings  the chosen settings, with this text
 * @property {import('./symbol_panel.js').SymbolOptions['symbolOf']} symbolOf
 * @property {(content: string) => Promise<import('../engine/types.js').TextAdvice>} adviceOn
 */

/**
 * @typedef {object} CodeListener
 * @property {(content: string) => void} onInput  the user has changed the text
 * @property {() => Promise<unknown>} onChange   the text has changed and typing has paused
 * @property {() => Promise<unknown>} onIncomplete  in place of onChange, while a required field is missing or wrong
 * @property {(makes: 'code' | 'text') => void} onMakes  the user wants a code, or the text alone; onInput follows
 */

export class CodePanel {
  /** @param {CodeOptions} options */
  constructor({ settings, symbolOf, adviceOn }) {
    /** @type {CodeListener | undefined} */ this.listener_ = undefined;
    this.text_ = byId('text', HTMLTextAreaElement);
    this.content_ = '';
    this.plain_ = ''; // the text before a builder replaced it, or the page's own
    this.other_ = ''; // the last text of a code while a text alone is made, or the other way round
    this.builderWrote_ = false;
    /** @type {'code' | 'text'} */ this.makes_ = 'code';
    /** @type {Parts | undefined} */ this.parts_ = undefined;
    /** @type {Placement | undefined} */ this.placement_ = undefined;
    this.pause_ = new TypingPause(() =>
      this.incomplete ? this.listener_?.onIncomplete() : this.listener_?.onChange(),
    );
    this.builder_ = new ContentPanel({
      onPayload: (payload) => this.take_(payload),
      onPlain: () => this.restorePlain_(),
      onMakes: (makes) => this.make_(makes),
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
    this.initialText = this.plain_ = this.text_.value;
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

  /** Shows whether a code or the text alone is made. @param {'code' | 'text'} makes */
  showMakes(makes) {
    this.makes_ = makes;
    this.builder_.showMakes(makes);
    byId('text-label', HTMLElement).dataset.text = makes === 'text' ? 'page.letters' : 'page.text';
    localise(byId('one-code', HTMLElement));
    this.advise_();
  }

  /** Closes the builder; the text stays. */
  leaveBuilder() {
    this.builder_.leave();
    this.builderWrote_ = false;
  }

  /** True while a required field of the builder is missing or wrong, or a text alone is empty. */
  get incomplete() {
    return this.parts_ === undefined && (this.builder_.incomplete || this.lacksText_);
  }

  /** Shows the parts of a batch, or a single code if there are none. @param {Parts | undefined} parts */
  showParts(parts) {
    this.parts_ = parts;
    this.advise_();
    this.showPlaced(this.placement_);
  }

  advise_() {
    this.symbol_.setAdvising(this.parts_ === undefined && this.makes_ === 'code', this.makes_);
  }

  /** Shows what is missing or wrong. */
  reveal() {
    if (this.lacksText_) this.text_.focus();
    else this.builder_.reveal();
  }

  get lacksText_() {
    return this.makes_ === 'text' && this.content_.trim() === '';
  }

  /** Says what is missing. */
  get incompleteWords() {
    return text(this.makes_ === 'text' ? 'code.letters.needed' : 'code.incomplete');
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
    else if (this.incomplete) showStep('code', 'open', () => this.incompleteWords);
    else if (placement)
      showStep('code', 'done', () =>
        placement.capitalMm === null
          ? text('page.codeState', { version: placement.version, modules: placement.modules })
          : text('page.lettersState', { capital: formatMm(placement.capitalMm) }),
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
    if (this.incomplete) showStep('code', 'open', () => this.incompleteWords);
    this.pause_.typed();
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
    this.changed_(this.content_ === '' && this.makes_ === 'code' ? this.plain_ : this.content_);
  }

  /** Goes on with the last text of a code, or of a text alone. @param {'code' | 'text'} makes */
  make_(makes) {
    if (makes === this.makes_) return;
    [this.content_, this.other_] = [this.other_, this.content_];
    this.listener_?.onMakes(makes);
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
