// SPDX-License-Identifier: GPL-3.0-or-later
// The findings at the head of the study page.

export const findings = {
  en: {
    findingModule: 'How small can a module be?',
    findingModuleSays:
      'is the smallest module that decodes as printed with a 0.4 mm nozzle in both orientations. A finer nozzle allows smaller ones. Choose larger modules where there is room, because no printer is as exact as the simulation.',
    findingDepth: 'How deep must a code be?',
    findingDepthSays:
      'is QRelief’s mean depth for modules of 1 mm. The bars compare it with the other methods that decode as printed on all {models} models. A shallower code leaves a thicker wall.',
    findingPrint: 'What does printing cost?',
    findingPrintSays:
      'decode after the print, in the median of the models. The nozzle rounds the edges of the modules, so fewer tries decode than in the design. A code counts as read from {needed} of {of} tries on.',
    findingLight: 'Where should the light come from?',
    findingLightSays:
      'above the surface is the highest single lamp under which a code of whole modules still decodes if it was engraved for even light. Such codes need daylight, a bright room or a low lamp; for a lamp that stays in place, engrave for that lamp. The bars show the tries that decode at each elevation.',
    findingDecoders: 'Do all apps read the same?',
    findingDecodersSays:
      'of the same pictures decode, depending on the decoder. The pictures are difficult on purpose: many have poor light or a steep view. If one app fails, try another before you engrave deeper.',
    findingMm: '{value}\u00a0mm',
    findingTries: '{reads} of {of} tries',
    findingDegrees: '{value}°',
    findingLampAt: 'Lamp at {value}°',
    findingRange: '{from} to {to}',
    findingDesigned: 'As designed',
    findingPrinted: 'As printed',
    findingMore: 'Figure and table',
  },
  de: {
    findingModule: 'Wie klein darf ein Modul sein?',
    findingModuleSays:
      'hat das kleinste Modul, das sich im Druck mit einer Düse von 0,4 mm in beiden Ausrichtungen lesen lässt. Eine feinere Düse erlaubt kleinere. Wählen Sie größere Module, wo Platz ist, denn kein Drucker ist so genau wie die Simulation.',
    findingDepth: 'Wie tief muss ein Code sein?',
    findingDepthSays:
      'tief graviert QRelief im Mittel bei Modulen von 1 mm. Die Balken vergleichen das mit den anderen Verfahren, die sich im Druck auf allen {models} Modellen lesen lassen. Ein flacherer Code lässt mehr Wand stehen.',
    findingPrint: 'Was kostet der Druck?',
    findingPrintSays:
      'gelingen nach dem Druck, im Median der Modelle. Die Düse rundet die Kanten der Module ab, deshalb gelingen weniger Versuche als im Entwurf. Ein Code gilt ab {needed} von {of} Versuchen als lesbar.',
    findingLight: 'Woher sollte das Licht kommen?',
    findingLightSays:
      'über der Fläche darf eine einzelne Lampe höchstens stehen, damit sich ein Code aus ganzen Modulen noch lesen lässt, der für gleichmäßiges Licht graviert ist. Solche Codes brauchen Tageslicht, einen hellen Raum oder eine niedrige Lampe; für eine feste Lampe gravieren Sie für diese Lampe. Die Balken zeigen, wie viele Versuche bei jeder Höhe gelingen.',
    findingDecoders: 'Lesen alle Apps gleich gut?',
    findingDecodersSays:
      'derselben Bilder werden gelesen, je nach Decoder. Die Bilder sind absichtlich schwierig: Viele haben schlechtes Licht oder einen schrägen Blick. Wenn eine App scheitert, versuchen Sie eine andere, bevor Sie tiefer gravieren.',
    findingMm: '{value}\u00a0mm',
    findingTries: '{reads} von {of} Versuchen',
    findingDegrees: '{value}°',
    findingLampAt: 'Lampe auf {value}°',
    findingRange: '{from} bis {to}',
    findingDesigned: 'Im Entwurf',
    findingPrinted: 'Im Druck',
    findingMore: 'Abbildung und Tabelle',
  },
};
