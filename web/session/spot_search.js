// SPDX-License-Identifier: GPL-3.0-or-later
// Searches for the best spots and lets the user choose one.
import { isReplaced } from '../engine/client.js';
import { describeThrown, isFatal } from '../engine/engine_error.js';
import { text } from '../i18n/catalogue.js';
import { chosenCentre, sameCentre } from './work.js';

const kLooking = () => text('page.working', { stage: text('page.lookingForSpots') });
const kPicturePx = 84; // height of a spot's picture
const kPictureAspect = 1.5;

/**
 * @typedef {object} SpotSearchOptions
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('./jobs.js').Jobs} jobs
 * @property {import('./work_store.js').WorkStore} store
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./placing.js').Placing} placing
 * @property {import('../ui/messages.js').Messages} messages
 * @property {import('../ui/spots_panel.js').SpotsPanel} panel
 * @property {Pick<import('./batching.js').Batching, 'settings' | 'plannedSettings'>} batching
 * @property {import('./carving.js').Carving} carving
 * @property {Pick<import('../ui/code_panel.js').CodePanel, 'settle'>} code
 * @property {(action: () => Promise<unknown>) => Promise<void>} guard
 */

export class SpotSearch {
  /** @param {SpotSearchOptions} options */
  constructor({ client, jobs, store, model, placing, messages, panel, batching, carving, code, guard }) {
    this.client_ = client;
    this.jobs_ = jobs;
    this.store_ = store;
    this.model_ = model;
    this.placing_ = placing;
    this.messages_ = messages;
    this.panel_ = panel;
    this.batching_ = batching;
    this.carving_ = carving;
    this.guard_ = guard;
    this.searching_ = false;
    this.search_ = 0;
    /** Resolves once no spot is being proposed. @type {Promise<void>} */ this.proposed = Promise.resolve();
    this.mayPropose_ = false;
    this.isProposing_ = false;
    this.isOutdated_ = false; // settings or model changed while a spot was being proposed
    panel.listen({
      onSuggest: () =>
        guard(async () => {
          await code.settle(); // apply the text first, or its change would end the search
          await this.suggest();
        }),
      onSpot: (index) => guard(() => this.choose(index)),
      onSizes: (areShown) => guard(() => this.showSizes_(areShown)),
    });
    carving.started.on(() => panel.setSizesShown(false));
    placing.moved.on(() => {
      panel.mark();
      this.stopProposing_();
    });
  }

  /** Proposes the best spot of a new model, unless the user has chosen a place. Does not make the page busy. */
  begin() {
    this.mayPropose_ = true;
    this.isOutdated_ = true;
    this.propose_();
  }

  stopProposing_() {
    this.mayPropose_ = false;
    this.jobs_.abortBackground();
  }

  get mayProposeNow_() {
    return this.mayPropose_ && this.model_.engravable && !chosenCentre(this.store_.work);
  }

  propose_() {
    // A second search would drop the spots of the first.
    if (this.mayProposeNow_ && !this.isProposing_) this.proposed = this.guard_(() => this.proposeUntilNewest_());
  }

  /** Proposes the best spot, again after each edit that came meanwhile. */
  async proposeUntilNewest_() {
    this.isProposing_ = true;
    try {
      this.isOutdated_ = false;
      await this.moveToBest_();
      while (this.isOutdated_ && this.mayProposeNow_) {
        await this.placing_.place();
        this.isOutdated_ = false;
        if (this.mayProposeNow_) await this.moveToBest_();
      }
    } finally {
      this.isProposing_ = false;
    }
    // A search that ended without a spot must not be said to go on.
    if (this.model_.engravable && this.messages_.isSaying(kLooking)) await this.placing_.place();
  }

  async moveToBest_() {
    const model = this.model_.info;
    const { result, failure } = await this.look_(); // after a failure the code may fit at the module's proposal
    const isWanted = () => this.mayPropose_ && !this.isOutdated_ && model === this.model_.info;
    if (isWanted() && result) {
      this.panel_.show(result, false);
      await this.placing_.propose({ spot: 0 });
      if (!isWanted()) return;
      this.mayPropose_ = false;
      this.panel_.mark(0);
      await this.client_.act({ kind: 'face' });
      void this.drawPictures_(result.spots.length);
    } else if (isWanted()) {
      await this.placing_.place();
      if (failure && isWanted() && !this.placing_.placement) this.placing_.explain(describeThrown(failure));
    }
  }

