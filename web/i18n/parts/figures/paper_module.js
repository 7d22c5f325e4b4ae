// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/paper_module.js.

export const paperModule = {
  en: {
    paperModuleAlt:
      'Two plots with a row for each method: mean depth and reads as printed of every model, with a bar at the median.',
    paperModuleShown:
      'Mean depth and reads as printed of every method at its published setting, with modules of 1.2 mm as in the paper’s prints; a dot is a model, the bar their median.',
    paperModuleReads:
      'With modules of 1.2 mm our default reads in {reads} tries as printed, at a depth of {depth} mm, in the median.',
    paperModuleOthers: 'The other methods for the sky: {list}.',
    paperModuleOther: '{method} {reads} at {depth} mm',
    paperModuleDefault: 'No other method reads more often than our default at no greater depth: this holds {cases}.',
  },
  de: {
    paperModuleAlt:
      'Zwei Diagramme mit einer Zeile je Verfahren: mittlere Tiefe und Lesungen im Druck für jedes Modell, mit einem Strich am Median.',
    paperModuleShown:
      'Mittlere Tiefe und Lesungen im Druck für jedes Verfahren mit seiner veröffentlichten Einstellung, mit Modulen von 1,2 mm wie in den Drucken des Artikels; ein Punkt ist ein Modell, der Strich der Median.',
    paperModuleReads:
      'Mit Modulen von 1,2 mm gelingen bei unserer Voreinstellung im Druck {reads} Versuche bei einer Tiefe von {depth} mm, im Median.',
    paperModuleOthers: 'Die anderen Verfahren für den Himmel: {list}.',
    paperModuleOther: '{method} {reads} bei {depth} mm',
    paperModuleDefault:
      'Kein anderes Verfahren lässt sich bei höchstens gleicher Tiefe öfter lesen als unsere Voreinstellung: Das gilt {cases}.',
  },
};
