// SPDX-License-Identifier: GPL-3.0-or-later

/** @param {number} value @param {number} [digits] after the point */
export const formatNumber = (value, digits = 0) =>
  value.toLocaleString('en', { minimumFractionDigits: digits, maximumFractionDigits: digits });

/** A length with as many digits as it is worth. @param {number} mm */
export const formatMm = (mm) => `${formatNumber(mm, mm < 10 ? 2 : mm < 1000 ? 1 : 0)} mm`;

/** @param {number} ms */
export const formatSeconds = (ms) => `${formatNumber(ms / 1000, 1)} s`;
