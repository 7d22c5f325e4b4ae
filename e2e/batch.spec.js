// SPDX-License-Identifier: GPL-3.0-or-later
// A code for every part: from the list to the ZIP.
import { expect, test } from '@playwright/test';
import { createHash } from 'node:crypto';
import { volume } from '../web/samples/solid.js';
import { readStl } from '../web/samples/stl.js';
import { expectNoViolations } from './support/axe.js';
import { Engraver } from './support/engraver.js';
import { poll } from './support/poll.js';
import { bodiesOf, filesOf, unzip } from './support/three_mf.js';
import { freeze, freezeAt, holdWorkers, thaw } from './support/workers.js';

const kTexts = [
  'https://example.org/p/1',
  'https://example.org/p/2',
  'Teil drei, „ö“',
  'https://example.org/p/4',
  'https://example.org/p/5',
];
const kTooLarge = 3; // the part whose code does not fit on the plate
/** @param {string[]} texts */
const csv = (texts) =>
  `id;text;size;bin\n${texts.map((text, i) => `P-${i + 1};${text};${i === kTooLarge ? 200 : ''};A${i}\n`).join('')}`;

/**
 * Fires the event of dropping a file onto the page.
 * @param {import('@playwright/test').Page} page
 * @param {string} name
 * @param {string} content
 * @param {BufferEncoding} [encoding]
 */
const drop = (page, name, content, encoding = 'utf8') =>
  page.evaluate(
    ({ fileName, bytes }) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([new Uint8Array(bytes)], fileName, { type: 'text/csv' }));
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    },
    { fileName: name, bytes: [...Buffer.from(content, encoding)] },
  );

