// SPDX-License-Identifier: GPL-3.0-or-later
import { symbolEdge, symbolPath } from '../export/symbol_file.js';

const kSvg = 'http://www.w3.org/2000/svg';
const kMargin = 1; // round letters, in modules

/**
 * Draws the symbol with its quiet zone, dark on light in any colour scheme, as cameras expect it.
 * @param {string[]} rows
 * @param {string} name  for screen readers
 */
export function drawSymbol(rows, name) {
  const edge = symbolEdge(rows);
  const svg = draw(0, edge, symbolPath(rows), name);
  svg.setAttribute('shape-rendering', 'crispEdges');
  return svg;
}

/**
 * Draws a text alone in its square, in the colours of a symbol.
 * @param {import('../engine/types.js').LetterFacts} letters
 * @param {string} name  for screen readers
 */
export const drawLetters = ({ size, path }, name) => draw(-kMargin, size + 2 * kMargin, path, name);

/** @param {number} from @param {number} edge @param {string} dark  path of the dark part @param {string} name */
function draw(from, edge, dark, name) {
  const svg = document.createElementNS(kSvg, 'svg');
  svg.setAttribute('viewBox', `${from} ${from} ${edge} ${edge}`);
  svg.setAttribute('role', 'img');
  svg.setAttribute('aria-label', name);
  for (const [fill, d] of [
    ['#fff', `M${from} ${from}h${edge}v${edge}h-${edge}z`],
    ['#000', dark],
  ]) {
    const path = document.createElementNS(kSvg, 'path');
    path.setAttribute('fill', fill);
    path.setAttribute('d', d);
    svg.append(path);
  }
  return svg;
}
