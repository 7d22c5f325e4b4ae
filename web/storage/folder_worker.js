// SPDX-License-Identifier: GPL-3.0-or-later
// The worker of folder.js: only a worker can write to a file in place in every browser. Data is on disk before a verb
// answers.

/**
 * @typedef {{ id: number, verb: 'write' | 'append' | 'copy', folder: string, file: string, bytes: Uint8Array }} Request
 */
/** @typedef {{ getSize: () => number, truncate: (size: number) => void, write: (bytes: Uint8Array, options?: { at: number }) => number,
 *   read: (bytes: Uint8Array, options?: { at: number }) => number, flush: () => void, close: () => void }} Access */

const scope = /** @type {any} */ (globalThis);
const kLineEnd = 10;

/**
 * Opens a file, uses it and closes it.
 * @template T
 * @param {string} folder @param {string} file @param {(access: Access) => T} use
 */
async function withFile(folder, file, use) {
  const root = await navigator.storage.getDirectory();
  const directory = await root.getDirectoryHandle(folder, { create: true });
  const handle = /** @type {any} */ (await directory.getFileHandle(file, { create: true }));
  /** @type {Access} */ const access = await handle.createSyncAccessHandle();
  try {
    const value = use(access);
    access.flush();
    return value;
  } finally {
    access.close();
  }
}

/** Writes all bytes. @param {Access} access @param {Uint8Array} bytes @param {number} at */
function put(access, bytes, at) {
  for (let written = 0; written < bytes.length;) {
    const more = access.write(bytes.subarray(written), { at: at + written });
    if (more === 0) throw new DOMException('nothing more was written', 'QuotaExceededError');
    written += more;
  }
}

const verbs = {
  /** Replaces the contents of the file. @param {Access} access @param {Uint8Array} bytes */
  write(access, bytes) {
    access.truncate(0);
    put(access, bytes, 0);
  },
  /** Appends a line; first ends the last line if it was cut off. @param {Access} access @param {Uint8Array} bytes */
  append(access, bytes) {
    const size = access.getSize(),
      last = new Uint8Array(1);
    if (size > 0) access.read(last, { at: size - 1 });
    const isCut = size > 0 && last[0] !== kLineEnd;
    if (isCut) put(access, Uint8Array.of(kLineEnd), size);
    put(access, bytes, size + Number(isCut));
  },
  /** Copies the contents of the file between two writes. @param {Access} access */
  copy(access) {
    const bytes = new Uint8Array(access.getSize());
    access.read(bytes, { at: 0 });
    return bytes;
  },
};

/** Queue of requests: a file can be open only once. @type {Promise<void>} */
let queue = Promise.resolve();

scope.onmessage = (/** @type {MessageEvent} */ { data }) => {
  const { id, verb, folder, file, bytes } = /** @type {Request} */ (data);
  queue = queue.then(async () => {
    try {
      const value = await withFile(folder, file, (access) => verbs[verb](access, bytes));
      scope.postMessage({ id, value }, value ? [value.buffer] : []);
    } catch (thrown) {
      const { name, message } =
        thrown instanceof Error || thrown instanceof DOMException ? thrown : { name: '', message: String(thrown) };
      scope.postMessage({ id, problem: { name, message } });
    }
  });
};

export {};
