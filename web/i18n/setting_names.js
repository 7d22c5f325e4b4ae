// SPDX-License-Identifier: GPL-3.0-or-later
// What the page calls a setting of the core, and each of its choices.
import { text } from './catalogue.js';

/** @typedef {import('./catalogue.js').Key} Key */

/** @type {Record<string, Key>} */
const kControls = {
  text: 'page.text', ecc: 'settings.eccLevel', preset: 'settings.preset', pattern: 'settings.modules',
  finderPattern: 'settings.finder', size: 'settings.size', sizeMm: 'settings.widthMm', maxSizeMm: 'settings.atMostMm', quietZone: 'settings.quietZone',
  direction: 'settings.direction', rotateDeg: 'settings.rotate', contrast: 'settings.contrast', minWallMm: 'settings.minWall',
  nozzleMm: 'settings.nozzle', layerMm: 'settings.layer', maxDepthMm: 'settings.maxDepth', eyeDistanceMm: 'settings.distance',
  centreMm: 'settings.centre', units: 'settings.unit', unit: 'settings.unit', scale: 'settings.unit', upAxis: 'settings.upAxis',
};

/** @type {Record<string, Record<string, Key>>} */
const kChoices = {
  ecc: { L: 'settings.eccL', M: 'settings.eccM', Q: 'settings.eccQ', H: 'settings.eccH' },
  preset: { shallow: 'settings.presetShallow', balanced: 'settings.presetBalanced', robust: 'settings.presetRobust' },
  pattern: {
    none: 'settings.full', square: 'settings.square', 'thin-plus': 'settings.thinPlus', diamond: 'settings.diamond',
    'thick-plus': 'settings.thickPlus',
  },
  finderPattern: {
    none: 'settings.full', 'as-modules': 'settings.asModules', diamond: 'settings.diamond',
    'thick-plus': 'settings.thickPlusRounded', 'thick-plus-sharp': 'settings.thickPlus',
  },
  units: { m: 'settings.metres', cm: 'settings.centimetres', in: 'settings.inches' },
  size: { free: 'settings.sizeFree', oriented: 'settings.sizeOriented', best: 'settings.sizeBest' },
  direction: {
    'depth-balanced': 'settings.directionBalanced', 'mean-normal': 'settings.directionNormal', pca: 'settings.directionPca',
    optimal: 'settings.directionOptimal',
  },
};

export const isKnownSetting = (/** @type {string} */ key) => key in kControls;

/** What stands at the control. @param {string} key  of the core */
export const controlName = (key) => (isKnownSetting(key) ? text(kControls[key]) : key);

/** The same without the unit behind it. @param {string} key */
export const controlLabel = (key) => controlName(key).replace(/ \([^)]*\)$/, '');

/** @param {string} key @param {string} value */
export function choiceLabel(key, value) {
  const label = kChoices[key]?.[value];
  return label ? text(label) : value;
}
