// SPDX-License-Identifier: GPL-3.0-or-later
// Engraves one code to the end, without a page.
import { isReplaced } from '../engine/client.js';
import { EngineFailure, internal, isFatal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { makePrint } from '../engine/printer.js';
import { kReaderName, readEach } from '../decoder/reader.js';

/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {Pick<import('../engine/client.js').JobOptions, 'signal' | 'onProgress'>} JobOptions */

/**
 * @typedef {object} CarverParts
 * @property {import('../engine/client.js').EngineClient} client  with a model and a centre
 * @property {typeof readEach} [read]
 * @property {typeof makePrint} [print]
 */

/** Share of a print in what the engraving has left before it. */
const kPrintShare = 0.2;

/** Tells whether the module must not be used any more. @param {unknown} thrown */
export const isLost = (thrown) =>
  isFatal(thrown) || isReplaced(thrown) || (thrown instanceof EngineFailure && thrown.code === 'engine-hung');

/**
 * Returns changes as settings.
 * @param {import('../engine/types.js').SettingChange[]} changes
 */
const changed = (changes) =>
  Object.fromEntries(
    changes.map(({ setting, value }) => [setting, Number.isFinite(Number(value)) ? Number(value) : value]),
  );

/** Each verb throws the reason of the signal once it is aborted. */
export class Carver {
  /** @param {CarverParts} parts */
  constructor({ client, read = readEach, print = makePrint }) {
    this.client_ = client;
    this.read_ = read;
    this.print_ = print;
  }

  /**
   * Engraves, with changed settings where the result or its print does not decode well. The result becomes the module's
   * current carving.
   * @param {Settings} settings
   * @param {boolean} looksAtPrint  also simulate and decode prints
   * @param {JobOptions} job
   * @returns {Promise<Settings>}  settings of the result
   */
  async carve(settings, looksAtPrint, { signal, onProgress }) {
    let reached = 0;
    const job = {
      signal,
      onProgress: (/** @type {import('../engine/types.js').EngraveProgress} */ progress) => {
        reached = Math.max(reached, progress.fraction);
        onProgress({ ...progress, fraction: reached });
      },
    };
    await this.client_.configure(settings);
    await this.client_.placement();
    let step = await this.client_.engrave({ ...job, options: { print: looksAtPrint } });
    for (;;) {
      job.signal.throwIfAborted();
      if (!step) throw new EngineFailure(internal(message('engine-replaced'))); // nothing else ends it
      if (step.needs === null) return { ...settings, ...changed(step.changes) };
      const texts = step.needs === 'texts' ? await this.read_(step.pictures) : undefined;
      if (!texts) await this.lookAtPrint_(step.carving, job, reached);
      job.signal.throwIfAborted();
      step = await this.client_.continueEngrave({ ...job, ...(texts && { read: { texts, reader: kReaderName } }) });
    }
  }

  /**
   * Simulates and decodes the print of the current carving.
   * @param {number} number
   * @param {JobOptions} job
   * @param {number} reached  progress of the engraving
   */
  async lookAtPrint_(number, { signal, onProgress }, reached) {
    const stage = message('printing');
    const onPrinted = (/** @type {number} */ fraction) =>
      onProgress({ stage, fraction: reached + kPrintShare * fraction * (1 - reached) });
    const order = await this.client_.printJob();
    const print = order && (await this.print_(order, { signal, onProgress: onPrinted }));
    signal.throwIfAborted();
    if (!print) throw new EngineFailure(internal(message('engine-replaced')));
    const texts = await this.read_(print.pictures);
    signal.throwIfAborted();
    const result = await this.client_.setPrintedReadings(number, texts, print.facingDeg);
    if (!result) throw new EngineFailure(internal(message('engine-replaced')));
  }
}
