// SPDX-License-Identifier: GPL-3.0-or-later
// The common part of all articles: language, appearance and offline use.
import { keepOffline } from '../offline/updates.js';
import { Theme, offerLanguages } from '../ui/preferences.js';

/**
 * @param {(dark: boolean) => void} [onTheme]
 * @returns {Theme}
 */
export function openArticle(onTheme = () => {}) {
  offerLanguages();
  const theme = new Theme(onTheme);
  if (import.meta.env.PROD) void keepOffline(() => {}); // only the app offers new versions
  return theme;
}
