// SPDX-License-Identifier: GPL-3.0-or-later
// For tests: fakes of the page and the module.
import { EngineFailure, internal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';

/** Records the messages that the page would show. */
export class FakeMessages {
  /** @type {string[]} */ said = [];
  /** @type {any} */ problem;
  /** @param {() => string} words */
  say(words) {
    this.said.push(words());
  }
  /** @param {any} problem */
  showError(problem) {
    this.problem = problem;
  }
  /** @param {any[]} warnings */
  warn(warnings) {
    if (warnings.length > 0) this.problem = warnings;
  }
  clearError() {
    this.problem = undefined;
  }
}

/** A promise that a test settles later. */
export class Pending {
  constructor() {
    /** @type {(value?: any) => void} */ this.resolve = () => {};
    /** @type {(reason: unknown) => void} */ this.reject = () => {};
    this.promise = new Promise((resolve, reject) => Object.assign(this, { resolve, reject }));
  }
}

/**
 * Makes an object that records the calls of all its methods and returns the given answers.
 * @param {Record<string, any>} [answers]
 */
export function fake(answers = {}) {
  /** @type {string[]} */ const calls = [];
  return /** @type {any} */ (
    new Proxy(
      { calls, answers },
      {
        get: (target, name) => {
          if (name in target) return /** @type {any} */ (target)[name];
          if (typeof name !== 'string' || name === 'then') return undefined;
          return (/** @type {any[]} */ ...args) => {
            calls.push([name, ...args.filter((arg) => typeof arg !== 'object' && typeof arg !== 'function')].join(' '));
            const answer = answers[name];
            return typeof answer === 'function' ? answer(...args) : answer;
          };
        },
      },
    )
  );
}

/** Waits until all pending promise callbacks have run. */
export const settled = () =>
  new Promise((resolve) => {
    setImmediate(resolve);
  });

export const replaced = () => new EngineFailure(internal(message('engine-replaced')));
export const crashed = () =>
  new EngineFailure(internal(message('engine-crashed', { detail: { term: 'unreachable' } })));
export const noRoom = () => new EngineFailure({ kind: 'NoSolution', ...message('no-centre') });
