// SPDX-License-Identifier: GPL-3.0-or-later
// Stores a few large values in IndexedDB beyond the visit. Where the browser stores nothing (private windows, blocked
// or full storage), values are dropped without an error.

const kName = 'qrelief';
const kStore = 'kept';

/**
 * @template T
 * @param {IDBRequest<T> | IDBOpenDBRequest} request
 * @returns {Promise<T>}
 */
const result = (request) =>
  new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(/** @type {T} */ (request.result));
    request.onerror = () => reject(request.error);
  });

export class Database {
  constructor() {
    /** @type {Promise<IDBDatabase> | undefined} */ this.open_ = undefined;
  }

  /** @returns {Promise<IDBDatabase>} */
  database_() {
    this.open_ ??= (async () => {
      const request = indexedDB.open(kName, 1);
      request.onupgradeneeded = () => request.result.createObjectStore(kStore);
      return /** @type {Promise<IDBDatabase>} */ (result(request));
    })();
    return this.open_;
  }

  /** Reads a value. @param {string} key @returns {Promise<any>}  undefined if absent */
  async get(key) {
    try {
      const database = await this.database_();
      return await result(database.transaction(kStore).objectStore(kStore).get(key));
    } catch {
      return undefined;
    }
  }

  /**
   * Writes all values or none.
   * @param {Record<string, any>} values  by key; undefined removes a value
   * @returns {Promise<boolean>}  false: not stored
   */
  async put(values) {
    try {
      const transaction = (await this.database_()).transaction(kStore, 'readwrite');
      const store = transaction.objectStore(kStore);
      for (const [key, value] of Object.entries(values)) {
        if (value === undefined) store.delete(key);
        else store.put(value, key);
      }
      return await new Promise((resolve) => {
        transaction.oncomplete = () => resolve(true);
        transaction.onabort = () => resolve(false); // for example if the quota is used up
      });
    } catch {
      return false;
    }
  }
}
