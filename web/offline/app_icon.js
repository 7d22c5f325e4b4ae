// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the app's icon, an SVG of straight lines on a rounded square, as pixels. It is used by the build, not by the
// page.

/** @typedef {[number, number, number]} Colour */
/** @typedef {{ size: number, radius: number, ground: Colour, ink: Colour, edges: Edge[] }} Icon */
/** @typedef {{ x0: number, y0: number, x1: number, y1: number }} Edge */

const kSamples = 4; // samples along a pixel's edge

/** @param {string} text  #rgb or #rrggbb @returns {Colour} */
function colour(text) {
  const digits = text.slice(1);
  const pairs =
    digits.length === 3 ? [...digits].map((digit) => digit + digit) : [0, 2, 4].map((at) => digits.slice(at, at + 2));
  return /** @type {Colour} */ (pairs.map((pair) => parseInt(pair, 16)));
}

/**
 * @param {string} path  with the commands M, h, v, H, V and z
 * @returns {Edge[]}
 */
function edgesOf(path) {
  /** @type {Edge[]} */ const edges = [];
  let [x, y, startX, startY] = [0, 0, 0, 0];
  const lineTo = (/** @type {number} */ toX, /** @type {number} */ toY) => {
    edges.push({ x0: x, y0: y, x1: toX, y1: toY });
    [x, y] = [toX, toY];
  };
  for (const [, command, rest] of path.matchAll(/([a-z])([^a-z]*)/gi)) {
    const [a, b] = (rest.match(/-?[\d.]+/g) ?? []).map(Number);
    if (command === 'M') [x, y, startX, startY] = [a, b, a, b];
    else if (command === 'h') lineTo(x + a, y);
    else if (command === 'v') lineTo(x, y + a);
    else if (command === 'H') lineTo(a, y);
    else if (command === 'V') lineTo(x, a);
    else if (command === 'z') lineTo(startX, startY);
    else throw new Error(`The icon's path has the command "${command}", which is not drawn here`);
  }
  return edges;
}

/**
 * @param {string} svg  a square view box from 0, one <rect> as background, then paths of one colour with the even-odd
 *   rule
 * @returns {Icon}
 */
export function readIcon(svg) {
  const [, size] = /viewBox="0 0 (\d+) \1"/.exec(svg) ?? [];
  const [, radius, ground] = /<rect[^>]* rx="([\d.]+)"[^>]* fill="(#\w+)"/.exec(svg) ?? [];
  const [, ink] = /<g fill="(#\w+)"/.exec(svg) ?? [];
  const paths = [...svg.matchAll(/<path d="([^"]+)"/g)].map(([, path]) => path);
  if (!size || !radius || !ink || paths.length === 0) throw new Error('The icon is not of the form that is drawn here');
  return {
    size: Number(size),
    radius: Number(radius),
    ground: colour(ground),
    ink: colour(ink),
    edges: paths.flatMap(edgesOf),
  };
}

/**
 * Tells whether a point lies inside a square with rounded corners.
 * @param {Icon} icon
 * @param {number} x
 * @param {number} y
 */
function onGround({ size, radius }, x, y) {
  if (x < 0 || y < 0 || x > size || y > size) return false;
  const beyond = (/** @type {number} */ v) => Math.max(radius - v, v - (size - radius), 0);
  return Math.hypot(beyond(x), beyond(y)) <= radius;
}

/** @param {Edge[]} edges @param {number} x @param {number} y */
function inside(edges, x, y) {
  let crossings = 0;
  for (const { x0, y0, x1, y1 } of edges) if (x0 === x1 && y0 > y !== y1 > y && x < x0) crossings += 1;
  return crossings % 2 === 1;
}

/**
 * @param {Icon} icon
 * @param {number} pixels  the picture's edge
 * @param {{ maskable?: boolean }} [options]  maskable: the background fills the square, and the drawing stays in the
 *   middle 80 % that every mask keeps
 * @returns {Uint8Array}  RGBA
 */
export function drawIcon(icon, pixels, { maskable = false } = {}) {
  const rgba = new Uint8Array(4 * pixels * pixels);
  const inner = maskable ? 0.8 : 1;
  const toIcon = (/** @type {number} */ v) => ((v / pixels - 0.5) / inner + 0.5) * icon.size;
  for (let row = 0; row < pixels; row += 1) {
    for (let column = 0; column < pixels; column += 1) {
      let [covered, inked] = [0, 0];
      for (let sample = 0; sample < kSamples * kSamples; sample += 1) {
        const x = toIcon(column + ((sample % kSamples) + 0.5) / kSamples);
        const y = toIcon(row + (Math.floor(sample / kSamples) + 0.5) / kSamples);
        if (!maskable && !onGround(icon, x, y)) continue;
        covered += 1;
        if (inside(icon.edges, x, y)) inked += 1;
      }
      if (covered === 0) continue;
      const share = inked / covered;
      rgba.set(
        [
          ...icon.ground.map((v, i) => Math.round(v + (icon.ink[i] - v) * share)),
          Math.round((255 * covered) / (kSamples * kSamples)),
        ],
        4 * (row * pixels + column),
      );
    }
  }
  return rgba;
}
