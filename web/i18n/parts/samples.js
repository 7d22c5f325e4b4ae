// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the sample models, by their ids.

export const samples = {
  en: {
    bunny: 'Stanford bunny',
    owl: 'Owl',
    pawn: 'Chess pawn',
    'bumpy-sphere': 'Bumpy sphere',
    vase: 'Vase',
    star: 'Star',
    pyramid: 'Pyramid',
    saddle: 'Saddle',
    plate: 'Test plate',
  },
  de: {
    bunny: 'Stanford-Hase',
    owl: 'Eule',
    pawn: 'Schachbauer',
    'bumpy-sphere': 'Wellige Kugel',
    vase: 'Vase',
    star: 'Stern',
    pyramid: 'Pyramide',
    saddle: 'Sattel',
    plate: 'Prüfplatte',
  },
};
