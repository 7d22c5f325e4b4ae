// SPDX-License-Identifier: GPL-3.0-or-later

/** @typedef {import('../engine/types.js').Settings} Settings */

/** @param {number | undefined} value  '' leaves it to the module */
const written = (value) => (value === undefined ? '' : String(value));

/**
 * What the controls of the page have to hold for these settings, by their ids.
 * @param {Settings} settings
 * @returns {Record<string, string | boolean>}
 */
export function formValues(settings) {
  const { size } = settings;
  const fixed = typeof size === 'number';
  return {
    preset: settings.preset,
    pattern: settings.pattern,
    'finder-pattern': settings.finderPattern,
    size: fixed ? 'fixed' : size,
    'size-mm': String(fixed ? size : settings.maxSizeMm),
    'quiet-zone': settings.quietZone,
    direction: settings.direction,
    rotate: String(settings.rotateDeg),
    'min-wall': String(settings.minWallMm),
    nozzle: String(settings.nozzleMm),
    layer: String(settings.layerMm),
    'eye-distance': String(settings.eyeDistanceMm),
    ecc: settings.ecc ?? 'auto',
    contrast: written(settings.contrast),
    'max-depth': written(settings.maxDepthMm),
  };
}
