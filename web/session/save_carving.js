// SPDX-License-Identifier: GPL-3.0-or-later
// Saves a carved model and its report, named after the model and the text that it was carved from.
import { downloadZip } from 'client-zip';
import { saveFile } from '../dom/save_file.js';
import { fileNameOf } from '../export/file_names.js';
import { messageWords } from '../i18n/message_words.js';
import { worded } from '../i18n/messages.js';

/** @typedef {import('./carving.js').Carved} Carved */

/** @param {Carved} carved @param {string} extension @param {string} [addition] */
const nameOf = ({ report, work }, extension, addition) =>
  fileNameOf({
    modelFile: work.source?.fileName ?? '',
    text: report.text,
    content: report.content,
    symbolMm: report.size.symbolMm,
    addition,
    extension,
  });

/**
 * Saves the model in the chosen format. An inlaid code as STL is a ZIP with the files that the command writes.
 * @param {Pick<import('../engine/client.js').EngineClient, 'exportModel' | 'exportFiles'>} client
 * @param {Carved} carved
 * @param {import('../ui/download_choice.js').Download} file
 */
export async function saveModel(client, carved, { format, slicer }) {
  const [extension, addition] = format.split('-');
  const { mark } = carved.report;
  if (mark === 'inlay' && format === 'stl') {
    const files = await client.exportFiles(nameOf(carved, extension), carved.number);
    const zip = downloadZip(files.map(({ name, bytes }) => ({ name, input: bytes })));
    saveFile(await zip.blob(), nameOf(carved, 'zip', mark));
    return;
  }
  const bytes = await client.exportModel(format, slicer, carved.number);
  const name = nameOf(carved, extension, mark === 'paint' ? mark : addition);
  saveFile(new Blob([bytes], { type: `model/${extension}` }), name);
}

/**
 * Returns a carved model as the source of a new one. A 3MF keeps its bodies and colours.
 * @param {Pick<import('../engine/client.js').EngineClient, 'exportModel'>} client
 * @param {Carved} carved
 * @returns {Promise<import('./model_session.js').Source>}
 */
export async function carvedSource(client, carved) {
  const format = carved.report.mark === 'shadow' ? '3mf' : '3mf-inlay';
  const bytes = await client.exportModel(format, 'any', carved.number);
  const { upAxis = /** @type {const} */ ('z'), credit = '' } = carved.work.source ?? {};
  return { bytes, fileName: nameOf(carved, '3mf'), scaleToMm: 0, upAxis, credit };
}

/**
 * Saves the maps of the surface, its light and every pass of the depth search.
 * @param {Pick<import('../engine/client.js').EngineClient, 'exportMaps'>} client
 * @param {Carved} carved
 */
export async function saveMaps(client, carved) {
  const bytes = await client.exportMaps(carved.number);
  saveFile(new Blob([bytes], { type: 'application/zip' }), nameOf(carved, 'npz', 'maps'));
}

/** @param {Carved} carved */
export async function saveReport(carved) {
  await messageWords.load();
  const json = JSON.stringify(worded(carved.report), null, 2);
  saveFile(new Blob([json], { type: 'application/json' }), nameOf(carved, 'json', 'report'));
}
