// SPDX-License-Identifier: GPL-3.0-or-later
// Moves the pointer over the built page and times what the view answers (bench/click_page.mjs).
/* global addEventListener, document, requestAnimationFrame */

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {import('@playwright/test').Worker} Worker */
/** @typedef {(part: number) => [number, number]} Path  a point on the page; `part` grows by 1 in ten moves */

const kMovingMs = 3000;
const kPatienceMs = 5000;
const kRestMs = 1000; // until a place beside the code is known to have room
const kDirections = 16;

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
 * Finds a place on the model that has room for a code, beside the placed code, which shows none under the pointer.
 * @param {Page} page
 * @returns {Promise<[number, number] | undefined>}  on the page; undefined: none is found
 */
async function besideCode(page) {
  const [x, y] = await middleOf(page, 'move'),
    [cornerX, cornerY] = await middleOf(page, 'size');
  const halfDiagonal = Math.hypot(cornerX - x, cornerY - y);
  for (let turn = 0; turn < kDirections; ++turn) {
    const angle = (2 * Math.PI * turn) / kDirections,
      away = (turn % 2 === 0 ? 0.9 : 1.2) * halfDiagonal;
    const place = /** @type {[number, number]} */ ([x + away * Math.cos(angle), y + away * Math.sin(angle)]);
    await page.mouse.move(...place);
    await page.waitForTimeout(kRestMs);
    if (await page.locator('.code-chip strong:not(:empty)').isVisible()) return place;
  }
  return undefined;
}

/** @param {Page} page @param {string} handle  of the placed code @returns {Promise<[number, number]>} */
async function middleOf(page, handle) {
  const shown = page.locator(`.code-handles .${handle}`);
  await shown.waitFor();
  const box = await shown.boundingBox();
  if (!box) throw new Error('No code is placed');
  return [box.x + box.width / 2, box.y + box.height / 2];
}

/**
 * Moves the pointer in small circles over the model beside the code, then lets it rest.
 * @param {Page} page
 * @returns {Promise<{ frameMs: number, previewMs: number, exactMs: number } | undefined>}  `frameMs`: a frame
 *   while it moves. From its last move until the code is shown as it will be carved, `previewMs`: after the first pass of
 *   the search; `exactMs`: at its end; NaN: not within five seconds. Undefined: nowhere beside the code is room
 */
export async function hover(page) {
  const beside = await besideCode(page);
  if (!beside) return undefined;
  const [x, y] = beside;
  const at = /** @type {Path} */ ((part) => [x + 8 * Math.sin(part), y + 8 * Math.cos(part)]);
  const frameMs = await frameMsAlong(page, at);
  const shown = page.evaluate(chipTimes, kPatienceMs);
  await page.mouse.move(x + 4, y); // nothing is known of this place yet
  return { frameMs, ...(await shown) };
}

/**
 * Runs in the page: waits for the next move of the pointer, and then for the depths beside it.
 * @param {number} patienceMs
 * @returns {Promise<{ previewMs: number, exactMs: number }>}
 */
function chipTimes(patienceMs) {
  return new Promise((resolve) => {
    /** @type {number | undefined} */ let movedAt;
    let isOld = true; // the chip may still show the depths of the place before
    const times = { previewMs: NaN, exactMs: NaN };
    addEventListener('pointermove', () => (movedAt = performance.now()), { once: true, capture: true });
    const look = () => {
      const words = document.querySelector('.code-chip')?.textContent ?? '';
      const ms = movedAt === undefined ? 0 : performance.now() - movedAt;
      isOld &&= movedAt === undefined || /mm deep|mm at most/.test(words);
      if (!isOld && /mm deep|mm at most/.test(words) && !(times.previewMs >= 0)) times.previewMs = ms;
      if (!isOld && /mm at most/.test(words)) times.exactMs = ms;
      if (times.exactMs >= 0 || ms > patienceMs) resolve(times);
      else requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
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
