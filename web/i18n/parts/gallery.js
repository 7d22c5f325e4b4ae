// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of the gallery's frame; study/gallery fills it.

export const gallery = {
  en: {
    title: 'Gallery – QRelief',
    description:
      'Engraved QR codes on the sample models, as designed and as printed, with every module pattern and finder pattern. One click opens each code in the app.',
    heading: 'Gallery',
    lead: 'Codes on the sample models, each as designed (left) and as printed (right). Click a code to engrave it in the app.',
    how: 'All pictures are simulated, for a nozzle of 0.4 mm, layers of 0.2 mm and the orientation in the model’s file. Prints are shown and judged under an even sky, even if the code is engraved for a lamp.',
  },
  de: {
    title: 'Galerie – QRelief',
    description:
      'Gravierte QR-Codes auf den Beispielmodellen, im Entwurf und im Druck, mit jedem Muster für Module und Suchmuster. Ein Klick öffnet jeden Code in der App.',
    heading: 'Galerie',
    lead: 'Codes auf den Beispielmodellen, jeder im Entwurf (links) und im Druck (rechts). Ein Klick graviert ihn in der App.',
    how: 'Alle Bilder sind simuliert, für eine Düse von 0,4 mm, Schichten von 0,2 mm und die Ausrichtung in der Datei des Modells. Drucke werden unter gleichmäßigem Himmel gezeigt und beurteilt, auch wenn der Code für eine Lampe graviert ist.',
  },
};
