// SPDX-License-Identifier: GPL-3.0-or-later
// Carves one code as the module's plan says, without a page.
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

/** Engraves as the module's plan says. Each verb throws the reason of the signal once it is aborted. */
export class Carver {
  /** @param {CarverParts} parts */
  constructor({ client, read = readEach, print = makePrint }) {
    this.client_ = client;
    this.read_ = read;
    this.print_ = print;
  }

  /**
   * Engraves, with changed settings where the result or its print does not decode well. The delivered carving becomes
   * the module's current one.
   * @param {Settings} settings
   * @param {boolean} looksAtPrint  also simulate and decode prints
   * @param {JobOptions} job
   * @returns {Promise<Settings>}  settings of the delivered carving
   */
  async carve(settings, looksAtPrint, job) {
    await this.client_.configure(settings);
    await this.client_.placement();
    const settingsOf = new Map();
    /** @type {unknown} */ let failure;
    try {
      await this.carveOnce_({ print: looksAtPrint }, job);
      settingsOf.set(await this.client_.carving(), settings);
    } catch (thrown) {
      if (isLost(thrown) || job.signal.aborted) throw thrown;
      failure = thrown; // the plan tries what the settings leave open
    }
    for (;;) {
      const step = await this.nextStep_(failure);
      job.signal.throwIfAborted();
      if (step.step === 'carve') {
        const current = { ...settings, ...changed(step.changes) };
        if (await this.carveNext_(job)) settingsOf.set(await this.client_.carving(), current);
        continue;
      }
      if (settingsOf.size === 0) throw failure;
      await this.client_.useCarving(step.carving);
      if (step.step === 'deliver') return settingsOf.get(step.carving) ?? settings;
      await this.lookAtPrint_(job);
    }
  }

  /** Returns the plan's next step. @param {unknown} failure  to throw if no plan began */
  async nextStep_(failure) {
    try {
      return await this.client_.nextStep();
    } catch (thrown) {
      throw failure ?? thrown;
    }
  }

  /** Carves the plan's next carving. @param {JobOptions} job @returns {Promise<boolean>}  false: it cannot be carved */
  async carveNext_(job) {
    try {
      await this.carveOnce_({ next: true }, job);
      return true;
    } catch (thrown) {
      if (isLost(thrown) || job.signal.aborted) throw thrown;
      return false;
    }
  }

  /** Carves and decodes once. @param {import('../engine/client.js').PlanOptions} plan @param {JobOptions} job */
  async carveOnce_(plan, job) {
    await this.client_.engrave({ ...job, plan });
    job.signal.throwIfAborted();
    const texts = await this.read_(await this.client_.pictures('reading'));
    job.signal.throwIfAborted();
    await this.client_.setReadings(texts, kReaderName);
  }

  /** Simulates and decodes the print of the current carving. @param {JobOptions} job */
  async lookAtPrint_({ signal, onProgress }) {
    const stage = message('printing');
    const order = await this.client_.printJob();
    const print =
      order && (await this.print_(order, { signal, onProgress: (fraction) => onProgress({ stage, fraction }) }));
    signal.throwIfAborted();
    if (!print) throw new EngineFailure(internal(message('engine-replaced')));
    const texts = await this.read_(print.pictures);
    signal.throwIfAborted();
    const result = await this.client_.setPrintedReadings(await this.client_.carving(), texts, print.facingDeg);
    if (!result) throw new EngineFailure(internal(message('engine-replaced')));
  }
}
