// SPDX-License-Identifier: GPL-3.0-or-later
// The lamps that the code is carved for, drawn over the model: each as a sun with a line towards the code.

/** @typedef {import('../engine/types.js').LampOnScreen} LampOnScreen */

const kSvg = 'http://www.w3.org/2000/svg';
const kSunPx = 7,
  kRayPx = [10, 14],
  kRays = 8;
const kGapPx = 16; // from the sun's middle to the line

export class LampMarks {
  /** @param {HTMLElement} overlay  covers the canvas */
  constructor(overlay) {
    this.svg_ = document.createElementNS(kSvg, 'svg');
    this.svg_.classList.add('lamp-marks');
    this.svg_.setAttribute('aria-hidden', 'true'); // the lamp fields give the same information
    overlay.append(this.svg_);
  }

  /** @param {readonly LampOnScreen[]} lamps */
  show(lamps) {
    this.svg_.replaceChildren(
      ...lamps.flatMap((lamp, at) =>
        lamp.from ? [mark(lamp.from, lamp.to, lamps.length > 1 ? String(at + 1) : '')] : [],
      ),
    );
  }
}

/** @param {[number, number]} from @param {[number, number]} to @param {string} number  of the lamp, if there are several */
function mark(from, to, number) {
  const group = document.createElementNS(kSvg, 'g');
  group.setAttribute('transform', `translate(${from.map((value) => value.toFixed(1)).join(' ')})`);
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]],
    length = Math.hypot(dx, dy);
  if (length > 2 * kGapPx)
    group.append(
      line(
        [dx, dy].map((value) => (value * kGapPx) / length),
        [dx, dy].map((value) => value / 2),
        'way',
      ),
    );
  for (let ray = 0; ray < kRays; ray += 1) {
    const angle = (2 * Math.PI * ray) / kRays,
      direction = [Math.cos(angle), Math.sin(angle)];
    group.append(
      line(
        direction.map((value) => value * kRayPx[0]),
        direction.map((value) => value * kRayPx[1]),
        'ray',
      ),
    );
  }
  const sun = document.createElementNS(kSvg, 'circle');
  sun.setAttribute('r', String(kSunPx));
  group.append(sun);
  if (number) group.append(Object.assign(document.createElementNS(kSvg, 'text'), { textContent: number }));
  return group;
}

/** @param {number[]} from @param {number[]} to @param {string} name */
function line(from, to, name) {
  const element = document.createElementNS(kSvg, 'line');
  element.classList.add(name);
  for (const [key, value] of Object.entries({ x1: from[0], y1: from[1], x2: to[0], y2: to[1] }))
    element.setAttribute(key, value.toFixed(1));
  return element;
}
