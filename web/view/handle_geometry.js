// SPDX-License-Identifier: GPL-3.0-or-later
// Positions of a code's handles on the screen, and the effect of dragging them. Screen positions are in CSS pixels; `u`
// and `v` count half edges of the code's square, to the right and upwards as its viewer sees it.

/** @typedef {[number, number]} Point */
/** @typedef {(point: Point) => Point} PointMap */
/** @typedef {'move' | 'turn' | 'size'} HandleKind */

const kSnapDeg = 5;
const kTurnDistancePx = 34; // from the square to the turning handle

/**
 * Returns the projective map from the square to its corners on the screen, and its inverse [Heckbert 1989, §2.2.3].
 * @param {Point[]} corners  upper left, upper right, lower right, lower left
 * @returns {{ toScreen: PointMap, toSquare: PointMap }}
 */
export function squareMaps([[x0, y0], [x1, y1], [x2, y2], [x3, y3]]) {
  const [sx, sy] = [x0 - x1 + x2 - x3, y0 - y1 + y2 - y3];
  const [dx1, dy1, dx2, dy2] = [x1 - x2, y1 - y2, x3 - x2, y3 - y2];
  const area = dx1 * dy2 - dx2 * dy1;
  const [g, h] = [(sx * dy2 - dx2 * sy) / area, (dx1 * sy - sx * dy1) / area];
  const m = [x1 - x0 + g * x1, x3 - x0 + h * x3, x0, y1 - y0 + g * y1, y3 - y0 + h * y3, y0, g, h, 1];
  const inverse = [
    // the adjugate; a common factor does not matter
    m[4] - m[5] * h,
    m[2] * h - m[1],
    m[1] * m[5] - m[2] * m[4],
    m[5] * g - m[3],
    m[0] - m[2] * g,
    m[2] * m[3] - m[0] * m[5],
    m[3] * h - m[4] * g,
    m[1] * g - m[0] * h,
    m[0] * m[4] - m[1] * m[3],
  ];
  return {
    toScreen: ([u, v]) => applied(m, [(u + 1) / 2, (1 - v) / 2]),
    toSquare: (point) => {
      const [s, t] = applied(inverse, point);
      return [2 * s - 1, 1 - 2 * t];
    },
  };
}

/** @param {number[]} m  3 × 3, row by row @param {Point} point @returns {Point} */
function applied(m, [x, y]) {
  const w = m[6] * x + m[7] * y + m[8];
  return [(m[0] * x + m[1] * y + m[2]) / w, (m[3] * x + m[4] * y + m[5]) / w];
}

/**
 * @param {Point[]} corners
 * @returns {{ move: Point, turn: Point, size: Point, stem: Point }}  `stem`: the point where the line to the turning
 *   handle meets the square
 */
export function handlePositions(corners) {
  const { toScreen } = squareMaps(corners);
  const move = toScreen([0, 0]);
  const stem = toScreen([0, 1]);
  const away = [stem[0] - move[0], stem[1] - move[1]];
  const length = Math.hypot(away[0], away[1]) || 1;
  const turn = /** @type {Point} */ (stem.map((at, axis) => at + (away[axis] / length) * kTurnDistancePx));
  return { move, turn, stem, size: corners[2] };
}

/** Returns whole degrees in -180 … 180, snapped to a multiple of 90 nearby. @param {number} deg */
export function snappedRotation(deg) {
  const wrapped = deg - 360 * Math.round(deg / 360);
  const upright = 90 * Math.round(wrapped / 90);
  const snapped = Math.abs(wrapped - upright) <= kSnapDeg ? upright : Math.round(wrapped);
  return snapped === -180 ? 180 : snapped + 0;
}

/**
 * Returns the turn in degrees, anticlockwise as the viewer sees it.
 * @param {Point} from
 * @param {Point} to  in the square
 */
export function turnBetween([u0, v0], [u1, v1]) {
  return ((Math.atan2(v1, u1) - Math.atan2(v0, u0)) * 180) / Math.PI;
}

/**
 * Returns the factor by which dragging a corner enlarges the square.
 * @param {Point} from
 * @param {Point} to  in the square
 */
export function scaleBetween([u0, v0], [u1, v1]) {
  return Math.max(Math.abs(u1), Math.abs(v1)) / Math.max(1e-6, Math.abs(u0), Math.abs(v0));
}

/**
 * Returns the turn and the scale from two fingers that hold the code.
 * @param {[Point, Point]} from
 * @param {[Point, Point]} to  on the screen
 * @returns {{ turnDeg: number, factor: number }}  the turn is anticlockwise
 */
export function twistBetween(from, to) {
  const [a, b] = [from, to].map(([[x0, y0], [x1, y1]]) => ({ x: x1 - x0, y: y1 - y0 }));
  const turn = Math.atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y); // clockwise, since y points down
  return { turnDeg: (-turn * 180) / Math.PI, factor: Math.hypot(b.x, b.y) / Math.max(1e-6, Math.hypot(a.x, a.y)) };
}

/**
 * Rounds a width to a value that a user would type: half millimetres, tenths below 10 mm.
 * @param {number} mm
 * @param {number} least
 * @param {number} most
 */
export function roundedSize(mm, least, most) {
  const step = mm < 10 ? 0.1 : 0.5;
  const rounded = Math.round(mm / step) * step;
  return Number(Math.min(most, Math.max(least, rounded)).toFixed(1));
}
