// SPDX-License-Identifier: GPL-3.0-or-later
// The inspector's texts, which the engine draws. Their keys are the English texts in app/inspector/*.cpp. They are a file
// of their own, so that the page loads them only with the inspector.
import { currentLanguage } from './catalogue.js';
import { settingTexts } from './setting_names.js';

/** @type {Record<string, string>} */
const kGerman = {
  Inspector: 'Inspektor',
  Maps: 'Karte',
  Search: 'Suche',
  Timing: 'Zeit',
  Settings: 'Werte',

  'Facet normal': 'Normale des Dreiecks',
  'angle between facet and line to the viewer': 'Winkel zwischen Dreieck und Linie zum Betrachter',
  'Smooth normal': 'Geglättete Normale',
  'the same for the interpolated normals': 'dasselbe für die interpolierten Normalen',
  Height: 'Höhe',
  'over the QR plane, towards the viewer': 'über der QR-Ebene, zum Betrachter hin',
  Distance: 'Entfernung',
  "from the viewer's eye, along the ray": 'vom Auge des Betrachters, entlang des Strahls',
  'Back distance': 'Entfernung der Rückseite',
  'from the eye to the exit of the ray': 'vom Auge bis zum Austritt des Strahls',
  Thickness: 'Dicke',
  'of the material along the ray': 'des Materials entlang des Strahls',
  'Wall limit': 'Grenze durch die Wand',
  'greatest depth of a submodule': 'größte mögliche Tiefe eines Teilmoduls',
  Depth: 'Tiefe',
  'carved, along the ray': 'graviert, entlang des Strahls',
  Luminance: 'Leuchtdichte',
  'LS, 1 = unoccluded': 'LS, 1 = unverdeckt',
  'Excess G': 'Überschuss G',
  'AL·(c - 1) + LS: above 0 is too bright': 'AL·(c - 1) + LS: über 0 ist zu hell',
  Sky: 'Himmel',
  'visible fraction of the sky': 'sichtbarer Anteil des Himmels',
  'Sky past walls': 'Himmel hinter Wänden',
  'the same, hidden only by pocket walls': 'dasselbe, nur von den Wänden der Taschen verdeckt',
  Lamps: 'Lampen',
  'direct light of the lamps': 'direktes Licht der Lampen',

  grey: 'grau',
  'blue to red': 'blau bis rot',
  'pass %d of {}': 'Durchgang %d von {}',
  'pass {}': 'Durchgang {}',
  'whole range': 'ganzer Bereich',
  'without 1 % at each end': 'ohne 1 % an jedem Ende',
  'manual range': 'eigener Bereich',
  'point at the map to read a value': 'auf die Karte zeigen, um einen Wert zu lesen',
  'row {}, column {}: {}': 'Zeile {}, Spalte {}: {}',
  All: 'Alles',
  'x, y, z as colours': 'x, y, z als Farben',
  nothing: 'nichts',
  '{} values': '{} Werte',
  'Click a submodule here or on the model to see its values in the search.':
    'Ein Teilmodul hier oder am Modell anklicken, um seine Werte in der Suche zu sehen.',
  'Submodule row {}, column {}: {}{}': 'Teilmodul Zeile {}, Spalte {}: {}{}',
  'quiet zone': 'Ruhezone',
  data: 'Daten',
  finder: 'Suchmuster',
  separator: 'Trennstreifen',
  timing: 'Taktmuster',
  alignment: 'Ausrichtungsmuster',
  format: 'Formatangabe',
  version: 'Versionsangabe',
  ', carved': ', graviert',
  ', in a dark module, not carved': ', in einem dunklen Modul, nicht graviert',
  ', light': ', hell',
  depth: 'Tiefe',
  limit: 'Grenze',
  'dark enough': 'dunkel genug',
  'too bright, limited': 'zu hell, begrenzt',
  'too bright': 'zu hell',
  'This map appears when the engraving is done.': 'Diese Karte erscheint, sobald fertig graviert ist.',
  'Nothing to see yet: press Engrave.': 'Noch nichts zu sehen: „Gravieren“ drücken.',

  '{}: {} passes': '{}: {} Durchgänge',
  'Engrave with another solver (Settings) to compare them here.':
    'Mit einem anderen Verfahren gravieren (Werte), um sie hier zu vergleichen.',
  'up to {}': 'bis {}',
  'Mean depth': 'Mittlere Tiefe',
  'Too bright (G > 0)': 'Zu hell (G > 0)',
  'Greatest change of a depth': 'Größte Änderung einer Tiefe',
  'Luminance at pass {}': 'Leuchtdichte bei Durchgang {}',
  'light modules': 'helle Module',
  'carved submodules': 'gravierte Teilmodule',
  'Depth at pass {}': 'Tiefe bei Durchgang {}',
  '{} of {} carved submodules too bright, by {} at most; deepest {}; took {:.0f} ms':
    '{} von {} gravierten Teilmodulen zu hell, um höchstens {}; am tiefsten {}; dauerte {:.0f} ms',
  'View: {} × {}, {} pictures averaged, {:.0f} ms per frame in motion':
    'Ansicht: {} × {}, {} Bilder gemittelt, {:.0f} ms je Bild in Bewegung',
  'Code: {:.2f} mm, modules {:.3f} mm, {} directions tried':
    'Code: {:.2f} mm, Module {:.3f} mm, {} Richtungen versucht',
  'The times of stages and passes appear here after an engraving.':
    'Die Zeiten der Schritte und Durchgänge erscheinen hier nach einer Gravur.',
  'Stages, named as in the report': 'Schritte, benannt wie im Bericht',
  'Passes are timed from the next engraving on, because the inspector was closed during the last one.':
    'Durchgänge werden ab der nächsten Gravur gemessen, weil der Inspektor bei der letzten geschlossen war.',
  'Passes, GPU time by timer queries': 'Durchgänge, GPU-Zeit durch Timer-Abfragen',
  'Passes, CPU time only': 'Durchgänge, nur CPU-Zeit',
  "This browser has no timer queries. CPU time ends when the calls return; the GPU's remaining work then counts as read-back.":
    'Dieser Browser hat keine Timer-Abfragen. Die CPU-Zeit endet, wenn die Aufrufe zurückkehren; die übrige Arbeit der GPU zählt dann als Zurücklesen.',
  pass: 'Durchgang',
  runs: 'Läufe',

  'Engrave again': 'Neu gravieren',
  'Reset all': 'Alles zurücksetzen',
  reset: 'zurücksetzen',
  'page: {}': 'Seite: {}',
  on: 'an',
  off: 'aus',
  'All settings are as on the page. Changes here apply only to Engrave again.':
    'Alles ist wie auf der Seite. Änderungen hier gelten nur für „Neu gravieren“.',
  "One setting is changed here, only for Engrave again: the page's Engrave ignores it.":
    'Ein Wert ist hier geändert, nur für „Neu gravieren“: „Gravieren“ auf der Seite beachtet ihn nicht.',
  "{} settings are changed here, only for Engrave again: the page's Engrave ignores them.":
    '{} Werte sind hier geändert, nur für „Neu gravieren“: „Gravieren“ auf der Seite beachtet sie nicht.',
  fast: 'schnell',
  "paper's steps": 'Schritte der Arbeit',
};

/**
 * Returns the texts for the engine. The engine has English texts of its own, except for the settings.
 * @returns {Record<string, string>}
 */
export const inspectorTexts = () => ({ ...settingTexts(), ...(currentLanguage() === 'de' ? kGerman : {}) });
