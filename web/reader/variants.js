// SPDX-License-Identifier: GPL-3.0-or-later
// What a scanning app tries on one camera frame: the same variants, in the same order, as core/verification.

/** @typedef {import('../engine/types.js').GreyImage} GreyImage */

const kSoftnessPerWidth = 1 / 230;  // out of focus by three pixels of 700: closes the gaps between a pattern's squares

/**
 * The picture as it is, contrast-stretched, out of focus, and from farther away.
 * @param {GreyImage} picture
 * @returns {GreyImage[]}
 */
export function readingVariants(picture) {
  const soft = stretched(blurred(picture, picture.width * kSoftnessPerWidth));
  return [picture, stretched(picture), soft, stretched(shrunk(picture, 2)), stretched(shrunk(picture, 3))];
}

/** The 1st and the 99th percentile become black and white. @param {GreyImage} image @returns {GreyImage} */
export function stretched({ width, height, pixels }) {
  const sorted = pixels.slice().sort();
  const margin = Math.floor(sorted.length / 100);
  const low = sorted[margin];
  const range = Math.max(sorted[sorted.length - 1 - margin] - low, 1);
  const stretch = (/** @type {number} */ value) => Math.min(255, Math.max(0, Math.round(((value - low) * 255) / range)));
  return { width, height, pixels: pixels.map(stretch) };
}

/** Means of factor × factor pixels. @param {GreyImage} image @param {number} factor @returns {GreyImage} */
export function shrunk({ width, height, pixels }, factor) {
  const small = { width: Math.floor(width / factor), height: Math.floor(height / factor) };
  const out = new Uint8Array(small.width * small.height);
  for (let y = 0; y < small.height; y += 1) {
    for (let x = 0; x < small.width; x += 1) {
      let sum = 0;
      for (let k = 0; k < factor * factor; k += 1) {
        sum += pixels[(y * factor + Math.floor(k / factor)) * width + x * factor + (k % factor)];
      }
      out[y * small.width + x] = Math.round(sum / (factor * factor));
    }
  }
  return { ...small, pixels: out };
}

/** Gaussian blur; the border is continued outwards. @param {GreyImage} image @param {number} sigma @returns {GreyImage} */
export function blurred({ width, height, pixels }, sigma) {
  const reach = Math.ceil(3 * sigma);
  const kernel = Array.from({ length: 2 * reach + 1 }, (_, i) => Math.exp(-((i - reach) ** 2) / (2 * sigma * sigma)));
  const sum = kernel.reduce((a, b) => a + b, 0);
  const rows = new Float32Array(pixels.length);
  convolve(pixels, rows, { length: width, stride: 1, lines: height, lineStride: width }, kernel);
  const both = new Float32Array(pixels.length);
  convolve(rows, both, { length: height, stride: width, lines: width, lineStride: 1 }, kernel);
  return { width, height, pixels: Uint8Array.from(both, (value) => Math.round(value / (sum * sum))) };
}

/**
 * @param {Uint8Array | Float32Array} from
 * @param {Float32Array} to
 * @param {{ length: number, stride: number, lines: number, lineStride: number }} layout
 * @param {number[]} kernel  of odd length
 */
function convolve(from, to, { length, stride, lines, lineStride }, kernel) {
  const reach = (kernel.length - 1) / 2;
  for (let line = 0; line < lines; line += 1) {
    const start = line * lineStride;
    for (let i = 0; i < length; i += 1) {
      let sum = 0;
      for (let k = -reach; k <= reach; k += 1) {
        sum += kernel[k + reach] * from[start + Math.min(length - 1, Math.max(0, i + k)) * stride];
      }
      to[start + i * stride] = sum;
    }
  }
}
