// SPDX-License-Identifier: GPL-3.0-or-later
// Simulates one print in its own module. The engine keeps working, and ending the worker frees the memory.
import { copyOf, parseAnswer } from './answers.js';
import { describeThrown } from './engine_error.js';
import { loadModule } from './module.js';

/** @typedef {import('./types.js').PrintJob} PrintJob */

const scope = /** @type {any} */ (globalThis);

const loading = loadModule(); // starts before the job arrives
loading.catch(() => {}); // the job reports the error

scope.onmessage = async (/** @type {MessageEvent<PrintJob>} */ { data: { stl, order } }) => {
  try {
    const { module } = await loading;
    const print = new module.PrintedCode();
    let progress = parseAnswer(print.start(stl, JSON.stringify(order)));
    while (!progress.done) {
      scope.postMessage({ progress });
      progress = parseAnswer(print.advance());
    }
    const { facingDeg, misread } = progress;
    const pictures = print.readingPictures().map(copyOf);
    scope.postMessage({ print: { facingDeg, misread, pictures, picture: copyOf(print.picture()) } });
  } catch (thrown) {
    scope.postMessage({ error: describeThrown(thrown) });
  }
};
