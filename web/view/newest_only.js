// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Runs one task at a time. Of the tasks requested meanwhile, it runs only the newest.
 * @template T
 */
export class NewestOnly {
  /** @param {(task: T) => Promise<unknown>} run  handles its own failures */
  constructor(run) {
    this.run_ = run;
    this.busy_ = false;
    /** @type {{ task: T } | undefined} */ this.waiting_ = undefined;
  }

  /** @param {T} task */
  ask(task) {
    this.waiting_ = { task };
    if (!this.busy_) void this.runAll_();
  }

  forget() {
    this.waiting_ = undefined;
  }

  async runAll_() {
    this.busy_ = true;
    try {
      while (this.waiting_) {
        const { task } = this.waiting_;
        this.waiting_ = undefined;
        await this.run_(task);
      }
    } finally {
      this.busy_ = false;
    }
  }
}
