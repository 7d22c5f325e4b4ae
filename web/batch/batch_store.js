// SPDX-License-Identifier: GPL-3.0-or-later
// Stores a batch in a folder of the browser: its record, list and model, the manifest, and the finished files. A
// row's files are written before its line.
import { messageWords } from '../i18n/message_words.js';
import { plainHintOf, plainSentenceOf } from '../i18n/messages.js';

/** @typedef {import('../storage/folder.js').Folder} Folder */
/** @typedef {import('../storage/last_work.js').Work} Work */
/** @typedef {import('./row_engine.js').CarvedUnit} CarvedUnit */
/** @typedef {import('../engine/types.js').ManifestEntry} ManifestEntry */

/**
 * @typedef {object} BatchRecord
 * @property {Omit<Work, 'bytes'>} work  state of the page's controls; the model's bytes are in a file
 * @property {number} rows
 * @property {number} printEvery
 * @property {[number, number, number]} centreMm
 * @property {import('../engine/types.js').BatchRequest} request
 * @property {string} input   SHA-256 of the model's file
 * @property {string} settingsOfFirst  hash of the first row's settings; differs if the program changed
 */

export const kManifest = 'manifest.jsonl';
const kRecord = 'batch.json',
  kModel = 'model',
  kList = 'list';
const kFormat = 2; // version of the stored data; versions other than this and 1 are ignored

export class BatchStore {
  /** @param {Pick<Folder, 'write' | 'append' | 'copy' | 'read' | 'remove'>} folder */
  constructor(folder) {
    this.folder_ = folder;
  }

  /**
   * Begins a batch; removes the previous one.
   * @param {BatchRecord} record
   * @param {{ model: Uint8Array, list: Uint8Array }} files  remain usable
   */
  async begin(record, { model, list }) {
    await this.folder_.remove();
    await this.folder_.write(kModel, model.slice());
    await this.folder_.write(kList, list.slice());
    // Written last: the record makes the batch valid.
    await this.folder_.write(kRecord, new TextEncoder().encode(JSON.stringify({ ...record, format: kFormat })));
  }

  /** Reads the record. @returns {Promise<BatchRecord | undefined>}  undefined: there is no batch */
  async recall() {
    const record = await parsed(await this.folder_.read(kRecord).catch(() => undefined));
    if (record?.format === 1) return { ...record, request: record.wanted };
    return record?.format === kFormat ? record : undefined;
  }

  /** Reads the model and the list. @returns {Promise<{ model: Uint8Array, list: Uint8Array }>} */
  async files() {
    const [model, list] = await Promise.all(
      [kModel, kList].map(async (name) => (await this.folder_.read(name))?.arrayBuffer()),
    );
    return { model: new Uint8Array(model ?? []), list: new Uint8Array(list ?? []) };
  }

  /**
   * Writes the rows' files, then their manifest lines.
   * @param {CarvedUnit} carved
   * @param {(entry: ManifestEntry) => string} lineOf
   * @returns {Promise<string>}  the lines
   */
  async save({ rows, files }, lineOf) {
    for (const { name, bytes } of files) await this.folder_.write(name, bytes);
    await messageWords.load();
    /** @type {string[]} */ const lines = [];
    for (const { entry, why } of rows) {
      const hint = why ? plainHintOf(why) : '';
      const reason = why ? plainSentenceOf(why) + (hint ? ` (${hint})` : '') : '';
      const line = lineOf({ ...entry, ...(why && { reason }) });
      await this.folder_.append(kManifest, line);
      lines.push(line);
    }
    return lines.join('\n');
  }

  /** Opens the manifest. @returns {Promise<Blob>}  empty if there is none; unusable after the next row is saved */
  async manifest() {
    return (await this.folder_.read(kManifest)) ?? new Blob();
  }

  /** Returns a copy of the manifest that stays. */
  async snapshot() {
    return new Blob([await this.folder_.copy(kManifest)]);
  }

  /** Opens a row's file. @param {string} name */
  file(name) {
    return this.folder_.read(name);
  }

  discard() {
    return this.folder_.remove();
  }
}

/** @param {File | undefined} file @returns {Promise<any>}  undefined: no JSON */
async function parsed(file) {
  try {
    return file && JSON.parse(await file.text());
  } catch {
    return undefined;
  }
}

/**
 * Lets a tracker read a manifest, with only a piece of it in memory.
 * @param {Blob} manifest
 * @param {Pick<import('./tracker.js').Tracker, 'readManifest'>} tracker
 * @param {{ restores: boolean }} options  `restores`: the lines set the states of the rows
 */
export async function readManifest(manifest, tracker, { restores }) {
  tracker.readManifest(new Uint8Array(), true, restores);
  const reader = manifest.stream().getReader();
  for (let piece = await reader.read(); !piece.done; piece = await reader.read())
    tracker.readManifest(piece.value, false, restores);
}
