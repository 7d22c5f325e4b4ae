// SPDX-License-Identifier: GPL-3.0-or-later
// Writes PNG files. It is used by the build, not by the page.
import { crc32, deflateSync } from 'node:zlib';

const kSignature = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);

/**
 * @param {string} type  four letters
 * @param {Uint8Array} data
 */
function chunk(type, data) {
  const bytes = Buffer.alloc(12 + data.length);
  bytes.writeUInt32BE(data.length, 0);
  bytes.write(type, 4, 'latin1');
  bytes.set(data, 8);
  bytes.writeUInt32BE(crc32(bytes.subarray(4, 8 + data.length)), 8 + data.length);
  return bytes;
}

/**
 * Returns a PNG file with 8 bits per channel and alpha.
 * @param {number} width
 * @param {number} height
 * @param {Uint8Array} rgba  row by row from the top left, not premultiplied
 * @returns {Buffer}
 */
export function writePng(width, height, rgba) {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 6], 8); // 8 bits, RGBA; then the only compression and filter methods, not interlaced
  const rows = Buffer.alloc(height * (1 + 4 * width)); // each row begins with its filter type: none
  for (let y = 0; y < height; y += 1)
    rows.set(rgba.subarray(4 * width * y, 4 * width * (y + 1)), y * (1 + 4 * width) + 1);
  return Buffer.concat([
    kSignature,
    chunk('IHDR', header),
    chunk('IDAT', deflateSync(rows, { level: 9 })),
    chunk('IEND', new Uint8Array()),
  ]);
}
