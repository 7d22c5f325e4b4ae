// SPDX-License-Identifier: GPL-3.0-or-later
// Colours in a picture of the page.
import { readPng } from './read_png.js';

/** @typedef {(red: number, green: number, blue: number) => boolean} Colour */

/** Counts the pixels of a picture that have a colour. @param {import('./read_png.js').Pixels} picture @param {Colour} colour */
export function countOf({ channels, data }, colour) {
  let count = 0;
  for (let i = 0; i < data.length; i += channels) if (colour(data[i], data[i + 1], data[i + 2])) count += 1;
  return count;
}

/**
 * Returns the share of an element's pixels that have a colour, 0 … 1.
 * @param {import('@playwright/test').Locator} element
 * @param {Colour} colour
 */
export async function shareOf(element, colour) {
  const picture = readPng(await element.screenshot());
  return countOf(picture, colour) / (picture.width * picture.height);
}

/**
 * Returns how far the brightness of two pictures in a rectangle is apart, in the mean over blocks; 1: black and white.
 * @param {import('./read_png.js').Pixels} one
 * @param {import('./read_png.js').Pixels} other  of the same size
 * @param {{ x: number, y: number }} from  its upper left corner
 * @param {{ x: number, y: number }} to    its lower right corner
 * @param {number} edge  of a block, in pixels
 */
export function meanDifference(one, other, from, to, edge) {
  const inBlock = (/** @type {number} */ left, /** @type {number} */ top) => {
    let sum = 0;
    for (let y = top; y < top + edge; y += 1)
      for (let x = left; x < left + edge; x += 1) {
        const at = one.channels * (y * one.width + x) + 1; // of green
        sum += one.data[at] - other.data[at];
      }
    return Math.abs(sum) / edge ** 2 / 255;
  };
  const differences = [];
  for (let y = Math.ceil(from.y); y + edge <= to.y; y += edge)
    for (let x = Math.ceil(from.x); x + edge <= to.x; x += edge) differences.push(inBlock(x, y));
  return differences.reduce((sum, difference) => sum + difference, 0) / differences.length;
}

/** A section, or the part of a code that misses the surface. @type {Colour} */
export const isOrange = (red, green, blue) => red > 1.35 * green && green > 1.1 * blue && red > 90;

/** Ink in light or shade. Words over the view count, too. @type {Colour} */
export const isDark = (red, green, blue) => Math.max(red, green, blue) < 75;

/** The middle colour of the depth map. The page's own green, as in buttons over the view, counts too. @type {Colour} */
export const isTeal = (red, green, blue) => green > 1.3 * red && blue > 1.1 * red && blue < 1.15 * green && green > 60;

/** The rays of the projection in the construction. @type {Colour} */
export const isViolet = (red, green, blue) => red > 1.15 * green && blue > 1.2 * red && blue > 120;
