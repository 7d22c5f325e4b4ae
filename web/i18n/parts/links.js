// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the links between the app and the articles.

export const links = {
  en: {
    toApp: 'Open the app',
    toMethod: 'How it works',
    toGuide: 'How to print it',
    toStudy: 'Measurements',
    toGallery: 'Gallery',
    source: 'Source code',
    issues: 'Report a problem',
  },
  de: {
    toApp: 'Zur App',
    toMethod: 'So funktioniert es',
    toGuide: 'So wird es gedruckt',
    toStudy: 'Messungen',
    toGallery: 'Galerie',
    source: 'Quelltext',
    issues: 'Problem melden',
  },
};
