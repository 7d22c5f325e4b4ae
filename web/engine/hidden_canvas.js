// SPDX-License-Identifier: GPL-3.0-or-later

/** Makes a canvas that no page shows, in a page or in a worker. */
export function makeHiddenCanvas() {
  if (typeof OffscreenCanvas === 'function') return new OffscreenCanvas(1, 1);
  return Object.assign(document.createElement('canvas'), { width: 1, height: 1 });
}
