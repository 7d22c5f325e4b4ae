// SPDX-License-Identifier: GPL-3.0-or-later
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { plateFile, saddleFile } from './support/models.js';
import { poll } from './support/poll.js';

/** @param {import('@playwright/test').Page} page */
const buttons = (page) => ({
  undo: page.getByRole('button', { name: 'Undo' }),
  redo: page.getByRole('button', { name: 'Redo' }),
  startOver: page.getByRole('button', { name: 'Start over' }),
});

test('Text, size and centre are undone and redone separately', async ({ page }) => {
  const app = new Engraver(page);
  const { undo, redo } = buttons(page);
  await app.open('?sample=saddle&text=first');
  await app.expectReady();
  await expect(undo).toBeDisabled();
  const centre = await app.centre();
  const width = await app.placement.innerText();

  await app.text.fill('second');
  await expect(undo).toBeEnabled();
  await app.expectReady();
  await app.openSettings();
  await app.setting('Size of the code').selectOption('Exactly');
  await app.setting('Width (mm)').fill('21');
  await app.setting('Width (mm)').press('Tab');
  await expect(app.placement).toContainText('21.0 mm wide');
  const box = /** @type {{ width: number, height: number }} */ (await app.canvas.boundingBox());
  await app.canvas.click({ position: { x: box.width / 2 + 30, y: box.height / 2 + 10 } });
  await poll(() => app.centre()).not.toEqual(centre);
  await app.expectReady();
  const moved = await app.centre();

  await undo.click();
  await poll(() => app.centre()).toEqual(centre);
  await expect(undo).toBeEnabled();
  await expect(app.setting('Width (mm)')).toHaveValue('21');
  await undo.click();
  await expect(undo).toBeEnabled();
  await expect(app.setting('Width (mm)')).toHaveValue('40');
  await undo.click();
  await expect(undo).toBeEnabled();
  await expect(app.setting('Size of the code')).toHaveValue('best');
  await expect(app.text).toHaveValue('second');
  await undo.click();
  await expect(app.text).toHaveValue('first');
  await expect(undo).toBeDisabled();
  await expect(app.placement).toHaveText(width);

  for (let i = 0; i < 4; i += 1) {
    await expect(redo).toBeEnabled();
    await redo.click();
  }
  await poll(() => app.centre()).toEqual(moved);
  await expect(redo).toBeDisabled();
  await expect(app.placement).toContainText('21.0 mm wide');
  await expect(app.text).toHaveValue('second');
});

test('Undoing a carving shows the uncarved model, and redoing it restores the result without carving again', async ({
  page,
}) => {
  const app = new Engraver(page);
  const { undo, redo } = buttons(page);
  await app.open('?sample=saddle&text=one&process=none');
  await app.expectReady();
  await app.engrave();
  const carved = page.getByRole('button', { name: 'With code' });
  const first = (await app.download()).bytes;

  await expect(undo).toBeEnabled();
  await undo.click();
  await expect(app.result).toBeHidden();
  await expect(carved).toBeHidden();
  await expect(redo).toBeEnabled();
  await redo.click();
  await expect(app.result).toBeVisible();
  await expect(app.alert).toHaveCount(0);
  await expect(app.progress).toBeHidden();
  await expect(carved).toHaveAttribute('aria-pressed', 'true');
  expect(Buffer.from((await app.download()).bytes).equals(Buffer.from(first))).toBe(true);

  await app.text.fill('another text, for a second carving');
  await expect(app.result).toContainText('Made before your last change');
  await app.expectReady();
  await app.engrave();
  await expect(app.result).toContainText('Reads as another text, for a second carving');
  await expect(undo).toBeEnabled();
  await undo.click();
  await expect(app.result).toContainText('Reads as one');
  await expect(app.result).toContainText('Made before your last change');
  await expect(undo).toBeEnabled();
  await undo.click();
  await expect(app.text).toHaveValue('one');
  await expect(app.result).not.toContainText('Made before your last change');
  expect(Buffer.from((await app.download()).bytes).equals(Buffer.from(first))).toBe(true);
});

test('After any change, the file is offered as the previous result only, until the code is engraved again', async ({
  page,
}) => {
  const app = new Engraver(page);
  const { undo } = buttons(page);
  await app.open('?sample=saddle&text=one&process=none');
  await app.expectReady();
  await app.openSettings();
  await app.engrave();
  const { name, bytes } = await app.download();
  /** @type {string[]} */ const saved = [];
  page.on('download', (download) => saved.push(download.suggestedFilename()));

  /** @type {Record<string, () => Promise<unknown>>} */
  const changes = {
    text: () => app.text.fill('two'),
    label: () => app.setting('Label').fill('2'),
    size: () => app.setting('At most (mm)').fill('20'),
    place: async () => {
      const box = /** @type {{ width: number, height: number }} */ (await app.canvas.boundingBox());
      await app.canvas.click({ position: { x: box.width / 2 + 40, y: box.height / 2 } });
    },
    mark: () => app.setting('Made by').selectOption('Second colour, painted'),
    depth: () => app.setting('How deep').selectOption('shallow'),
    process: () => app.setting('Process').selectOption('resin-0.05'),
    orientation: () => app.setting('Up axis').selectOption('y'),
    parts: () => page.getByRole('radio', { name: 'A code for every part' }).check(),
  };
  for (const [what, change] of Object.entries(changes)) {
    await test.step(what, async () => {
      await change();
      await expect(app.downloadButton).toBeHidden();
      await expect(app.engraveAgainButton).toBeVisible();
      await app.canvas.focus();
      await page.keyboard.press('d');
      saved.length = 0;
      const previous = await app.download('Download the previous result');
      expect(previous.name).toBe(name);
      expect(Buffer.from(previous.bytes).equals(Buffer.from(bytes))).toBe(true);
      expect(saved, 'the key D saves nothing').toEqual([name]);
      await expect(undo).toBeEnabled();
      await undo.click();
      await expect(app.downloadButton).toBeVisible();
      await expect(app.engraveAgainButton).toBeHidden();
    });
  }

  await test.step('engraved again', async () => {
    await app.text.fill('three');
    await app.engraveAgainButton.click();
    await app.expectResult();
    expect((await app.download()).name).toContain('-three-');
  });

  await test.step('with another model, there is no file', async () => {
    await app.sample.selectOption('Star');
    await expect(app.facts).toContainText('Star');
    await expect(app.result).toBeHidden();
    await app.expectReady();
    await expect(page.locator('#check-state')).toHaveText('Not engraved yet');
  });
});

