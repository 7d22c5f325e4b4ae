// SPDX-License-Identifier: GPL-3.0-or-later
// The finished files of a batch and its manifest as a ZIP, written as it is read: no more than a piece of it is in memory.
import { makeZip } from 'client-zip';
import { saveFile } from '../dom/save_file.js';
import { entryOf, kManifest } from './batch_store.js';

/** @typedef {import('./batch_store.js').BatchStore} BatchStore */
/** @typedef {import('./batch_store.js').Span} Span */
/** @typedef {Pick<import('../engine/client.js').EngineClient, 'manifestCsv'>} Client */
/** @typedef {(options: { suggestedName: string, types: object[] }) => Promise<FileSystemFileHandle>} Picker */

const kLinesAtOnce = 200;

/**
 * The manifest's last line about each row, in the order of the rows, some at a time.
 * @param {Blob} manifest @param {Span[]} spans
 * @returns {AsyncGenerator<string>}
 */
async function* linesInOrder(manifest, spans) {
  for (let from = 0; from < spans.length; from += kLinesAtOnce) {
    const lines = await Promise.all(spans.slice(from, from + kLinesAtOnce).map(({ begin, end }) => manifest.slice(begin, end).text()));
    yield lines.map((line) => `${line}\n`).join('');
  }
}

/** @param {AsyncGenerator<string>} pieces @param {Client} client @returns {AsyncGenerator<string>} */
async function* asTable(pieces, client) {
  let withHeader = true;
  for await (const lines of pieces) {
    yield await client.manifestCsv(lines, withHeader);
    withHeader = false;
  }
}

/**
 * Everything in it: the models of rows that are done, and the manifest of all rows that were tried, as lines and as a table.
 * @param {BatchStore} store @param {Client} client
 */
export async function* archiveContents(store, client) {
  const { lines: manifest, spans } = await store.lastLines();
  /** @type {Set<string>} */ const there = new Set();  // of plates: rows share them
  yield { name: kManifest, input: linesInOrder(manifest, spans) };
  yield { name: 'manifest.csv', input: asTable(linesInOrder(manifest, spans), client) };
  for await (const lines of linesInOrder(manifest, spans)) {
    for (const line of lines.trimEnd().split('\n')) {
      const entry = entryOf(line);
      if (entry?.status !== 'done' || there.has(entry.file)) continue;
      const model = await store.file(entry.file);
      there.add(entry.file);
      if (model) yield { name: entry.file, input: model };
    }
  }
}

/**
 * Asks where it is to be saved, and writes it there; where browsers do not ask, it is a download. Must be called by a click.
 * @param {BatchStore} store @param {Client} client @param {string} name
 * @returns {Promise<boolean>}  false: the user did not want to
 */
export async function saveArchive(store, client, name) {
  const pick = /** @type {{ showSaveFilePicker?: Picker }} */ (window).showSaveFilePicker;
  if (!pick) {
    saveFile(await new Response(makeZip(archiveContents(store, client))).blob(), name);
    return true;
  }
  /** @type {FileSystemFileHandle} */ let target;
  try {
    target = await pick({ suggestedName: name, types: [{ accept: { 'application/zip': ['.zip'] } }] });
  } catch (thrown) {
    if (thrown instanceof DOMException && thrown.name === 'AbortError') return false;
    throw thrown;
  }
  await makeZip(archiveContents(store, client)).pipeTo(await target.createWritable());
  return true;
}
