// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the print of what was carved while the user looks at the result, and reads it.
import { readEach } from '../decoder/reader.js';
import { describeThrown } from '../engine/engine_error.js';
import { makePrint } from '../engine/printer.js';

/** @typedef {import('../engine/types.js').Printed} Printed */
/** @typedef {import('../engine/types.js').PrintChange} PrintChange */
/** @typedef {import('../engine/types.js').PrintTrials} PrintTrials */
/** @typedef {import('../engine/types.js').Report} Report */

export class Printing {
  /**
   * @param {object} options
   * @param {Pick<import('../engine/client.js').EngineClient, 'printJob' | 'setPrintedReadings' | 'otherPrints' | 'judgePrint'>} options.client
   * @param {typeof makePrint} [options.make]
   * @param {typeof readEach} [options.read]
   */
  constructor({ client, make = makePrint, read = readEach }) {
    this.client_ = client;
    this.make_ = make;
    this.read_ = read;
    /** @type {AbortController | undefined} */ this.abort_ = undefined;
  }

  /**
   * Of the carving that is there now. A print that is under way is given up.
   * @param {number} number  of the carving
   * @param {(printed: Printed, report?: Report) => void} tell  how far it is; the report, once the print is in it
   */
  async begin(number, tell) {
    this.stop();
    const abort = new AbortController();
    this.abort_ = abort;
    abort.signal.addEventListener('abort', () => tell({ state: 'stopped' }), { once: true });
    const { signal } = abort;
    try {
      const job = await this.client_.printJob();
      if (signal.aborted) return;
      if (!job) {
        tell({ state: 'none' });
        return;
      }
      tell({ state: 'under-way', fraction: 0 });
      const print = await this.make_(job, { signal, onProgress: (fraction) => tell({ state: 'under-way', fraction }) });
      if (!print || signal.aborted) return;
      const texts = await this.read_(print.pictures);
      if (signal.aborted) return;
      const report = await this.client_.setPrintedReadings(number, texts, print.facingDeg);
      if (report && !signal.aborted) tell({ state: 'made', print: { ...print, pictures: [] } }, report);
    } catch (thrown) {
      if (!signal.aborted) tell({ state: 'failed', error: describeThrown(thrown) });
    } finally {
      if (this.abort_ === abort) this.abort_ = undefined;
    }
  }

  /**
   * Prints the same carving in other ways, one after the other.
   * @param {number} number  of the carving
   * @param {(trials: PrintTrials) => void} tell  how far it is
   */
  async tryOthers(number, tell) {
    this.stop();
    const abort = new AbortController();
    this.abort_ = abort;
    const { signal } = abort;
    /** @type {PrintTrials['tried']} */ let tried = [];
    let all = 0;
    try {
      const changes = await this.client_.otherPrints(number);
      all = changes.length;
      for (const change of changes) {
        tell({ tried, all, fraction: 0 });
        const job = await this.client_.printJob(change);
        const print = job && await this.make_(job, { signal, onProgress: (fraction) => tell({ tried, all, fraction }) });
        if (!print || signal.aborted) break;
        const texts = await this.read_(print.pictures);
        const prints = await this.client_.judgePrint(number, change, texts, print.facingDeg);
        if (!prints || signal.aborted) break;
        tried = [...tried, { change, prints }];
      }
      tell({ tried, all });
    } catch (thrown) {
      tell({ tried, all, ...(signal.aborted ? {} : { error: describeThrown(thrown) }) });
    } finally {
      if (this.abort_ === abort) this.abort_ = undefined;
    }
  }

  /** If one is under way. */
  stop() {
    this.abort_?.abort();
    this.abort_ = undefined;
  }
}
