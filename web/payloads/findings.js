// SPDX-License-Identifier: GPL-3.0-or-later
// Collects the errors and warnings about the fields of one content.

/** @typedef {import('./types.js').Problem} Problem */
/** @typedef {import('./types.js').Key} Key */

export class Findings {
  constructor() {
    /** @type {Problem[]} */ this.problems = [];
  }

  /** @param {string} field @param {Key} key @param {Record<string, string | number>} [values] */
  error(field, key, values) {
    this.problems.push({ field, severity: 'error', key, values });
  }

  /** @param {string} field @param {Key} key @param {Record<string, string | number>} [values] */
  warning(field, key, values) {
    this.problems.push({ field, severity: 'warning', key, values });
  }

  /**
   * @param {() => string} write  called only if there is no error
   * @returns {import('./types.js').Built}
   */
  built(write) {
    const wrong = this.problems.some(({ severity }) => severity === 'error');
    return { payload: wrong ? '' : write(), problems: this.problems };
  }
}
