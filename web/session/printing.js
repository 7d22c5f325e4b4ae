// SPDX-License-Identifier: GPL-3.0-or-later
// Simulates the carving's print while the user looks at the result, and decodes it.
import { readEach } from '../decoder/reader.js';
import { describeThrown } from '../engine/engine_error.js';
import { dismissPrinter, makePrint, preparePrinter } from '../engine/printer.js';

/** @typedef {import('../engine/types.js').Printed} Printed */
/** @typedef {import('../engine/types.js').PrintChange} PrintChange */
/** @typedef {import('../engine/types.js').PrintTrials} PrintTrials */
/** @typedef {import('../engine/types.js').PrintedResult} PrintedResult */

/** A print in progress. */
class Making {
  fraction = 0;
  /** @type {(fraction: number) => void} */ onProgress = () => {};

  /** @param {typeof makePrint} make @param {import('../engine/types.js').PrintJob} job @param {AbortSignal} signal */
  constructor(make, job, signal) {
    this.print = make(job, {
      signal,
      onProgress: (fraction) => {
        this.fraction = fraction;
        this.onProgress(fraction);
      },
    });
    this.print.catch(() => {}); // begin() reports it
  }
}

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
    /** @type {{ making: Making | undefined } | undefined} */ this.early_ = undefined; // of an unfinished carving
  }

  /** Loads the next print's module in advance. */
  expect() {
    preparePrinter();
  }

  /**
   * Starts the print of a carving that is not finished yet; begin() waits for it. Cancels an earlier print.
   * @param {import('../engine/types.js').PrintJob | null} job  null: no print process is chosen
   */
  beginEarly(job) {
    this.abort_?.abort();
    this.abort_ = new AbortController();
    this.early_ = { making: job ? new Making(this.make_, job, this.abort_.signal) : undefined };
    if (!job) dismissPrinter();
  }

  /**
   * Simulates and decodes the print of the finished carving. Cancels the print of another carving.
   * @param {number} number  of the carving
   * @param {(printed: Printed, result?: PrintedResult) => void} tell
   *   reports the state and, once the print is decoded, the result
   */
  async begin(number, tell) {
    const { early_: early } = this;
    if (!early) this.stop();
    this.early_ = undefined;
    const abort = (this.abort_ ??= new AbortController());
    abort.signal.addEventListener('abort', () => tell({ state: 'stopped' }), { once: true });
    const { signal } = abort;
    try {
      const making = early ? early.making : await this.makingNow_(signal);
      if (signal.aborted) return;
      if (!making) {
        tell({ state: 'none' });
        return;
      }
      making.onProgress = (fraction) => tell({ state: 'under-way', fraction });
      making.onProgress(making.fraction);
      const print = await making.print;
      if (!print || signal.aborted) return;
      const texts = await this.read_(print.pictures);
      if (signal.aborted) return;
      const result = await this.client_.setPrintedReadings(number, texts, print.facingDeg);
      if (result && !signal.aborted) tell({ state: 'made', print: { ...print, pictures: [] } }, result);
    } catch (thrown) {
      if (!signal.aborted) tell({ state: 'failed', error: describeThrown(thrown) });
    } finally {
      if (this.abort_ === abort) this.abort_ = undefined;
    }
  }

  /**
   * @param {AbortSignal} signal
   * @returns {Promise<Making | undefined>}  undefined: no print process is chosen, or stopped
   */
  async makingNow_(signal) {
    const job = await this.client_.printJob();
    return job && !signal.aborted ? new Making(this.make_, job, signal) : undefined;
  }

  /**
   * Simulates other ways to print the same carving, one after the other.
   * @param {number} number  of the carving
   * @param {(trials: PrintTrials) => void} tell  reports the state
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
        const print =
          job && (await this.make_(job, { signal, onProgress: (fraction) => tell({ tried, all, fraction }) }));
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

  /** Cancels the print, and unloads a module that was loaded in advance. */
  stop() {
    this.abort_?.abort();
    this.abort_ = undefined;
    this.early_ = undefined;
    dismissPrinter();
  }
}
