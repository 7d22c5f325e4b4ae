// SPDX-License-Identifier: GPL-3.0-or-later

export const exports = {
  en: {
    settings: 'Save settings',
    symbolSvg: 'Code as SVG',
    symbolPng: 'Code as PNG',
    picture: 'Save picture',
    symbolSvgTitle: 'The flat code, for print and drawing programs',
    symbolPngTitle: 'The flat code as pixels, with its quiet zone',
    pictureTitle: 'The 3D view as it is now',
    settingsTitle: 'All your settings, as a file that you can drop onto this page again',
    secret: 'The settings contain the Wi-Fi password: keep the file to yourself',
    settingsUsed: 'Using the settings from {file}.',
    settingsOtherModel: 'Using the settings from {file}, made for {model}: choose the spot on this model.',
  },
  de: {
    settings: 'Einstellungen speichern',
    symbolSvg: 'Code als SVG',
    symbolPng: 'Code als PNG',
    picture: 'Bild speichern',
    symbolSvgTitle: 'Der flache Code, für Druck und Zeichenprogramme',
    symbolPngTitle: 'Der flache Code als Pixel, mit seiner Ruhezone',
    pictureTitle: 'Die 3D-Ansicht, wie sie jetzt ist',
    settingsTitle: 'Alle Einstellungen als Datei, um sie wieder auf diese Seite zu ziehen',
    secret: 'Die Einstellungen enthalten das WLAN-Passwort: Datei für sich behalten',
    settingsUsed: 'Verwendet werden die Einstellungen aus {file}.',
    settingsOtherModel: 'Verwendet werden die Einstellungen aus {file} für {model}: Stelle auf diesem Modell wählen.',
  },
};
