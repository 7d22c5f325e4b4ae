// SPDX-License-Identifier: GPL-3.0-or-later
// What the core says it is doing, by its own words.

export const stages = {
  en: {
    'Finding direction and size': 'Finding direction and size',
    'Measuring the surface': 'Measuring the surface',
    'Finding the depth': 'Finding the depth',
    'Carving the mesh': 'Carving the mesh',
    'Checking the solid': 'Checking the solid',
    'Looking at the result': 'Looking at the result',
    'Looking from all sides': 'Looking from all sides',
    'Testing spots': 'Testing spots',
    'Finding the largest size': 'Finding the largest size',
  },
  de: {
    'Finding direction and size': 'Richtung und Größe suchen',
    'Measuring the surface': 'Oberfläche vermessen',
    'Finding the depth': 'Tiefe suchen',
    'Carving the mesh': 'Code ins Netz schneiden',
    'Checking the solid': 'Körper prüfen',
    'Looking at the result': 'Ergebnis ansehen',
    'Looking from all sides': 'Von allen Seiten schauen',
    'Testing spots': 'Stellen prüfen',
    'Finding the largest size': 'Größte Breite suchen',
  },
};
