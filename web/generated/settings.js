// SPDX-License-Identifier: GPL-3.0-or-later
// Written by build/release/bin/qrelief_generate from core/settings: do not edit.

/**
 * @typedef {object} Setting
 * @property {string} group
 * @property {'text' | 'switch' | 'number' | 'choice' | 'choice-or-number' | 'choice-or-vector' | 'vector' | 'mask' | 'lamps'} kind
 * @property {UnitName} [unit]
 * @property {number} [min]          of a number, inclusive
 * @property {number} [max]
 * @property {number} [step]
 * @property {boolean} [whole]       a number without decimals
 * @property {boolean} [mayBeEmpty]  may be left out: what then counts follows from the rest
 * @property {readonly string[]} [choices]
 * @property {unknown} default       null: it is empty
 * @property {Readonly<Record<string, { min: number, max: number, step: number, default: number }>>} [parts]  of a lamp
 * @property {number} [most]         lamps
 */

/** @typedef {'text' | 'content' | 'ecc' | 'version' | 'mask' | 'eci' | 'mark' | 'markDepthMm' | 'albedo' | 'darkReflectance' | 'preset' | 'keepPreset' | 'pattern' | 'patternMask' | 'finderPattern' | 'contrast' | 'carveFor' | 'objective' | 'solver' | 'maxDepthMm' | 'minWallMm' | 'size' | 'maxSizeMm' | 'quietZone' | 'up' | 'rotateDeg' | 'direction' | 'eyeDistanceMm' | 'light' | 'surface' | 'label' | 'frame' | 'process' | 'nozzleMm' | 'layerMm' | 'lineWidthMm' | 'buildUp'} SettingKey */
/** @typedef {'mm' | 'deg' | 'skies'} UnitName */

/** @type {Readonly<Record<SettingKey, Setting>>} */
export const kSettings = {
  text: {"group":"symbol","kind":"text","default":""},
  content: {"group":"symbol","kind":"choice","choices":["code","text"],"default":"code"},
  ecc: {"group":"symbol","kind":"choice","choices":["auto","L","M","Q","H"],"default":"auto"},
  version: {"group":"symbol","kind":"number","min":1.0,"max":40.0,"step":1.0,"whole":true,"mayBeEmpty":true,"default":null},
  mask: {"group":"symbol","kind":"choice-or-number","min":0.0,"max":7.0,"step":1.0,"whole":true,"choices":["auto","shadiest"],"default":"auto"},
  eci: {"group":"symbol","kind":"choice","choices":["auto","never"],"default":"auto"},
  mark: {"group":"mark","kind":"choice","choices":["auto","shadow","inlay","paint"],"default":"shadow"},
  markDepthMm: {"group":"mark","kind":"number","unit":"mm","min":0.05,"max":1000.0,"step":0.05,"mayBeEmpty":true,"default":null},
  albedo: {"group":"mark","kind":"number","min":0.01,"max":0.95,"step":0.05,"mayBeEmpty":true,"default":null},
  darkReflectance: {"group":"mark","kind":"number","min":0.01,"max":1.0,"step":0.05,"default":0.05},
  preset: {"group":"depth","kind":"choice","choices":["shallow","balanced","robust"],"default":"balanced"},
  keepPreset: {"group":"depth","kind":"switch","default":false},
  pattern: {"group":"depth","kind":"choice","choices":["auto","none","square","thin-plus","diamond","thick-plus"],"default":"auto"},
  patternMask: {"group":"depth","kind":"mask","mayBeEmpty":true,"default":null},
  finderPattern: {"group":"depth","kind":"choice","choices":["auto","none","as-modules","diamond","thick-plus","thick-plus-sharp"],"default":"auto"},
  contrast: {"group":"depth","kind":"number","min":0.01,"max":0.99,"step":0.01,"mayBeEmpty":true,"default":null},
  carveFor: {"group":"depth","kind":"choice","choices":["design","print"],"default":"print"},
  objective: {"group":"depth","kind":"choice","choices":["contrast","one-light"],"default":"contrast"},
  solver: {"group":"depth","kind":"choice","choices":["fast","paper-steps"],"default":"fast"},
  maxDepthMm: {"group":"depth","kind":"number","unit":"mm","min":0.1,"max":1000.0,"step":0.1,"mayBeEmpty":true,"default":null},
  minWallMm: {"group":"depth","kind":"number","unit":"mm","min":0.0,"max":1000.0,"step":0.1,"default":0.8},
  size: {"group":"placement","kind":"choice-or-number","unit":"mm","min":0.1,"max":10000.0,"step":1.0,"choices":["best","oriented","free"],"default":"best"},
  maxSizeMm: {"group":"placement","kind":"number","unit":"mm","min":0.1,"max":10000.0,"step":1.0,"default":40.0},
  quietZone: {"group":"placement","kind":"switch","default":true},
  up: {"group":"placement","kind":"vector","default":[0.0,0.0,1.0]},
  rotateDeg: {"group":"placement","kind":"number","unit":"deg","min":-360.0,"max":360.0,"step":5.0,"default":0.0},
  direction: {"group":"placement","kind":"choice-or-vector","choices":["mean-normal","depth-balanced","pca","optimal","largest"],"default":"depth-balanced"},
  eyeDistanceMm: {"group":"placement","kind":"number","unit":"mm","min":20.0,"max":100000.0,"step":10.0,"default":250.0},
  light: {"group":"light","kind":"lamps","default":[],"parts":{"azimuthDeg":{"min":-360.0,"max":360.0,"step":15.0,"default":0.0},"elevationDeg":{"min":0.1,"max":90.0,"step":5.0,"default":45.0},"strength":{"min":0.0,"max":1000.0,"step":0.25,"default":1.0}},"most":2},
  surface: {"group":"making","kind":"choice","choices":["preserved","resampled"],"default":"preserved"},
  label: {"group":"making","kind":"text","default":""},
  frame: {"group":"making","kind":"choice","choices":["none","rounded","square"],"default":"none"},
  process: {"group":"printing","kind":"choice","choices":["none","fdm-0.4/0.2","fdm-0.4/0.12","fdm-0.25/0.1","fdm-0.6/0.3","resin-0.05","powder"],"default":"fdm-0.4/0.2"},
  nozzleMm: {"group":"printing","kind":"number","unit":"mm","min":0.01,"max":10.0,"step":0.05,"default":0.4},
  layerMm: {"group":"printing","kind":"number","unit":"mm","min":0.01,"max":1.0,"step":0.01,"default":0.2},
  lineWidthMm: {"group":"printing","kind":"number","unit":"mm","min":0.01,"max":10.0,"step":0.05,"mayBeEmpty":true,"default":null},
  buildUp: {"group":"printing","kind":"choice-or-vector","choices":["as-modelled","code-up","code-upright"],"default":"as-modelled"},
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
