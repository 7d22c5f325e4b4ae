// SPDX-License-Identifier: GPL-3.0-or-later
// The table of the decoders’ rates on CarvedQR.

export const decoderRates = {
  en: {
    ratesShown:
      'CarvedQR has {pictures} pictures of engraved codes, drawn from wide ranges of text, pattern, depth, size, print, lamp and camera; many are hard, and some cannot be decoded. Each decoder gets each picture once, with its own thorough settings.',
    ratesWrong: {
      one: '{count} text in all was wrong. The table gives the share that each decoder reads.',
      other: '{count} texts in all were wrong. The table gives the share that each decoder reads.',
    },
    ratesNoneWrong: 'No text was wrong. The table gives the share that each decoder reads.',
    ratesDecoder: 'Decoder',
    ratesDesigned: 'as designed',
    ratesPrinted: 'as printed',
    ratesSky: 'sky',
    ratesLamp: 'sky and lamp',
    ratesFront: 'from the front',
    ratesTilted: 'tilted to 20°',
    ratesSteep: 'tilted to 45°',
    ratesNone: '–',
  },
  de: {
    ratesShown:
      'CarvedQR enthält {pictures} Bilder gravierter Codes, gezogen aus weiten Bereichen von Text, Muster, Tiefe, Größe, Druck, Lampe und Kamera; viele sind schwer, manche unlesbar. Jeder Decoder bekommt jedes Bild einmal, mit seinen eigenen gründlichen Einstellungen.',
    ratesWrong: {
      one: '{count} Text war insgesamt falsch. Die Tabelle nennt den Anteil, den jeder Decoder liest.',
      other: '{count} Texte waren insgesamt falsch. Die Tabelle nennt den Anteil, den jeder Decoder liest.',
    },
    ratesNoneWrong: 'Kein Text war falsch. Die Tabelle nennt den Anteil, den jeder Decoder liest.',
    ratesDecoder: 'Decoder',
    ratesDesigned: 'im Entwurf',
    ratesPrinted: 'im Druck',
    ratesSky: 'Himmel',
    ratesLamp: 'Himmel und Lampe',
    ratesFront: 'von vorn',
    ratesTilted: 'bis 20° schräg',
    ratesSteep: 'bis 45° schräg',
    ratesNone: '–',
  },
};
