// SPDX-License-Identifier: GPL-3.0-or-later

export const inspector = {
  en: {
    engraved: 'Engraved with these settings of the inspector instead of yours: {overrides}.',
    figures: 'What it shows, as text',
  },
  de: {
    engraved: 'Mit diesen Einstellungen des Inspektors statt der eigenen graviert: {overrides}.',
    figures: 'Was er zeigt, als Text',
  },
};
