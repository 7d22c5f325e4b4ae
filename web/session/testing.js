// SPDX-License-Identifier: GPL-3.0-or-later
// For tests: fakes of the page and the module.
import { EngineFailure, internal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { kNoWork } from './work.js';
import { WorkStore } from './work_store.js';

/**
 * Records the messages that the page would show.
 * @implements {Pick<import('../ui/messages.js').Messages, 'say' | 'isSaying' | 'showError' | 'clearError'>}
 */
export class FakeMessages {
  /** @type {string[]} */ said = [];
  /** @type {any} */ problem;
  /** @param {() => string} words */
  say(words) {
    this.said.push(words());
  }
  /** @param {() => string} words */
  isSaying(words) {
    return this.said.at(-1) === words();
  }
  /** @param {any} problem */
  showError(problem) {
    this.problem = problem;
  }
  clearError() {
    this.problem = undefined;
  }
}

/** Makes a store with a work that differs from an empty one. @param {Partial<import('./work.js').Work>} [work] */
export const storeOf = (work) => new WorkStore({ ...kNoWork, ...work });

/** A promise that a test settles later. */
export class Pending {
  constructor() {
    /** @type {(value?: any) => void} */ this.resolve = () => {};
    /** @type {(reason: unknown) => void} */ this.reject = () => {};
    this.promise = new Promise((resolve, reject) => Object.assign(this, { resolve, reject }));
  }
}

/**
 * Makes a stand-in for an object of a class. It records the calls of the class's methods and returns the given answers.
 * A name that the class lacks throws, so that a test fails after a rename.
 * @template T
 * @param {abstract new (...args: any[]) => T} type
 * @param {{ [K in keyof T]?: any }} [answers]  of methods and getters: a value, or a function of the arguments
 * @param {{ [K in keyof T]?: any }} [fields]   fields that tests and the tested code may read and write
 * @returns {T & { calls: string[], answers: { [K in keyof T]?: any } }}
 */
export function fake(type, answers = {}, fields = {}) {
  /** @type {string[]} */ const calls = [];
  const unknown = (/** @type {string} */ name) => new TypeError(`${type.name} has no ${name}`);
  const memberOf = (/** @type {string} */ name) => {
    for (let from = type.prototype; from !== Object.prototype; from = Object.getPrototypeOf(from)) {
      const member = Object.getOwnPropertyDescriptor(from, name);
      if (member) return member;
    }
    return undefined;
  };
  const checkedAnswers = new Proxy(/** @type {Record<string, any>} */ ({}), {
    set: (target, name, answer) => {
      if (!memberOf(String(name))) throw unknown(String(name));
      return Reflect.set(target, name, answer);
    },
  });
  Object.assign(checkedAnswers, answers);
  const target = { calls, answers: checkedAnswers, ...fields };
  return /** @type {any} */ (
    new Proxy(target, {
      get: (_, name) => {
        if (name in target) return /** @type {any} */ (target)[name];
        if (typeof name !== 'string' || name === 'then') return undefined; // asked by console and await
        const member = memberOf(name);
        if (!member) throw unknown(name);
        const answer = (/** @type {any[]} */ ...args) => {
          const given = checkedAnswers[name];
          return typeof given === 'function' ? given(...args) : given;
        };
        if (member.get) return answer();
        return (/** @type {any[]} */ ...args) => {
          calls.push([name, ...args.filter((arg) => typeof arg !== 'object' && typeof arg !== 'function')].join(' '));
          return answer(...args);
        };
      },
      set: (_, name, value) => {
        if (!(name in fields)) throw unknown(String(name));
        return Reflect.set(target, name, value);
      },
    })
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
