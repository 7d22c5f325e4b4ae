// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the finished files of a batch and its manifest as a ZIP. The ZIP is streamed: only a piece of it is in memory.
import { makeZip } from 'client-zip';
import { saveFile } from '../dom/save_file.js';
import { entryOf, kManifest } from './batch_store.js';

/** @typedef {import('./batch_store.js').BatchStore} BatchStore */
/** @typedef {import('./batch_store.js').Span} Span */
/** @typedef {Pick<import('../engine/client.js').EngineClient, 'manifestCsv'>} Client */
/** @typedef {(options: { suggestedName: string, types: object[] }) => Promise<FileSystemFileHandle>} Picker */

const kLinesAtOnce = 200;

/**
 * Yields the manifest's last line of each row, in row order, several lines at a time.
 * @param {Blob} manifest @param {Span[]} spans
 * @returns {AsyncGenerator<string>}
 */
async function* linesInOrder(manifest, spans) {
  for (let from = 0; from < spans.length; from += kLinesAtOnce) {
    const lines = await Promise.all(
      spans.slice(from, from + kLinesAtOnce).map(({ begin, end }) => manifest.slice(begin, end).text()),
    );
    yield lines.map((line) => `${line}\n`).join('');
  }
}

/**
 * Converts manifest lines to CSV.
 * @param {AsyncGenerator<string>} pieces
 * @param {Client} client
 * @returns {AsyncGenerator<string>}
 */
async function* asTable(pieces, client) {
  let withHeader = true;
  for await (const lines of pieces) {
    yield await client.manifestCsv(lines, withHeader);
    withHeader = false;
  }
}

/**
 * Yields the files of the ZIP: the manifest of all attempted rows as JSON lines and as CSV, and the models of finished
 * rows.
 * @param {BatchStore} store @param {Client} client
 */
export async function* archiveContents(store, client) {
  const { lines: manifest, spans } = await store.lastLines();
  /** @type {Set<string>} */ const there = new Set(); // files written; rows of a plate share one
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
 * Asks for a file and writes the ZIP to it; browsers without a file picker download it. Call this from a click handler.
 * @param {BatchStore} store @param {Client} client @param {string} name
 * @returns {Promise<boolean>}  false: the user cancelled
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
