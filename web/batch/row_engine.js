// SPDX-License-Identifier: GPL-3.0-or-later
// Carves rows of a batch in its own worker, which gets model, centre and list once.
import { EngineClient } from '../engine/client.js';
import { EngineFailure, describeThrown, internal } from '../engine/engine_error.js';
import { makeHiddenCanvas } from '../engine/hidden_canvas.js';
import { message } from '../engine/message.js';
import { Carver, isLost } from './carver.js';
import { sha256 } from './hashes.js';

/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {import('../engine/types.js').ManifestEntry} ManifestEntry */
/** @typedef {import('../engine/message.js').Message} Message */

/**
 * The data that all rows share.
 * @typedef {object} BatchJob
 * @property {{ bytes: Uint8Array, fileName: string, scaleToMm: number, upAxis: import('../engine/types.js').UpAxis }} model
 * @property {string} input  SHA-256 of the model's file
 * @property {[number, number, number]} centreMm
 * @property {Uint8Array} list  empty if there is none
 * @property {import('../engine/types.js').WantedBatch} wanted
 */

/**
 * The result of a row; `why`: the error if it failed.
 * @typedef {{ entry: ManifestEntry, why?: Message }} CarvedRow
 * The result of one file: of one row, or of all rows on a plate. `bytes`: absent if all failed.
 * @typedef {{ rows: CarvedRow[], file: string, bytes?: Uint8Array<ArrayBuffer> }} CarvedUnit
 */

/** Makes an engine with an invisible canvas. A failure outside any verb ends it. */
export function makeHiddenClient() {
  /** @type {EngineClient} */ const client = new EngineClient({
    makeCanvas: makeHiddenCanvas,
    onEvent: ({ event }) => {
      if (event === 'contextlost' || event === 'failure') client.end();
    },
    draws: false,
  });
  return client;
}

export class RowEngine {
  /** @param {BatchJob} job @param {import('./carver.js').CarverParts} [parts] */
  constructor(job, parts = { client: makeHiddenClient() }) {
    this.job_ = job;
    this.client_ = parts.client;
    this.carver_ = new Carver(parts);
    this.ended_ = new AbortController();
  }

  /** Starts the engine with the data that all rows share. */
  async start() {
    const { model, centreMm, list, wanted } = this.job_;
    const { problems } = await this.client_.start();
    if (problems.length > 0) throw new EngineFailure(internal(message('no-graphics', { why: { cause: problems[0] } })));
    await this.client_.show({ upAxis: model.upAxis });
    await this.client_.loadModel(model.bytes, model.fileName, model.scaleToMm);
    await this.client_.planBatch(list, wanted);
    await this.client_.setCentre({ mm: centreMm });
  }

  /** Ends even a busy engine. Its pending work is rejected with an error that `isLost` recognises. */
  end() {
    this.ended_.abort(new EngineFailure(internal(message('engine-replaced'))));
    this.client_.end();
  }

  /**
   * Carves one row, or all rows of a plate.
   * @param {import('../engine/types.js').RowToCarve[]} unit
   * @returns {Promise<CarvedUnit>}
   */
  async carve(unit) {
    const isPlate = this.job_.wanted.perPlate > 0;
    const pending = await this.pending(unit[0].index);
    /** @type {CarvedRow[]} */ const rows = [];
    /** @type {Uint8Array<ArrayBuffer> | undefined} */ let bytes;
    for (const [place, { index, print }] of unit.entries()) {
      const carved = await this.carveRow_(index, pending[place], print);
      const { row, withInlay } = carved;
      const { id, status, file } = row.entry;
      rows.push(row);
      if (status === 'done' && isPlate) await this.client_.addToPlate(place, id, unit.length);
      else if (status === 'done')
        bytes = await this.written_([row], () => this.client_.exportModel(formatOf(file, withInlay)));
    }
    const [
        {
          entry: { file },
        },
      ] = rows,
      done = rows.filter(({ entry }) => entry.status === 'done');
    if (isPlate && done.length > 0) bytes = await this.written_(done, () => this.client_.exportPlate(file));
    return { rows, file, ...(bytes && { bytes }) };
  }

  /**
   * Writes the file of finished rows. If that fails, the rows have failed.
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
      for (const row of rows)
        Object.assign(row, { entry: { ...row.entry, status: 'failed' }, why: describeThrown(thrown) });
      return undefined;
    }
  }

  /**
   * Carves one row.
   * @param {number} index
   * @param {ManifestEntry} entry  the row before it is carved
   * @param {boolean} looksAtPrint
   * @returns {Promise<{ row: CarvedRow, withInlay: boolean }>}
   */
  async carveRow_(index, entry, looksAtPrint) {
    const begun = performance.now();
    const { settings: own } = await this.client_.batchRow(index);
    const settings = /** @type {Settings & { inlay?: boolean }} */ ({ ...this.job_.wanted.settings, ...own });
    const withInlay = settings.inlay ?? false;
    try {
      await this.carver_.carve(settings, looksAtPrint, { signal: this.ended_.signal, onProgress: () => {} });
      const { passed, failed, details } = await this.client_.describeRow(performance.now() - begun);
      if (!passed) return { row: { entry: { ...entry, ...details }, why: failed[0] }, withInlay };
      return { row: { entry: { ...entry, ...details, status: 'done' } }, withInlay };
    } catch (thrown) {
      if (isLost(thrown)) throw thrown;
      return { row: { entry, why: describeThrown(thrown) }, withInlay };
    }
  }

  /**
   * Returns the rows of a unit before they are carved, with the hashes of their inputs.
   * @param {number} index  of any of its rows
   * @returns {Promise<ManifestEntry[]>}
   */
  async pending(index) {
    const {
      model: { scaleToMm, upAxis },
      centreMm: centre,
      input,
    } = this.job_;
    const others = `${scaleToMm} ${upAxis}`;
    /** @param {'plate' | 'rows'} of @param {string[]} mates */
    const hashesOf = async (of, mates) =>
      Promise.all((await this.client_.unitTexts(index, { of, centre, others, mates })).map(sha256));
    return this.client_.unitEntries(index, { input, settings: await hashesOf('rows', await hashesOf('plate', [])) });
  }
}

/** Returns a file's format by the names of Engine.exportModel(). @param {string} file @param {boolean} withInlay */
export function formatOf(file, withInlay) {
  const extension = file.slice(file.lastIndexOf('.') + 1).toLowerCase();
  return extension === '3mf' && withInlay ? '3mf-inlay' : extension;
}
