// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the worker that simulates a print.
import { EngineFailure, crash } from './engine_error.js';

/** @typedef {import('./types.js').Print} Print */

/** @type {Worker | undefined} */ let ready;

/** Starts the worker of the next print, so that it loads the module in advance. */
export function preparePrinter() {
  ready ??= new Worker(new URL('./print_worker.js', import.meta.url), { type: 'module', name: 'print' });
}

/** Ends a worker that was started in advance. */
export function dismissPrinter() {
  ready?.terminate();
  ready = undefined;
}

/**
 * Simulates a print.
 * @param {import('./types.js').PrintJob} job
 * @param {{ signal: AbortSignal, onProgress: (fraction: number) => void }} options
 * @returns {Promise<Print | undefined>}  undefined: aborted
 */
export function makePrint(job, { signal, onProgress }) {
  if (signal.aborted) return Promise.resolve(undefined);
  preparePrinter();
  const worker = /** @type {Worker} */ (ready);
  ready = undefined;
  /** @type {Promise<Print | undefined>} */ const whenPrinted = new Promise((resolve, reject) => {
    signal.addEventListener('abort', () => resolve(undefined), { once: true });
    worker.onmessage = ({ data: { progress, print, error } }) => {
      if (print) resolve(print);
      else if (error) reject(new EngineFailure(error));
      else onProgress(progress.fraction);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      reject(new EngineFailure(crash(event.message || 'it could not be loaded')));
    };
    worker.postMessage(job);
  });
  return whenPrinted.finally(() => worker.terminate());
}
