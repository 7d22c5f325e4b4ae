// SPDX-License-Identifier: GPL-3.0-or-later
// Reads PrusaSlicer's G-code: which tool prints where.

/** @typedef {{ x0: number, y0: number, x1: number, y1: number, tool: number }} Bead */
/** @typedef {{ z: number, height: number, beads: Bead[] }} Layer  z is its upper side */

/**
 * Reads the beads of each layer. Distances of the filament are relative or absolute.
 * @param {string} text
 * @returns {Layer[]} ascending
 */
export function layersOf(text) {
  /** @type {Layer[]} */ const layers = [];
  let [x, y, e, tool, isRelative] = [0, 0, 0, 0, true];
  for (const line of text.split('\n')) {
    if (line.startsWith(';Z:')) {
      const z = Number(line.slice(3));
      layers.push({ z, height: z - (layers.at(-1)?.z ?? 0), beads: [] });
    } else if (/^T\d/.test(line)) tool = Number(line.slice(1));
    else if (line.startsWith('M83')) isRelative = true;
    else if (line.startsWith('M82')) isRelative = false;
    else if (line.startsWith('G92')) e = Number(/E([-\d.]+)/.exec(line)?.[1] ?? e);
    else if (/^G[01] /.test(line)) {
      const value = (/** @type {string} */ axis) => new RegExp(`${axis}(-?[\\d.]+)`).exec(line)?.[1];
      const [toX, toY] = [Number(value('X') ?? x), Number(value('Y') ?? y)];
      const given = value('E');
      const fed = given === undefined ? 0 : isRelative ? Number(given) : Number(given) - e;
      if (given !== undefined && !isRelative) e = Number(given);
      if (fed > 0 && (toX !== x || toY !== y)) layers.at(-1)?.beads.push({ x0: x, y0: y, x1: toX, y1: toY, tool });
      [x, y] = [toX, toY];
    }
  }
  return layers;
}

/**
 * Returns the tool that prints a point; -1 if no bead is near.
 * @param {Layer} layer
 * @param {number} x
 * @param {number} y
 * @param {number} reach  largest distance from a bead's middle, mm
 */
export function toolAt(layer, x, y, reach) {
  let [nearest, tool] = [reach, -1];
  for (const { x0, y0, x1, y1, tool: own } of layer.beads) {
    const [dx, dy] = [x1 - x0, y1 - y0];
    const along = Math.min(1, Math.max(0, ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy)));
    const distance = Math.hypot(x - x0 - along * dx, y - y0 - along * dy);
    if (distance < nearest) [nearest, tool] = [distance, own];
  }
  return tool;
}
