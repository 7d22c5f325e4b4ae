// SPDX-License-Identifier: GPL-3.0-or-later
// The elements of the handles over a placed code: a grip that moves it, sliders that turn and size it, and a button
// that sets it upright. code_editor.js handles their events.
import { text } from '../i18n/catalogue.js';
import { make } from '../dom/dom.js';
import { handlePositions } from './handle_geometry.js';

/** @typedef {import('../engine/types.js').CodeOnScreen} CodeOnScreen */
/** @typedef {import('./handle_geometry.js').HandleKind} HandleKind */
/** @typedef {import('./handle_geometry.js').Point} Point */

const kLeastFacing = 0.2; // cosine: a code seen nearly edge-on cannot be handled
const kLeastEdgePx = 48;
const kSvg = 'http://www.w3.org/2000/svg';

const kIcons = {
  move: 'M12 3v18M3 12h18M12 3l-2.5 3M12 3l2.5 3M12 21l-2.5-3M12 21l2.5-3M3 12l3-2.5M3 12l3 2.5M21 12l-3-2.5M21 12l-3 2.5',
  turn: 'M5.5 9A7.5 7.5 0 1 1 5 14M5.5 9V4.5M5.5 9H10',
  size: 'M7 7l10 10M17 17v-5M17 17h-5M7 7v5M7 7h5',
};

export class CodeHandles {
  /** @param {HTMLElement} overlay  covers the canvas */
  constructor(overlay) {
    this.line_ = document.createElementNS(kSvg, 'line');
    this.svg_ = document.createElementNS(kSvg, 'svg');
    this.svg_.classList.add('handle-stem');
    this.svg_.setAttribute('aria-hidden', 'true');
    this.svg_.append(this.line_);
    this.handles = {
      move: handle('move', 'button', text('view.moveCode')),
      turn: handle('turn', 'slider', text('view.turnCode')),
      size: handle('size', 'slider', text('view.sizeCode')),
    };
    this.handles.turn.setAttribute('aria-valuemin', '-180');
    this.handles.turn.setAttribute('aria-valuemax', '180');
    this.handles.size.setAttribute('aria-valuemin', '5');
    this.handles.size.setAttribute('aria-valuemax', '1000');
    this.upright = make('button', { className: 'upright', text: text('view.upright') });
    this.upright.type = 'button';
    this.box_ = make(
      'div',
      { className: 'code-handles' },
      this.svg_,
      this.handles.move,
      this.handles.turn,
      this.handles.size,
      this.upright,
    );
    this.box_.hidden = true;
    overlay.append(this.box_);
  }

  /** @param {CodeOnScreen | null} code */
  show(code) {
    const isShown = code !== null && code.facing >= kLeastFacing && shortestEdge(code.corners) >= kLeastEdgePx;
    this.box_.hidden = !isShown;
    if (!code) return;
    const { move, turn, size, stem } = handlePositions(code.corners);
    put(this.handles.move, move);
    put(this.handles.turn, turn);
    put(this.handles.size, size);
    put(this.upright, [turn[0], turn[1] - 34]);
    const ends = { x1: stem[0], y1: stem[1], x2: turn[0], y2: turn[1] };
    for (const [name, value] of Object.entries(ends)) this.line_.setAttribute(name, value.toFixed(1));
    this.setValues(code.rotationDeg, code.symbolMm);
  }

  /** @param {number} rotationDeg @param {number} symbolMm */
  setValues(rotationDeg, symbolMm) {
    const deg = Math.round(rotationDeg - 360 * Math.round(rotationDeg / 360)) + 0;
    const mm = Number(symbolMm.toFixed(1));
    this.handles.turn.setAttribute('aria-valuenow', String(deg));
    this.handles.turn.setAttribute('aria-valuetext', text('view.degrees', { deg }));
    this.handles.size.setAttribute('aria-valuenow', String(mm));
    this.handles.size.setAttribute('aria-valuetext', text('view.millimetres', { mm }));
    this.upright.hidden = deg === 0;
  }

  /** @param {HandleKind | undefined} kind  the handle that is held */
  hold(kind) {
    this.box_.classList.toggle('held', kind !== undefined);
    for (const [name, element] of Object.entries(this.handles)) element.classList.toggle('active', name === kind);
  }
}

/** @param {HandleKind} kind @param {string} role @param {string} label */
function handle(kind, role, label) {
  const element = make('div', { className: `handle ${kind}` });
  element.tabIndex = 0;
  element.setAttribute('role', role);
  element.setAttribute('aria-label', label);
  element.title = label;
  const svg = document.createElementNS(kSvg, 'svg');
  svg.setAttribute('viewBox', '0 0 24 24');
  svg.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(kSvg, 'path');
  path.setAttribute('d', kIcons[kind]);
  svg.append(path);
  element.append(svg);
  return element;
}

/** @param {HTMLElement} element @param {Point} middle */
function put(element, [x, y]) {
  element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -50%)`;
}

/** @param {Point[]} corners */
const shortestEdge = (corners) =>
  Math.min(
    ...corners.map(([x, y], i) => {
      const [nextX, nextY] = corners[(i + 1) % corners.length];
      return Math.hypot(nextX - x, nextY - y);
    }),
  );
