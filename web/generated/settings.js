// SPDX-License-Identifier: GPL-3.0-or-later
// Written by build/release/bin/qrelief_generate from core/settings and messages/settings: do not edit.

/** @typedef {{ en: string, de: string }} Words  in every language of the page */

/**
 * @typedef {object} Setting
 * @property {string} group
 * @property {'text' | 'switch' | 'number' | 'choice' | 'choice-or-number' | 'choice-or-vector' | 'vector' | 'lamps'} kind
 * @property {UnitName} [unit]
 * @property {number} [min]          of a number, inclusive
 * @property {number} [max]
 * @property {number} [step]
 * @property {boolean} [whole]       a number without decimals
 * @property {boolean} [mayBeEmpty]  may be left out: what then counts follows from the rest
 * @property {readonly string[]} [choices]
 * @property {unknown} default       null: it is empty
 * @property {Words} label           without the unit
 * @property {Words} [hint]          a sentence under the control
 * @property {Readonly<Record<string, Words>>} [choiceNames]  and of `number` and `vector`, where it takes those
 * @property {Readonly<Record<string, Words>>} [partLabels]   of the parts that it is set by
 * @property {Readonly<Record<string, { min: number, max: number, step: number, default: number }>>} [parts]  of a lamp
 * @property {number} [most]         lamps
 */

/** @typedef {'text' | 'content' | 'ecc' | 'version' | 'mask' | 'eci' | 'mark' | 'markDepthMm' | 'darkReflectance' | 'lightReflectance' | 'preset' | 'keepPreset' | 'pattern' | 'finderPattern' | 'contrast' | 'carveFor' | 'objective' | 'solver' | 'maxDepthMm' | 'minWallMm' | 'size' | 'maxSizeMm' | 'quietZone' | 'up' | 'rotateDeg' | 'direction' | 'eyeDistanceMm' | 'light' | 'albedo' | 'surface' | 'inlay' | 'label' | 'frame' | 'process' | 'nozzleMm' | 'layerMm' | 'lineWidthMm' | 'buildUp'} SettingKey */
/** @typedef {'mm' | 'deg' | 'skies'} UnitName */

