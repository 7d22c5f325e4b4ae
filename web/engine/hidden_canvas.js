// SPDX-License-Identifier: GPL-3.0-or-later

/**
 * Makes a canvas that no page shows, in a page or in a worker.
 * @returns {HTMLCanvasElement | OffscreenCanvas | null}  null where there are none: in Node
 */
export function makeHiddenCanvas() {
  if (typeof OffscreenCanvas === 'function') return new OffscreenCanvas(1, 1);
  if (typeof document !== 'object') return null;
  return Object.assign(document.createElement('canvas'), { width: 1, height: 1 });
}
