// SPDX-License-Identifier: GPL-3.0-or-later
// Stores a batch in a folder of the browser: its record, list and model, the manifest, and the finished files. The last
// manifest line of a row gives its state. A row's file is written before its line.
import { messageWords } from '../i18n/message_words.js';
import { hintOf, sentenceOf } from '../i18n/messages.js';

/** @typedef {import('../storage/folder.js').Folder} Folder */
/** @typedef {import('../storage/last_work.js').Work} Work */
/** @typedef {import('./row_engine.js').CarvedUnit} CarvedUnit */
/** @typedef {import('./row_states.js').RowStates} RowStates */
/** @typedef {import('../engine/types.js').ManifestEntry} ManifestEntry */

/**
 * @typedef {object} BatchRecord
 * @property {Omit<Work, 'bytes'>} work  state of the page's controls; the model's bytes are in a file
 * @property {number} rows
 * @property {number} printEvery
 * @property {[number, number, number]} centreMm
 * @property {import('../engine/types.js').WantedBatch} wanted
 * @property {string} input   SHA-256 of the model's file
 * @property {string} settingsOfFirst  hash of the first row's settings; differs if the program changed
 */

/** Byte range of a manifest line. @typedef {{ begin: number, end: number }} Span */

export const kManifest = 'manifest.jsonl';
const kRecord = 'batch.json',
  kModel = 'model',
  kList = 'list';
const kFormat = 1; // version of the stored data; other versions are ignored
const kLineEnd = 10;

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
   * Writes the rows' file, then their manifest lines.
   * @param {CarvedUnit} carved
   * @param {(entry: ManifestEntry) => Promise<string>} lineOf
   * @returns {Promise<string[]>}  each row's failure reason in words; '' if none
   */
  async save({ rows, file, bytes }, lineOf) {
    if (bytes) await this.folder_.write(file, bytes);
    await messageWords.come();
    /** @type {string[]} */ const reasons = [];
    for (const { entry, why } of rows) {
      const hint = why ? hintOf(why) : '';
      const reason = why ? sentenceOf(why) + (hint ? ` (${hint})` : '') : '';
      await this.folder_.append(kManifest, await lineOf({ ...entry, ...(why && { reason }) }));
      reasons.push(reason);
    }
    return reasons;
  }

  /** Reads the row states from the manifest. @param {RowStates} states  all waiting */
  async readStates(states) {
    const file = await this.folder_.read(kManifest);
    if (!file) return;
    for await (const { text } of linesOf(file)) {
      const entry = entryOf(text);
      if (entry) states.set(entry.number - 1, entry.status, entry.reason);
    }
  }

  /**
   * Returns a snapshot of the manifest and the byte range of each row's last line, in row order.
   * @returns {Promise<{ lines: Blob, spans: Span[] }>}
   */
  async lastLines() {
    const lines = new Blob([await this.folder_.copy(kManifest)]);
    /** @type {Map<number, Span>} */ const last = new Map();
    for await (const { text, ...span } of linesOf(lines)) {
      const entry = entryOf(text);
      if (entry) last.set(entry.number, span);
    }
    return { lines, spans: [...last].sort(([a], [b]) => a - b).map(([, span]) => span) };
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
 * Parses a manifest line.
 * @param {string} line
 * @returns {ManifestEntry | undefined}  undefined: cut off by a closing page
 */
export function entryOf(line) {
  try {
    const entry = JSON.parse(line);
    return Number.isInteger(entry.number) && ['done', 'failed'].includes(entry.status) ? entry : undefined;
  } catch {
    return undefined;
  }
}

/**
 * Yields a file line by line, with only a piece of it in memory.
 * @param {Blob} file
 * @returns {AsyncGenerator<Span & { text: string }>}
 */
export async function* linesOf(file) {
  const decoder = new TextDecoder();
  const reader = file.stream().getReader();
  let rest = new Uint8Array(),
    begin = 0;
  for (;;) {
    const { value, done } = await reader.read();
    if (done) break;
    const bytes = joined(rest, value);
    let from = 0;
    for (let end = bytes.indexOf(kLineEnd); end >= 0; end = bytes.indexOf(kLineEnd, from)) {
      yield { text: decoder.decode(bytes.subarray(from, end)), begin: begin + from, end: begin + end };
      from = end + 1;
    }
    begin += from;
    rest = bytes.slice(from);
  }
  if (rest.length > 0) yield { text: decoder.decode(rest), begin, end: begin + rest.length };
}

/** @param {Uint8Array<ArrayBuffer>} a @param {Uint8Array<ArrayBuffer>} b */
function joined(a, b) {
  if (a.length === 0) return b;
  const both = new Uint8Array(a.length + b.length);
  both.set(a);
  both.set(b, a.length);
  return both;
}
