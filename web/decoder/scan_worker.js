// SPDX-License-Identifier: GPL-3.0-or-later
// The worker of reader.js: decodes pictures one after the other.
import { loadLibrary, scan } from './scans.js';

/** @typedef {{ id: number, pictures: import('./scans.js').GreyImage[], expected?: string }} Request */

const scope = /** @type {any} */ (globalThis);

loadLibrary().catch(() => {}); // the first scan reports the error

scope.onmessage = async (/** @type {MessageEvent} */ { data }) => {
  const { id, pictures, expected } = /** @type {Request} */ (data);
  try {
    scope.postMessage({ id, texts: await scan(pictures, expected) });
  } catch (thrown) {
    scope.postMessage({ id, problem: thrown instanceof Error ? thrown.message : String(thrown) });
  }
};
