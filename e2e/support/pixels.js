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

/** A section, or the part of a code that misses the surface. @type {Colour} */
export const isOrange = (red, green, blue) => red > 1.35 * green && green > 1.1 * blue && red > 90;

/** Ink in light or shade. Words over the view count, too. @type {Colour} */
export const isDark = (red, green, blue) => Math.max(red, green, blue) < 75;

/** The middle colour of the depth map. The page's own green, as in buttons over the view, counts too. @type {Colour} */
export const isTeal = (red, green, blue) => green > 1.3 * red && blue > 1.1 * red && blue < 1.15 * green && green > 60;
