// SPDX-License-Identifier: GPL-3.0-or-later
// Carves a code until it decodes, and until its print decodes, with the changes that the module proposes.
import { isReplaced } from '../engine/client.js';
import { EngineFailure, internal, isFatal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { makePrint } from '../engine/printer.js';
import { kReaderName, readEach } from '../decoder/reader.js';

/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {import('../engine/types.js').ReadingResult} ReadingResult */
/** @typedef {Pick<import('../engine/client.js').JobOptions, 'signal' | 'onProgress'>} JobOptions */

/**
 * @typedef {object} CarverParts
 * @property {import('../engine/client.js').EngineClient} client  with a model and a centre
 * @property {typeof readEach} [read]
 * @property {typeof makePrint} [print]
 */

/** Tells whether the module must not be used any more. @param {unknown} thrown */
export const isLost = (thrown) =>
  isFatal(thrown) || isReplaced(thrown) || (thrown instanceof EngineFailure && thrown.code === 'engine-hung');

/** Each verb throws the reason of the signal once it is aborted. */
export class Carver {
  /** @param {CarverParts} parts */
  constructor({ client, read = readEach, print = makePrint }) {
    this.client_ = client;
    this.read_ = read;
    this.print_ = print;
  }

  /**
   * Carves with the requested settings and, while the result does not decode, with the module's next proposal.
   * @param {Settings} asked
   * @param {JobOptions} job
   * @returns {Promise<Settings>}  settings of the last carving
   */
  async carveUntilItReads(asked, job) {
    let settings = asked;
    for (let next = await this.carveOnce_(settings, job); next;) {
      settings = { ...settings, [next.setting]: next.value };
      next = await this.carveOnce_(settings, job);
    }
    return settings;
  }

  /**
   * Simulates the print. If it barely decodes, carves deeper until a print decodes well; returns to the first carving
   * if none does.
   * @param {Settings} carved  settings of the carving
   * @param {JobOptions} job
   * @returns {Promise<Settings>}  settings of the current carving
   */
  async carveUntilItPrints(carved, job) {
    const first = await this.client_.carving();
    let settings = carved;
    for (let result = await this.lookAtPrint_(job); !result.passed && result.next;) {
      settings = { ...settings, [result.next.setting]: result.next.value };
      const reads = await this.carveOnce_(settings, job).then(
        (next) => next === null,
        (thrown) => {
          if (isLost(thrown) || job.signal.aborted) throw thrown;
          return false;
        },
      );
      result = reads ? await this.lookAtPrint_(job) : { passed: false, next: null };
      if (result.passed || result.next) continue;
      await this.client_.useCarving(first);
      return carved;
    }
    return settings;
  }

  /**
   * Carves and decodes once.
   * @param {Settings} settings
   * @param {JobOptions} job
   * @returns {Promise<ReadingResult['next']>}  change to carve with next
   */
  async carveOnce_(settings, job) {
    await this.client_.configure(settings);
    await this.client_.placement();
    await this.client_.engrave(job);
    job.signal.throwIfAborted();
    const texts = await this.read_(await this.client_.readingPictures());
    job.signal.throwIfAborted();
    return (await this.client_.setReadings(texts, kReaderName)).next;
  }

  /**
   * Simulates and decodes the print.
   * @param {JobOptions} job
   * @returns {Promise<ReadingResult>}  passes if no print process is chosen
   */
  async lookAtPrint_({ signal, onProgress }) {
    const order = await this.client_.printJob();
    if (!order) return { passed: true, next: null };
    const stage = message('printing');
    const print = await this.print_(order, { signal, onProgress: (fraction) => onProgress({ stage, fraction }) });
    signal.throwIfAborted();
    if (!print) throw new EngineFailure(internal(message('engine-replaced')));
    const texts = await this.read_(print.pictures);
    signal.throwIfAborted();
    const result = await this.client_.setPrintedReadings(await this.client_.carving(), texts, print.facingDeg);
    if (!result) throw new EngineFailure(internal(message('engine-replaced')));
    return result;
  }
}
