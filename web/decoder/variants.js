// SPDX-License-Identifier: GPL-3.0-or-later
// What a scanning app tries on one camera frame: the same variants, in the same order, as core/verification.

/** @typedef {import('../engine/types.js').GreyImage} GreyImage */

/**
 * The picture as it is, contrast-stretched, out of focus (which closes the gaps between a pattern's squares), and from
 * farther away.
 * @param {GreyImage} picture
 * @param {number} pixelsPerModule  of the code in it
 * @returns {GreyImage[]}
 */
export function readingVariants(picture, pixelsPerModule) {
  const outOfFocus = (/** @type {number} */ modules) => stretched(blurred(picture, modules * pixelsPerModule));
  return [picture, stretched(picture), outOfFocus(0.2), outOfFocus(0.35), stretched(shrunk(picture, 2)), stretched(shrunk(picture, 3))];
}

const kScales = [1, 6.5 / 8, 5 / 8];
const kBlursModules = [0, 0.13];

/**
 * Pictures from the front that differ in scale and focus: that one of them reads says little.
 * @param {GreyImage} picture
 * @param {number} pixelsPerModule
 * @returns {{ picture: GreyImage, pixelsPerModule: number }[]}
 */
export function frontalPictures(picture, pixelsPerModule) {
  return kScales.flatMap((scale) => kBlursModules.map((modules) => {
    const focused = modules > 0 ? blurred(picture, modules * pixelsPerModule) : picture;
    return { picture: scale < 1 ? shrunkTo(focused, Math.round(picture.width * scale)) : focused, pixelsPerModule: pixelsPerModule * scale };
  }));
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

/** Means over the areas that the new pixels cover. @param {GreyImage} image  square @param {number} edge  of the new one, smaller @returns {GreyImage} */
export function shrunkTo({ width, pixels }, edge) {
  const weights = coverage(width, edge);
  const out = new Uint8Array(edge * edge);
  for (let y = 0; y < edge; y += 1) {
    for (let x = 0; x < edge; x += 1) {
      let sum = 0;
      for (const [row, wy] of weights[y]) for (const [column, wx] of weights[x]) sum += wy * wx * pixels[row * width + column];
      out[y * edge + x] = Math.round(sum);
    }
  }
  return { width: edge, height: edge, pixels: out };
}

/** For each new pixel of a line the old ones in it, with their shares. @param {number} from @param {number} to @returns {[number, number][][]} */
function coverage(from, to) {
  const step = from / to;
  return Array.from({ length: to }, (_, i) => {
    /** @type {[number, number][]} */ const parts = [];
    for (let k = Math.floor(i * step); k < Math.min(from, Math.ceil((i + 1) * step)); k += 1) {
      parts.push([k, (Math.min(k + 1, (i + 1) * step) - Math.max(k, i * step)) / step]);
    }
    return parts;
  });
}