test('Undo restores the previous model with unit and centre; Start over restores the opening state', async ({
  page,
}) => {
  const app = new Engraver(page);
  const { undo, redo, startOver } = buttons(page);
  await app.open();
  await app.expectReady();
  const text = await app.text.inputValue();
  await app.sample.selectOption('Vase');
  await expect(app.facts).toContainText('Vase');
  await app.expectReady();
  const centre = await app.centre();
  await app.file.setInputFiles(saddleFile);
  await expect(app.facts).toContainText('my saddle.stl, 90.0 × 90.0 × 40.0 mm');
  await app.expectReady();
  await app.openSettings();
  await app.setting('Unit').selectOption('cm');
  await expect(app.facts).toContainText('900.0 × 900.0 × 400.0 mm');
  await expect(undo).toBeEnabled();
  await undo.click();
  await expect(app.facts).toContainText('my saddle.stl, 90.0 × 90.0 × 40.0 mm');
  await expect(app.setting('Unit')).toHaveValue('1');
  await expect(undo).toBeEnabled();
  await undo.click();
  await expect(app.facts).toContainText('Vase');
  await expect(app.sample).toHaveValue('vase');
  await poll(() => app.centre()).toEqual(centre);
  await expect(redo).toBeEnabled();
  await redo.click();
  await expect(app.facts).toContainText('my saddle.stl');

  await test.step('start over', async () => {
    await app.text.fill('mine');
    await app.openSettings();
    await app.setting('Modules').selectOption('Full');
    await app.sample.selectOption('Star');
    await expect(app.facts).toContainText('Star');
    await app.expectReady();

    await startOver.click();
    await expect(app.facts).toContainText('Stanford bunny');
    await expect(app.text).toHaveValue(text);
    await expect(app.setting('Modules')).toHaveValue('auto');
    await expect(undo).toBeEnabled();
    await undo.click();
    await expect(app.facts).toContainText('Star');
    await expect(app.text).toHaveValue('mine');
    await expect(app.setting('Modules')).toHaveValue('none');
  });
});

test('A size typed for one model stays with it: the next one starts with its largest code', async ({ page }) => {
  const app = new Engraver(page);
  const { undo, redo } = buttons(page);
  const enlarge = page.getByRole('button', { name: 'Make it as large as possible' });
  await app.open('?sample=plate');
  await app.expectReady();
  await app.openSettings();
  await app.setting('Size of the code').selectOption('Exactly');
  await app.setting('Width (mm)').fill('30');
  await app.setting('Width (mm)').blur();
  await poll(() => app.width()).toBe(30);
  await app.expectReady();

  await app.file.setInputFiles(plateFile(22));
  await expect(app.facts).toContainText('22.0 × 22.0 × 2.00 mm');
  await expect(app.setting('Size of the code')).toHaveValue('best');
  await app.expectReady();
  const largest = await app.width();
  expect(largest).toBeGreaterThan(14);

  await test.step('undo brings model and size back', async () => {
    await expect(undo).toBeEnabled();
    await undo.click();
    await expect(app.facts).toContainText('44.0 × 44.0');
    await expect(app.setting('Size of the code')).toHaveValue('fixed');
    await poll(() => app.width()).toBe(30);
    await expect(redo).toBeEnabled();
    await redo.click();
    await expect(app.facts).toContainText('22.0 × 22.0');
    await poll(() => app.width()).toBe(largest);
    await app.expectReady();
  });

  await test.step('a size without room there offers the largest again', async () => {
    await app.setting('Size of the code').selectOption('Exactly');
    await app.setting('Width (mm)').fill('60');
    await app.setting('Width (mm)').blur();
    const notes = page.getByRole('list', { name: 'Notes on the place' });
    await expect(notes).toContainText('No spot on the model has room for a code of 60 mm');
    await expect(notes).toContainText(/the largest size found is\s[\d.]+\smm/);
    await expect(page.locator('#view-hint')).toBeHidden();
    await enlarge.click();
    await poll(() => app.width()).toBe(largest);
    await expect(enlarge).toHaveCount(0);
  });
});
