// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the carved code back, beside the page: its workers are started when first needed, and stay.
import { frontalPictures } from './variants.js';

/** @typedef {import('../engine/types.js').GreyImage} GreyImage */
/** @typedef {{ resolve: (texts: string[]) => void, reject: (reason: Error) => void }} Pending */

export const kReaderName = 'ZXing-C++ (zxing-wasm)';

const kMostWorkers = 2;  // each holds a reader of its own

/** @type {ScanWorker[]} */
let workers = [];

/** Starts the workers, so that they are ready when there is something to read. */
export function prepareReader() {
  if (workers.length > 0) return;
  const count = Math.min(kMostWorkers, navigator.hardwareConcurrency || 1);
  workers = Array.from({ length: count }, () => new ScanWorker(() => {
    workers = [];  // the next reading starts new ones
  }));
}

/** @typedef {{ text: string, tries: number, reads: number }} Reading
 *   `text`: what was read, '' if nothing; `reads`: in so many of the tries */

/**
 * Everything that a scanning app tries, on pictures from the front that differ in scale and focus.
 * @param {GreyImage} image
 * @param {number} pixelsPerModule  of the code in it
 * @returns {Promise<Reading>}
 */
export async function readAll(image, pixelsPerModule) {
  prepareReader();
  const scans = frontalPictures(image, pixelsPerModule).map((frontal, i) =>
    workers[i % workers.length].scan(frontal.picture, frontal.pixelsPerModule));
  const texts = (await Promise.all(scans)).flat();
  const text = texts.find((each) => each !== '') ?? '';
  return { text, tries: texts.length, reads: text === '' ? 0 : texts.filter((each) => each === text).length };
}

/** Whether any of it succeeds on one picture. @param {GreyImage} image @param {number} pixelsPerModule @param {string} wanted */
export async function reads(image, pixelsPerModule, wanted) {
  prepareReader();
  return (await workers[0].scan(image, pixelsPerModule, wanted)).includes(wanted);
}

class ScanWorker {
  /** @param {() => void} onFailure  it will not answer any more */
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

  /** @param {GreyImage} picture @param {number} pixelsPerModule @param {string} [wanted] @returns {Promise<string[]>} */
  scan(picture, pixelsPerModule, wanted) {
    return new Promise((resolve, reject) => {
      const id = this.nextId_++;
      this.pending_.set(id, { resolve, reject });
      this.worker_.postMessage({ id, picture, pixelsPerModule, wanted });
    });
  }
}

/** @param {string} detail */
const failed = (detail) => new Error(`The reader stopped (${detail})`);
