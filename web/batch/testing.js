// SPDX-License-Identifier: GPL-3.0-or-later
// For tests: a folder in memory, and a tracker without the module.
import assert from 'node:assert/strict';

export class FakeFolder {
  /** @type {Map<string, Uint8Array>} */ files = new Map();

  /** @param {string} name @param {Uint8Array} bytes */
  async write(name, bytes) {
    this.files.set(name, bytes);
  }

  /** @param {string} name @param {string} line */
  async append(name, line) {
    this.files.set(name, Uint8Array.from([...(this.files.get(name) ?? []), ...new TextEncoder().encode(`${line}\n`)]));
  }

  /** @param {string} name */
  async copy(name) {
    return /** @type {Uint8Array<ArrayBuffer>} */ (this.files.get(name) ?? new Uint8Array());
  }

  /** @param {string} name */
  async read(name) {
    const bytes = this.files.get(name);
    return bytes && new File([/** @type {Uint8Array<ArrayBuffer>} */ (bytes)], name);
  }

  async remove() {
    this.files.clear();
  }
}

/** Gives waiting rows one by one. The module's tracker is tested in tests/batch/batch_progress_test.cpp. */
export class FakeTracker {
  /** Next answers of `lose`; then 'retry'. @type {('retry' | 'fail' | 'stop')[]} */ reactions = [];

  /** @param {number} count */
  constructor(count) {
    /** @type {import('../engine/types.js').RowState[]} */ this.states = Array(count).fill('waiting');
  }

  /** @returns {any} */
  state() {
    return { waiting: this.states.filter((state) => state === 'waiting').length };
  }

  take() {
    const index = this.states.indexOf('waiting');
    if (index < 0) return [];
    this.states[index] = 'running';
    return [{ index, print: index === 0 }];
  }

  /** @param {string} lines */
  settle(lines) {
    for (const { number, status } of lines.split('\n').map((line) => JSON.parse(line)))
      this.states[number - 1] = status;
  }

  /** @param {number} index */
  lose(index) {
    const reaction = this.reactions.shift() ?? 'retry';
    if (reaction === 'retry' && index >= 0) this.states[index] = 'waiting';
    return reaction;
  }

  /** @param {'start' | 'retry' | 'end'} what */
  run(what) {
    assert.equal(what, 'end');
    this.states = this.states.map((state) => (state === 'running' ? 'waiting' : state));
  }
}
