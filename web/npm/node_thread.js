// SPDX-License-Identifier: GPL-3.0-or-later
// The thread of a NodeWorker: gives the worker's module the globals that it has in browsers.
import { readFile } from 'node:fs/promises';
import { parentPort, workerData } from 'node:worker_threads';

const port = /** @type {import('node:worker_threads').MessagePort} */ (parentPort);
const scope = /** @type {any} */ (globalThis);

scope.postMessage = (/** @type {unknown} */ data, /** @type {any[]} */ transfer) => port.postMessage(data, transfer);
// Node's own fetch() reads no files. All that a worker fetches is WebAssembly of this package.
scope.fetch = async (/** @type {string} */ url) =>
  new Response(await readFile(new URL(url)), { headers: { 'Content-Type': 'application/wasm' } });
scope.ImageData ??= class ImageData {
  /** @param {number} width @param {number} height */
  constructor(width, height) {
    this.width = width;
    this.height = height;
    this.data = new Uint8ClampedArray(4 * width * height);
  }
};

await import(workerData);
port.on('message', (data) => scope.onmessage({ data })); // messages wait until now
