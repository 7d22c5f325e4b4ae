// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/least_module.js.

export const leastModule = {
  en: {
    leastModuleAlt:
      'Four plots, for two nozzles lying and standing: the smallest module that reads, by module pattern and finder pattern.',
    leastModuleShown:
      'The smallest module that reads as printed, on a plate, for each module pattern and finder pattern; figure 11 of the paper.',
    leastOne:
      '{process}: the smallest module that reads is {module} mm wide, {pose} (modules: {pattern}, finders: {finders}).',
    leastThick:
      'In the paper thick plus has the smallest modules and thin plus the largest; here the modules of thick plus are at least as small as the modules of thin plus {thin}.',
    leastFinders:
      'In the paper whole finders also allow smaller modules than finders in the pattern of the modules; here their modules are at least as small {cases}.',
    leastPrint:
      'Modules can be at least as small standing as lying {standing}, and at least as small with the finer nozzle {finer}.',
    leastUnread: {
      one: '{count} of {of} combinations does not read even at the largest module.',
      other: '{count} of {of} combinations do not read even at the largest module.',
    },
    leastPaper:
      'The authors tried a few sizes on real prints and removed strings by hand; here sizes shrink in steps of a tenth, and the simulated print has no strings.',
  },
  de: {
    leastModuleAlt:
      'Vier Diagramme, zu zwei Düsen, liegend und stehend: das kleinste lesbare Modul nach Modulmuster und Suchmuster.',
    leastModuleShown:
      'Das kleinste Modul, das sich im Druck lesen lässt, auf einer Platte, nach Modulmuster und Suchmuster; Abbildung 11 des Artikels.',
    leastOne:
      '{process}: Das kleinste lesbare Modul ist {module} mm groß, {pose} (Module: {pattern}, Suchmuster: {finders}).',
    leastThick:
      'Im Artikel hat das dicke Plus die kleinsten Module und das dünne die größten; hier sind die Module des dicken Plus {thin} mindestens so klein wie die Module des dünnen.',
    leastFinders:
      'Auch erlauben dort ganze Suchmuster kleinere Module als Suchmuster im Muster der Module; hier sind ihre Module {cases} mindestens so klein.',
    leastPrint: 'Stehend sind die Module {standing} mindestens so klein wie liegend, mit der feineren Düse {finer}.',
    leastUnread: {
      one: '{count} von {of} Kombinationen ist selbst mit dem größten Modul nicht lesbar.',
      other: '{count} von {of} Kombinationen sind selbst mit dem größten Modul nicht lesbar.',
    },
    leastPaper:
      'Für den Artikel wurden einige Größen wirklich gedruckt und Fäden von Hand entfernt; hier schrumpfen die Größen um je ein Zehntel, und der Druck ist ohne Fäden simuliert.',
  },
};
