// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { Site } from './support/site.js';

test('Until it can be used the page needs 1.5 MB at most; the reader of codes comes later', async ({ page }) => {
  const site = await new Site('/').open();
  try {
    const app = new Engraver(page);
    await page.goto(site.address);
    await app.expectReady();
    const bytes = site.sent.reduce((sum, file) => sum + file.bytes, 0);
    console.log(`first load: ${(bytes / 1e6).toFixed(2)} MB by gzip in ${site.sent.length} files`);
    expect(site.sent.map(({ path }) => path)).toContain('samples/bunny.stl');
    expect(site.sent.filter(({ path }) => path.includes('reader'))).toEqual([]);
    expect(bytes).toBeLessThan(1.5e6);
  } finally {
    await site.close();
  }
});
