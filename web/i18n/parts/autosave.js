// SPDX-License-Identifier: GPL-3.0-or-later

export const autosave = {
  en: {
    newVersion: 'A new version is ready.',
    reload: 'Reload',
    later: 'Later',
    continueWith: 'Continue with {name}?',
    continue: 'Continue',
    discard: 'Discard',
  },
  de: {
    newVersion: 'Eine neue Version ist da.',
    reload: 'Neu laden',
    later: 'Später',
    continueWith: 'Mit {name} weitermachen?',
    continue: 'Weitermachen',
    discard: 'Verwerfen',
  },
};
