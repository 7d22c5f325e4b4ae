// SPDX-License-Identifier: GPL-3.0-or-later
// The page and the command are one core and one set of shaders on two renderers: they must agree within a tolerance.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';

const command = fileURLToPath(new URL('../build/release/bin/qrelief', import.meta.url));
const kText = 'https://example.org/agreement';

/** @param {number[]} a @param {number[]} b @returns degrees */
function angleBetween(a, b) {
  const dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return (Math.acos(Math.min(1, dot)) * 180) / Math.PI;
}

test('The page carves what the command carves', async ({ page }) => {
  const app = new Engraver(page);
  await app.open();
  await app.expectReady();
  await app.text.fill(kText);
  await app.expectReady();
  await app.engrave();
  const inPage = await app.report();

  const folder = mkdtempSync(join(tmpdir(), 'qrelief-'));
  const model = join(folder, 'bunny.stl');
  writeFileSync(model, await (await page.request.get('samples/bunny.stl')).body());
  const at = inPage.projection.centre.join(',');
  execFileSync(command, ['engrave', model, '--text', kText, `--at=${at}`, '-o', join(folder, 'carved.stl'), '--report', join(folder, 'report.json'), '--quiet']);
  const native = JSON.parse(readFileSync(join(folder, 'report.json'), 'utf8'));

  console.log(`page ${inPage.gl.renderer}: ${JSON.stringify(inPage.depth)}; command ${native.gl.renderer}: ${JSON.stringify(native.depth)}`);
  expect(inPage.symbol).toEqual(native.symbol);
  expect(angleBetween(inPage.projection.normal, native.projection.normal)).toBeLessThan(0.5);
  expect(Math.abs(inPage.size.symbolMm / native.size.symbolMm - 1)).toBeLessThan(0.01);
  // A submodule whose luminance lies at the threshold may take one step of 0.1 mm more on one renderer.
  expect(Math.abs(inPage.depth.meanMm - native.depth.meanMm)).toBeLessThan(0.02);
  expect(Math.abs(inPage.depth.maxMm - native.depth.maxMm)).toBeLessThanOrEqual(0.21);
  expect(Math.abs(inPage.mesh.volumeMm3 / native.mesh.volumeMm3 - 1)).toBeLessThan(1e-4);
});
