// SPDX-License-Identifier: GPL-3.0-or-later
// Reads screenshots here, which is much faster than to read them in the page and to send the pixels through Playwright.
import assert from 'node:assert/strict';
import { inflateSync } from 'node:zlib';

/** @typedef {{ width: number, height: number, channels: number, data: Uint8Array }} Pixels  row by row from the top left */

/** Returns the data of a file's chunks of a type. @param {Buffer} file @param {string} type */
function chunksOf(file, type) {
  const chunks = [];
  for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at))
    if (file.toString('latin1', at + 4, at + 8) === type)
      chunks.push(file.subarray(at + 8, at + 8 + file.readUInt32BE(at)));
  return Buffer.concat(chunks);
}

/** @param {number} left @param {number} above @param {number} aboveLeft */
function paeth(left, above, aboveLeft) {
  const [toLeft, toAbove] = [Math.abs(above - aboveLeft), Math.abs(left - aboveLeft)];
  const toBoth = Math.abs(left + above - 2 * aboveLeft);
  return toLeft <= toAbove && toLeft <= toBoth ? left : toAbove <= toBoth ? above : aboveLeft;
}

/** Predictions of a byte from its neighbours, by the type of a row's filter. */
const kPredictions = [
  () => 0,
  (/** @type {number} */ left) => left,
  (/** @type {number} */ _left, /** @type {number} */ above) => above,
  (/** @type {number} */ left, /** @type {number} */ above) => (left + above) >> 1,
  paeth,
];

/**
 * Returns the pixels of a PNG file with 8 bits per channel, in colour and not interlaced.
 * @param {Uint8Array} png
 * @returns {Pixels}
 */
export function readPng(png) {
  const file = Buffer.from(png);
  const header = chunksOf(file, 'IHDR');
  const [width, height] = [header.readUInt32BE(0), header.readUInt32BE(4)];
  const channels = header[9] === 6 ? 4 : 3;
  assert.deepEqual([...header.subarray(8)], [8, channels === 4 ? 6 : 2, 0, 0, 0]);
  const packed = inflateSync(chunksOf(file, 'IDAT')); // each row begins with the type of its filter
  const length = width * channels;
  const data = new Uint8Array(height * length);
  for (let y = 0; y < height; y += 1) {
    const predict = kPredictions[packed[y * (length + 1)]];
    const row = y * length;
    for (let x = 0; x < length; x += 1) {
      const left = x >= channels ? data[row + x - channels] : 0;
      const above = y > 0 ? data[row + x - length] : 0;
      const aboveLeft = x >= channels && y > 0 ? data[row + x - length - channels] : 0;
      data[row + x] = packed[y * (length + 1) + 1 + x] + predict(left, above, aboveLeft);
    }
  }
  return { width, height, channels, data };
}
