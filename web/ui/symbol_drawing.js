// SPDX-License-Identifier: GPL-3.0-or-later
import { symbolEdge, symbolPath } from '../export/symbol_file.js';

const kSvg = 'http://www.w3.org/2000/svg';

/**
 * Draws the symbol with its quiet zone, dark on light in any colour scheme, as cameras expect it.
 * @param {string[]} rows
 * @param {string} name  for screen readers
 */
export function drawSymbol(rows, name) {
  const svg = document.createElementNS(kSvg, 'svg');
  const edge = symbolEdge(rows);
  svg.setAttribute('viewBox', `0 0 ${edge} ${edge}`);
  svg.setAttribute('shape-rendering', 'crispEdges');
  svg.setAttribute('role', 'img');
  svg.setAttribute('aria-label', name);
  for (const [fill, d] of [
    ['#fff', `M0 0h${edge}v${edge}h-${edge}z`],
    ['#000', symbolPath(rows)],
  ]) {
    const path = document.createElementNS(kSvg, 'path');
    path.setAttribute('fill', fill);
    path.setAttribute('d', d);
    svg.append(path);
  }
  return svg;
}
