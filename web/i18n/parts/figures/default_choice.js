// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/default_choice.js.

export const defaultChoice = {
  en: {
    defaultChoiceAlt:
      'Plots for four module widths: reads as printed against mean depth, and against maximum depth, a marker for each pattern tried. A circle marks the default.',
    defaultChoiceShown:
      'Reads as printed against mean depth (above) and maximum depth (below) of the settings that remained after a search of 59 random draws, on the four models that were not used to choose the default: means of lying, upright and slanted prints. The circle marks the default; markers are module pattern / finder pattern.',
    choiceReads: 'On these four models the default reads in {list}.',
    choiceReadsAt: '{reads} tries at {depth} mm with modules of {width} mm',
    choiceFrontier: 'No other choice reads more often at no greater mean depth on {list}.',
    choiceFrontierAt: '{holds} of {of} models with modules of {width} mm',
    choiceOthers: 'Without diamonds this holds on {list}.',
    choiceBetter: '{pattern} modules with finders “{finders}” read more often on average with modules of {list}.',
    choiceWhy:
      'Diamonds are still not the default. On average 3.1 of five decoder families decoded each of nine diamond prints made from a slicer’s toolpaths; 3.8 families decoded the prints with the previous default. A single decoder makes all tries here.',
  },
  de: {
    defaultChoiceAlt:
      'Diagramme für vier Modulbreiten: Lesungen im Druck nach mittlerer und nach größter Tiefe, ein Zeichen je versuchtem Muster. Ein Kreis markiert die Voreinstellung.',
    defaultChoiceShown:
      'Lesungen im Druck nach mittlerer Tiefe (oben) und größter Tiefe (unten) für die Einstellungen, die eine Suche mit 59 zufälligen Ziehungen übrig ließ, auf den vier Modellen, nach denen die Voreinstellung nicht gewählt wurde: Mittel aus liegenden, stehenden und schrägen Drucken. Der Kreis markiert die Voreinstellung; Zeichen sind Modulmuster / Suchmuster.',
    choiceReads: 'Auf diesen vier Modellen gelingen mit der Voreinstellung {list}.',
    choiceReadsAt: '{reads} Versuche bei {depth} mm Tiefe mit Modulen von {width} mm',
    choiceFrontier: 'Keine andere Wahl lässt sich bei höchstens gleicher mittlerer Tiefe öfter lesen bei {list}.',
    choiceFrontierAt: '{holds} von {of} Modellen mit Modulen von {width} mm',
    choiceOthers: 'Ohne Rauten gilt das bei {list}.',
    choiceBetter:
      'Module mit dem Muster „{pattern}“ und Suchmuster „{finders}“ lassen sich mit Modulen von {list} im Mittel öfter lesen.',
    choiceWhy:
      'Rauten sind trotzdem nicht die Voreinstellung. Im Mittel lasen 3,1 von fünf Decoder-Familien jeden von neun Drucken mit Rauten aus den Bahnen eines Slicers; bei den Drucken mit der früheren Voreinstellung waren es 3,8. Alle Versuche hier macht ein einziger Decoder.',
  },
};
