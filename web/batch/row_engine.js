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
/** @typedef {import('../engine/types.js').NamedFile} NamedFile */
/** @typedef {import('../engine/message.js').Message} Message */

/**
 * The data that all rows share.
 * @typedef {object} BatchJob
 * @property {{ bytes: Uint8Array, fileName: string, scaleToMm: number, upAxis: import('../engine/types.js').UpAxis }} model
 * @property {string} input  SHA-256 of the model's file
 * @property {[number, number, number]} centreMm
 * @property {Uint8Array} list  empty if there is none
 * @property {import('../engine/types.js').BatchRequest} request
 */

/**
 * The result of a row; `why`: the error if it failed.
 * @typedef {{ entry: ManifestEntry, why?: Message }} CarvedRow
 * The result of one row, or of all rows on a plate. `files`: none if all rows failed.
 * @typedef {{ rows: CarvedRow[], files: NamedFile[] }} CarvedUnit
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
    const { model, centreMm, list, request } = this.job_;
    const { problems } = await this.client_.start();
    if (problems.length > 0) throw new EngineFailure(internal(message('no-graphics', { why: { cause: problems[0] } })));
    await this.client_.show({ upAxis: model.upAxis });
    await this.client_.loadModel(model.bytes, model.fileName, model.scaleToMm);
    await this.client_.planBatch(list, request);
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
   * @param {(rows: number) => void} onProgress  gets how many rows are carved; 0.5: half of the first one
   * @returns {Promise<CarvedUnit>}
   */
  async carve(unit, onProgress) {
    const isPlate = this.job_.request.perPlate > 0;
    const pending = await this.pending(unit[0].index);
    /** @type {CarvedRow[]} */ const rows = [];
    /** @type {NamedFile[]} */ let files = [];
    for (const [place, { index, print }] of unit.entries()) {
      const row = await this.carveRow_(index, pending[place], print, (fraction) => onProgress(place + fraction));
      const { id, status, file } = row.entry;
      rows.push(row);
      if (status === 'done' && isPlate) await this.client_.addToPlate(place, id, unit.length);
      else if (status === 'done') files = await this.written_([row], () => this.client_.exportFiles(file));
    }
    const [{ entry }] = rows,
      done = rows.filter(({ entry: { status } }) => status === 'done');
    if (isPlate && done.length > 0)
      files = await this.written_(done, async () => [
        { name: entry.file, bytes: await this.client_.exportPlate(entry.file) },
      ]);
    return { rows, files };
  }

  /**
   * Writes the files of finished rows. If that fails, the rows have failed.
   * @param {CarvedRow[]} rows
   * @param {() => Promise<NamedFile[]>} write  the rows' file, and a second file if there is one
   */
  async written_(rows, write) {
    try {
      const files = await write();
      const [output, second] = await Promise.all(files.map(({ bytes }) => sha256(bytes)));
      for (const { entry } of rows) {
        Object.assign(entry.sha256, { output, ...(second && { second }) });
        if (second) entry.second = files[1].name; // an open mark shows only now whether there is one
      }
      return files;
    } catch (thrown) {
      if (isLost(thrown)) throw thrown;
      for (const row of rows)
        Object.assign(row, { entry: { ...row.entry, status: 'failed' }, why: describeThrown(thrown) });
      return [];
    }
  }

  /**
   * Carves one row.
   * @param {number} index
   * @param {ManifestEntry} entry  the row before it is carved
   * @param {boolean} looksAtPrint
   * @param {(fraction: number) => void} onProgress
   * @returns {Promise<CarvedRow>}
   */
  async carveRow_(index, entry, looksAtPrint, onProgress) {
    const begun = performance.now();
    const { settings: own } = await this.client_.batchRow(index);
    const settings = /** @type {Settings} */ ({ ...this.job_.request.settings, ...own });
    try {
      await this.carver_.carve(settings, looksAtPrint, {
        signal: this.ended_.signal,
        onProgress: ({ fraction }) => onProgress(fraction),
      });
      const { passed, failed, details } = await this.client_.describeRow(performance.now() - begun);
      if (!passed) return { entry: { ...entry, ...details }, why: failed[0] };
      return { entry: { ...entry, ...details, status: 'done' } };
    } catch (thrown) {
      if (isLost(thrown)) throw thrown;
      return { entry, why: describeThrown(thrown) };
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
