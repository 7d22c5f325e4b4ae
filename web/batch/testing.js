// SPDX-License-Identifier: GPL-3.0-or-later
// For tests: a folder in memory.

export class FakeFolder {
  /** @type {Map<string, Uint8Array>} */ files = new Map();

  /** @param {string} name @param {Uint8Array} bytes */
  async write(name, bytes) {
    this.files.set(name, bytes);
  }

  /** @param {string} name @param {string} line */
  async append(name, line) {
    this.files.set(name, Uint8Array.from([...(this.files.get(name) ?? []), ...new TextEncoder().encode(`${line}\n`)]));
  }

  /** @param {string} name */
  async copy(name) {
    return /** @type {Uint8Array<ArrayBuffer>} */ (this.files.get(name) ?? new Uint8Array());
  }

  /** @param {string} name */
  async read(name) {
    const bytes = this.files.get(name);
    return bytes && new File([/** @type {Uint8Array<ArrayBuffer>} */ (bytes)], name);
  }

  async remove() {
    this.files.clear();
  }
}
