// SPDX-License-Identifier: GPL-3.0-or-later

/** @typedef {'en' | 'de'} Language */

/** @type {readonly Language[]} */
export const kLanguages = ['en', 'de'];
