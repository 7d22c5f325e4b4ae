// SPDX-License-Identifier: GPL-3.0-or-later
// A folder of files in the browser's origin private file system. The files outlive the page. They are read from disk on
// demand and take no memory.
import { EngineFailure, internal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';

/** @typedef {{ resolve: (value: any) => void, reject: (reason: unknown) => void }} Pending */

/** Returns the folder that holds all folders. @returns {Promise<FileSystemDirectoryHandle>} */
async function rootFolder() {
  try {
    return await navigator.storage.getDirectory();
  } catch {
    // No secure origin, a private window, or an old browser.
    throw new EngineFailure(internal(message('storage-missing')));
  }
}

/** @param {{ name: string, message: string }} problem */
const failureOf = ({ name, message: detail }) =>
  new EngineFailure(
    name === 'QuotaExceededError'
      ? internal(message('storage-full'))
      : internal(message('storage-failed', { detail: { term: detail || name } })),
  );

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
   * Writes a file; replaces an existing one.
   * @param {string} file
   * @param {Uint8Array<ArrayBuffer>} bytes  are transferred
   */
  write(file, bytes) {
    return this.send_('write', file, bytes, [bytes.buffer]);
  }

  /** Appends a line. @param {string} file @param {string} line  without line break */
  append(file, line) {
    return this.send_('append', file, new TextEncoder().encode(`${line}\n`), []);
  }

  /**
   * Copies the contents of a file that may change meanwhile. A later write invalidates the `File` that `read` returns.
   * @param {string} file
   * @returns {Promise<Uint8Array<ArrayBuffer>>}
   */
  copy(file) {
    return this.send_('copy', file, new Uint8Array(), []);
  }

  /**
   * Opens a file; its contents are read on demand.
   * @param {string} file
   * @returns {Promise<File | undefined>}  undefined if absent
   */
  async read(file) {
    try {
      const folder = await (await rootFolder()).getDirectoryHandle(this.name_);
      return await (await folder.getFileHandle(file)).getFile();
    } catch (thrown) {
      if (thrown instanceof DOMException && thrown.name === 'NotFoundError') return undefined;
      throw thrown;
    }
  }

  /** Removes the folder with all files. */
  async remove() {
    const root = await rootFolder();
    await root.removeEntry(this.name_, { recursive: true }).catch(() => {}); // it does not exist
  }

  /**
   * @param {'write' | 'append' | 'copy'} verb
   * @param {string} file
   * @param {Uint8Array} bytes
   * @param {Transferable[]} transfer
   * @returns {Promise<any>}
   */
  async send_(verb, file, bytes, transfer) {
    await rootFolder();
    const worker = (this.worker_ ??= this.start_());
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