/** @type {Readonly<Record<SettingKey, Setting>>} */
export const kSettings = {
  text: {"group":"symbol","kind":"text","default":"","label":{"de":"Text oder Link","en":"Text or link"}},
  content: {"group":"symbol","kind":"choice","choices":["code","text"],"default":"code","label":{"de":"Inhalt","en":"Content"},"choiceNames":{"code":{"de":"QR-Code","en":"QR code"},"text":{"de":"Nur Text","en":"Text alone"}}},
  ecc: {"group":"symbol","kind":"choice","choices":["auto","L","M","Q","H"],"default":"auto","label":{"de":"Schäden, die er übersteht","en":"Damage it survives"},"choiceNames":{"H":{"de":"H, 30 %","en":"H, 30 %"},"L":{"de":"L, 7 %","en":"L, 7 %"},"M":{"de":"M, 15 %","en":"M, 15 %"},"Q":{"de":"Q, 25 %","en":"Q, 25 %"},"auto":{"de":"So hoch wie möglich, mindestens M","en":"As high as fits, at least M"}}},
  version: {"group":"symbol","kind":"number","min":1.0,"max":40.0,"step":1.0,"whole":true,"mayBeEmpty":true,"default":null,"label":{"de":"Version","en":"Version"},"hint":{"de":"Mehr Module, als der Text braucht, machen jedes kleiner.","en":"More modules than the text needs make each of them smaller."}},
  mask: {"group":"symbol","kind":"choice-or-number","min":0.0,"max":7.0,"step":1.0,"whole":true,"choices":["auto","shadiest"],"default":"auto","label":{"de":"Maske","en":"Mask"},"hint":{"de":"Mischt dunkle und helle Module. Jede Maske ist lesbar.","en":"Mixes dark and light modules. Every mask decodes."},"choiceNames":{"auto":{"de":"Norm","en":"Standard"},"number":{"de":"Fest","en":"Fixed"},"shadiest":{"de":"Kleinste dunkle Flächen","en":"Smallest dark areas"}},"partLabels":{"number":{"de":"Feste Maske","en":"Fixed mask"}}},
  eci: {"group":"symbol","kind":"choice","choices":["auto","never"],"default":"auto","label":{"de":"Zeichensatz","en":"Character set"},"hint":{"de":"Sagt dem Decoder, dass der Text UTF-8 ist. Einzelne Scanner lehnen solche Codes ab.","en":"Tells decoders that the text is UTF-8. A few scanners refuse such codes."},"choiceNames":{"auto":{"de":"Angegeben, wenn nötig","en":"Named if needed"},"never":{"de":"Nie angegeben","en":"Never named"}}},
  mark: {"group":"mark","kind":"choice","choices":["auto","shadow","inlay","paint"],"default":"shadow","label":{"de":"Gemacht durch","en":"Made by"},"choiceNames":{"auto":{"de":"Das Beste für diese Stelle","en":"Best for this spot"},"inlay":{"de":"Zweite Farbe, eingelegt","en":"Second colour, inlaid"},"paint":{"de":"Zweite Farbe, aufgemalt","en":"Second colour, painted"},"shadow":{"de":"Schatten","en":"Shadow"}}},
  markDepthMm: {"group":"mark","kind":"number","unit":"mm","min":0.05,"max":1000.0,"step":0.05,"mayBeEmpty":true,"default":null,"label":{"de":"Tiefe der Einlage","en":"Depth of the inlay"}},
  darkReflectance: {"group":"mark","kind":"number","min":0.01,"max":1.0,"step":0.05,"default":0.05,"label":{"de":"Reflexion der zweiten Farbe","en":"Reflectance of the second colour"},"hint":{"de":"Anteil des Lichts, den die zweite Farbe zurückwirft. Schwarzer Kunststoff: 0,05.","en":"Fraction of the light that the second colour reflects. Black plastic: 0.05."}},
  lightReflectance: {"group":"mark","kind":"number","min":0.01,"max":1.0,"step":0.05,"default":0.85,"label":{"de":"Reflexion des Modells","en":"Reflectance of the model"},"hint":{"de":"Anteil des Lichts, den das Modell zurückwirft. Weißer Kunststoff: 0,85.","en":"Fraction of the light that the model reflects. White plastic: 0.85."}},
  preset: {"group":"depth","kind":"choice","choices":["shallow","balanced","robust"],"default":"balanced","label":{"de":"Wie tief","en":"How deep"},"choiceNames":{"balanced":{"de":"Ausgewogen","en":"Balanced"},"robust":{"de":"Robust, für schlechtes Licht","en":"Robust, for poor light"},"shallow":{"de":"Flach, für gleichmäßiges Licht","en":"Shallow, for even light"}}},
  keepPreset: {"group":"depth","kind":"switch","default":false,"label":{"de":"Nicht tiefer als die Voreinstellung","en":"No deeper than the preset"}},
  pattern: {"group":"depth","kind":"choice","choices":["auto","none","square","thin-plus","diamond","thick-plus"],"default":"auto","label":{"de":"Module","en":"Modules"},"choiceNames":{"auto":{"de":"Automatisch","en":"Automatic"},"diamond":{"de":"Raute","en":"Diamond"},"none":{"de":"Voll","en":"Full"},"square":{"de":"Quadrat","en":"Square"},"thick-plus":{"de":"Dickes Plus","en":"Thick plus"},"thin-plus":{"de":"Dünnes Plus","en":"Thin plus"}}},
  finderPattern: {"group":"depth","kind":"choice","choices":["auto","none","as-modules","diamond","thick-plus","thick-plus-sharp"],"default":"auto","label":{"de":"Suchmuster","en":"Finder patterns"},"hint":{"de":"Gravierter Teil der drei großen Quadrate.","en":"Engraved part of the three large squares."},"choiceNames":{"as-modules":{"de":"Wie die Module","en":"Same as modules"},"auto":{"de":"Automatisch","en":"Automatic"},"diamond":{"de":"Raute","en":"Diamond"},"none":{"de":"Voll","en":"Full"},"thick-plus":{"de":"Dickes Plus, gerundet","en":"Thick plus, rounded"},"thick-plus-sharp":{"de":"Dickes Plus","en":"Thick plus"}}},
  contrast: {"group":"depth","kind":"number","min":0.01,"max":0.99,"step":0.01,"mayBeEmpty":true,"default":null,"label":{"de":"Kontrast","en":"Contrast"}},
  carveFor: {"group":"depth","kind":"choice","choices":["design","print"],"default":"print","label":{"de":"Gravieren für","en":"Engrave for"},"hint":{"de":"Mit dem Druck werden Module tiefer, die der Drucker verlieren würde.","en":"With the print, modules that the printer would lose become deeper."},"choiceNames":{"design":{"de":"Nur den Entwurf","en":"Design only"},"print":{"de":"Entwurf und Druck","en":"Design and print"}}},
  objective: {"group":"depth","kind":"choice","choices":["contrast","one-light"],"default":"contrast","label":{"de":"Dunkel durch","en":"Darken by"},"hint":{"de":"Der Schatten einer Lampe ist am flachsten, aber lesbar nur, solange diese Lampe scheint.","en":"The shadow of one lamp is shallowest, but the code reads only while that lamp shines."},"choiceNames":{"contrast":{"de":"Tiefe, für jedes Licht","en":"Depth, for any light"},"one-light":{"de":"Schatten einer Lampe (am flachsten)","en":"Shadow of one lamp (shallowest)"}}},
  solver: {"group":"depth","kind":"choice","choices":["fast","paper-steps"],"default":"fast","label":{"de":"Verfahren","en":"Solver"},"hint":{"de":"Sucht die Tiefen. Die veröffentlichten Schritte dauern länger und dienen Vergleichen.","en":"Searches the depths. The published steps take longer and are for comparisons."},"choiceNames":{"fast":{"de":"Schnell","en":"Fast"},"paper-steps":{"de":"Wie veröffentlicht","en":"As published"}}},
  maxDepthMm: {"group":"depth","kind":"number","unit":"mm","min":0.1,"max":1000.0,"step":0.1,"mayBeEmpty":true,"default":null,"label":{"de":"Größte Tiefe","en":"Maximum depth"}},
  minWallMm: {"group":"depth","kind":"number","unit":"mm","min":0.0,"max":1000.0,"step":0.1,"default":0.8,"label":{"de":"Restwand","en":"Minimum wall"}},
  size: {"group":"placement","kind":"choice-or-number","unit":"mm","min":0.1,"max":10000.0,"step":1.0,"choices":["best","oriented","free"],"default":"best","label":{"de":"Größe des Codes","en":"Size of the code"},"choiceNames":{"best":{"de":"Größte, die passt","en":"Largest that fits"},"free":{"de":"Größte, gleich wie gedreht","en":"Largest, any way up"},"number":{"de":"Genau","en":"Exactly"},"oriented":{"de":"Größte, so gedreht","en":"Largest, this way up"}},"partLabels":{"number":{"de":"Breite","en":"Width"}}},
  maxSizeMm: {"group":"placement","kind":"number","unit":"mm","min":0.1,"max":10000.0,"step":1.0,"default":40.0,"label":{"de":"Höchstens","en":"At most"}},
  quietZone: {"group":"placement","kind":"switch","default":true,"label":{"de":"Ruhezone von vier Modulen einhalten","en":"Keep a quiet zone of four modules"}},
  up: {"group":"placement","kind":"vector","default":[0.0,0.0,1.0],"label":{"de":"Oben am Code","en":"Top of the code"}},
  rotateDeg: {"group":"placement","kind":"number","unit":"deg","min":-360.0,"max":360.0,"step":5.0,"default":0.0,"label":{"de":"Drehung","en":"Rotation"}},
  direction: {"group":"placement","kind":"choice-or-vector","choices":["mean-normal","depth-balanced","pca","optimal"],"default":"depth-balanced","label":{"de":"Richtung","en":"Direction"},"hint":{"de":"Findet die Richtung, aus der man den Code ansieht.","en":"Finds the direction from which the code is viewed."},"choiceNames":{"depth-balanced":{"de":"Ausgeglichene Tiefe","en":"Balanced depth"},"mean-normal":{"de":"Mittel der Normalen","en":"Mean of the normals"},"optimal":{"de":"Beste (langsamer)","en":"Best (slower)"},"pca":{"de":"Flachste Seite","en":"Flattest side"},"vector":{"de":"Angegeben","en":"Given"}}},
  eyeDistanceMm: {"group":"placement","kind":"number","unit":"mm","min":20.0,"max":100000.0,"step":10.0,"default":250.0,"label":{"de":"Betrachtungsabstand","en":"Viewing distance"},"hint":{"de":"Vom Auge des Betrachters zum Code.","en":"From the viewer’s eye to the code."}},
  light: {"group":"light","kind":"lamps","default":[],"label":{"de":"Lampe","en":"Lamp"},"partLabels":{"azimuthDeg":{"de":"Azimut","en":"azimuth"},"elevationDeg":{"de":"Höhe","en":"elevation"},"strength":{"de":"Stärke","en":"strength"}},"parts":{"azimuthDeg":{"min":-360.0,"max":360.0,"step":15.0,"default":0.0},"elevationDeg":{"min":0.1,"max":90.0,"step":5.0,"default":45.0},"strength":{"min":0.0,"max":1000.0,"step":0.25,"default":1.0}},"most":2},
  albedo: {"group":"light","kind":"number","min":0.0,"max":0.95,"step":0.05,"default":0.7,"label":{"de":"Albedo","en":"Albedo"}},
  surface: {"group":"making","kind":"choice","choices":["preserved","resampled"],"default":"preserved","label":{"de":"Oberfläche","en":"Surface"},"hint":{"de":"Dreiecke um den Code: die des Modells oder ein regelmäßiges Gitter.","en":"Triangles around the code: the model’s own, or a regular grid."},"choiceNames":{"preserved":{"de":"Erhalten","en":"Preserved"},"resampled":{"de":"Neu vernetzt","en":"Resampled"}}},
  inlay: {"group":"making","kind":"switch","default":false,"label":{"de":"Zweite Farbe","en":"Second colour"}},
  label: {"group":"making","kind":"text","default":"","label":{"de":"Beschriftung","en":"Label"}},
  frame: {"group":"making","kind":"choice","choices":["none","rounded","square"],"default":"none","label":{"de":"Rahmen","en":"Frame"},"choiceNames":{"none":{"de":"Keiner","en":"None"},"rounded":{"de":"Runde Ecken","en":"Rounded corners"},"square":{"de":"Eckig","en":"Square corners"}}},
  process: {"group":"printing","kind":"choice","choices":["none","fdm-0.4/0.2","fdm-0.4/0.12","fdm-0.25/0.1","fdm-0.6/0.3","resin-0.05","powder"],"default":"fdm-0.4/0.2","label":{"de":"Verfahren","en":"Process"},"choiceNames":{"fdm-0.25/0.1":{"de":"Filament, Düse 0,25 mm, Schichten 0,1 mm","en":"Filament, nozzle 0.25 mm, layers 0.1 mm"},"fdm-0.4/0.12":{"de":"Filament, Düse 0,4 mm, Schichten 0,12 mm","en":"Filament, nozzle 0.4 mm, layers 0.12 mm"},"fdm-0.4/0.2":{"de":"Filament, Düse 0,4 mm, Schichten 0,2 mm","en":"Filament, nozzle 0.4 mm, layers 0.2 mm"},"fdm-0.6/0.3":{"de":"Filament, Düse 0,6 mm, Schichten 0,3 mm","en":"Filament, nozzle 0.6 mm, layers 0.3 mm"},"none":{"de":"Keines: nicht simulieren","en":"None: do not simulate"},"powder":{"de":"Pulver (SLS, MJF)","en":"Powder (SLS, MJF)"},"resin-0.05":{"de":"Harz, Schichten 0,05 mm","en":"Resin, layers 0.05 mm"}}},
  nozzleMm: {"group":"printing","kind":"number","unit":"mm","min":0.01,"max":10.0,"step":0.05,"default":0.4,"label":{"de":"Düse","en":"Nozzle"}},
  layerMm: {"group":"printing","kind":"number","unit":"mm","min":0.01,"max":1.0,"step":0.01,"default":0.2,"label":{"de":"Schicht","en":"Layer"}},
  lineWidthMm: {"group":"printing","kind":"number","unit":"mm","min":0.01,"max":10.0,"step":0.05,"mayBeEmpty":true,"default":null,"label":{"de":"Linienbreite","en":"Line width"}},
  buildUp: {"group":"printing","kind":"choice-or-vector","choices":["as-modelled","code-up","code-upright"],"default":"as-modelled","label":{"de":"Ausrichtung im Drucker","en":"Orientation on the printer"},"choiceNames":{"as-modelled":{"de":"Wie in der Datei","en":"As in the file"},"code-up":{"de":"Liegend, Code nach oben","en":"Lying, code facing up"},"code-upright":{"de":"Stehend, Code senkrecht","en":"Standing, code upright"},"vector":{"de":"Angegeben","en":"Given"}}},
};

