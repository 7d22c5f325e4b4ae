// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the finished files of a batch and its manifest as a ZIP. The ZIP is streamed: only a piece of it is in memory.
import { makeZip } from 'client-zip';
import { saveFile } from '../dom/save_file.js';
import { kManifest, readManifest } from './batch_store.js';

/** @typedef {import('./batch_store.js').BatchStore} BatchStore */
/** @typedef {Pick<import('./tracker.js').Tracker, 'readManifest' | 'manifestSpans' | 'manifestCsv'>} Tracker */
/** @typedef {(options: { suggestedName: string, types: object[] }) => Promise<FileSystemFileHandle>} Picker */

const kLinesAtOnce = 200;

/**
 * Yields the manifest's last line of each row, in row order, several lines at a time.
 * @param {Blob} manifest @param {Tracker} tracker  has read the manifest
 * @returns {AsyncGenerator<string>}
 */
async function* linesInOrder(manifest, tracker) {
  /** @type {number | null} */ let from = 1;
  while (from !== null) {
    const { spans, next } = tracker.manifestSpans(from, kLinesAtOnce);
    const lines = await Promise.all(spans.map(([begin, end]) => manifest.slice(begin, end).text()));
    if (lines.length > 0) yield lines.map((line) => `${line}\n`).join('');
    from = next;
  }
}

/**
 * Converts manifest lines to CSV.
 * @param {AsyncGenerator<string>} pieces
 * @param {Tracker} tracker
 * @returns {AsyncGenerator<string>}
 */
async function* asTable(pieces, tracker) {
  let withHeader = true;
  for await (const lines of pieces) {
    yield tracker.manifestCsv(lines, withHeader);
    withHeader = false;
  }
}

/**
 * Yields the files of the ZIP: the manifest of all attempted rows as JSON lines and as CSV, and the files of finished
 * rows.
 * @param {BatchStore} store @param {Tracker} tracker
 */
export async function* archiveContents(store, tracker) {
  const manifest = await store.snapshot();
  await readManifest(manifest, tracker, { restores: false });
  /** @type {Set<string>} */ const there = new Set(); // files written; rows of a plate share one
  yield { name: kManifest, input: linesInOrder(manifest, tracker) };
  yield { name: 'manifest.csv', input: asTable(linesInOrder(manifest, tracker), tracker) };
  for await (const lines of linesInOrder(manifest, tracker)) {
    for (const line of lines.trimEnd().split('\n')) {
      /** @type {import('../engine/types.js').ManifestEntry} */ const { status, file, second } = JSON.parse(line);
      if (status !== 'done') continue;
      for (const name of second === undefined ? [file] : [file, second]) {
        if (there.has(name)) continue;
        there.add(name);
        const input = await store.file(name);
        if (input) yield { name, input };
      }
    }
  }
}

/**
 * Asks for a file and writes the ZIP to it; browsers without a file picker download it. Call this from a click handler.
 * @param {BatchStore} store @param {Tracker} tracker @param {string} name
 * @returns {Promise<boolean>}  false: the user cancelled
 */
export async function saveArchive(store, tracker, name) {
  const pick = /** @type {{ showSaveFilePicker?: Picker }} */ (window).showSaveFilePicker;
  if (!pick) {
    saveFile(await new Response(makeZip(archiveContents(store, tracker))).blob(), name);
    return true;
  }
  /** @type {FileSystemFileHandle} */ let target;
  try {
    target = await pick({ suggestedName: name, types: [{ accept: { 'application/zip': ['.zip'] } }] });
  } catch (thrown) {
    if (thrown instanceof DOMException && thrown.name === 'AbortError') return false;
    throw thrown;
  }
  await makeZip(archiveContents(store, tracker)).pipeTo(await target.createWritable());
  return true;
}
