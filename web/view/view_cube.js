// SPDX-License-Identifier: GPL-3.0-or-later
// A small cube that turns with the camera. A click on a face turns the camera to it. It is for pointers only: the menu
// "Views" and the keys 1 to 7 do the same.
import { text } from '../i18n/catalogue.js';
import { visibleFaces } from './cube_geometry.js';

/** @typedef {import('../engine/types.js').StandardView} StandardView */

const kSvg = 'http://www.w3.org/2000/svg';
const kHalfEdge = 22;

export class ViewCube {
  /** @param {HTMLElement} place @param {(name: StandardView) => void} onView */
  constructor(place, onView) {
    this.svg_ = document.createElementNS(kSvg, 'svg');
    this.svg_.classList.add('view-cube');
    this.svg_.setAttribute('viewBox', '-40 -40 80 80');
    this.svg_.setAttribute('aria-hidden', 'true');
    this.faces_ = new Map(
      /** @type {StandardView[]} */ (['front', 'back', 'left', 'right', 'top', 'bottom']).map((name) => [
        name,
        face(name),
      ]),
    );
    for (const [name, group] of this.faces_) group.addEventListener('click', () => onView(name));
    place.append(this.svg_);
  }

  /** @param {number[][]} axes  the camera's */
  turn(axes) {
    const visible = visibleFaces(axes, kHalfEdge);
    this.svg_.replaceChildren(
      ...visible.reverse().map(({ name, matrix, facing }) => {
        const group = /** @type {SVGGElement} */ (this.faces_.get(name));
        group.setAttribute('transform', `matrix(${matrix.map((v) => v.toFixed(3)).join(' ')})`);
        group.style.setProperty('--facing', facing.toFixed(2));
        return group;
      }),
    );
  }
}

/** @param {StandardView} name */
function face(name) {
  const group = document.createElementNS(kSvg, 'g');
  const square = document.createElementNS(kSvg, 'rect');
  for (const [key, value] of Object.entries({ x: -1, y: -1, width: 2, height: 2 }))
    square.setAttribute(key, String(value));
  const label = document.createElementNS(kSvg, 'text');
  label.textContent = text(`view.${name}`);
  label.setAttribute('text-anchor', 'middle');
  label.setAttribute('dominant-baseline', 'central');
  group.append(square, label);
  group.dataset.view = name;
  return group;
}
