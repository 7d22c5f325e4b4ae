// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/light_angles.js.

export const lightAngles = {
  en: {
    lightAnglesAlt:
      'Two plots, for whole and for square modules: reads against the elevation of the reading lamp, a line for each light that the code was engraved for.',
    lightAnglesShown:
      'Reads of codes on a plate under the sky and one lamp, by the elevation of that lamp above the code. Each line is a light that the code was engraved for; figure 22 of the paper.',
    anglesWhole:
      'Whole modules engraved for a lamp at {oneAt}° read {one}; whole modules engraved for a lamp at {otherAt}° read {other}.',
    anglesPaper:
      'In the paper these codes tolerate a lamp up to {oneHigher}° and {otherHigher}° higher ({onePaper}° and {otherPaper}° in its measure) and any lower lamp. Here the first holds {higher} and the second {lower}; with the lamp that they were engraved for they read {own}.',
    anglesPattern:
      'Square modules engraved for these lamps read {one} and {other}; in the paper no code with patterns that was engraved for a lamp could be read.',
    anglesWith: 'with lamps at {list}',
    anglesFromTo: { one: '{from}°', other: '{from}° to {to}°' },
    anglesNone: 'with none of the lamps tried',
    anglesWhy:
      'Our lamp is as strong as the sky. The paper does not give the strength of its lamp, and one app decoded rendered pictures at some angles.',
  },
  de: {
    lightAnglesAlt:
      'Zwei Diagramme, für ganze und für quadratische Module: gelesene Versuche über der Höhe der Leselampe, eine Linie für jedes Licht, für das graviert wurde.',
    lightAnglesShown:
      'Gelesene Versuche auf einer Platte unter dem Himmel und einer Lampe, nach der Höhe dieser Lampe über dem Code. Jede Linie ist ein Licht, für das graviert wurde; Abbildung 22 des Artikels.',
    anglesWhole:
      'Ganze Module, die für eine Lampe auf {oneAt}° graviert sind, lassen sich {one} lesen, ganze Module für eine Lampe auf {otherAt}° {other}.',
    anglesPaper:
      'Im Artikel vertragen sie eine um bis zu {oneHigher}° und {otherHigher}° höhere Lampe ({onePaper}° und {otherPaper}° in seinem Maß) und jede tiefere; hier gilt das erste {higher}, das zweite {lower}, und mit eben der Lampe, für die sie graviert sind, lassen sie sich {own} lesen.',
    anglesPattern:
      'Quadratische Module, für diese Lampen graviert, lassen sich {one} und {other} lesen; im Artikel war kein Code mit Mustern lesbar, der für eine Lampe graviert war.',
    anglesWith: 'mit Lampen auf {list}',
    anglesFromTo: { one: '{from}°', other: '{from}° bis {to}°' },
    anglesNone: 'mit keiner der versuchten Lampen',
    anglesWhy:
      'Unsere Lampe ist so stark wie der Himmel. Der Artikel nennt die Stärke seiner Lampe nicht, und eine App las gezeichnete Bilder einiger Winkel.',
  },
};