test('A list becomes one code per part, across a reload, and a ZIP has the parts and their manifest', async ({
  page,
}) => {
  await page.addInitScript(() => {
    Object.assign(window, { showSaveFilePicker: undefined }); // a test cannot use the system’s dialog
  });
  await page.addInitScript(holdWorkers);
  const app = new Engraver(page);
  const press = (/** @type {string} */ name) => page.getByRole('button', { name, exact: true }).click();
  const state = page.locator('#parts-state'),
    plan = page.locator('#code-state');
  const problems = page.getByRole('list', { name: 'Problems in the list' }).getByRole('listitem');
  const rows = page.getByRole('table', { name: 'Parts' }).getByRole('row');
  const finished = async () => Number(/(\d+) of 5/.exec(await state.innerText())?.[1] ?? 0);
  await app.open('?sample=plate');
  await app.expectReady();

  await test.step('a list with mistakes is refused with their lines, and nothing is carved', async () => {
    await drop(page, 'parts.csv', csv(kTexts).replace('p/5', 'p/4') + 'P-6;"not closed;;A\n');
    await expect(page.getByRole('radio', { name: 'A code for every part' })).toBeChecked();
    await expect(problems).toHaveText([/^A quotation mark in line 7 of the list is never closed\./]);
    await drop(page, 'parts.csv', csv(kTexts).replace('p/5', 'p/4'));
    await expect(problems).toHaveText([
      /^Line 6: The text “https:\/\/example\.org\/p\/4” is also in line 5\. Give every part/,
      /“bin”|bin/,
    ]);
    await expect(plan).toHaveText('The list has a problem');
    await expectNoViolations(page, 'a list with mistakes');
    await press('Engrave the first part');
    await expect(page.getByRole('list', { name: 'Problems in the list' })).toBeFocused();
    await expect(app.progress).toHaveCount(0);
  });

  await test.step('a list shows its first rows, and its columns can be chosen', async () => {
    const preview = page.getByRole('region', { name: 'First rows of the list' });
    const texts = page.getByLabel('Texts from column'),
      names = page.getByLabel('Names from column');
    await drop(page, 'windows.csv', 'Tür;https://example.org/1\r\nTor;https://example.org/2\r\n', 'latin1');
    await expect(preview.getByRole('columnheader')).toHaveText(['column1', 'text']);
    await expect(preview.getByRole('cell')).toHaveText([
      'Tür',
      'https://example.org/1',
      'Tor',
      'https://example.org/2',
    ]);
    await expect(texts).toHaveValue('text');
    await expect(problems).toContainText(['The first row of the list', 'was read as Windows-1252', 'Unused columns']);
    await names.selectOption('column1');
    await expect(page.getByText('This is the code of part Tür: https://example.org/1')).toBeVisible();

    await drop(page, 'url.csv', 'nr,url\n1,https://example.org/1\n');
    await expect(texts).toHaveValue('url');
    await expect(names).toHaveValue('');
    await drop(page, 'other.csv', 'Name,Adresse\nA,example.org/a\nB,example.org/b\n');
    await expect(problems).toContainText(['The list has no column “text”']);
    await expect(texts.locator('option:checked')).toHaveText('Choose one');
    await texts.selectOption('Adresse');
    await expect(plan).toHaveText(/^2 parts/);
    await expect(page.getByLabel('Text of each code')).toHaveValue('{Adresse}');
  });

  await test.step('the first part must be carved before the others', async () => {
    await drop(page, 'parts.csv', csv(kTexts));
    await expect(plan).toHaveText('5 parts, version 2, 25 × 25 modules');
    await expect(problems).toHaveText(['Unused columns: bin.']);
    await expect(page.getByText('This is the code of part P-1: https://example.org/p/1')).toBeVisible();
    await app.expectReady();
    await expect(page.getByRole('button', { name: 'Make all 5 parts' })).toBeDisabled();
    await press('Engrave the first part');
    await app.expectResult();
    await expect(app.result).toContainText('Reads as https://example.org/p/1');
    await expect(page.getByRole('button', { name: 'Make all 5 parts' })).toBeEnabled();
  });

  await test.step('all are carved in parallel; while paused, none is started', async () => {
    await page.getByLabel('Simulate the print of every … part').fill('4');
    const amidFirst = page.getByRole('progressbar', { name: 'Parts engraved', includeHidden: true }).evaluate(
      (bar) =>
        new Promise((resolve) => {
          new MutationObserver(() => {
            const { value, max } = /** @type {HTMLProgressElement} */ (bar);
            if (max === 5 && value > 0 && value < 1) resolve(value);
          }).observe(bar, { attributes: true });
        }),
    );
    await press('Make all 5 parts');
    await freezeAt(state, /[1-9] of 5/);
    expect(await amidFirst, 'the bar moves within the first part').toBeLessThan(1);
    expect(
      await page.evaluate(() => /** @type {any} */ (window).workers.length),
      'the page’s own engine, and two',
    ).toBe(3);
    await press('Pause');
    await thaw(page);
    await expect(state).toHaveText(/^Paused: \d of 5/);
    const before = await finished();
    expect(before).toBeLessThan(5);
    await expect(rows.filter({ hasText: /Done|Failed/ })).toHaveCount(before);
    await expect(page.getByRole('radio', { name: 'One code' })).toBeDisabled();
    await expectNoViolations(page, 'parts, paused');
    await freeze(page);
    await press('Go on');
    await expect(state).toHaveText(/^Engraving/);
    await press('Stop');
    await expect(state).toHaveText(/^Stopped: \d of 5/);
    await expect(rows.filter({ hasText: 'Engraving' })).toHaveCount(0);
  });

  await test.step('after a reload it resumes without carving any part again', async () => {
    const before = await finished();
    await page.reload();
    await expect(page.getByText(/^\d of 5 parts of Test plate are engraved\. Go on\?/)).toBeVisible();
    await page.getByRole('button', { name: 'Go on' }).click();
    await expect(rows.filter({ hasText: 'Done' })).not.toHaveCount(0);
    await poll(finished).toBeGreaterThanOrEqual(before);
    await expect(state).toHaveText('4 engraved, 1 failed');
    await expect(app.status).toHaveText('4 engraved, 1 failed.');
    await expect(rows.filter({ hasText: 'Done' })).toHaveCount(4);
    for (const words of ['P-3', 'Teil drei, „ö“', 'P-3.stl']) await expect(rows.nth(3)).toContainText(words);
  });

  await test.step('the failed part says why, fails again on a retry, and does not stop the others', async () => {
    await page.getByLabel('Show', { exact: true }).selectOption('Failed');
    await expect(rows).toHaveCount(2);
    await expect(rows.nth(1)).toContainText('P-4');
    await expect(rows.nth(1)).toContainText(/Failed.*200\smm/);
    await freeze(page);
    await press('Retry failed parts');
    await expect(state).toHaveText('Getting ready: 4 of 5');
    await expect(page.getByRole('button', { name: 'Retry failed parts' })).toBeHidden();
    await thaw(page);
    await expect(state).toHaveText('4 engraved, 1 failed');
  });

  await test.step('the ZIP has each part’s file and the manifest as the command writes it', async () => {
    const { name, bytes } = await app.download('Download 4 of 5 as ZIP');
    expect(name).toBe('plate-qr-parts.zip');
    const files = filesOf(bytes);
    expect([...files.keys()]).toEqual(['manifest.jsonl', 'manifest.csv', 'P-1.stl', 'P-2.stl', 'P-3.stl', 'P-5.stl']);
    const entries = String(files.get('manifest.jsonl'))
      .trimEnd()
      .split('\n')
      .map((line) => JSON.parse(line));
    expect(entries.map(({ text }) => text)).toEqual(kTexts);
    const [failed] = entries.splice(kTooLarge, 1);
    expect(failed).toMatchObject({
      number: 4,
      id: 'P-4',
      file: 'P-4.stl',
      status: 'failed',
      reason: expect.stringContaining('200 mm'),
    });
    for (const { file, sha256, status, verdict, symbol } of entries) {
      expect(status).toBe('done');
      expect(verdict).toMatchObject({ passed: true, solid: 'good' });
      expect(symbol.version).toBe(2);
      expect(
        createHash('sha256')
          .update(/** @type {Buffer} */ (files.get(file)))
          .digest('hex'),
      ).toBe(sha256.output);
    }
    expect(entries.map(({ printed }) => printed !== undefined)).toEqual([true, false, false, true]);
    const table = String(files.get('manifest.csv')).trimEnd().split('\r\n');
    expect(table[0]).toMatch(/^number,id,text,file,plate,status,/);
    expect(table).toHaveLength(6);
    expect(table[3]).toContain('"Teil drei, „ö“"');
    expect(table[4]).toContain(',failed,');
  });

  await test.step('discarding leaves nothing', async () => {
    await press('Discard the parts');
    await expectNoViolations(page, 'parts, carved');
    await page
      .getByText('Discard 4 engraved parts?')
      .locator('..')
      .getByRole('button', { name: 'Discard the parts' })
      .click();
    await expect(page.getByRole('button', { name: 'Make all 5 parts' })).toBeVisible();
    await expect(page.getByRole('radio', { name: 'One code' })).toBeEnabled();
    expect(
      await page.evaluate(async () => {
        const names = [];
        for await (const name of /** @type {any} */ (await navigator.storage.getDirectory()).keys()) names.push(name);
        return names;
      }),
    ).toEqual([]);
  });
});

