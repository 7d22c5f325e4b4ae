// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/light_errors.js.

export const lightErrors = {
  en: {
    lightErrorsAlt:
      'Two plots with a row for each method: the difference between its own estimate of the light and path tracing, by size and with sign.',
    lightErrorsShown:
      'Difference between the light that a method estimates on the engraved submodules and path tracing on the engraved mesh, as a fraction of the light on a free surface. Negative: the method estimates too little light.',
    errorsRange:
      '{least} is the most accurate with {leastError} in the median, {most} the least accurate with {mostError}.',
    errorsOursDark: 'QRelief is off by {size}, and on average estimates the pockets too dark by {mean}.',
    errorsOursBright: 'QRelief is off by {size}, and on average estimates the pockets too bright by {mean}.',
    errorsWhy:
      'Kikuchi and Peng 2019 measure the visible part of the sky, which is a different quantity from light and not an error of their programs. Papp 2021, Papp 2022 and the even depth use our model of the light here. Codes for one lamp are traced under that lamp. The paper has no such comparison.',
  },
  de: {
    lightErrorsAlt:
      'Zwei Diagramme mit einer Zeile je Verfahren: wie weit seine eigene Schätzung des Lichts vom Ergebnis der Strahlverfolgung abweicht, als Betrag und mit Vorzeichen.',
    lightErrorsShown:
      'Unterschied zwischen dem Licht, das ein Verfahren in den gravierten Teilmodulen annimmt, und dem Licht, das die Strahlverfolgung auf dem gravierten Netz findet, als Anteil des Lichts auf einer freien Fläche. Negativ: Das Verfahren nimmt zu wenig Licht an.',
    errorsRange: '{least} ist mit {leastError} im Median am genauesten, {most} mit {mostError} am ungenauesten.',
    errorsOursDark: 'QRelief liegt um {size} daneben und nimmt die Taschen im Mittel um {mean} zu dunkel an.',
    errorsOursBright: 'QRelief liegt um {size} daneben und nimmt die Taschen im Mittel um {mean} zu hell an.',
    errorsWhy:
      'Kikuchi und Peng 2019 messen den sichtbaren Teil des Himmels; das ist eine andere Größe als Licht und kein Fehler ihrer Programme. Papp 2021, Papp 2022 und die gleiche Tiefe verwenden hier unser Modell des Lichts. Bei Codes für eine Lampe wird das Licht unter dieser Lampe verfolgt. Der Artikel hat keinen solchen Vergleich.',
  },
};
