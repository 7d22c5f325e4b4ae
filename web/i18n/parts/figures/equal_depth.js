// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/equal_depth.js.

export const equalDepth = {
  en: {
    equalDepthAlt: 'A row for each method: reads as printed of every model and text, with a bar at the median.',
    equalDepthShown:
      'Reads as printed with several texts on each model; every method engraves as deep on average as the app engraves that model.',
    equalDepthOthers: 'By the median over {texts} texts, no other method reads more often than our default {cases}.',
    equalDepthList: 'Medians over the models, of the medians over the texts: our default {reads}; {list}.',
    equalDepthBy: '{method} {reads} (more often than the default {cases})',
    equalDepthSpread:
      'From text to text the reads of one method on one model differ by {spread} tries (median of the differences between most and fewest), so a single text proves little.',
  },
  de: {
    equalDepthAlt:
      'Eine Zeile je Verfahren: gelesene Versuche im Druck von jedem Modell und Text, mit einem Strich beim Median.',
    equalDepthShown:
      'Gelesene Versuche im Druck mit mehreren Texten je Modell, jedes Verfahren im Mittel so tief graviert, wie die App dieses Modell graviert.',
    equalDepthOthers:
      'Nach dem Median über {texts} Texte wird {cases} kein Verfahren anderer öfter gelesen als unsere übliche Einstellung.',
    equalDepthList:
      'Mediane über die Modelle, jeweils vom Median über die Texte: unsere übliche Einstellung {reads}; {list}.',
    equalDepthBy: '{method} {reads} ({cases} öfter als die übliche Einstellung)',
    equalDepthSpread:
      'Von Text zu Text unterscheiden sich die gelesenen Versuche eines Verfahrens auf einem Modell um {spread} (Median der Abstände zwischen den meisten und den wenigsten); ein Text allein entscheidet also wenig.',
  },
};
