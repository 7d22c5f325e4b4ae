// SPDX-License-Identifier: GPL-3.0-or-later
// The figure of study/figures/guaranteed_size.js.

export const guaranteedSize = {
  en: {
    guaranteedSizeAlt:
      'Three plots of the edge of the largest code on each model, by the method that finds its direction: at every rotation, upright, and turned by 45 degrees.',
    guaranteedSizeShown:
      'Edge of the largest code without its quiet zone, which must fit as well; figures 13 and 14 of the paper.',
    sizesSame:
      'If depth counts in addition to the normals, the size at every rotation changes by less than {percent} % {cases}.',
    sizesMost: 'It helps most on the model “{model}”, by {percent} %.',
    sizesLeast: 'On the model “{model}” it costs {percent} %.',
    sizesOptimal:
      '“Best” looks for the direction with the least distorted code, not the largest code; its code is the largest of the four {cases}.',
    sizesTurned: 'A code at a fixed rotation can be {times} times as large, in the median.',
    sizesPaper:
      'In the paper the depth allows larger codes on strongly curved places and makes no difference on flat or wavy places; its models and places differ from ours.',
  },
  de: {
    guaranteedSizeAlt:
      'Drei Diagramme zur Kante des größten Codes auf jedem Modell, je nachdem, wie die Richtung gefunden wird: in jeder Drehung, aufrecht und um 45 Grad gedreht.',
    guaranteedSizeShown:
      'Kante des größten Codes ohne seine Ruhezone, die auch passen muss; Abbildungen 13 und 14 des Artikels.',
    sizesSame:
      'Zählt neben den Normalen auch die Tiefe, ändert sich die Größe in jeder Drehung {cases} um weniger als {percent} %.',
    sizesMost: 'Am meisten hilft es beim Modell „{model}“, um {percent} %.',
    sizesLeast: 'Beim Modell „{model}“ kostet es {percent} %.',
    sizesOptimal:
      '„Beste“ sucht die Richtung mit dem am wenigsten verzerrten Code, nicht mit dem größten; {cases} ist ihr Code dennoch der größte der vier.',
    sizesTurned: 'Ein Code in einer festen Drehung kann im Median {times}-mal so groß sein.',
    sizesPaper:
      'Im Artikel erlaubt die Tiefe an stark gekrümmten Stellen größere Codes und ändert an flachen oder welligen nichts; seine Modelle und Stellen sind andere als unsere.',
  },
};
