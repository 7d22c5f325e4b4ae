// SPDX-License-Identifier: GPL-3.0-or-later
// The page as its user knows it, by roles and names.
import { readFile } from 'node:fs/promises';
import { expect } from '@playwright/test';
import { meanDifference } from './pixels.js';
import { poll } from './poll.js';
import { readPng } from './read_png.js';

/** @typedef {import('@playwright/test').Page} Page */

export class Engraver {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    this.canvas = page.locator('canvas[aria-label="3D view"]');
    this.text = page.getByRole('textbox', { name: 'Text or link' });
    this.sample = page.getByRole('combobox', { name: 'Sample model' });
    this.file = page.getByLabel('Model file');
    this.engraveButton = page.getByRole('button', { name: /^Engrave(?! again)/ });
    this.engraveAgainButton = page.getByRole('button', { name: 'Engrave again' });
    this.downloadButton = page.getByRole('button', { name: 'Download', exact: true });
    this.previousButton = page.getByRole('button', { name: 'Download the previous result' });
    this.cancelButton = page.getByRole('button', { name: 'Cancel' });
    this.progress = page.getByRole('progressbar');
    this.status = page.getByRole('status');
    this.alert = page.getByRole('alert');
    this.result = page.getByRole('region', { name: 'Result' });
    this.placement = page.locator('#placement-facts');
    this.facts = page.locator('#model-state');
    this.spots = page.getByRole('list', { name: 'Spots' }).getByRole('button');
    this.chip = page.locator('.code-chip'); // next to the pointer, hidden from screen readers
    this.moveHandle = page.getByRole('button', { name: 'Move the code' });
    this.turnHandle = page.getByRole('slider', { name: 'Turn the code' });
    this.sizeHandle = page.getByRole('slider', { name: 'Size of the code on the model' });
  }

  /** @param {string} [query] */
  async open(query = '') {
    await this.page.goto(`./${query}`);
  }

  /** Waits until a model is loaded and its code is placed. */
  async expectReady() {
    await poll(() => this.placement.textContent()).toContain('mm wide');
    await poll(() => this.status.textContent()).toMatch(/^Ready\./); // and whether the code was moved off an edge
    await expect(this.engraveButton).toBeEnabled();
  }

  /** @param {string} name */
  setting(name) {
    return this.page.getByLabel(name, { exact: true });
  }

  /** Unfolds the settings of every step. */
  async openSettings() {
    const folded = this.page.locator('.step > details:not([open], [hidden]) > summary');
    while ((await folded.count()) > 0) await folded.first().click();
  }

  /** Returns the centre in the model's coordinates, mm. */
  async centre() {
    const values = await Promise.all(['x', 'y', 'z'].map((axis) => this.page.locator(`#centre-${axis}`).inputValue()));
    return values.map(Number);
  }

  /** Returns the symbol's width shown on the page, mm. */
  async width() {
    return Number(/^([\d.]+)\smm wide/.exec(await this.placement.innerText())?.[1]);
  }

  async rotation() {
    return Number(await this.page.locator('#rotate').inputValue());
  }

  /** Returns a picture of the view, once it is refined. */
  async settledPicture() {
    let picture = await this.canvas.screenshot();
    await poll(async () => {
      const before = picture;
      await this.page.waitForTimeout(500);
      picture = await this.canvas.screenshot();
      return before.equals(picture);
    }).toBe(true);
    return picture;
  }

  /**
   * Returns how far the view's brightness now differs from an earlier picture of it; 1: black and white.
   * @param {Buffer} before  see settledPicture()
   */
  async differenceFrom(before) {
    const [one, other] = [readPng(before), readPng(await this.canvas.screenshot())];
    return meanDifference(one, other, { x: 0, y: 0 }, { x: one.width, y: one.height }, 8);
  }

  /** Shows codes as they will be carved, however slow the machine is. */
  async showLive() {
    const placed = this.page.locator('#placement-depth');
    const live = this.page.locator('#show-live');
    await live.click();
    await expect(placed).toBeHidden();
    await live.click(); // tries again where a search took too long
    await expect(placed).toBeVisible({ timeout: 30_000 });
  }

  /** Asks for suggested spots and waits for them. */
  async suggest() {
    await this.page.getByRole('button', { name: 'Suggest spots' }).click();
    await poll(() => this.status.textContent()).toBe('Choose a spot, or click the model.');
  }

  /** Clicks Engrave and waits for the result. */
  async engrave() {
    await this.engraveButton.click(); // from here to the end the status shows the work
    await this.expectResult();
  }

  /** Waits until the engraving in progress has ended. */
  async expectResult() {
    await poll(() => this.status.textContent(), { timeout: 240_000 }).toMatch(/^Engraved/);
    await expect(this.result).toBeVisible();
    await expect(this.alert).toHaveCount(0);
  }

  /** Returns the disabled buttons that do not say why. */
  unexplained() {
    return this.page
      .locator('button:disabled')
      .evaluateAll((all) => all.filter((one) => !(/** @type {HTMLElement} */ (one).title)).map(({ id }) => id));
  }

  /** Unfolds the three lines of a failed verdict, and returns them. */
  async failedLines() {
    await this.result.getByText('Why, and what else helps').click({ timeout: 120_000 });
    return this.result.getByRole('list', { name: 'In detail' }).locator('> li');
  }

  /** @returns {Promise<{ name: string, bytes: Uint8Array }>} */
  async download(button = 'Download') {
    const pressed = this.page.getByRole('button', { name: button, exact: true });
    if (!(await pressed.isVisible())) await this.openSettings(); // it is folded
    const [download] = await Promise.all([this.page.waitForEvent('download'), pressed.click()]);
    return { name: download.suggestedFilename(), bytes: new Uint8Array(await readFile(await download.path())) };
  }

  async report() {
    return JSON.parse(new TextDecoder().decode((await this.download('Save report')).bytes));
  }
}