test('Numbered parts are placed on plates, and the ZIP is written to the chosen file', async ({ page }) => {
  await page.addInitScript(() => {
    // Where the browser lets the page write to a file of the user's choice: a file in the page's own storage replaces
    // it.
    Object.assign(window, {
      showSaveFilePicker: async (/** @type {{ suggestedName: string }} */ { suggestedName }) =>
        (await navigator.storage.getDirectory()).getFileHandle(suggestedName, { create: true }),
    });
  });
  const app = new Engraver(page);
  await app.open('?sample=plate&lang=de');
  await page.getByRole('radio', { name: 'Ein Code je Teil' }).check();
  await page.getByLabel('Die Teile kommen aus').selectOption('Nummern, ohne Liste');
  await page.getByLabel('Anzahl der Teile').fill('3');
  await page.getByLabel('Text jedes Codes').fill('Nr. {n:03}');
  await page.getByLabel('Dateien', { exact: true }).selectOption('3MF-Platten mit mehreren Teilen');
  await page.getByLabel('Je Platte').fill('2');
  await expect(page.locator('#code-state')).toHaveText('3 Teile auf 2 Platten, Version 1, 21 × 21 Module');
  await expect(app.status).toHaveText('Bereit.');
  await page.getByRole('button', { name: 'Erstes Teil gravieren' }).click();
  await page.getByRole('button', { name: 'Alle 3 Teile gravieren' }).click({ timeout: 240_000 });
  await expect(page.locator('#parts-state')).toHaveText('3 Teile sind graviert');

  await page.getByRole('button', { name: 'Als ZIP herunterladen' }).click();
  await expect(app.status).toHaveText('Das ZIP ist gespeichert.');
  const bytes = await page.evaluate(async () => {
    const file = await (await (await navigator.storage.getDirectory()).getFileHandle('plate-qr-parts.zip')).getFile();
    return new Uint8Array(await file.arrayBuffer());
  });
  const files = filesOf(bytes);
  expect([...files.keys()]).toEqual(['manifest.jsonl', 'manifest.csv', 'plate-001.3mf', 'plate-002.3mf']);
  const namesOn = (/** @type {string} */ plate) => {
    const model = unzip(/** @type {Buffer} */ (files.get(plate))).get('3D/3dmodel.model') ?? '';
    return [...bodiesOf(model).values()].map(({ name }) => name);
  };
  expect(namesOn('plate-001.3mf')).toEqual(['1', '2']);
  expect(namesOn('plate-002.3mf')).toEqual(['3']);
  const lines = String(files.get('manifest.jsonl'))
    .trimEnd()
    .split('\n')
    .map((line) => JSON.parse(line));
  expect(lines.map(({ text, file }) => `${text} ${file}`)).toEqual([
    'Nr. 001 plate-001.3mf',
    'Nr. 002 plate-001.3mf',
    'Nr. 003 plate-002.3mf',
  ]);
  expect(lines[0].sha256.output).toBe(lines[1].sha256.output);
});

