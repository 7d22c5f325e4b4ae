// SPDX-License-Identifier: GPL-3.0-or-later
// The code that follows the mouse over the model: a quick estimate while the mouse moves, exact once it rests, and then
// as it will be carved.
import { isReplaced } from '../engine/client.js';
import { NewestOnly } from './newest_only.js';

/** @typedef {import('../engine/client.js').EngineClient} EngineClient */
/** @typedef {import('./code_chip.js').CodeChip} CodeChip */

const kRestMs = 40; // without a movement: the mouse rests

export class HoverPreview {
  /** @param {EngineClient} client @param {CodeChip} chip @param {import('./live_view.js').LiveView} live */
  constructor(client, chip, live) {
    this.client_ = client;
    this.chip_ = chip;
    this.live_ = live;
    this.shown_ = false;
    this.isEnabled_ = false;
    /** @type {ReturnType<typeof setTimeout> | undefined} */ this.rest_ = undefined;
    this.queue_ = new NewestOnly((/** @type {{ x: number, y: number }} */ at) => this.update_(at));
    this.latest_ = 0;
    this.movedAt_ = 0; // as performance.now()
  }

  /** @param {boolean} isEnabled  a code may be placed and no job runs */
  setEnabled(isEnabled) {
    this.isEnabled_ = isEnabled;
    if (!isEnabled) this.end();
  }

  /** @param {number} x @param {number} y */
  move(x, y) {
    if (!this.isEnabled_) return;
    this.latest_ += 1;
    this.movedAt_ = performance.now();
    this.shown_ = true;
    clearTimeout(this.rest_);
    this.queue_.ask({ x, y });
  }

  end() {
    clearTimeout(this.rest_);
    this.queue_.forget();
    this.latest_ += 1;
    this.chip_.hide();
    if (!this.shown_) return;
    this.shown_ = false;
    this.client_.hover(null).catch(() => {}); // fails only if the engine is replaced, which shows no code either
  }

  /** @param {{ x: number, y: number }} at */
  async update_({ x, y }) {
    const asked = this.latest_;
    try {
      const { code } = await this.client_.hover([x, y]);
      if (!this.shown_) return;
      if (!code) {
        this.chip_.hide();
        return;
      }
      this.chip_.show(code, x, y);
      if (asked !== this.latest_) return;
      const leftMs = this.movedAt_ + kRestMs - performance.now();
      this.rest_ = setTimeout(() => void this.settle_(x, y), Math.max(leftMs, 0));
    } catch (thrown) {
      if (!isReplaced(thrown)) this.chip_.hide();
    }
  }

  /** @param {number} x @param {number} y */
  async settle_(x, y) {
    const asked = this.latest_;
    const isCurrent = () => this.shown_ && asked === this.latest_;
    try {
      const result = await this.client_.settle();
      if (!result?.code || !isCurrent()) return;
      this.chip_.show(result.code, x, y);
      const depths = this.live_.isOn
        ? await this.live_.carve(
            (untilShown) => this.client_.carvePreview(untilShown),
            async (rough) => {
              if (isCurrent()) this.chip_.showDepthAbout(rough);
              await this.showConcerns_(isCurrent);
            },
          )
        : null;
      if (depths && isCurrent()) this.chip_.showDepths(depths);
      else await this.showConcerns_(isCurrent);
    } catch (thrown) {
      if (!isReplaced(thrown) && isCurrent()) this.chip_.showNoRoom(x, y);
    }
  }

  /** @param {() => boolean} isCurrent */
  async showConcerns_(isCurrent) {
    if (!isCurrent()) return;
    const concerns = await this.client_.hoverConcerns();
    if (isCurrent()) this.chip_.showConcerns(concerns);
  }
}
