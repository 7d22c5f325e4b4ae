// SPDX-License-Identifier: GPL-3.0-or-later
// Judges meshes by manifold-3d (https://github.com/elalish/manifold), which shares no code with this project.
import Module from 'manifold-3d';

/** @typedef {import('./solids.mjs').Mesh} Mesh */

const manifold = await Module();
manifold.setup();

/** Returns the mesh with equal corners joined, for files that hold loose triangles. @param {Mesh} mesh @returns {Mesh} */
export function welded({ positions, triangles }) {
  /** @type {Map<string, number>} */ const places = new Map();
  const place = (/** @type {number} */ v) => {
    const key = positions[v].join(' ');
    if (!places.has(key)) places.set(key, places.size);
    return /** @type {number} */ (places.get(key));
  };
  const joined = triangles.map((t) => /** @type {import('./solids.mjs').Point} */ (t.map(place)));
  return {
    positions: [...places.keys()].map((key) => /** @type {any} */ (key.split(' ').map(Number))),
    triangles: joined,
  };
}

/** Returns the volume within a closed mesh, mm³. @param {Mesh} mesh */
export function volumeOf({ positions, triangles }) {
  let sum = 0;
  const [x0, y0, z0] = positions[triangles[0][0]];
  for (const triangle of triangles) {
    const [a, b, c] = triangle.map((v) => [positions[v][0] - x0, positions[v][1] - y0, positions[v][2] - z0]);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

/** Returns why a mesh is no closed manifold that encloses a volume; empty if it is one. @param {Mesh} mesh */
export function faultOf({ positions, triangles }) {
  const used = [...new Set(triangles.flat())];
  const place = new Map(used.map((v, i) => [v, i]));
  const mesh = new manifold.Mesh({
    numProp: 3,
    vertProperties: Float32Array.from(used.flatMap((v) => positions[v])),
    triVerts: Uint32Array.from(triangles.flat(), (v) => /** @type {number} */ (place.get(v))),
  });
  try {
    const solid = new manifold.Manifold(mesh);
    const [status, volume] = [solid.status(), solid.volume()];
    solid.delete();
    if (status !== 'NoError') return String(status);
    return volume > 0 ? '' : `volume of ${volume} mm³`;
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  }
}
