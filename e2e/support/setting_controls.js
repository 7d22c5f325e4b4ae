// SPDX-License-Identifier: GPL-3.0-or-later
// The controls of settings that are saved and carved with, for controls.spec.js.

/** For each setting: the value to choose, its entry in the settings file, and the value to find in the report. */
export const kSettings =
  /** @type {Record<string, { value: string | boolean, saved: Record<string, unknown>, reported?: (report: any) => unknown }>} */ ({
    ecc: { value: 'Q', saved: { ecc: 'Q' }, reported: ({ symbol }) => symbol.ecc },
    'quiet-zone': { value: false, saved: { quietZone: false } },
    rotate: { value: '10', saved: { rotateDeg: 10 }, reported: ({ size }) => size.rotationDeg },
    size: { value: 'fixed', saved: { size: 40 } },
    'size-mm': { value: '31', saved: { size: 31 }, reported: ({ size }) => size.symbolMm },
    direction: {
      value: 'mean-normal',
      saved: { direction: 'mean-normal' },
      reported: ({ projection }) => projection.method,
    },
    'eye-distance': {
      value: '300',
      saved: { eyeDistanceMm: 300 },
      reported: ({ projection }) => projection.eyeDistanceMm,
    },
    preset: { value: 'shallow', saved: { preset: 'shallow' } },
    pattern: { value: 'square', saved: { pattern: 'square' }, reported: ({ depth }) => depth.features.pattern },
    'finder-pattern': { value: 'diamond', saved: { finderPattern: 'diamond' } },
    contrast: { value: '0.28', saved: { contrast: 0.28 }, reported: ({ depth }) => depth.contrast },
    'carve-for': { value: 'design', saved: { carveFor: 'design' }, reported: ({ depth }) => depth.carvedFor },
    version: { value: '5', saved: { version: 5 }, reported: ({ symbol }) => symbol.version },
    mask: { value: '3', saved: { mask: 3 }, reported: ({ symbol }) => symbol.mask },
    eci: { value: 'never', saved: { eci: 'never' } },
    'min-wall': { value: '1.5', saved: { minWallMm: 1.5 } },
    'max-depth': { value: '1.4', saved: { maxDepthMm: 1.4 } },
    process: { value: 'resin-0.05', saved: { process: 'resin-0.05' } },
    'build-up': { value: 'code-up', saved: { buildUp: 'code-up' } },
    nozzle: { value: '0.3', saved: { nozzleMm: 0.3 }, reported: ({ depth }) => depth.features.nozzleMm },
    layer: { value: '0.08', saved: { layerMm: 0.08 }, reported: ({ depth }) => depth.features.layerMm },
  });
