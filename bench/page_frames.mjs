// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the pointer over the built page and times what the view answers (bench/click_page.mjs).

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {import('@playwright/test').Worker} Worker */
/** @typedef {(part: number) => [number, number]} Path  a point on the page; `part` grows by 1 in ten moves */

const kMovingMs = 3000;
const kPatienceMs = 5000;

/** In the engine's worker: notes when frames are drawn; each ends with a fence (web/engine/frames.js). */
function noteFrames() {
  const scope = /** @type {any} */ (globalThis);
  scope.frames = [];
  const context = scope.WebGL2RenderingContext?.prototype;
  if (!context || scope.isNoting) return;
  scope.isNoting = true;
  const { fenceSync } = context;
  context.fenceSync = function (/** @type {unknown[]} */ ...values) {
    scope.frames.push(performance.now());
    return fenceSync.apply(this, values);
  };
}

/** @param {number[]} values */
const medianOf = (values) => values.toSorted((a, b) => a - b)[values.length >> 1] ?? NaN;

/**
 * Moves the pointer along a path for three seconds.
 * @param {Page} page @param {Path} at
 * @returns {Promise<number>}  median interval between the frames meanwhile, ms; NaN: fewer than two
 */
async function frameMsAlong(page, at) {
  const workers = page.workers();
  await Promise.all(workers.map((worker) => worker.evaluate(noteFrames)));
  const end = Date.now() + kMovingMs;
  for (let step = 0; Date.now() < end; ++step) await page.mouse.move(...at(step / 10));
  const frames = await Promise.all(
    workers.map((worker) => worker.evaluate(() => /** @type {number[]} */ (/** @type {any} */ (globalThis).frames))),
  );
  const most = frames.reduce((a, b) => (b.length > a.length ? b : a), []);
  return medianOf(most.slice(1).map((time, i) => time - most[i]));
}

/**
 * Moves the pointer in circles over the model, then lets it rest.
 * @param {Page} page
 * @returns {Promise<{ frameMs: number, previewMs: number }>}  of a frame while it moves; from its last move until the code
 *   is shown as it will be carved, NaN if it is not within five seconds (web/view/live_view.js gives up)
 */
export async function hover(page) {
  const box = await page.locator('#view').boundingBox();
  if (!box) throw new Error('The view has no size');
  const at = /** @type {Path} */ (
    (part) => [box.x + (0.45 + 0.06 * Math.sin(part)) * box.width, box.y + (0.5 + 0.06 * Math.cos(part)) * box.height]
  );
  const frameMs = await frameMsAlong(page, at);
  const start = Date.now();
  await page.mouse.move(...at(0));
  const depths = page.locator('.code-chip').getByText('mm at most');
  const isShown = await depths.waitFor({ timeout: kPatienceMs }).then(
    () => true,
    () => false,
  );
  return { frameMs, previewMs: isShown ? Date.now() - start : NaN };
}

/**
 * Drags the first lamp in circles.
 * @param {Page} page  shows the light of a lamp
 * @returns {Promise<number>}  of a frame meanwhile, ms
 */
export async function dragLamp(page) {
  const box = await page.locator('.lamp-marks .hold').first().boundingBox();
  if (!box) throw new Error('No lamp is shown');
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const at = /** @type {Path} */ ((part) => [x + 60 * Math.sin(part), y + 60 * (1 - Math.cos(part))]);
  await page.mouse.move(x, y);
  await page.mouse.down();
  const frameMs = await frameMsAlong(page, at);
  await page.mouse.up();
  return frameMs;
}
