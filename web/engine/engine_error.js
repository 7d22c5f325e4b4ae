// SPDX-License-Identifier: GPL-3.0-or-later
import { message } from './message.js';

/** @typedef {import('./types.js').EngineError} EngineErrorValue */

/** Returns the text of an error. The page words errors itself, in its language. @type {(value: EngineErrorValue) => string} */
let textOf = ({ code }) => code;

/** Gives errors a text from now on. @param {typeof textOf} words */
export const wordErrors = (words) => void (textOf = words);

/** An error with a message and its kind. It crosses the worker's boundary as a plain value. */
export class EngineFailure extends Error {
  static name = 'EngineError'; // its name in the npm package, in traces, too

  /** @param {EngineErrorValue} value */
  constructor({ kind, code, values }) {
    super(textOf({ kind, code, values }));
    this.name = EngineFailure.name;
    this.kind = kind;
    this.code = code;
    this.values = values;
  }

  /** @returns {EngineErrorValue} */
  get value() {
    const { kind, code, values } = this;
    return { kind, code, values };
  }
}

/**
 * Makes an error caused by the program or the browser.
 * @param {import('./message.js').Message} said
 * @returns {EngineErrorValue}
 */
export const internal = (said) => ({ kind: 'Internal', ...said });

/**
 * Converts anything thrown to an error that can be shown.
 * @param {unknown} thrown
 * @returns {EngineErrorValue}
 */
export function describeThrown(thrown) {
  if (thrown instanceof EngineFailure) return thrown.value;
  if (isOutOfMemory(thrown)) return internal(message('out-of-memory'));
  const detail = thrown instanceof Error ? thrown.message : String(thrown);
  if (thrown instanceof WebAssembly.RuntimeError) return crash(detail);
  return internal(message('internal-fault', { detail: { term: detail } }));
}

/** Makes the error of a module that crashed and has to be replaced. @param {string} detail */
export const crash = (detail) => internal(message('engine-crashed', { detail: { term: detail } }));

/** Makes the error of a module that hangs. @param {number} silenceMs */
export const hung = (silenceMs) => internal(message('engine-hung', { count: { count: Math.round(silenceMs / 1000) } }));

/** Tells whether the module must not be called any more. @param {unknown} thrown */
export const isFatal = (thrown) =>
  thrown instanceof EngineFailure && (thrown.code === 'engine-crashed' || thrown.code === 'out-of-memory');

/** Recognises an out-of-memory error by its text: browsers and Emscripten give no code. @param {unknown} thrown */
function isOutOfMemory(thrown) {
  return (
    thrown instanceof Error &&
    /out of memory|cannot enlarge memory|allocation failed|bad_alloc|OOM/i.test(thrown.message)
  );
}
