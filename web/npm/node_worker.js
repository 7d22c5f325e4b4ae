// SPDX-License-Identifier: GPL-3.0-or-later
// The Worker class of browsers for Node, as far as the engine uses it.
import { Worker as Thread } from 'node:worker_threads';

export class NodeWorker {
  /** @param {URL} url  of a module that sets `onmessage` */
  constructor(url) {
    /** @type {((event: { data: any }) => void) | null} */ this.onmessage = null;
    /** @type {((event: { message: string, preventDefault: () => void }) => void) | null} */ this.onerror = null;
    this.thread_ = new Thread(new URL('./node_thread.js', import.meta.url), {
      workerData: url.href,
      execArgv: [], // some flags of the program, such as --input-type, stop a thread that runs a file
    });
    this.thread_.on('message', (data) => this.onmessage?.({ data }));
    this.thread_.on('error', ({ message }) => this.onerror?.({ message, preventDefault: () => {} }));
  }

  /** @param {unknown} data @param {any[]} [transfer] */
  postMessage(data, transfer) {
    this.thread_.postMessage(data, transfer);
  }

  terminate() {
    void this.thread_.terminate();
  }
}
