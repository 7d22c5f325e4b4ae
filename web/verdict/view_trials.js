// SPDX-License-Identifier: GPL-3.0-or-later
// From where a carved code reads: simulated pictures from aside and from farther away, each given to the reader.
import { shrunkTo } from '../decoder/variants.js';

/** @typedef {import('../engine/types.js').GreyImage} GreyImage */
/** @typedef {{ tiltDeg: number, reads: number, all: number }} TiltTrial */
/** @typedef {{ tilts: TiltTrial[], leastPixels: number | undefined }} Trials
 *   `tilts`: up to the first from which nothing is read; `leastPixels`: a module's least width in pixels at which it reads, without a gap from the nearest */

const kTiltsDeg = [5, 10, 15, 30, 45];
const kAzimuthsDeg = [0, 90, 180, 270];
const kPixelsPerModule = [6.5, 5, 4, 3.3, 2.6, 2];
const kMarginModules = 12;  // beside the symbol in the picture, as core/pipeline/engrave.cpp draws it
export const kTrials = kTiltsDeg.length * kAzimuthsDeg.length + kPixelsPerModule.length;

/** @param {GreyImage} picture  of the code @param {number} modules  along the symbol's edge */
export const pixelsPerModule = (picture, modules) => picture.width / (modules + kMarginModules);

/** Hands hold a phone as straight as this without taking care. */
export const kForgivingDeg = 10;

const kVideoPixels = 1920;  // across a phone's video,
const kVideoDeg = 65;       // which sees so much

/** How far a phone may be for a module to be so many pixels wide in its video. @param {number} moduleMm @param {number} pixels */
export const distanceMm = (moduleMm, pixels) => (kVideoPixels / 2 / Math.tan((kVideoDeg / 2) * (Math.PI / 180))) * (moduleMm / pixels);

/** The last tilt up to which every direction reads; 0: none. @param {TiltTrial[]} tilts */
export function safeTiltDeg(tilts) {
  const failing = tilts.findIndex((trial) => trial.reads < trial.all);
  return failing < 0 ? tilts.at(-1)?.tiltDeg ?? 0 : tilts[failing - 1]?.tiltDeg ?? 0;
}

/**
 * @param {object} options
 * @param {(tiltDeg: number, azimuthDeg: number) => Promise<GreyImage>} options.pictureFrom
 * @param {() => Promise<GreyImage>} options.picture  from the reader's eye
 * @param {(image: GreyImage) => Promise<boolean>} options.reads
 * @param {number} options.modules  along the symbol's edge
 * @param {(done: number) => void} options.onTrial
 * @param {AbortSignal} options.signal
 * @returns {Promise<Trials | undefined>}  none if it was stopped
 */
export async function tryViews({ pictureFrom, picture, reads, modules, onTrial, signal }) {
  let done = 0;
  const trial = async (/** @type {GreyImage} */ image) => {
    const read = image.width > 0 && await reads(image);
    done += 1;
    if (!signal.aborted) onTrial(done);
    return read;
  };
  /** @type {TiltTrial[]} */ const tilts = [];
  for (const tiltDeg of kTiltsDeg) {
    const one = { tiltDeg, reads: 0, all: kAzimuthsDeg.length };
    for (const azimuthDeg of kAzimuthsDeg) {
      if (signal.aborted) return undefined;
      if (await trial(await pictureFrom(tiltDeg, azimuthDeg))) one.reads += 1;
    }
    tilts.push(one);
    if (one.reads === 0) break;  // farther aside nothing is read, either
  }
  done = kTiltsDeg.length * kAzimuthsDeg.length;
  const whole = await picture();
  /** @type {number | undefined} */ let leastPixels;
  let gap = false;
  for (const pixels of kPixelsPerModule) {
    if (signal.aborted) return undefined;
    const width = Math.round(pixels * (modules + kMarginModules));
    const read = await trial(width < whole.width ? shrunkTo(whole, width) : whole);
    gap ||= !read;
    if (!gap) leastPixels = pixels;
  }
  return { tilts, leastPixels };
}
