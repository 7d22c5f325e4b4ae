// SPDX-License-Identifier: GPL-3.0-or-later
// A signal that objects created later can listen to: the sender does not know its listeners.

/** @template {unknown[]} Values */
export class Signal {
  constructor() {
    /** @type {((...values: Values) => void)[]} */ this.listeners_ = [];
  }

  /** Adds a listener; listeners are called in this order. @param {(...values: Values) => void} listener */
  on(listener) {
    this.listeners_.push(listener);
  }

  /** @param {Values} values */
  emit(...values) {
    for (const listener of this.listeners_) listener(...values);
  }
}
