// SPDX-License-Identifier: GPL-3.0-or-later
// Binary STL files of any size, written without holding the mesh.

/**
 * Returns a closed sphere of radius 50 mm with waves of 1 mm, with 4 · rows · (rows − 1) triangles.
 * @param {number} rows  from pole to pole
 * @returns {Buffer}
 */
export function wavySphereStl(rows) {
  const columns = 2 * rows;
  const count = 2 * columns * (rows - 1);
  const bytes = Buffer.alloc(84 + 50 * count);
  bytes.writeUInt32LE(count, 80);
  const row = (/** @type {number} */ i) => {
    const points = new Float32Array(3 * columns);
    const polar = (Math.PI * i) / rows;
    for (let k = 0; k < columns; k += 1) {
      const angle = i === 0 || i === rows ? 0 : (2 * Math.PI * k) / columns; // each pole is one point
      const radius = 50 + Math.sin(8 * polar) ** 2 * Math.cos(9 * angle);
      const across = i === 0 || i === rows ? 0 : Math.sin(polar);
      points.set(
        [radius * across * Math.cos(angle), radius * across * Math.sin(angle), radius * Math.cos(polar)],
        3 * k,
      );
    }
    return points;
  };
  let at = 84;
  const corner = (/** @type {Float32Array} */ points, /** @type {number} */ k) => {
    for (let axis = 0; axis < 3; axis += 1) at = bytes.writeFloatLE(points[3 * k + axis], at);
  };
  let above = row(0);
  for (let i = 0; i < rows; i += 1) {
    const below = row(i + 1);
    for (let k = 0; k < columns; k += 1) {
      const next = (k + 1) % columns;
      /** @type {[Float32Array, number][][]} */
      const triangles = [
        [
          [above, k],
          [below, k],
          [below, next],
        ],
        [
          [above, k],
          [below, next],
          [above, next],
        ],
      ];
      for (const triangle of triangles) {
        if (
          (i === 0 && triangle[2][0] === above) ||
          (i === rows - 1 && triangle[1][0] === below && triangle[2][0] === below)
        )
          continue;
        at += 12; // normals are zero; parsers compute them
        triangle.forEach(([points, index]) => corner(points, index));
        at += 2;
      }
    }
    above = below;
  }
  return bytes;
}
