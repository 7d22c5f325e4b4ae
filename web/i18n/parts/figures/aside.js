// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/aside.js.

export const aside = {
  en: {
    asideAlt:
      'A plot for each decoder: the largest angle at which codes read, against the arc of the cylinder that they take, a line for each layout.',
    asideShown:
      'The largest angle to the side at which npm decoders read painted codes on a cylinder, by the arc of the circumference that the codes take: medians over all versions. The codes are projected, as QRelief engraves them, wrapped round the cylinder like a label, or half-way between. A point is missing where half of the versions or more do not read even from the front.',
    asideArcs:
      'Projected codes that take {narrow}° of the circumference read {narrowTilt}, and codes that take {wide}° read {wideTilt}, in the median of all decoders and versions.',
    asideUpTo: 'up to {tilt}° to the side',
    asideOnlyFront: 'only from the front',
    asideUnread: 'not even from the front',
    asideLayouts:
      'Projected codes read at least as far to the side as wrapped codes {cases} in which either of them reads.',
    asideFront:
      'From the front, projected codes read {projected}, half-way codes {halfway} and wrapped codes {wrapped}.',
    asideMarks:
      'From version {version} on, a code has six alignment patterns instead of one, which show how it bends. At every arc these codes read farther to the side by {list}.',
    asidePaper:
      'The codes are painted, so the figure shows the effect of the bent surface alone, whatever the engraving. The paper has no such experiment.',
  },
  de: {
    asideAlt:
      'Ein Diagramm je Decoder: der größte Winkel, aus dem Codes gelesen werden, über dem Bogen des Zylinders, den sie einnehmen, eine Linie für jede Anordnung.',
    asideShown:
      'Der größte Winkel zur Seite, aus dem Decoder von npm gemalte Codes auf einem Zylinder lesen, nach dem Bogen des Umfangs, den die Codes einnehmen: Mediane aller Versionen. Die Codes sind projiziert, wie QRelief sie graviert, wie ein Etikett um den Zylinder gewickelt, oder halbwegs dazwischen. Ein Punkt fehlt, wo die Hälfte der Versionen oder mehr nicht einmal von vorn gelesen wird.',
    asideArcs:
      'Projizierte Codes, die {narrow}° des Umfangs einnehmen, werden im Median aller Decoder und Versionen {narrowTilt} gelesen, solche, die {wide}° einnehmen, {wideTilt}.',
    asideUpTo: 'bis {tilt}° von der Seite',
    asideOnlyFront: 'nur von vorn',
    asideUnread: 'nicht einmal von vorn',
    asideLayouts:
      'Projizierte Codes werden {cases}, in denen eine der beiden Arten gelesen wird, mindestens so weit von der Seite gelesen wie gewickelte.',
    asideFront:
      'Von vorn werden projizierte Codes {projected} gelesen, solche dazwischen {halfway}, gewickelte {wrapped}.',
    asideMarks:
      'Von Version {version} an hat ein Code sechs Ausrichtungsmuster statt eines, und sie zeigen, wie er sich biegt: Bei jedem Bogen sind solche Codes weiter von der Seite lesbar: {list}.',
    asidePaper:
      'Die Codes sind gemalt; die Abbildung zeigt also die Wirkung der gebogenen Fläche allein, unabhängig von der Gravur. Der Artikel hat keinen solchen Versuch.',
  },
};
