// SPDX-License-Identifier: GPL-3.0-or-later
// The gallery.

export const gallery = {
  en: {
    galleryDefault: 'By default',
    galleryLamp: 'For a lamp at 33°',
    galleryPatterns: 'Every pattern of modules and finders',
    galleryDesigned: 'As designed',
    galleryPrinted: 'As printed',
    galleryFacts: '{depth} mm deep; {reads} of {tries} tries decode the design, {printed} the print',
  },
  de: {
    galleryDefault: 'Mit der Voreinstellung',
    galleryLamp: 'Für eine Lampe auf 33°',
    galleryPatterns: 'Jedes Muster für Module und Suchmuster',
    galleryDesigned: 'Im Entwurf',
    galleryPrinted: 'Im Druck',
    galleryFacts: '{depth} mm tief; {reads} von {tries} Versuchen lesen den Entwurf, {printed} den Druck',
  },
};
