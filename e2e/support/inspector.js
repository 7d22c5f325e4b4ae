// SPDX-License-Identifier: GPL-3.0-or-later
// The inspector. Its controls are pixels of the canvas, so tests press where its state says they are.
import { poll } from './poll.js';

/** @typedef {import('@playwright/test').Page} Page */
/** @typedef {import('../../web/engine/types.js').InspectorState} State */
/** @typedef {{ x: number, y: number, width: number, height: number }} Clip */

export class Inspector {
  /** @param {Page} page */
  constructor(page) {
    this.page = page;
    this.button = page.getByRole('button', { name: 'Inspector' });
    this.canvas = page.locator('canvas[aria-label="3D view"]');
  }

  async open() {
    if (!(await this.button.isVisible())) await this.page.getByText('For experts', { exact: true }).click();
    await this.button.click();
    await poll(() => this.state()).toBeDefined();
  }

  /** @returns {Promise<State | undefined>} */
  async state() {
    const json = await this.page.locator('#view').getAttribute('data-inspector');
    return json === null ? undefined : JSON.parse(json);
  }

  /** Waits until the state has the expected value. @param {(state: State) => unknown} value @param {unknown} expected */
  async expectState(value, expected) {
    await poll(async () => {
      const state = await this.state();
      return state && value(state);
    }).toEqual(expected);
  }

  /**
   * Returns a point of a control in page coordinates, once the window no longer changes. Scrolls down to it.
   * @param {string} control
   * @param {{ x: number, y: number }} [share]  fraction of the control's width and height; the middle if left out
   */
  async placeOf(control, share = { x: 0.5, y: 0.5 }) {
    /** @type {State | undefined} */ let state;
    await poll(async () => {
      state = await this.state();
      if (!state?.still) return [];
      if (!(control in state.controls)) await this.scrollDown_(state);
      return Object.keys(state.controls);
    }).toContain(control);
    const [x, y, width, height] = /** @type {State} */ (state).controls[control];
    const box = /** @type {{ x: number, y: number }} */ (await this.canvas.boundingBox());
    return { x: box.x + x + width * share.x, y: box.y + y + height * share.y };
  }

  /** Turns the wheel over the lower part of the window, and waits until all has moved. @param {State} before */
  async scrollDown_(before) {
    const [x, y, width, height] = before.window;
    const box = /** @type {{ x: number, y: number }} */ (await this.canvas.boundingBox());
    await this.page.mouse.move(box.x + x + width / 2, box.y + y + height * 0.8);
    await this.page.mouse.wheel(0, 100);
    await poll(async () => {
      const state = await this.state();
      return state?.still && JSON.stringify(state.controls) !== JSON.stringify(before.controls);
    }).toBe(true);
  }

  /** @param {string} control @param {{ x: number, y: number }} [share] */
  async press(control, share) {
    const { x, y } = await this.placeOf(control, share);
    await this.page.mouse.click(x, y);
  }

  /** @param {string} tab */
  async openTab(tab) {
    await this.press(tab);
    await this.expectState((state) => state.tab, tab);
  }

  /** Returns a control's area on the page. @param {string} control @returns {Promise<Clip>} */
  async clipOf(control) {
    const from = await this.placeOf(control, { x: 0, y: 0 });
    const to = await this.placeOf(control, { x: 1, y: 1 });
    return { x: from.x, y: from.y, width: to.x - from.x, height: to.y - from.y };
  }

  /** Waits until a part of the page has stopped changing. @param {Clip} clip */
  async expectStill(clip) {
    let last = '';
    let alike = 0;
    await poll(
      async () => {
        const now = (await this.page.screenshot({ clip })).toString('base64');
        alike = now === last ? alike + 1 : 0;
        last = now;
        return alike;
      },
      { intervals: [500] },
    ).toBe(4);
  }

  /** Returns a picture of a part of the page, as PNG. @param {Clip} clip */
  picture(clip) {
    return this.page.screenshot({ clip });
  }
}
