// SPDX-License-Identifier: GPL-3.0-or-later
// Shows every error on the page and replaces a module that crashed.
import { isReplaced } from '../engine/client.js';
import { describeThrown, isFatal } from '../engine/engine_error.js';
import { text } from '../i18n/catalogue.js';

/** @typedef {import('../engine/types.js').HostEvent} HostEvent */

const kMaxReplacements = 3; // within kFaultSpanMs; then the page gives up
const kFaultSpanMs = 10 * 60 * 1000;

export class Recovery {
  /**
   * @param {import('../ui/messages.js').Messages} messages
   * @param {() => Promise<void>} replace  replaces the module
   */
  constructor(messages, replace) {
    this.messages_ = messages;
    this.replace_ = replace;
    /** @type {number[]} */ this.faults_ = []; // times, ms
    this.recovering_ = false;
  }

  /**
   * Runs a control's action and handles its errors.
   * @param {() => Promise<unknown>} action
   */
  async guard(action) {
    try {
      await action();
    } catch (thrown) {
      if (isReplaced(thrown)) return;
      const error = describeThrown(thrown);
      this.messages_.showError(error);
      this.messages_.say(() => text('page.failed'));
      if (isFatal(thrown)) await this.recoverFrom({ event: 'failure', error });
    }
  }

  /** @param {HostEvent} event */
  async recoverFrom(event) {
    if (this.recovering_) return; // each pending verb reports the same fault
    this.recovering_ = true;
    try {
      await this.replaceAfter_(event);
    } finally {
      this.recovering_ = false;
    }
  }

  /** @param {HostEvent} event */
  async replaceAfter_(event) {
    const now = Date.now();
    this.faults_ = [...this.faults_.filter((at) => now - at < kFaultSpanMs), now];
    if (event.event === 'failure') this.messages_.showError(event.error);
    if (this.faults_.length > kMaxReplacements) {
      this.messages_.say(() => text('page.stopped'));
      this.messages_.showError({ found: () => text('page.failsAgain'), help: () => text('page.failsAgainHint') });
      return;
    }
    this.messages_.say(() => text(event.event === 'contextlost' ? 'page.contextLost' : 'page.restarting'));
    await this.replace_();
  }
}
