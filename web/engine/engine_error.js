// SPDX-License-Identifier: GPL-3.0-or-later

/** @typedef {import('./types.js').EngineError} EngineErrorValue */

/** Something that could not be done, in words for the user. It crosses the worker's boundary as a plain value. */
export class EngineFailure extends Error {
  /** @param {EngineErrorValue} value */
  constructor(value) {
    super(value.message);
    this.name = 'EngineFailure';
    this.code = value.code;
    this.hint = value.hint;
  }

  /** @returns {EngineErrorValue} */
  get value() {
    return { code: this.code, message: this.message, hint: this.hint };
  }
}

/**
 * Any thrown thing as an error that can be shown.
 * @param {unknown} thrown
 * @returns {EngineErrorValue}
 */
export function describeThrown(thrown) {
  if (thrown instanceof EngineFailure) return thrown.value;
  if (isOutOfMemory(thrown)) {
    return {
      code: 'OutOfMemory',
      message: 'This browser gave no more memory for the work',
      hint: 'Close other tabs, or use a model with fewer triangles.',
    };
  }
  const detail = thrown instanceof Error ? thrown.message : String(thrown);
  if (thrown instanceof WebAssembly.RuntimeError) return crash(detail);
  return {
    code: 'Internal',
    message: `Something went wrong inside QRelief: ${detail}`,
    hint: 'The model and the settings are kept: try again, or reload the page.',
  };
}

/**
 * The module is beyond use and has to be replaced.
 * @param {string} detail
 * @returns {EngineErrorValue}
 */
export function crash(detail) {
  return {
    code: 'Crashed',
    message: `The engraving module stopped (${detail})`,
    hint: 'It is started again with your model and settings. If this repeats, use a model with fewer triangles.',
  };
}

/**
 * The module gives no sign of life.
 * @param {number} silenceMs
 * @returns {EngineErrorValue}
 */
export function hung(silenceMs) {
  return {
    code: 'Hung',
    message: `The engraving module has not answered for ${Math.round(silenceMs / 1000)} seconds`,
    hint: 'It is started again with your model and settings. If this repeats, use a model with fewer triangles.',
  };
}

/** Whether the module must not be called any more. @param {unknown} thrown */
export const isFatal = (thrown) => thrown instanceof EngineFailure && (thrown.code === 'Crashed' || thrown.code === 'OutOfMemory');

/** @param {unknown} thrown */
function isOutOfMemory(thrown) {
  return thrown instanceof Error && /out of memory|cannot enlarge memory|allocation failed|bad_alloc|OOM/i.test(thrown.message);
}
