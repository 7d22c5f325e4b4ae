// SPDX-License-Identifier: GPL-3.0-or-later
// Finds room for a window over the view that covers none of the page's overlays.

/** @typedef {import('../engine/types.js').Area} Area */

const kMargin = 12;
/**
 * A larger area counts no more than this size. Of the areas that are large enough, the nearest to the upper left wins.
 */
const kEnough = { width: 400, height: 720 };

/**
 * Finds the best rectangle free of obstacles by trying all rectangles bounded by obstacles and edges.
 * @param {{ width: number, height: number }} stage
 * @param {readonly Area[]} obstacles
 * @returns {Area}  the whole stage but its margin if there are no obstacles
 */
export function freeArea({ width, height }, obstacles) {
  const grown = obstacles.map((o) => ({
    left: o.x - kMargin,
    top: o.y - kMargin,
    right: o.x + o.width + kMargin,
    bottom: o.y + o.height + kMargin,
  }));
  const within = (/** @type {number[]} */ values, /** @type {number} */ end) =>
    [...new Set(values)].filter((v) => v >= kMargin && v <= end - kMargin).sort((a, b) => a - b);
  const xs = within([kMargin, width - kMargin, ...grown.flatMap(({ left, right }) => [left, right])], width);
  const ys = within([kMargin, height - kMargin, ...grown.flatMap(({ top, bottom }) => [top, bottom])], height);
  /** @type {Area} */ let best = { x: kMargin, y: kMargin, width: 0, height: 0 };
  let bestWorth = 0;
  for (const y of ys) {
    for (const x of xs) {
      for (const bottom of ys.filter((v) => v > y)) {
        for (const right of xs.filter((v) => v > x)) {
          const worth = Math.min(right - x, kEnough.width) * Math.min(bottom - y, kEnough.height);
          if (worth <= bestWorth) continue;
          if (grown.some((o) => o.left < right && o.right > x && o.top < bottom && o.bottom > y)) continue;
          best = { x, y, width: right - x, height: bottom - y };
          bestWorth = worth;
        }
      }
    }
  }
  return best;
}

const kWrapperShare = 0.6; // of the view: a larger element is only a container

/**
 * Returns the elements shown over the view, in the view's coordinates. The stage may be larger than the view.
 * @param {HTMLElement} stage
 * @param {HTMLElement} view  the canvas's element, which is no obstacle
 * @returns {Area[]}
 */
export function obstaclesOver(stage, view) {
  const origin = view.getBoundingClientRect();
  /** @type {Area[]} */ const areas = [];
  const collect = (/** @type {Element} */ parent) => {
    for (const child of parent.children) {
      if (child === view || child.classList.contains('hidden')) continue;
      if (getComputedStyle(child).display === 'contents') {
        collect(child);
        continue;
      }
      const { left, top, width, height } = child.getBoundingClientRect();
      if (width === 0 || height === 0) continue;
      if (width * height > kWrapperShare * origin.width * origin.height) collect(child);
      else areas.push({ x: left - origin.left, y: top - origin.top, width, height });
    }
  };
  collect(stage);
  return areas;
}
