// SPDX-License-Identifier: GPL-3.0-or-later
// What the pages beside the app have in common: language, appearance, and being kept on the device.
import { keepOffline } from '../offline/updates.js';
import { Theme, offerLanguages } from '../ui/preferences.js';

/**
 * @param {(dark: boolean) => void} [onTheme]
 * @returns {Theme}
 */
export function openArticle(onTheme = () => {}) {
  offerLanguages();
  const theme = new Theme(onTheme);
  if (import.meta.env.PROD) void keepOffline(() => {});  // the app offers new versions
  return theme;
}
