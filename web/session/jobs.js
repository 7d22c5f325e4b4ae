// SPDX-License-Identifier: GPL-3.0-or-later
// Runs long jobs, one at a time, with progress and cancellation.
import { isReplaced } from '../engine/client.js';
import { text } from '../i18n/catalogue.js';
import { sentenceOf } from '../i18n/messages.js';

/** @typedef {import('../i18n/live.js').Words} Words */

/**
 * @typedef {object} JobsOptions
 * @property {import('../ui/work_panel.js').WorkPanel} panel
 * @property {import('../ui/messages.js').Messages} messages
 * @property {(busy: boolean) => void} onBusy
 */

export class Jobs {
  /** @param {JobsOptions} options */
  constructor({ panel, messages, onBusy }) {
    this.panel_ = panel;
    this.messages_ = messages;
    this.onBusy_ = onBusy;
    /** @type {AbortController | undefined} */ this.abort_ = undefined;
    /** @type {AbortController | undefined} */ this.background_ = undefined;
    /** @type {Promise<unknown> | undefined} */ this.running_ = undefined;
  }

  get busy() {
    return this.abort_ !== undefined;
  }

  /**
   * Runs a job after the current one.
   * @template T
   * @param {Words} stage  first stage
   * @param {(signal: AbortSignal) => Promise<T>} run
   * @param {number} [reached]  progress of what the job goes on with; absent: the duration is unknown
   * @returns {Promise<T>}
   */
  async run(stage, run, reached) {
    while (this.running_) await this.running_.catch(() => {}); // no await after this: others may wait for the same job
    const abort = new AbortController();
    this.abort_ = abort;
    this.panel_.begin(stage(), reached);
    this.onBusy_(true);
    this.messages_.say(() => text('page.working', { stage: stage() }));
    const running = run(abort.signal);
    this.running_ = running;
    try {
      return await running;
    } catch (thrown) {
      if (isReplaced(thrown) && abort.signal.aborted) this.messages_.say(() => text('page.cancelled'));
      throw thrown;
    } finally {
      this.running_ = undefined;
      this.abort_ = undefined;
      this.panel_.end();
      this.onBusy_(false);
    }
  }

  /**
   * Runs a job after the current one, without making the page busy. The next job waits for it.
   * @template T
   * @param {(signal: AbortSignal) => Promise<T>} run
   * @returns {Promise<T>}
   */
  async runInBackground(run) {
    while (this.running_) await this.running_.catch(() => {}); // as above
    const abort = new AbortController();
    this.background_ = abort;
    const running = run(abort.signal);
    this.running_ = running;
    try {
      return await running;
    } finally {
      this.running_ = undefined;
      this.background_ = undefined;
    }
  }

  abortBackground() {
    this.background_?.abort();
  }

  /**
   * @param {import('../engine/types.js').EngraveProgress} progress
   * @param {Words} [purpose]  what the job is for, if the user has not asked for it
   */
  showProgress({ stage, fraction }, purpose) {
    const words = () => sentenceOf(stage) || text('page.preparing');
    this.panel_.update(fraction, words());
    this.messages_.say(() => text('page.working', { stage: [...(purpose ? [purpose()] : []), words()].join('. ') }));
  }

  /** Aborts on the user's request and says so. */
  cancel() {
    this.messages_.say(() => text('page.stopping'));
    this.abort();
  }

  abort() {
    this.abort_?.abort();
    this.abortBackground();
  }

  async untilIdle() {
    while (this.running_) await this.running_.catch(() => {}); // its starter handles the error
  }
}
