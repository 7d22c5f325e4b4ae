// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/symbol_flips.js.

export const symbolFlips = {
  en: {
    symbolFlipsAlt:
      'Two plots, for the search of 2019 and for ours: mean depth without flips, with the flips of Peng 2019 and with ours, a marker for each model.',
    symbolFlipsShown:
      'Mean depth of whole modules at error correction H, when dark modules in wide dark areas are flipped to light and decoders restore them.',
    flipsCount:
      'Peng 2019 flips {peng} modules to light and QRelief {ours}, as QRelief spends more of the error correction.',
    flipsSaved:
      'With the search of 2019 these flips make codes shallower by {peng2019} % and {ours2019} %, with our search by {peng} % and {ours} %, in the median.',
    flipsReads:
      'As printed the reads change by at most {tries}, in the median, but the spent error correction no longer protects against dirt and damage.',
  },
  de: {
    symbolFlipsAlt:
      'Zwei Diagramme, zur Suche von 2019 und zu unserer: mittlere Tiefe ohne Umkehren, mit dem von Peng 2019 und mit unserem, ein Zeichen je Modell.',
    symbolFlipsShown:
      'Mittlere Tiefe ganzer Module mit Fehlerkorrektur H, wenn dunkle Module in weiten dunklen Flächen hell bleiben und Decoder sie wiederherstellen.',
    flipsCount: 'Peng 2019 lässt {peng} Module hell, QRelief {ours}, weil es mehr von der Fehlerkorrektur verbraucht.',
    flipsSaved:
      'Mit der Suche von 2019 macht das Codes um {peng2019} % und {ours2019} % flacher, mit unserer um {peng} % und {ours} %, im Median.',
    flipsReads:
      'Im Druck ändern sich die gelesenen Versuche im Median um höchstens {tries}, aber die verbrauchte Fehlerkorrektur schützt nicht mehr vor Schmutz und Schäden.',
  },
};
