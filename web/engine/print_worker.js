// SPDX-License-Identifier: GPL-3.0-or-later
// Simulates one print in its own module. The engine keeps working, and ending the worker frees the memory.
import { describeThrown } from './engine_error.js';
import { loadModule } from './module.js';
import { callsOf } from './module_calls.js';
import { kPrintVerbs } from './verbs.js';

/** @typedef {import('./types.js').PrintJob} PrintJob */

const scope = /** @type {any} */ (globalThis);

const loading = loadModule(); // starts before the job arrives
loading.catch(() => {}); // the job reports the error

scope.onmessage = async (/** @type {MessageEvent<PrintJob>} */ { data: { stl, order } }) => {
  try {
    const module = await loading;
    const printed = callsOf(new module.PrintedCode(), kPrintVerbs);
    let progress = printed.start(stl, order);
    while (!progress.done) {
      scope.postMessage({ progress });
      progress = printed.advance();
    }
    const { facingDeg, misread } = progress;
    const [picture] = printed.pictures('front');
    scope.postMessage({ print: { facingDeg, misread, pictures: printed.pictures('reading'), picture } });
  } catch (thrown) {
    scope.postMessage({ error: describeThrown(thrown) });
  }
};