test('Inlaid parts named .stl have a second file each, in the ZIP and in the manifest', async ({ page }) => {
  await page.addInitScript(() => {
    Object.assign(window, { showSaveFilePicker: undefined }); // a test cannot use the system’s dialog
  });
  const app = new Engraver(page);
  await app.open('?sample=plate&mark=inlay');
  await page.getByRole('radio', { name: 'A code for every part' }).check();
  await page.getByLabel('The parts come from').selectOption('Numbers, without a list');
  await page.getByLabel('Number of parts').fill('3');
  await page.getByLabel('Make only the first … parts, as a trial').fill('2');
  await page.getByLabel('Text of each code').fill('No {n}');
  await page.getByLabel('File names').fill('{n}.stl');
  await expect(page.locator('#code-state')).toHaveText('3 parts, version 1, 21 × 21 modules');
  await expect(app.status).toHaveText('Ready.');
  await page.getByRole('button', { name: 'Engrave the first part' }).click();
  await page.getByRole('button', { name: 'Make the first 2 parts' }).click({ timeout: 240_000 });
  await expect(page.locator('#parts-state')).toHaveText('2 parts are engraved');
  const files = filesOf((await app.download('Download as ZIP')).bytes);
  expect([...files.keys()]).toEqual(['manifest.jsonl', 'manifest.csv', '1.stl', '1-2.stl', '2.stl', '2-2.stl']);
  const plate = volume(readStl(new Uint8Array(await (await page.request.get('samples/plate.stl')).body())));
  const lines = String(files.get('manifest.jsonl')).trimEnd().split('\n');
  for (const { file, second, sha256 } of lines.map((line) => JSON.parse(line))) {
    const [body, inlay] = [file, second].map((name) => /** @type {Buffer} */ (files.get(name)));
    expect([body, inlay].map((bytes) => createHash('sha256').update(bytes).digest('hex'))).toEqual([
      sha256.output,
      sha256.second,
    ]);
    const volumes = [body, inlay].map((bytes) => volume(readStl(new Uint8Array(bytes))));
    expect(volumes[1]).toBeGreaterThan(1);
    expect((volumes[0] + volumes[1]) / plate).toBeCloseTo(1, 5);
  }
});
