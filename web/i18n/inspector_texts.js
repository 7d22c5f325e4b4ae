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
  'angle between facet and line to the reader': 'Winkel zwischen Dreieck und Linie zum Betrachter',
  'Smooth normal': 'Geglättete Normale',
  'the same, of the interpolated normals': 'dasselbe, der interpolierten Normalen',
  Height: 'Höhe',
  'over the QR plane, towards the reader': 'über der QR-Ebene, zum Betrachter hin',
  Distance: 'Entfernung',
  "from the reader's eye, along the ray": 'vom Auge des Betrachters, entlang des Strahls',
  'Back distance': 'Entfernung der Rückseite',
  'from the eye to where the ray leaves': 'vom Auge bis dorthin, wo der Strahl austritt',
  Thickness: 'Dicke',
  'of the material along the ray': 'des Materials entlang des Strahls',
  'Wall limit': 'Grenze durch die Wand',
  'deepest a submodule may become': 'größte mögliche Tiefe eines Teilmoduls',
  Depth: 'Tiefe',
  'carved, along the ray': 'graviert, entlang des Strahls',
  Luminance: 'Leuchtdichte',
  'LS, 1 = unoccluded': 'LS, 1 = unverdeckt',
  'Excess G': 'Überschuss G',
  'AL·(c - 1) + LS: above 0 is too bright': 'AL·(c - 1) + LS: über 0 ist zu hell',
  Sky: 'Himmel',
  'share of the sky that is seen': 'sichtbarer Anteil des Himmels',
  'Sky past walls': 'Himmel hinter Wänden',
  "the same past the pockets' walls alone": 'dasselbe, verdeckt allein von den Wänden der Taschen',
  Lamps: 'Lampen',
  'direct light of the lamps': 'direktes Licht der Lampen',

  grey: 'grau',
  'blue to red': 'blau bis rot',
  'pass %d of {}': 'Durchgang %d von {}',
  'pass {}': 'Durchgang {}',
  'whole range': 'ganzer Bereich',
  'without 1 % at either end': 'ohne 1 % an jedem Ende',
  'range by hand': 'Bereich von Hand',
  'point at the map to read a value': 'auf die Karte zeigen, um einen Wert zu lesen',
  'row {}, column {}: {}': 'Zeile {}, Spalte {}: {}',
  All: 'Alles',
  'x, y, z as colours': 'x, y, z als Farben',
  nothing: 'nichts',
  '{} values': '{} Werte',
  'Click a submodule here or on the model to see what the search knows of it.':
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
  ', of a dark module, left standing': ', eines dunklen Moduls, stehen gelassen',
  ', light': ', hell',
  depth: 'Tiefe',
  limit: 'Grenze',
  'dark enough': 'dunkel genug',
  'too bright, limited': 'zu hell, begrenzt',
  'too bright': 'zu hell',
  'This map is there when the engraving is done.': 'Diese Karte ist da, sobald fertig graviert ist.',
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
  'View: {} × {}, {} pictures averaged, {:.0f} ms a frame in motion':
    'Ansicht: {} × {}, {} Bilder gemittelt, {:.0f} ms je Bild in Bewegung',
  'Code: {:.2f} mm, modules {:.3f} mm, {} directions tried':
    'Code: {:.2f} mm, Module {:.3f} mm, {} Richtungen versucht',
  'Times of the stages and passes are here after an engraving.':
    'Zeiten der Schritte und Durchgänge stehen hier nach einer Gravur.',
  size: 'Größe',
  'depth search': 'Tiefensuche',
  embedding: 'Einbetten',
  checks: 'Prüfen',
  'Stages, by the clock': 'Schritte, nach der Uhr',
  'Passes are timed from the next engraving on, as the inspector was closed during the last.':
    'Durchgänge werden ab der nächsten Gravur gemessen, da der Inspektor bei der letzten geschlossen war.',
  'Passes, GPU time by timer queries': 'Durchgänge, GPU-Zeit durch Timer-Abfragen',
  'Passes, CPU time only': 'Durchgänge, nur CPU-Zeit',
  'This browser has no timer queries. CPU time ends when the calls return; what the graphics processor still has to do then counts as reading back.':
    'Dieser Browser hat keine Timer-Abfragen. Die CPU-Zeit endet, wenn die Aufrufe zurückkehren; was der Grafikprozessor dann noch zu tun hat, zählt als Zurücklesen.',
  pass: 'Durchgang',
  runs: 'Läufe',

  'Engrave again': 'Neu gravieren',
  'Reset all': 'Alles zurücksetzen',
  reset: 'zurücksetzen',
  'page: {}': 'Seite: {}',
  on: 'an',
  off: 'aus',
  'Everything is as the page says. What is changed here counts for Engrave again alone.':
    'Alles ist wie auf der Seite. Änderungen hier gelten nur für „Neu gravieren“.',
  "One is changed here, for Engrave again alone: the page's own Engrave leaves it out.":
    'Ein Wert ist hier geändert, nur für „Neu gravieren“: „Gravieren“ auf der Seite lässt ihn aus.',
  "{} are changed here, for Engrave again alone: the page's own Engrave leaves them out.":
    '{} Werte sind hier geändert, nur für „Neu gravieren“: „Gravieren“ auf der Seite lässt sie aus.',
  direction: 'Richtung',
  fast: 'schnell',
  "paper's steps": 'Schritte der Arbeit',
};

/**
 * Returns the texts for the engine. The engine has English texts of its own, except for the settings.
 * @returns {Record<string, string>}
 */
export const inspectorTexts = () => ({ ...settingTexts(), ...(currentLanguage() === 'de' ? kGerman : {}) });
