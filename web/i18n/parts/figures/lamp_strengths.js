// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/lamp_strengths.js.

export const lampStrengths = {
  en: {
    lampStrengthsAlt:
      'Two plots, for whole and for square modules: mean depth against the strength of one lamp, a line for each elevation and one for the sky alone.',
    lampStrengthsShown:
      'Mean depth of a code on a plate that is engraved for one lamp, by the strength of the lamp (1: as strong as the sky) and its elevation above the code.',
    lampAt: 'Lamp at {elevation}°',
    skyAlone: 'Sky alone',
    degrees: '{elevation}°',
    millimetres: '{width} mm',
    moduleOf: 'Modules of {width} mm',
    strengthsSides:
      '{pattern} modules become shallower than under the sky alone with a lamp at {shallower} and deeper with one at {deeper}, whatever its strength.',
    strengthsWhy:
      'The elevation matters, not the strength. The paper’s lamp is at {elevation}°, between the two, where small differences in the light decide.',
  },
  de: {
    lampStrengthsAlt:
      'Zwei Diagramme, für ganze und für quadratische Module: mittlere Tiefe nach der Stärke einer Lampe, eine Linie je Höhe und eine für den Himmel allein.',
    lampStrengthsShown:
      'Mittlere Tiefe eines Codes auf einer Platte, der für eine Lampe graviert ist, nach der Stärke der Lampe (1: so stark wie der Himmel) und ihrer Höhe über dem Code.',
    lampAt: 'Lampe auf {elevation}°',
    skyAlone: 'Himmel allein',
    degrees: '{elevation}°',
    millimetres: '{width} mm',
    moduleOf: 'Module von {width} mm',
    strengthsSides:
      'Module mit dem Muster „{pattern}“ werden mit einer Lampe auf {shallower} flacher als unter dem Himmel allein und mit einer auf {deeper} tiefer, wie stark sie auch ist.',
    strengthsWhy:
      'Die Höhe entscheidet, nicht die Stärke. Die Lampe des Artikels steht auf {elevation}°, zwischen beiden, wo kleine Unterschiede im Licht entscheiden.',
  },
};
