// SPDX-License-Identifier: GPL-3.0-or-later
// Decodes the carved code in workers, which start on first use and stay.
/** @typedef {import('../engine/types.js').GreyImage} GreyImage */
/** @typedef {{ resolve: (texts: string[]) => void, reject: (reason: Error) => void }} Pending */

export const kReaderName = 'ZXing-C++ (zxing-wasm)';

const kMostWorkers = 2; // each loads its own decoder

/** @type {ScanWorker[]} */
let workers = [];

/** Starts the workers in advance. */
export function prepareReader() {
  if (workers.length > 0) return;
  const count = Math.min(kMostWorkers, globalThis.navigator?.hardwareConcurrency || 1);
  workers = Array.from(
    { length: count },
    () =>
      new ScanWorker(() => {
        workers = []; // the next call starts new ones
      }),
  );
}

/** Ends the workers; nobody may wait for them. */
export function dismissReader() {
  for (const worker of workers) worker.end();
  workers = [];
}

/**
 * Decodes all pictures with all tries, in parallel.
 * @param {GreyImage[]} pictures
 * @returns {Promise<string[]>}  text decoded in each try, '' if none; the same number of tries for each picture in turn
 */
export async function readEach(pictures) {
  prepareReader();
  const perWorker = Math.ceil(pictures.length / workers.length);
  const scans = workers.map((worker, i) => worker.scan(pictures.slice(i * perWorker, (i + 1) * perWorker)));
  return (await Promise.all(scans)).flat();
}

/** Tells whether any try on any picture decodes to the text. @param {GreyImage[]} pictures @param {string} text */
export async function readsAny(pictures, text) {
  prepareReader();
  return (await workers[0].scan(pictures, text)).includes(text);
}

class ScanWorker {
  /** @param {() => void} onFailure  called when the worker has failed for good */
  constructor(onFailure) {
    /** @type {Map<number, Pending>} */ this.pending_ = new Map();
    this.nextId_ = 1;
    this.worker_ = new Worker(new URL('./scan_worker.js', import.meta.url), { type: 'module', name: 'reader' });
    this.worker_.onmessage = ({ data: { id, texts, problem } }) => {
      const pending = this.pending_.get(id);
      this.pending_.delete(id);
      if (texts) pending?.resolve(texts);
      else pending?.reject(failed(problem));
    };
    this.worker_.onerror = (event) => {
      event.preventDefault();
      this.worker_.terminate();
      onFailure();
      for (const { reject } of this.pending_.values()) reject(failed(event.message || 'it could not be loaded'));
      this.pending_.clear();
    };
  }

  end() {
    this.worker_.terminate();
  }

  /** @param {GreyImage[]} pictures @param {string} [text] @returns {Promise<string[]>} */
  scan(pictures, text) {
    return new Promise((resolve, reject) => {
      const id = this.nextId_++;
      this.pending_.set(id, { resolve, reject });
      this.worker_.postMessage({ id, pictures, expected: text });
    });
  }
}

/** @param {string} detail */
const failed = (detail) => new Error(`The reader stopped (${detail})`);
