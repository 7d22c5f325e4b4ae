// SPDX-License-Identifier: GPL-3.0-or-later
// A folder of files that outlive the page, in the browser's origin private file system. They are read from the disk when
// they are asked for, so that their number takes no memory.
import { EngineFailure, internal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';

/** @typedef {{ resolve: (value: any) => void, reject: (reason: unknown) => void }} Pending */

/** @returns {Promise<FileSystemDirectoryHandle>}  of all folders */
async function rootFolder() {
  try {
    return await navigator.storage.getDirectory();
  } catch {
    throw new EngineFailure(internal(message('storage-missing')));  // no secure origin, a private window, or an old browser
  }
}

/** @param {{ name: string, message: string }} problem */
const failureOf = ({ name, message: detail }) => new EngineFailure(name === 'QuotaExceededError' ? internal(message('storage-full'))
  : internal(message('storage-failed', { detail: { term: detail || name } })));

/** @param {unknown} thrown */
export const isStorageFailure = (thrown) => thrown instanceof EngineFailure && thrown.code.startsWith('storage-');

export class Folder {
  /** @param {string} name */
  constructor(name) {
    this.name_ = name;
    /** @type {Worker | undefined} */ this.worker_ = undefined;
    /** @type {Map<number, Pending>} */ this.pending_ = new Map();
    this.nextId_ = 1;
  }

  /**
   * In place of the file of this name.
   * @param {string} file
   * @param {Uint8Array<ArrayBuffer>} bytes  are handed over
   */
  write(file, bytes) {
    return this.send_('write', file, bytes, [bytes.buffer]);
  }

  /** @param {string} file @param {string} line  without its end */
  append(file, line) {
    return this.send_('append', file, new TextEncoder().encode(`${line}\n`), []);
  }

  /** What a file has that may be written to meanwhile: what `read` gives is of no use then. @param {string} file @returns {Promise<Uint8Array<ArrayBuffer>>} */
  copy(file) {
    return this.send_('copy', file, new Uint8Array(), []);
  }

  /** @param {string} file @returns {Promise<File | undefined>}  not read yet; none: it is not there */
  async read(file) {
    try {
      const folder = await (await rootFolder()).getDirectoryHandle(this.name_);
      return await (await folder.getFileHandle(file)).getFile();
    } catch (thrown) {
      if (thrown instanceof DOMException && thrown.name === 'NotFoundError') return undefined;
      throw thrown;
    }
  }

  /** With all that is in it. */
  async remove() {
    const root = await rootFolder();
    await root.removeEntry(this.name_, { recursive: true }).catch(() => {});  // it is not there
  }

  /** @param {'write' | 'append' | 'copy'} verb @param {string} file @param {Uint8Array} bytes @param {Transferable[]} transfer @returns {Promise<any>} */
  async send_(verb, file, bytes, transfer) {
    await rootFolder();
    const worker = this.worker_ ??= this.start_();
    return new Promise((resolve, reject) => {
      const id = this.nextId_++;
      this.pending_.set(id, { resolve, reject });
      worker.postMessage({ id, verb, folder: this.name_, file, bytes }, transfer);
    });
  }

  start_() {
    const worker = new Worker(new URL('./folder_worker.js', import.meta.url), { type: 'module', name: 'folder' });
    worker.onmessage = ({ data: { id, value, problem } }) => {
      const pending = this.pending_.get(id);
      this.pending_.delete(id);
      if (problem) pending?.reject(failureOf(problem));
      else pending?.resolve(value);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      const failure = failureOf({ name: '', message: event.message || 'its worker could not be loaded' });
      this.worker_ = undefined;
      this.pending_.forEach(({ reject }) => reject(failure));
      this.pending_.clear();
    };
    return worker;
  }
}
