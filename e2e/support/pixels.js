// SPDX-License-Identifier: GPL-3.0-or-later
// Colours in a picture of the page.

/** @typedef {(red: number, green: number, blue: number) => boolean} Colour */

/**
 * Returns the share of an element's pixels that have a colour, 0 … 1.
 * @param {import('@playwright/test').Locator} element
 * @param {Colour} colour
 */
export async function shareOf(element, colour) {
  const png = (await element.screenshot()).toString('base64');
  const pixels = await element.page().evaluate(async (encoded) => {
    const bytes = Uint8Array.from(atob(encoded), (letter) => letter.charCodeAt(0));
    const picture = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const scale = Math.min(1, 240 / picture.width); // enough pixels, yet few to transfer
    const [width, height] = [Math.round(picture.width * scale), Math.round(picture.height * scale)];
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (
      new OffscreenCanvas(width, height).getContext('2d')
    );
    context.imageSmoothingEnabled = false;
    context.drawImage(picture, 0, 0, width, height);
    return [...context.getImageData(0, 0, width, height).data];
  }, png);
  let count = 0;
  for (let i = 0; i < pixels.length; i += 4) if (colour(pixels[i], pixels[i + 1], pixels[i + 2])) count += 1;
  return (4 * count) / pixels.length;
}

/** A section, or the part of a code that misses the surface. @type {Colour} */
export const isOrange = (red, green, blue) => red > 1.35 * green && green > 1.1 * blue && red > 90;

/** Ink in light or shade. Words over the view count, too. @type {Colour} */
export const isDark = (red, green, blue) => Math.max(red, green, blue) < 75;

/** The middle colour of the depth map. The page's own green, as in buttons over the view, counts too. @type {Colour} */
export const isTeal = (red, green, blue) => green > 1.3 * red && blue > 1.1 * red && blue < 1.15 * green && green > 60;
