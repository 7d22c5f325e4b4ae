// SPDX-License-Identifier: GPL-3.0-or-later
// Binary STL: an 80-byte header, the count, then 50 bytes per triangle, little-endian.

/** @typedef {import('./solid.js').Mesh} Mesh */
/** @typedef {import('./solid.js').Point} Point */
/** @typedef {import('./solid.js').Triangle} Triangle */

const kHeaderBytes = 84;
const kTriangleBytes = 50;

/**
 * Leaves the normals zero, which tells readers to compute them from the corners. Zeros compress; normals hardly do.
 * @param {Mesh} mesh
 * @param {string} title  at most 80 ASCII characters; must not begin with "solid"
 * @returns {Uint8Array}
 */
export function writeStl(mesh, title) {
  const bytes = new Uint8Array(kHeaderBytes + kTriangleBytes * mesh.triangles.length);
  bytes.set(new TextEncoder().encode(title).subarray(0, 80));
  const view = new DataView(bytes.buffer);
  view.setUint32(80, mesh.triangles.length, true);
  mesh.triangles.forEach((corners, index) => {
    corners.forEach((corner, row) => {
      const at = kHeaderBytes + index * kTriangleBytes + 12 + row * 12;
      mesh.positions[corner].forEach((x, axis) => view.setFloat32(at + axis * 4, x, true));
    });
  });
  return bytes;
}

/**
 * Reads a binary STL and welds vertices with equal coordinates.
 * @param {Uint8Array} bytes
 * @returns {Mesh}
 */
export function readStl(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = bytes.length < kHeaderBytes ? -1 : view.getUint32(80, true);
  if (bytes.length !== kHeaderBytes + kTriangleBytes * count) {
    throw new Error(`A binary STL of ${count} triangles cannot have ${bytes.length} bytes`);
  }
  /** @type {Map<string, number>} */ const indices = new Map();
  /** @type {Point[]} */ const positions = [];
  /** @type {Triangle[]} */ const triangles = [];
  for (let index = 0; index < count; index += 1) {
    const corners = [0, 1, 2].map((corner) => {
      const at = kHeaderBytes + index * kTriangleBytes + 12 + corner * 12;
      const point = /** @type {Point} */ ([0, 4, 8].map((offset) => view.getFloat32(at + offset, true) + 0));
      const key = point.join();
      let vertex = indices.get(key);
      if (vertex === undefined) {
        vertex = positions.length;
        positions.push(point);
        indices.set(key, vertex);
      }
      return vertex;
    });
    triangles.push(/** @type {Triangle} */ (corners));
  }
  return { positions, triangles };
}
