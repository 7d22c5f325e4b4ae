// SPDX-License-Identifier: GPL-3.0-or-later
// The gallery's codes and their pictures, as kept in study/gallery/pictures.
import { readFileSync, readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { kEnglish } from '../../web/i18n/locales.js';

/**
 * One code, as written by make_gallery.cpp; its pictures are WebP files.
 * @typedef {object} Exhibit
 * @property {'default' | 'lamp' | 'pattern'} kind
 * @property {Record<string, string>} settings  that differ from the defaults, as in the page's address
 * @property {string} designed   file
 * @property {string} printed    file
 * @property {number} depthMm    mean
 * @property {number} moduleMm
 * @property {number} reads         tries that decode, of the design
 * @property {number} printedReads  of the print
 * @property {number} tries
 */
/** @typedef {{ sample: string, exhibits: Exhibit[] }} Room */

export const kPicturesFolder = fileURLToPath(new URL('pictures', import.meta.url));
export const kPatterns = ['none', 'square', 'thin-plus', 'diamond', 'thick-plus'];
export const kFinders = ['none', 'as-modules', 'diamond', 'thick-plus', 'thick-plus-sharp'];

/** The samples in the page's order. */
export const kSamples = Object.keys(kEnglish.page.samples);

/** Samples with every pattern: a curved and a flat one. */
export const kPatterned = ['bunny', 'plate'];

/** @returns {Room[]}  in the order of the page's samples */
export const readGallery = () =>
  readdirSync(kPicturesFolder)
    .filter((file) => file.endsWith('.json'))
    .map((file) => JSON.parse(readFileSync(`${kPicturesFolder}/${file}`, 'utf8')))
    .sort((a, b) => kSamples.indexOf(a.sample) - kSamples.indexOf(b.sample));
