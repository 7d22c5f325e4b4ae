// SPDX-License-Identifier: GPL-3.0-or-later
// The effects of the controls for a code on every part, for controls.spec.js.
import { expect } from '@playwright/test';

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {import('./hands.js').Hands} Hands */
/** @typedef {import('./hands.js').Effects} Effects */

/** @param {string} text @param {string} [name] */
const listFile = (text, name = 'parts.csv') => ({ name, mimeType: 'text/csv', buffer: Buffer.from(text) });

/** @type {Effects} */
export const kOfTheParts = {
  'code-for-many': async ({ at, page }) => {
    await at('code-for-many').check();
    await expect(page.getByRole('group', { name: 'A code for every part' })).toBeVisible();
    await expect(at('code-state')).toHaveText('Open, drop or paste a list');
  },
  'batch-list': async ({ at }) => {
    await at('batch-list').fill('text\nA\nB\n');
    await expect(at('code-state')).toHaveText(/^2 parts/);
  },
  'batch-open-file': async ({ at }) => {
    await at('batch-open-file').setInputFiles(listFile('text\nA\nB\nC\n'));
    await expect(at('code-state')).toHaveText(/^3 parts/);
    await expect(at('batch-file-name')).toHaveText('parts.csv, 1 kB');
  },
  'batch-file-remove': async ({ at, press }) => {
    await press('batch-file-remove');
    await expect(at('batch-list')).toBeFocused();
    await expect(at('code-state')).toHaveText('Open, drop or paste a list');
  },
  'batch-text-column': async ({ at }) => {
    await at('batch-open-file').setInputFiles(listFile('name,link,site\nA,example.org/a,example.org/b\n'));
    await expect(at('batch-text-column')).toHaveValue('link');
    await at('batch-text-column').selectOption('site');
    await expect(at('batch-text')).toHaveValue('{site}');
    await expect(at('batch-first')).toHaveText('This is the code of part 1: example.org/b');
  },
  'batch-id-column': async ({ at }) => {
    await at('batch-id-column').selectOption('name');
    await expect(at('batch-first')).toHaveText('This is the code of part A: example.org/b');
  },
  'batch-from': async ({ at }) => {
    await at('batch-from').selectOption('count');
    await expect(at('code-state')).toHaveText(/^100 parts, version 2/);
  },
  'batch-count': async ({ at }) => {
    await at('batch-count').fill('7');
    await expect(at('code-state')).toHaveText(/^7 parts/);
  },
  'batch-text': async ({ at }) => {
    await at('batch-text').fill('{n}');
    await expect(at('code-state')).toHaveText(/^7 parts, version 1,/);
  },
  content: async ({ at }) => {
    await at('content').selectOption('text');
    await expect(at('code-state')).toHaveText('7 parts');
    await at('content').selectOption('code');
    await expect(at('code-state')).toHaveText(/^7 parts, version 1,/);
  },
  'batch-files': async ({ at }) => {
    await at('batch-files').selectOption('plates');
    await expect(at('code-state')).toHaveText(/^7 parts on 1 plate, version 1,/);
  },
  'batch-per-plate': async ({ at }) => {
    await at('batch-per-plate').fill('3');
    await expect(at('code-state')).toHaveText(/^7 parts on 3 plates,/);
    await at('batch-files').selectOption('each');
  },
  'batch-name': async ({ at, page }) => {
    await at('batch-name').fill('a/{n}.stl');
    await expect(page.getByRole('list', { name: 'Problems in the list' })).toContainText(
      '“a/1.stl” is not a plain file name',
    );
  },
  'code-for-one': async ({ at, app }) => {
    await at('code-for-one').check();
    await expect(app.text).toBeVisible();
    await app.expectReady();
  },
};
