// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { askWorker, holdWorkers } from './support/workers.js';

/** @typedef {import('../web/engine/types.js').MemoryUse} MemoryUse */

const kCarves = 16;
const kTolerance = 1.01; // allows about 20 kB per carve
const kSeen = 5; // carves compared at the beginning and at the end

/** Returns the least amount in use. @param {MemoryUse[]} used @param {'usedBytes' | 'heapBytes' | 'glObjects'} what */
const leastOf = (used, what) => Math.min(...used.map((one) => one[what]));

test(`After ${kCarves} carves in a row the module needs no more memory than after the first ones`, async ({ page }) => {
  await page.addInitScript(holdWorkers);
  const app = new Engraver(page);
  await app.open('?sample=pyramid&text=A');
  await app.expectReady();
  /** @type {MemoryUse[]} */ const used = [];
  const begun = Date.now();
  for (let carve = 0; carve < kCarves; carve += 1) {
    await app.engrave();
    await askWorker(page, 'prepareEngrave'); // as the idle page does, so that every carve is measured after it
    used.push(await askWorker(page, 'memory'));
  }
  const early = used.slice(2, 2 + kSeen); // everything made on demand exists by then, also the stored carving for undo
  const late = used.slice(-kSeen);
  const mb = (/** @type {'usedBytes' | 'heapBytes'} */ what) =>
    [early, late].map((some) => (leastOf(some, what) / 1e6).toFixed(2)).join(' → ');
  console.log(
    `memory: ${mb('usedBytes')} MB in use, heap ${mb('heapBytes')} MB, GL objects ${used.map(({ glObjects }) => glObjects).join(' ')}; ` +
      `${((Date.now() - begun) / kCarves / 1000).toFixed(1)} s a carve`,
  );
  for (const what of /** @type {const} */ (['usedBytes', 'heapBytes']))
    expect(leastOf(late, what), what).toBeLessThan(kTolerance * leastOf(early, what));
  // The picture that codes are printed on (Viewer::makePlain) is created when a code first changes in a finished view,
  // which may be after any carve. It stays, whereas a leak keeps growing.
  const most = Math.max(...used.slice(0, -kSeen).map(({ glObjects }) => glObjects));
  expect(
    leastOf(late, 'glObjects'),
    JSON.stringify([early[0].glKinds, used[used.length - 1].glKinds]),
  ).toBeLessThanOrEqual(most);
});
