// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { askWorker, holdWorkers } from './support/workers.js';

const kCarves = 30;
const kTolerance = 1.1;

test(`After ${kCarves} carves in a row the module needs no more memory than after the first ones`, async ({ page }) => {
  test.setTimeout(900_000);
  await page.addInitScript(holdWorkers);
  const app = new Engraver(page);
  await app.open('?sample=pyramid&text=A');
  await app.expectReady();
  /** @type {import('../web/engine/types.js').MemoryUse[]} */ const used = [];
  const begun = Date.now();
  for (let carve = 0; carve < kCarves; carve += 1) {
    await app.engraveButton.click();
    if (carve > 0) await expect(app.result).toBeHidden();  // the last one's
    await app.expectResult();
    await askWorker(page, 'prepareEngrave');  // as the page does when it is left alone: so it is there each time
    used.push(await askWorker(page, 'memory'));
  }
  const [, , early] = used;  // by then all that is made on demand exists, and the one carving that can be brought back
  const late = used[kCarves - 1];
  const mb = (/** @type {number} */ bytes) => (bytes / 1e6).toFixed(1);
  console.log(`memory: ${mb(early.usedBytes)} → ${mb(late.usedBytes)} MB in use, heap ${mb(early.heapBytes)} → ${mb(late.heapBytes)} MB, ` +
    `${early.glObjects} → ${late.glObjects} GL objects; ${((Date.now() - begun) / kCarves / 1000).toFixed(1)} s a carve`);
  expect(late.usedBytes).toBeLessThan(kTolerance * early.usedBytes);
  expect(late.heapBytes).toBeLessThan(kTolerance * early.heapBytes);
  // Now and then two more are seen than at the last carve and the next one; what leaks is there each time.
  const least = Math.min(...used.slice(-5).map(({ glObjects }) => glObjects));
  expect(least).toBeLessThanOrEqual(early.glObjects);
});
