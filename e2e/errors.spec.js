// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { openFile, plateFile, saddleFile, truncatedFile } from './support/models.js';

test('A bad file is refused with a reason, and the previous model stays', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=pyramid');
  await app.expectReady();
  const before = await app.facts.innerText();

  await test.step('a truncated file: names both sizes', async () => {
    await app.file.setInputFiles(truncatedFile);
    await expect(app.alert).toContainText('10,000');
    await expect(app.alert).toContainText(saddleFile.buffer.length.toLocaleString('en'));
    await expect(app.facts).toHaveText(before);
    await expect(app.engraveButton).toBeEnabled();
    await page.getByRole('button', { name: 'Dismiss' }).click();
    await expect(app.alert).toHaveCount(0);
  });
  await test.step('a model with a hole: names the number of open edges', async () => {
    await app.file.setInputFiles(openFile);
    await expect(app.alert).toContainText(/4 .*edge/i);
    await expect(page.locator('#view-hint')).toBeHidden(); // it would ask for a click that does nothing
  });
  await test.step('a file dropped on the page is opened', async () => {
    await app.canvas.drop({ files: saddleFile });
    await expect(app.facts).toContainText('my saddle.stl, 90.0 × 90.0 × 40.0 mm');
    await expect(page.getByText('Drop the model, or a list of texts, to open it')).toBeHidden();
    await app.expectReady();
    await expect(app.alert).toHaveCount(0);
  });
  await test.step('another unit makes the model larger by its factor', async () => {
    await app.openSettings();
    await app.setting('Unit').selectOption('inch');
    await expect(app.facts).toContainText('2,286.0 × 2,286.0 × 1,016.0 mm');
  });
});

test('An empty text, a too large code and a setting out of range are refused with a reason', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle');
  await app.expectReady();
  await app.text.fill('');
  await expect(app.alert).toContainText(/text/i);
  await app.text.fill('short');
  await expect(app.alert).toHaveCount(0);
  await app.expectReady();
  await app.openSettings();
  await app.setting('Viewing distance (mm)').fill('3');
  await app.setting('Viewing distance (mm)').blur();
  await expect(app.alert).toContainText('“Viewing distance” is 3 mm. Choose from 20 mm to 100,000 mm.');
  await app.setting('Viewing distance (mm)').fill('300');
  await app.setting('Viewing distance (mm)').blur();
  await expect(app.alert).toHaveCount(0);
  await app.expectReady();
  await app.setting('Size of the code').selectOption('Exactly');
  await app.setting('Width (mm)').fill('200');
  await app.setting('Width (mm)').blur();
  const notes = page.getByRole('list', { name: 'Notes on the place' });
  await expect(notes).toContainText('No spot on the model has room for a code of 200 mm');
  await expect(app.status).toHaveText('The code has no spot yet: “Place” says why.');
  await expect(app.alert).toHaveCount(0); // the notes say more
  await expect(page.locator('#view-hint')).toBeHidden();
  await app.engraveButton.click();
  await expect(app.result).toBeHidden();
  await expect(app.alert).toContainText(/mm/);
});

test('A model that is too small for any code shows none, and asks for no click', async ({ page }) => {
  const app = new Engraver(page);
  const hint = page.locator('#view-hint');
  await app.open('?sample=plate');
  await app.expectReady();
  await app.file.setInputFiles(plateFile(4));
  await expect(page.getByRole('list', { name: 'Notes on the place' })).toContainText(
    'The model is too small for any code',
  );
  await expect(app.status).toHaveText('The code has no spot yet: “Place” says why.');
  await expect(hint).toBeHidden();
  await expect(app.moveHandle).toHaveCount(0);
  await expect(app.alert).toHaveCount(0);
});

test('Of several dropped files the model is opened, and the page says that the others are not', async ({ page }) => {
  const app = new Engraver(page);
  await app.open('?sample=plate');
  await app.expectReady();
  await page.evaluate(
    ({ name, bytes }) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File(['newmtl red'], 'saddle.mtl'));
      dataTransfer.items.add(new File([new Uint8Array(bytes)], name));
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    },
    { name: saddleFile.name, bytes: [...saddleFile.buffer] },
  );
  await expect(app.alert).toContainText('Of the 2 files, only my saddle.stl was opened.');
  await expect(app.facts).toContainText('my saddle.stl');
});

test('Without WebGL 2 or WebAssembly the page says so', async ({ page, context }) => {
  await page.addInitScript(() => {
    Object.defineProperty(HTMLCanvasElement.prototype, 'transferControlToOffscreen', { value: undefined });
    delete (/** @type {any} */ (HTMLCanvasElement.prototype).transferControlToOffscreen);
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  const app = new Engraver(page);
  await app.open();
  await expect(app.alert).toContainText('This browser offers no WebGL 2');
  await expect(app.engraveButton).toBeDisabled();

  const other = new Engraver(await context.newPage());
  await other.page.addInitScript(() => {
    delete (/** @type {any} */ (window).WebAssembly);
  });
  await other.open();
  await expect(other.alert).toContainText('WebAssembly');
  await expect(other.engraveButton).toBeDisabled();
});
