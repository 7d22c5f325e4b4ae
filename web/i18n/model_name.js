// SPDX-License-Identifier: GPL-3.0-or-later
import { textOr } from './catalogue.js';

/**
 * Returns the name of a model as the page shows it: of a sample in the current language, else of the file.
 * @param {{ sampleId?: string, fileName: string }} model
 */
export const modelName = ({ sampleId, fileName }) =>
  sampleId === undefined ? fileName : textOr('samples', sampleId, fileName);
