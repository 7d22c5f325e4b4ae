// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/method_depths.js.

export const methodDepths = {
  en: {
    methodDepthsAlt: 'A row for each method: mean depth on each model as a dot, the median as a bar.',
    methodDepthsShown:
      'Mean depth by method, each at its published setting, ours at its default. A dot is a model, the bar their median; figure 20 of the paper.',
    methodsOrder:
      'The paper’s order, Peng 2020 shallowest, then Papp 2022, then Peng 2019, holds {cases}; the medians are {light}, {papp} and {shadow} mm.',
    methodsHalf:
      'Peng 2020 engraves {middle} times as deep as Peng 2019 in the median, {least} to {most} times; the paper says about half.',
    methodsWhole:
      'In the paper its search without patterns is about as deep as Peng 2019. Here this holds {cases}, within {percent} %; in the median Peng 2019 engraves {times} times as deep.',
    methodsWhy:
      'The methods stop at different darkness. Peng’s limit is a fifth of a grey scale that was fitted to photographs, which requires much more contrast than a fifth of the light. Our limit, used here for Papp 2022 too, is a fraction of the light itself, computed for the exact sky with the light that the walls reflect. Floors are steps here, not the meshes of the originals.',
    methodsLamp:
      'Under their lamp, as designed, codes for one lamp read {peng} if engraved by Peng 2020 and {ours} if engraved by QRelief: a low lamp lights curved surfaces unevenly and does not reach surfaces that slope steeply away from it.',
    methodsAllRead: 'As printed every method reads in the median.',
    methodsUnread: 'As printed these methods do not read in the median: {list}.',
  },
  de: {
    methodDepthsAlt: 'Eine Zeile je Verfahren: die mittlere Tiefe auf jedem Modell als Punkt, der Median als Strich.',
    methodDepthsShown:
      'Mittlere Tiefe nach Verfahren, jedes mit seiner veröffentlichten Einstellung, unseres mit seiner üblichen. Ein Punkt ist ein Modell, der Strich der Median; Abbildung 20 des Artikels.',
    methodsOrder:
      'Die Reihenfolge des Artikels, Peng 2020 am flachsten, dann Papp 2022, dann Peng 2019, gilt {cases}; die Mediane sind {light}, {papp} und {shadow} mm.',
    methodsHalf:
      'Peng 2020 graviert im Median {middle}-mal so tief wie Peng 2019, {least}- bis {most}-mal; nach dem Artikel etwa halb so tief.',
    methodsWhole:
      'Im Artikel graviert seine Suche ohne Muster etwa so tief wie Peng 2019. Auf {percent} % genau gilt das {cases}: Im Median graviert Peng 2019 {times}-mal so tief.',
    methodsWhy:
      'Die Verfahren hören bei verschiedener Dunkelheit auf. Pengs Grenze ist ein Fünftel einer Grauskala, die an Fotos angepasst wurde; sie verlangt viel mehr Kontrast als ein Fünftel des Lichts. Unsere Grenze, die hier auch für Papp 2022 gilt, ist ein Anteil am Licht selbst, berechnet für den genauen Himmel und mit dem Licht, das die Wände zurückwerfen. Die Böden sind hier Stufen und nicht die Netze der Originale.',
    methodsLamp:
      'Unter ihrer Lampe sind Codes für eine Lampe im Entwurf {peng} lesbar, wenn Peng 2020 sie graviert, und {ours}, wenn QRelief sie graviert: Eine niedrige Lampe beleuchtet gewölbte Flächen ungleichmäßig und Flächen, die steil von ihr abfallen, gar nicht.',
    methodsAllRead: 'Im Druck ist jedes Verfahren im Median lesbar.',
    methodsUnread: 'Im Druck sind diese Verfahren im Median nicht lesbar: {list}.',
  },
};
