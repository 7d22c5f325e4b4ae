// SPDX-License-Identifier: GPL-3.0-or-later
// For tests: what the parts of the session speak to, without a page and without a module.
import { EngineFailure, internal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';

/** Remembers what was said, as the page would show it. */
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
  clearError() {
    this.problem = undefined;
  }
}

/** Of a verb: it can be answered later. */
export class Pending {
  constructor() {
    /** @type {(value?: any) => void} */ this.resolve = () => {};
    /** @type {(reason: unknown) => void} */ this.reject = () => {};
    this.promise = new Promise((resolve, reject) => Object.assign(this, { resolve, reject }));
  }
}

/** An object whose methods all note their calls and answer with what is given for them. @param {Record<string, any>} [answers] */
export function fake(answers = {}) {
  /** @type {string[]} */ const calls = [];
  return /** @type {any} */ (new Proxy({ calls, answers }, {
    get: (target, name) => {
      if (name in target) return /** @type {any} */ (target)[name];
      if (typeof name !== 'string' || name === 'then') return undefined;
      return (/** @type {any[]} */ ...args) => {
        calls.push([name, ...args.filter((arg) => typeof arg !== 'object' && typeof arg !== 'function')].join(' '));
        const answer = answers[name];
        return typeof answer === 'function' ? answer(...args) : answer;
      };
    },
  }));
}

/** Everything that waits for nothing has run. */
export const settled = () => new Promise((resolve) => { setImmediate(resolve); });

export const replaced = () => new EngineFailure(internal(message('engine-replaced')));
export const crashed = () => new EngineFailure(internal(message('engine-crashed', { detail: { term: 'unreachable' } })));
export const noRoom = () => new EngineFailure({ kind: 'NoSolution', ...message('no-centre') });
