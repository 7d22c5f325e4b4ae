// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/search_times.js.

export const searchTimes = {
  en: {
    searchTimesAlt:
      'A row for each method: time of the search on each model as a dot, the median as a bar, on a logarithmic scale.',
    searchTimesShown: 'Time to find the depths; a dot is a model, the bar their median, the scale is logarithmic.',
    timesRange: '{fastest} is the fastest with {least} s in the median, {slowest} the slowest with {most} s.',
    timesPaperHolds:
      'The paper says that its search takes a fraction of the time of Peng’s search. This holds here: {papp} s and {peng} s.',
    timesPaperFails:
      'The paper says that its search takes a fraction of the time of Peng’s search. This does not hold here: {papp} s and {peng} s.',
    timesWhy:
      'These are rough times of our programs, measured during other work on a machine without a graphics card. Papp’s search and ours draw in software there; the searches of Peng and Kikuchi trace rays, Peng 2019 far fewer rays than the original.',
  },
  de: {
    searchTimesAlt:
      'Eine Zeile je Verfahren: die Zeit der Suche auf jedem Modell als Punkt, der Median als Strich, logarithmisch.',
    searchTimesShown:
      'Zeit, die Tiefen zu finden; ein Punkt ist ein Modell, der Strich der Median, die Skala ist logarithmisch.',
    timesRange: '{fastest} ist mit {least} s im Median am schnellsten, {slowest} mit {most} s am langsamsten.',
    timesPaperHolds:
      'Der Artikel sagt, seine Suche brauche einen Bruchteil der Zeit von Pengs Suche. Das gilt hier: {papp} s und {peng} s.',
    timesPaperFails:
      'Der Artikel sagt, seine Suche brauche einen Bruchteil der Zeit von Pengs Suche. Das gilt hier nicht: {papp} s und {peng} s.',
    timesWhy:
      'Das sind grobe Zeiten unserer Programme, während anderer Arbeit auf einem Rechner ohne Grafikkarte gemessen. Papps und unsere Suche zeichnen dort in Software; die von Peng und Kikuchi verfolgen Strahlen, Peng 2019 weit weniger als das Original.',
  },
};
