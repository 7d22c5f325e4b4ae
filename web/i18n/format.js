// SPDX-License-Identifier: GPL-3.0-or-later
// Formats numbers for the current language.
import { currentLanguage } from './catalogue.js';

/** @param {number} value @param {number} [digits] after the decimal point */
export const formatNumber = (value, digits = 0) =>
  value.toLocaleString(currentLanguage(), { minimumFractionDigits: digits, maximumFractionDigits: digits });

/** Returns the number of useful decimals for a length. @param {number} mm */
const digitsOf = (mm) => (mm < 10 ? 2 : mm < 1000 ? 1 : 0);

/** @param {number} mm */
export const formatMm = (mm) => `${formatNumber(mm, digitsOf(mm))}\u00a0mm`;

/** Formats width × depth × height. @param {readonly number[]} mm */
export const formatBox = (mm) => `${mm.map((edge) => formatNumber(edge, edge < 10 ? 2 : 1)).join(' × ')}\u00a0mm`;

/**
 * Formats a number as a person would write it, without needless digits.
 * @param {number} value
 * @param {number} [digits] at most
 */
export const formatPlain = (value, digits = 2) =>
  value.toLocaleString(currentLanguage(), { maximumFractionDigits: digits });

/** Formats a share with a space, as all texts do. @param {number} share */
export const formatPercent = (share) => `${formatNumber(100 * share)}\u00a0%`;

/** @param {number} ms */
export const formatSeconds = (ms) => `${formatNumber(ms / 1000, 1)}\u00a0s`;
