// SPDX-License-Identifier: GPL-3.0-or-later

export const take = {
  en: {
    settings: 'Save settings',
    symbolSvg: 'Code as SVG',
    symbolPng: 'Code as PNG',
    picture: 'Save picture',
    symbolSvgTitle: 'The flat code, for print and drawing programs',
    symbolPngTitle: 'The flat code as pixels, with its light margin',
    pictureTitle: 'What the 3D view shows now',
    settingsTitle: 'All that was chosen, as a file to drop onto this page again',
    secret: 'The settings hold the Wi-Fi password: keep their file to yourself',
    settingsUsed: 'The settings of {file} are in use.',
    settingsOtherModel: 'The settings of {file} are in use, made for {model}: choose the place on this model.',
  },
  de: {
    settings: 'Einstellungen speichern',
    symbolSvg: 'Code als SVG',
    symbolPng: 'Code als PNG',
    picture: 'Bild speichern',
    symbolSvgTitle: 'Der flache Code, für Druck und Zeichenprogramme',
    symbolPngTitle: 'Der flache Code als Pixel, mit seinem hellen Rand',
    pictureTitle: 'Was die 3D-Ansicht jetzt zeigt',
    settingsTitle: 'Alles Gewählte als Datei, um sie wieder auf diese Seite zu ziehen',
    secret: 'Die Einstellungen enthalten das WLAN-Passwort: Datei für sich behalten',
    settingsUsed: 'Die Einstellungen aus {file} gelten.',
    settingsOtherModel: 'Die Einstellungen aus {file} gelten; sie sind für {model} gemacht: Stelle auf diesem Modell wählen.',
  },
};
