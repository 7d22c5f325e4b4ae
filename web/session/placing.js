// SPDX-License-Identifier: GPL-3.0-or-later
// Places the code: at the chosen or proposed centre, with the direction and size found there.
import { isReplaced } from '../engine/client.js';
import { describeThrown, isFatal } from '../engine/engine_error.js';
import { text } from '../i18n/catalogue.js';
import { hintOf, sentenceOf } from '../i18n/messages.js';

/** @typedef {import('../engine/types.js').Placement} Placement */
/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {[number, number, number]} Point */

/**
 * @typedef {object} PlacingOptions
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./centre.js').Centre} centre
 * @property {import('../ui/messages.js').Messages} messages
 * @property {import('../ui/place_panel.js').PlacePanel} panel
 * @property {() => Settings | Promise<Settings>} settings  throws an EngineFailure
 * @property {() => boolean} mayMove                    false while a job needs the centre
 * @property {() => void} onMoved                       called when another centre is chosen
 * @property {(placement: Placement | undefined) => void} onPlaced
 */

export class Placing {
  /** @param {PlacingOptions} options */
  constructor({ client, model, centre, messages, panel, settings, mayMove, onMoved, onPlaced }) {
    this.client_ = client;
    this.model_ = model;
    this.centre_ = centre;
    this.messages_ = messages;
    this.panel_ = panel;
    this.settings_ = settings;
    this.mayMove_ = mayMove;
    this.onMoved_ = onMoved;
    this.onPlaced_ = onPlaced;
    /** @type {Placement | undefined} */ this.placement = undefined;
    /** @type {Promise<void> | undefined} */ this.running_ = undefined;
    this.again_ = false;
  }

  /** Reports a failed placement as an error from now on, even at a proposed centre. */
  insist() {
    this.centre_.accept();
  }

  /** Places the code on a new model: at the chosen centre, or else at the module's proposal. */
  async begin() {
    const { info } = this.model_;
    if (!info) return;
    const { chosenMm } = this.centre_;
    this.show_(undefined);
    if (!info.engravable) {
      this.refuse_(info);
    } else if (chosenMm) {
      await this.move(() => this.client_.setCentre({ mm: chosenMm }));
    } else if (info.centre) {
      this.centre_.put(info.centre, true);
      await this.place();
    } else {
      this.centre_.put(undefined);
      this.messages_.say(() => text('page.askForCentre'));
    }
  }

  /**
   * Restores an earlier centre without placing the code.
   * @param {Point | undefined} centreMm
   * @param {boolean} isGuess
   */
  async put(centreMm, isGuess) {
    if (!centreMm) return;
    await this.client_.setCentre({ mm: centreMm });
    this.centre_.put(centreMm, isGuess);
  }

  /** Moves the code. @param {() => Promise<import('../engine/types.js').PickResult>} pick */
  async move(pick) {
    if (!this.mayMove_() || !this.model_.engravable) return;
    const { hit, centre } = await pick();
    if (!hit || !centre) return;
    this.messages_.clearError();
    this.centre_.put(centre);
    this.onMoved_();
    await this.place();
  }

  /** Places the code again. A call while it runs makes it run once more, with the newest settings. */
  place() {
    this.again_ = true;
    this.running_ ??= this.placeUntilNewest_().finally(() => {
      this.running_ = undefined;
    });
    return this.running_;
  }

  async placeUntilNewest_() {
    while (this.again_) {
      this.again_ = false;
      if (!this.model_.engravable) return;
      try {
        // At once: “Ready” no longer holds.
        if (this.mayMove_() && this.centre_.mm) this.messages_.say(() => text('page.placing'));
        await this.client_.configure(await this.settings_());
        if (this.centre_.mm === undefined) {
          this.messages_.say(() => text('page.askForCentre'));
          return;
        }
        this.messages_.say(() => text('page.placing'));
        this.show_(await this.client_.placement());
        // Otherwise a job asked for the placement and continues.
        if (this.mayMove_() && !this.again_) this.messages_.say(() => text('page.ready'));
      } catch (thrown) {
        if (isReplaced(thrown) || isFatal(thrown)) throw thrown;
        this.show_(undefined);
        const guess = this.centre_.isGuess;
        this.messages_.say(() => text(guess ? 'page.askForCentre' : 'page.noPlace'));
        if (!this.again_ && !guess) {
          this.messages_.showError(describeThrown(thrown));
        }
      }
    }
  }

  /** @param {Placement | undefined} placement */
  show_(placement) {
    this.placement = placement;
    this.panel_.showPlacement(placement);
    this.onPlaced_(placement);
  }

  /** @param {import('../engine/types.js').ModelInfo} info */
  refuse_({ findings }) {
    const blocking = findings.filter(({ severity }) => severity === 'blocking');
    this.messages_.showError({
      found: () =>
        blocking
          .map((finding) => sentenceOf(finding))
          .filter(Boolean)
          .join('; ') || text('page.notEngravable'),
      help: () => blocking.map((finding) => hintOf(finding)).find((hint) => hint !== '') ?? '',
    });
    this.messages_.say(() => text('page.notEngravable'));
  }
}
