// SPDX-License-Identifier: GPL-3.0-or-later
// All that is kept of a batch, in a folder of the browser: what it was begun with, its list and its model, the manifest line by
// line, and the finished files. A row counts as done by the manifest's last line about it; its file was written before.
import { messageWords } from '../i18n/message_words.js';
import { hintOf, sentenceOf } from '../i18n/messages.js';

/** @typedef {import('../storage/folder.js').Folder} Folder */
/** @typedef {import('../storage/last_work.js').Work} Work */
/** @typedef {import('./row_engine.js').CarvedUnit} CarvedUnit */
/** @typedef {import('./row_states.js').RowStates} RowStates */
/** @typedef {import('../engine/types.js').ManifestEntry} ManifestEntry */

/**
 * @typedef {object} BatchRecord
 * @property {Omit<Work, 'bytes'>} work  what the page's controls held; the model's bytes stand in a file
 * @property {number} rows
 * @property {number} printEvery
 * @property {[number, number, number]} centreMm
 * @property {import('../engine/types.js').WantedBatch} wanted
 * @property {string} input   SHA-256 of the model's file
 * @property {string} settingsOfFirst  hash of the first row's settings: another version of the program has another one
 */

/** Where a line of the manifest stands: from which byte to which. @typedef {{ begin: number, end: number }} Span */

export const kManifest = 'manifest.jsonl';
const kRecord = 'batch.json', kModel = 'model', kList = 'list';
const kFormat = 1;  // of what is kept; another one is not gone on with
const kLineEnd = 10;

export class BatchStore {
  /** @param {Pick<Folder, 'write' | 'append' | 'copy' | 'read' | 'remove'>} folder */
  constructor(folder) {
    this.folder_ = folder;
  }

  /** In place of the batch before it. @param {BatchRecord} record @param {{ model: Uint8Array, list: Uint8Array }} files  stay usable */
  async begin(record, { model, list }) {
    await this.folder_.remove();
    await this.folder_.write(kModel, model.slice());
    await this.folder_.write(kList, list.slice());
    await this.folder_.write(kRecord, new TextEncoder().encode(JSON.stringify({ ...record, format: kFormat })));  // last: then it counts
  }

  /** @returns {Promise<BatchRecord | undefined>}  none: there is no batch */
  async recall() {
    const record = await parsed(await this.folder_.read(kRecord).catch(() => undefined));
    return record?.format === kFormat ? record : undefined;
  }

  /** What the batch was begun with. @returns {Promise<{ model: Uint8Array, list: Uint8Array }>} */
  async files() {
    const [model, list] = await Promise.all([kModel, kList].map(async (name) => (await this.folder_.read(name))?.arrayBuffer()));
    return { model: new Uint8Array(model ?? []), list: new Uint8Array(list ?? []) };
  }

  /**
   * The file of the rows, then their lines.
   * @param {CarvedUnit} carved
   * @param {(entry: ManifestEntry) => Promise<string>} lineOf
   * @returns {Promise<string[]>}  why each row failed, in words; '' if it did not
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

  /** What the manifest says of the rows. @param {RowStates} states  none is done yet */
  async readStates(states) {
    const file = await this.folder_.read(kManifest);
    if (!file) return;
    for await (const { text } of linesOf(file)) {
      const entry = entryOf(text);
      if (entry) states.set(entry.number - 1, entry.status, entry.reason);
    }
  }

  /** The manifest as it is now, and where the last line about each row stands, in the order of the rows. @returns {Promise<{ lines: Blob, spans: Span[] }>} */
  async lastLines() {
    const lines = new Blob([await this.folder_.copy(kManifest)]);
    /** @type {Map<number, Span>} */ const last = new Map();
    for await (const { text, ...span } of linesOf(lines)) {
      const entry = entryOf(text);
      if (entry) last.set(entry.number, span);
    }
    return { lines, spans: [...last].sort(([a], [b]) => a - b).map(([, span]) => span) };
  }

  /** A row's file. @param {string} name */
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

/** @param {string} line @returns {ManifestEntry | undefined}  none: it was cut off, as by a page that was closed */
export function entryOf(line) {
  try {
    const entry = JSON.parse(line);
    return Number.isInteger(entry.number) && ['done', 'failed'].includes(entry.status) ? entry : undefined;
  } catch {
    return undefined;
  }
}

/**
 * Line by line, with little of the file in memory.
 * @param {Blob} file
 * @returns {AsyncGenerator<Span & { text: string }>}
 */
export async function* linesOf(file) {
  const decoder = new TextDecoder();
  const reader = file.stream().getReader();
  let rest = new Uint8Array(), begin = 0;
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