/** @type {Readonly<Record<string, { nozzleMm: number, layerMm: number }>>} */
export const kProcesses = {
  'fdm-0.4/0.2': {"nozzleMm":0.4,"layerMm":0.2},
  'fdm-0.4/0.12': {"nozzleMm":0.4,"layerMm":0.12},
  'fdm-0.25/0.1': {"nozzleMm":0.25,"layerMm":0.1},
  'fdm-0.6/0.3': {"nozzleMm":0.6,"layerMm":0.3},
  'resin-0.05': {"nozzleMm":0.05,"layerMm":0.05},
  'powder': {"nozzleMm":0.1,"layerMm":0.1},
};

/** @type {Readonly<Record<string, Words>>} */
export const kSettingGroups = {
  depth: {"de":"Muster und Tiefe","en":"Pattern and depth"},
  light: {"de":"Licht","en":"Light"},
  making: {"de":"Ausgabe","en":"Output"},
  mark: {"de":"Markierung","en":"Mark"},
  placement: {"de":"Lage","en":"Placement"},
  printing: {"de":"Druck","en":"Printing"},
  symbol: {"de":"Symbol","en":"Symbol"},
};

/** @type {Readonly<Record<string, Words>>} */
export const kUnits = {
  deg: {"de":"°","en":"°"},
  mm: {"de":"mm","en":"mm"},
  skies: {"de":"Himmel","en":"skies"},
};
