// SPDX-License-Identifier: GPL-3.0-or-later
// The simulation of the print: it runs while the user looks at the result, shows the print next to the design, and can
// be stopped and started again.
import { expect, test } from '@playwright/test';
import { Engraver } from './support/engraver.js';
import { poll } from './support/poll.js';

const kPrinted = { timeout: 120_000 };

test('The print is simulated with the result, shown in the reader’s view, and follows process and pose', async ({
  page,
}) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=HELLO');
  await app.expectReady();
  await app.engrave();
  const line = app.result.getByRole('list', { name: 'Verdict' }).getByRole('listitem').nth(1);

  await test.step('it never blocks the download, can be stopped, and runs again on demand', async () => {
    await line.getByRole('button', { name: 'Stop' }).click();
    await expect(line).toContainText('The print was not simulated.');
    expect((await app.download()).bytes.length).toBeGreaterThan(1000);
    expect((await app.report()).verification.printed).toBeNull();
    await line.getByRole('button', { name: 'Simulate the print' }).click();
    await expect(line).toContainText('Simulating the print');
    expect((await app.download()).bytes.length).toBeGreaterThan(1000);
    await expect(line).toContainText('Reads as printed, facing up (0.4 mm nozzle, 0.2 mm layers)', kPrinted);
    const { printed, verdict } = (await app.report()).verification;
    expect(printed.process).toBe('fdm-0.4/0.2');
    expect(printed.reads).toBeGreaterThanOrEqual(printed.readsNeeded);
    expect(verdict.prints.level).toBe('good');
  });

  await test.step('the reader’s view switches between print and design', async () => {
    await page.getByRole('button', { name: 'Phone view' }).click();
    const view = page.getByRole('group', { name: 'Phone view' });
    const marks = page.locator('.lost-modules rect');
    await expect(view).toContainText('The phone reads: HELLO');
    await expect(marks).toHaveCount(0);
    await view.getByRole('button', { name: 'As printed' }).click();
    await expect(view).toContainText(/The print reads; modules lost: \d+/);
    await expect(marks).toHaveCount(Number(/lost: (\d+)/.exec(await view.innerText())?.[1]));
    const printed = await app.canvas.screenshot();
    await view.getByRole('button', { name: 'As designed' }).click();
    await expect(marks).toHaveCount(0);
    await poll(async () => printed.equals(await app.canvas.screenshot())).toBe(false);
    await view.getByRole('button', { name: 'As printed' }).click();
    await page.getByRole('button', { name: 'Fit' }).click();
    await expect(marks).toHaveCount(0);
  });

  await test.step('another process sets nozzle and layer, another pose turns the model, and simulation can be switched off', async () => {
    await app.openSettings();
    await app.setting('Process').selectOption('fdm-0.6/0.3');
    await expect(app.setting('Nozzle (mm)')).toHaveValue('0.6');
    await expect(app.setting('Layer (mm)')).toHaveValue('0.3');
    await app.setting('Orientation on the printer').selectOption('code-upright');
    await app.expectReady();
    await app.engrave();
    await expect(line).toContainText('upright (0.6 mm nozzle, 0.3 mm layers)', kPrinted);
    await app.setting('Process').selectOption('none');
    await app.expectReady();
    await app.engrave();
    await expect(line).toContainText('Prints with your 0.6 mm nozzle');
    expect((await app.report()).verification.printed).toBeNull();
  });
});

test('If the print does not decode, other processes are tried, and one press applies a better one', async ({
  page,
}) => {
  const app = new Engraver(page);
  await app.open('?sample=saddle&text=HELLO');
  await app.expectReady();
  await app.openSettings();
  await app.setting('At most (mm)').fill('8');
  await app.setting('At most (mm)').press('Tab');
  await app.expectReady();
  await app.engrave();
  const failure = app.result.getByRole('list', { name: 'Verdict' }).locator('> li');
  const lost = failure.getByRole('figure');
  await test.step('the verdict is one sentence, a picture of the lost modules, and three remedies', async () => {
    await expect(lost).toBeVisible(kPrinted);
    await expect(failure).toHaveCount(1);
    await expect(failure.locator('> strong')).toHaveText(
      /^The code does not read as printed, .*: \d+ of 72 tries on simulated pictures .* succeeded, and 12 are needed\.$/,
    );
    const [, count] = /the (\d+) modules that it loses/.exec(await lost.innerText()) ?? [];
    expect(Number(count)).toBeGreaterThan(10);
    await expect(lost.locator('rect')).toHaveCount(Number(count));
    await expect(failure.locator('> .remedies').getByRole('button')).toHaveText([
      /^Allow \d+\smm$/,
      'Use a 0.25 mm nozzle and layers of 0.16 mm',
      /^Print layers of/,
    ]);
    await expect(failure.getByRole('button')).toHaveCount(3); // the others are folded
  });
  await expect(page.locator('#check-state')).toHaveText('Reads, but may not print');
  const line = (await app.failedLines()).nth(1);
  await line.getByRole('button', { name: 'Try other ways of printing' }).click();
  await expect(line).toContainText(/Print 1 of 4: \d+\s%/);
  await expect(line.locator('.print-trials li')).toHaveCount(4, { timeout: 180_000 });
  await expect(line).not.toContainText(/Print \d of 4/);
  await expect(line.locator('.print-trials')).toContainText('upright (0.4 mm nozzle, 0.2 mm layers)');
  await line.getByRole('button', { name: 'Use it: Resin, layers 0.05 mm' }).click();
  await expect(app.setting('Process')).toHaveValue('resin-0.05');
  await expect(app.setting('Layer (mm)')).toHaveValue('0.05');
  await expect(app.result).toContainText('Engrave again to update it');
});