  /** @returns {Promise<{ result?: import('../engine/types.js').Spots, failure?: unknown }>}  neither: it was ended */
  async look_() {
    try {
      const result = await this.jobs_.runInBackground(async (signal) => {
        this.messages_.say(kLooking);
        await this.client_.configure(await this.batching_.plannedSettings());
        return this.client_.findSpots({ signal, onProgress: () => {} });
      });
      return { result };
    } catch (thrown) {
      if (isReplaced(thrown) || isFatal(thrown)) throw thrown;
      return { failure: thrown };
    }
  }

  /** Offers the spots with room for a size that is too large at the chosen centre, or says that there are none. */
  async lookElsewhere_() {
    this.isOutdated_ = false;
    const { result, failure } = await this.look_();
    if (this.isOutdated_ || !this.placing_.isTooLarge) return;
    if (result) {
      this.panel_.show(result, false);
      this.messages_.say(() => text('page.chooseSpot'));
      void this.drawPictures_(result.spots.length);
    } else if (failure) {
      this.placing_.explain(describeThrown(failure));
    }
  }

  /** @param {import('../dom/set_disabled.js').Key} [why]  the search is disabled; absent: enabled */
  setDisabled(why) {
    this.panel_.setDisabled(why);
  }

  /** Drops the spots of another model. */
  clear() {
    this.panel_.clear();
  }

  /** @param {boolean} areShown */
  async showSizes_(areShown) {
    if (areShown) await this.carving_.show(false);
    await this.client_.show({ sizes: areShown });
  }

  async suggest() {
    if (this.jobs_.busy || !this.model_.engravable) return;
    this.messages_.clearError();
    this.panel_.clear();
    const { missing } = this.placing_;
    if (missing) {
      this.messages_.say(missing);
      return;
    }
    await this.client_.configure(this.batching_.settings());
    this.searching_ = true;
    try {
      const result = await this.jobs_.run(
        () => text('page.lookingForSpots'),
        (signal) => this.client_.findSpots({ signal, onProgress: (progress) => this.jobs_.showProgress(progress) }),
      );
      if (!result) {
        this.messages_.say(() => text('page.searchCancelled')); // at once: the module may still be busy
        return;
      }
      await this.carving_.show(false);
      await this.show_(result);
      this.messages_.say(() => text('page.chooseSpot'));
    } finally {
      this.searching_ = false;
    }
  }

  /** @param {import('../engine/types.js').Spots} result */
  async show_(result) {
    this.panel_.show(result, true);
    await this.client_.show({ sizes: true });
    void this.drawPictures_(result.spots.length);
  }

  /** @param {number} count */
  async drawPictures_(count) {
    try {
      await this.drawEach_(count);
    } catch (thrown) {
      if (!isReplaced(thrown)) console.warn('The spots have no pictures:', thrown);
    }
  }

  /** Draws the pictures one by one, so that the view is drawn in between. @param {number} count */
  async drawEach_(count) {
    this.search_ += 1;
    const { search_: search } = this;
    const size = kPicturePx * Math.min(devicePixelRatio, 2);
    for (let index = 0; index < count; index += 1) {
      const picture = await this.client_.spotPicture(index, Math.round(size * kPictureAspect), Math.round(size));
      if (search !== this.search_ || !this.panel_.known) return;
      this.panel_.showPicture(index, picture);
    }
  }

  /** @param {number} index */
  async choose(index) {
    /** @type {import('./work.js').Point | undefined} */ let centre;
    await this.placing_.move(async () => {
      const picked = await this.client_.setCentre({ spot: index });
      ({ centre } = picked);
      return picked;
    });
    if (!centre || !sameCentre(centre, this.store_.work.centreMm)) return; // undone, or moved again
    this.panel_.mark(index);
    if (this.placing_.placement) await this.client_.act({ kind: 'face' });
  }

  /** Shows no spot as chosen: the code lies elsewhere. */
  unmark() {
    this.panel_.mark();
  }

  /** Drops the spots: they were found with other settings. */
  async forget() {
    this.isOutdated_ = true;
    if (this.searching_) this.jobs_.abort();
    this.jobs_.abortBackground();
    if (!this.panel_.known) return;
    this.panel_.clear();
    await this.client_.show({ sizes: false });
  }

  /** Looks again with the new settings, if the proposal had not come before they changed or has no room for them. */
  proposeAgain() {
    if (this.placing_.isTooLarge && chosenCentre(this.store_.work)) {
      this.proposed = this.guard_(() => this.lookElsewhere_());
      return;
    }
    this.mayPropose_ ||= this.placing_.lacksRoom;
    this.propose_();
  }
}
