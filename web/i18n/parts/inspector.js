// SPDX-License-Identifier: GPL-3.0-or-later

export const inspector = {
  en: {
    engraved: 'Engraved with the inspector’s settings instead of these: {overrides}.',
  },
  de: {
    engraved: 'Mit den Einstellungen des Inspektors statt dieser graviert: {overrides}.',
  },
};
