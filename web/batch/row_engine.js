// SPDX-License-Identifier: GPL-3.0-or-later
// Carves row after row of a batch, in a worker of its own: model, place and list are given to it once.
import { EngineClient, isReplaced } from '../engine/client.js';
import { EngineFailure, describeThrown, internal, isFatal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { makePrint } from '../engine/printer.js';
import { kReaderName, readEach } from '../decoder/reader.js';
import { sha256 } from './hashes.js';

/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {import('../engine/types.js').ManifestEntry} ManifestEntry */
/** @typedef {import('../engine/message.js').Message} Message */

/**
 * What all rows share.
 * @typedef {object} BatchJob
 * @property {{ bytes: Uint8Array, fileName: string, scaleToMm: number, upAxis: import('../engine/types.js').UpAxis }} model
 * @property {string} input  SHA-256 of the model's file
 * @property {[number, number, number]} centreMm
 * @property {Uint8Array} list  none: empty
 * @property {import('../engine/types.js').WantedBatch} wanted
 */

/**
 * What became of a row, and why it failed if it did.
 * @typedef {{ entry: ManifestEntry, why?: Message }} CarvedRow
 * What became of rows with one file: of one row, or of those on a plate. `bytes`: none if all failed.
 * @typedef {{ rows: CarvedRow[], file: string, bytes?: Uint8Array<ArrayBuffer> }} CarvedUnit
 */

/**
 * @typedef {object} RowEngineParts
 * @property {EngineClient} client
 * @property {typeof readEach} [read]
 * @property {typeof makePrint} [print]
 */

/** Whether the module must not be used any more. @param {unknown} thrown */
export const isLost = (thrown) => isFatal(thrown) || isReplaced(thrown) || (thrown instanceof EngineFailure && thrown.code === 'engine-hung');

/** An engine whose canvas nobody sees. What befalls it outside of any verb ends it. */
export function makeHiddenClient() {
  /** @type {EngineClient} */ const client = new EngineClient({
    makeCanvas: () => Object.assign(document.createElement('canvas'), { width: 1, height: 1 }),
    onEvent: ({ event }) => {
      if (event === 'contextlost' || event === 'failure') client.end();
    },
    draws: false,
  });
  return client;
}

export class RowEngine {
  /** @param {BatchJob} job @param {RowEngineParts} [parts] */
  constructor(job, { client, read = readEach, print = makePrint } = { client: makeHiddenClient() }) {
    this.job_ = job;
    this.client_ = client;
    this.read_ = read;
    this.print_ = print;
    this.ended_ = new AbortController();
  }

  /** Gives it everything that rows share. */
  async start() {
    const { model, centreMm, list, wanted } = this.job_;
    const { problems } = await this.client_.start();
    if (problems.length > 0) throw new EngineFailure(internal(message('no-graphics', { why: { cause: problems[0] } })));
    await this.client_.setUpAxis(model.upAxis);
    await this.client_.loadModel(model.bytes, model.fileName, model.scaleToMm);
    await this.client_.planBatch(list, wanted);
    await this.client_.setCentre(centreMm);
  }

  /** However busy: what it is at is rejected, as `isLost` tells. */
  end() {
    this.ended_.abort();
    this.client_.end();
  }

  /**
   * One row, or all of a plate.
   * @param {number[]} indices  from 0
   * @param {(index: number) => boolean} looksAtPrint  whether to find out how it comes off the printer, too
   * @returns {Promise<CarvedUnit>}
   */
  async carve(indices, looksAtPrint) {
    const isPlate = this.job_.wanted.perPlate > 0;
    if (isPlate) await this.client_.startPlate(indices.length);
    const others = isPlate ? (await Promise.all(indices.map((index) => this.hashOf(index)))).join('') : '';
    /** @type {CarvedRow[]} */ const rows = [];
    /** @type {Uint8Array<ArrayBuffer> | undefined} */ let bytes;
    for (const [place, index] of indices.entries()) {
      const carved = await this.carveRow_(index, others, looksAtPrint(index));
      const { row, withInlay } = carved;
      const { id, status, file } = row.entry;
      rows.push(row);
      if (status === 'done' && isPlate) await this.client_.addToPlate(place, id);
      else if (status === 'done') bytes = await this.written_([row], () => this.client_.exportModel(formatOf(file, withInlay)));
    }
    const [{ entry: { file } }] = rows, done = rows.filter(({ entry }) => entry.status === 'done');
    if (isPlate && done.length > 0) bytes = await this.written_(done, () => this.client_.exportPlate(file));
    return { rows, file, ...(bytes && { bytes }) };
  }

  /**
   * The file of rows that are done; without it they have failed.
   * @param {CarvedRow[]} rows
   * @param {() => Promise<Uint8Array<ArrayBuffer>>} write
   */
  async written_(rows, write) {
    try {
      const bytes = await write();
      const output = await sha256(bytes);
      for (const { entry } of rows) entry.sha256.output = output;
      return bytes;
    } catch (thrown) {
      if (isLost(thrown)) throw thrown;
      for (const row of rows) Object.assign(row, { entry: { ...row.entry, status: 'failed' }, why: describeThrown(thrown) });
      return undefined;
    }
  }

  /** @param {number} index @param {string} others  what else its file's hash is of @param {boolean} looksAtPrint @returns {Promise<{ row: CarvedRow, withInlay: boolean }>} */
  async carveRow_(index, others, looksAtPrint) {
    const begun = performance.now();
    const { settings: own, ...name } = await this.client_.batchRow(index);
    const settings = /** @type {Settings & { inlay?: boolean }} */ ({ ...this.job_.wanted.settings, ...own });
    const { number, id, text, file } = name;
    /** @type {ManifestEntry} */
    const entry = { number, id, text, file, status: 'failed', sha256: { input: this.job_.input, settings: await this.hashOf(index, others) } };
    const withInlay = settings.inlay ?? false;
    try {
      const carved = await this.carveUntilItReads_(settings);
      if (looksAtPrint) await this.carveUntilItPrints_(carved);
      const { passed, failed, details } = await this.client_.describeRow(performance.now() - begun);
      if (!passed) return { row: { entry: { ...entry, ...details }, why: failed[0] }, withInlay };
      return { row: { entry: { ...entry, ...details, status: 'done' } }, withInlay };
    } catch (thrown) {
      if (isLost(thrown)) throw thrown;
      return { row: { entry, why: describeThrown(thrown) }, withInlay };
    }
  }

  /** Of what decides the row's file beside the model, as the manifest has it. @param {number} index @param {string} [others] */
  async hashOf(index, others = '') {
    const { model: { scaleToMm, upAxis }, centreMm } = this.job_;
    return sha256(await this.client_.batchRowToHash(index, { centre: centreMm, others: `${scaleToMm} ${upAxis}${others}` }));
  }

  /**
   * As asked for; where it does not read so, as the module proposes next.
   * @param {Settings} asked
   * @returns {Promise<Settings>}  it was carved with at last
   */
  async carveUntilItReads_(asked) {
    let settings = asked;
    for (let next = await this.carveOnce_(settings); next; ) {
      settings = { ...settings, [next.setting]: next.value };
      next = await this.carveOnce_(settings);
    }
    return settings;
  }

  /** Prints what is carved; if that barely reads, carves deeper until a print reads well, else goes back. @param {Settings} carved */
  async carveUntilItPrints_(carved) {
    const first = await this.client_.carving();
    let settings = carved;
    for (let result = await this.lookAtPrint_(); !result.passed && result.next; ) {
      settings = { ...settings, [result.next.setting]: result.next.value };
      const reads = await this.carveOnce_(settings).then((next) => next === null, (thrown) => {
        if (isLost(thrown)) throw thrown;
        return false;
      });
      result = reads ? await this.lookAtPrint_() : { passed: false, next: null };
      if (!result.passed && !result.next) await this.client_.useCarving(first);
    }
  }

  /** @param {Settings} settings @returns {Promise<import('../engine/types.js').ReadingResult['next']>}  what to carve with instead */
  async carveOnce_(settings) {
    await this.client_.configure(settings);
    await this.client_.placement();
    await this.client_.engrave({ signal: this.ended_.signal, onProgress: () => {} });
    if (this.ended_.signal.aborted) throw new EngineFailure(internal(message('engine-replaced')));
    const texts = await this.read_(await this.client_.readingPictures());
    return (await this.client_.setReadings(texts, kReaderName)).next;
  }

  /** @returns {Promise<import('../engine/types.js').ReadingResult>}  of the print; where none is asked for, it passes */
  async lookAtPrint_() {
    const job = await this.client_.printJob();
    if (!job) return { passed: true, next: null };
    const print = await this.print_(job, { signal: this.ended_.signal, onProgress: () => {} });
    if (!print) throw new EngineFailure(internal(message('engine-replaced')));
    const result = await this.client_.setPrintedReadings(await this.client_.carving(), await this.read_(print.pictures), print.facingDeg);
    if (!result) throw new EngineFailure(internal(message('engine-replaced')));
    return result;
  }
}

/** As Engine.exportModel() calls it. @param {string} file @param {boolean} withInlay */
export function formatOf(file, withInlay) {
  const extension = file.slice(file.lastIndexOf('.') + 1).toLowerCase();
  return extension === '3mf' && withInlay ? '3mf-inlay' : extension;
}
