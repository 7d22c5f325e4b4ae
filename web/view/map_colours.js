// SPDX-License-Identifier: GPL-3.0-or-later
// Paints maps of numbers as pictures. The first row of a map is the lowest, the first row of a picture the highest.

/** @typedef {import('../engine/types.js').JobMap} JobMap */
/** @typedef {{ width: number, height: number, rgba: Uint8ClampedArray<ArrayBuffer> }} Pixels */

/** Samples of Viridis, as in the page's legend. It suits every kind of colour vision. */
const kRamp = [
  [68, 1, 84],
  [58, 82, 139],
  [33, 144, 140],
  [93, 201, 98],
  [253, 231, 37],
];

/** @param {number} share  0 … 1 @returns {number[]} */
export function rampColour(share) {
  const at = Math.min(1, Math.max(0, share)) * (kRamp.length - 1);
  const below = Math.min(Math.floor(at), kRamp.length - 2);
  return kRamp[below].map((value, i) => value + (kRamp[below + 1][i] - value) * (at - below));
}

/**
 * @param {JobMap} map
 * @param {(at: number) => number[] | undefined} colour  of the texel whose first value is values[at]; undefined:
 *   transparent
 * @returns {Pixels}
 */
function paint({ width, height, components }, colour) {
  const rgba = new Uint8ClampedArray(4 * width * height);
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      const rgb = colour(components * ((height - 1 - y) * width + x));
      if (rgb) rgba.set([...rgb, 255], 4 * (y * width + x));
    }
  }
  return { width, height, rgba };
}

/** Tells whether a texel's ray meets the model. @param {JobMap} map @param {number} at  the texel's first value */
const isSurface = ({ values }, at) => values[at] !== 0 || values[at + 1] !== 0 || values[at + 2] !== 0;

/** @param {JobMap} surface @returns {Pixels}  −1 … 1 as 0 … 255 */
export const paintNormals = (surface) =>
  paint(surface, (at) =>
    isSurface(surface, at) ? [0, 1, 2].map((axis) => (surface.values[at + axis] + 1) * 127.5) : undefined,
  );

/**
 * @param {JobMap} map
 * @param {(at: number) => number | undefined} valueOf
 * @returns {Pixels & { from: number, to: number }}
 */
function paintRamp(map, valueOf) {
  let [from, to] = [Infinity, -Infinity];
  for (let at = 0; at < map.values.length; at += map.components) {
    const value = valueOf(at);
    if (value === undefined) continue;
    from = Math.min(from, value);
    to = Math.max(to, value);
  }
  const span = to - from || 1;
  const pixels = paint(map, (at) => {
    const value = valueOf(at);
    return value === undefined ? undefined : rampColour((value - from) / span);
  });
  return { ...pixels, from, to };
}

/** @param {JobMap} surface */
export const paintHeights = (surface) =>
  paintRamp(surface, (at) => (isSurface(surface, at) ? surface.values[at + 3] : undefined));

/** Paints the depths of the carved texels; the rest stays transparent. @param {JobMap} depths */
export const paintDepths = (depths) =>
  paintRamp(depths, (at) => (depths.values[at] > 0 ? depths.values[at] : undefined));

/** @param {JobMap} luminance @returns {Pixels}  linear light, as the grey that a screen needs to show it */
export const paintLight = (luminance) =>
  paint(luminance, (at) => {
    const grey = 255 * Math.min(1, Math.max(0, luminance.values[at])) ** (1 / 2.2);
    return [grey, grey, grey];
  });
