// SPDX-License-Identifier: GPL-3.0-or-later
// Searches for the best spots and lets the user choose one.
import { isReplaced } from '../engine/client.js';
import { text } from '../i18n/catalogue.js';

const kPicturePx = 84; // height of a spot's picture
const kPictureAspect = 1.5;

/**
 * @typedef {object} SpotFindingOptions
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('./jobs.js').Jobs} jobs
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./placing.js').Placing} placing
 * @property {import('../ui/messages.js').Messages} messages
 * @property {import('../ui/spots_panel.js').SpotsPanel} panel
 * @property {Pick<import('./batching.js').Batching, 'settings'>} batching
 * @property {import('./carving.js').Carving} carving
 * @property {Pick<import('../ui/code_panel.js').CodePanel, 'settle'>} code
 * @property {(action: () => Promise<unknown>) => Promise<void>} guard
 */

export class SpotFinding {
  /** @param {SpotFindingOptions} options */
  constructor({ client, jobs, model, placing, messages, panel, batching, carving, code, guard }) {
    this.client_ = client;
    this.jobs_ = jobs;
    this.model_ = model;
    this.placing_ = placing;
    this.messages_ = messages;
    this.panel_ = panel;
    this.batching_ = batching;
    this.carving_ = carving;
    this.guard_ = guard;
    this.searching_ = false;
    this.search_ = 0;
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
    placing.moved.on(() => panel.mark());
  }

  /** Enables or disables the search. @param {boolean} allowed */
  allow(allowed) {
    this.panel_.allow(allowed);
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
    await this.client_.configure(this.batching_.settings());
    this.searching_ = true;
    try {
      const result = await this.jobs_.run(
        () => text('page.lookingForSpots'),
        (signal) => this.client_.findSpots({ signal, onProgress: (progress) => this.jobs_.showProgress(progress) }),
      );
      void this.guard_(() => this.carving_.show(false)); // the model shows the sizes
      if (result) this.show_(result);
      this.messages_.say(() => text(result ? 'page.chooseSpot' : 'page.searchCancelled'));
    } finally {
      this.searching_ = false;
    }
  }

  /** @param {import('../engine/types.js').Spots} result */
  show_(result) {
    this.panel_.show(result);
    this.drawPictures_(result.spots.length).catch((thrown) => {
      if (!isReplaced(thrown)) console.warn('The spots have no pictures:', thrown);
    });
  }

  /** Draws the pictures one by one, so that the view is drawn in between. @param {number} count */
  async drawPictures_(count) {
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
    await this.placing_.move(() => this.client_.setCentre({ spot: index }));
    this.panel_.mark(index);
    if (this.placing_.placement) await this.client_.act({ kind: 'face' });
  }

  /** Drops the spots: they were found with other settings. */
  async forget() {
    if (this.searching_) this.jobs_.abort();
    if (!this.panel_.known) return;
    this.panel_.clear();
    await this.client_.show({ sizes: false });
  }
}
