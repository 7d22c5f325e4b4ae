// SPDX-License-Identifier: GPL-3.0-or-later
// Opens and closes the inspector. Loads its texts on first use.
import { onLanguage } from '../i18n/catalogue.js';

/**
 * @typedef {object} InspectorControlOptions
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('../view/view.js').View} view
 * @property {import('../view/inspector_view.js').InspectorView} window
 * @property {import('../ui/view_toolbar.js').ViewToolbar} toolbar
 * @property {(action: () => Promise<void>) => Promise<void>} guard
 */

export class InspectorControl {
  /** @param {InspectorControlOptions} options */
  constructor({ client, view, window, toolbar, guard }) {
    this.client_ = client;
    this.view_ = view;
    this.window_ = window;
    this.toolbar_ = toolbar;
    onLanguage(() => {
      if (toolbar.inspectorShown) void guard(() => this.translate_());
    });
  }

  /** @param {boolean} isShown */
  async show(isShown) {
    if (!isShown) {
      await this.close_();
      return;
    }
    try {
      await this.client_.inspector({ kind: 'open' });
      await this.translate_();
      await this.makeRoom();
      if (!this.toolbar_.inspectorShown) return; // closed meanwhile
      this.view_.reportsPointer = true;
      await this.client_.inspector({ kind: 'show', shown: true });
    } catch (thrown) {
      this.toolbar_.releaseInspector();
      await this.close_();
      throw thrown;
    }
  }

  /** Keeps the inspector clear of the page's controls. */
  async makeRoom() {
    if (this.toolbar_.inspectorShown) await this.client_.inspector({ kind: 'area', ...this.window_.area() });
  }

  /** Reopens the inspector in a new module. */
  async restore() {
    this.window_.update(undefined);
    if (this.toolbar_.inspectorShown) await this.show(true);
  }

  async close_() {
    this.view_.reportsPointer = false;
    await this.client_.inspector({ kind: 'show', shown: false });
    this.window_.update(undefined); // last, because frames drawn until now have reported states
  }

  async translate_() {
    const { inspectorTexts } = await import('../i18n/inspector_texts.js');
    await this.client_.inspector({ kind: 'texts', texts: await inspectorTexts() });
  }
}
