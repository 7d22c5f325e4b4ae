// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of the gallery; study/gallery fills it.

export const gallery = {
  en: {
    title: 'Gallery – QRelief',
    description: 'Carved QR codes on the sample models, as designed and as printed, with every pattern of modules and finders. One click opens each in the app.',
    heading: 'Gallery',
    lead: 'Codes on the sample models, each as designed (left) and as a printer leaves it (right). Click one to carve it in the app.',
    how: 'All pictures are simulated, for a nozzle of 0.4 mm and layers of 0.2 mm with the model standing as its file has it. Prints are shown and judged under an even sky, also those of codes for a lamp.',
  },
  de: {
    title: 'Galerie – QRelief',
    description: 'Gravierte QR-Codes auf den Beispielmodellen, im Entwurf und im Druck, mit jedem Muster für Module und Suchmuster. Ein Klick öffnet jeden in der App.',
    heading: 'Galerie',
    lead: 'Codes auf den Beispielmodellen, jeder im Entwurf (links) und wie ein Drucker ihn hinterlässt (rechts). Ein Klick graviert ihn in der App.',
    how: 'Alle Bilder sind simuliert, für eine Düse von 0,4 mm und Schichten von 0,2 mm; das Modell steht, wie es in seiner Datei steht. Drucke sind unter gleichmäßigem Himmel gezeigt und beurteilt, auch die von Codes für eine Lampe.',
  },
};
