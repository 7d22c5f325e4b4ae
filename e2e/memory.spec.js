// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { askWorker, holdWorkers } from './support/workers.js';

/** @typedef {import('../web/engine/types.js').MemoryUse} MemoryUse */

const kCarves = 12;
const kWarmUp = 2; // carves until everything made on demand exists, also the stored carving for undo
const kSeen = 4; // carves compared at the beginning and at the end
const kCarvesBetween = kCarves - kWarmUp - kSeen; // from a carve at the beginning to its counterpart at the end

// Growth of the memory in use. Every map of a carve has a number per submodule, at least 105 × 105 × 4 bytes = 44 kB
// for the smallest symbol, so the budget finds a leak of one of them. Without a leak the growth was below 2 kB per carve.
const kBudgetBytesPerCarve = 10_000;

const kSetsOfView = 4; // of GL objects that the view makes once each, when it first needs them

/** Returns the least memory in use, in bytes. @param {MemoryUse[]} used */
const leastOf = (used) => Math.min(...used.map(({ usedBytes }) => usedBytes));

test('Carving again and again stays within the memory budget', async ({ page }) => {
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
  const early = used.slice(kWarmUp, kWarmUp + kSeen);
  const late = used.slice(-kSeen);
  const growth = (leastOf(late) - leastOf(early)) / kCarvesBetween;
  const counts = used.map(({ glObjects }) => glObjects);
  const mb = (/** @type {number} */ bytes) => `${(bytes / 1e6).toFixed(2)} MB`;
  console.log(
    `memory: ${mb(leastOf(early))} in use, ${(growth / 1e3).toFixed(1)} kB more per carve, ` +
      `heap ${used.map(({ heapBytes }) => mb(heapBytes)).join(' ')}, ` +
      `GL objects ${counts.join(' ')}; ` +
      `${((Date.now() - begun) / kCarves / 1000).toFixed(1)} s a carve`,
  );
  expect(growth, 'bytes per carve').toBeLessThan(kBudgetBytesPerCarve);
  // The heap never shrinks and grows by a fifth at a time, so after the warm-up it must not grow at all.
  expect(late[0].heapBytes, 'heap').toBe(early[0].heapBytes);
  // A leak adds GL objects with every carve. The view's own sets, which stay, come once each, after any carve: textures
  // for a picture at rest and for one in motion, the coarse canvas of the latter, and the picture that codes are printed
  // on.
  const rises = counts.filter((count, i) => i > 0 && count > Math.max(...counts.slice(0, i))).length;
  expect(rises, JSON.stringify([early[0].glKinds, used[used.length - 1].glKinds])).toBeLessThanOrEqual(kSetsOfView);
});
