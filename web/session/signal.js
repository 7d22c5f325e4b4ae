// SPDX-License-Identifier: GPL-3.0-or-later
// A signal: tells its listeners that something has happened, so that the sender need not know them.

/** @template {unknown[]} Values */
export class Signal {
  constructor() {
    /** @type {((...values: Values) => void)[]} */ this.listeners_ = [];
  }

  /** Calls a listener each time from now on, after earlier listeners. @param {(...values: Values) => void} listener */
  on(listener) {
    this.listeners_.push(listener);
  }

  /** @param {Values} values */
  tell(...values) {
    for (const listener of this.listeners_) listener(...values);
  }
}
