// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the page, and restores the work in a new module.
import { EngineFailure, describeThrown, internal } from '../engine/engine_error.js';
import { message } from '../engine/message.js';
import { spotFromAddress } from '../export/address_settings.js';
import { text } from '../i18n/catalogue.js';
import { fetchJson } from './fetch_file.js';

const kAsked = ['sample', 'at', 'text', 'engrave']; // address parameters

/**
 * @typedef {object} StartupOptions
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('../view/view.js').View} view
 * @property {import('../ui/preferences.js').Theme} theme
 * @property {import('../ui/view_toolbar.js').ViewToolbar} toolbar
 * @property {import('../ui/messages.js').Messages} messages
 * @property {import('./work_store.js').WorkStore} store
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./batching.js').Batching} batching
 * @property {import('./batch_carving.js').BatchCarving} batchCarving
 * @property {import('./carving.js').Carving} carving
 * @property {import('./autosave.js').Autosave} autosave
 * @property {import('./exporter.js').Exporter} exporter
 * @property {import('./inspector_control.js').InspectorControl} inspectorControl
 * @property {import('./file_opener.js').FileOpener} opener
 * @property {import('./session.js').Session} session
 * @property {(action: () => Promise<unknown>) => Promise<void>} guard
 */

export class Startup {
  /** @param {StartupOptions} options */
  constructor(options) {
    this.options_ = options;
  }

  /** @param {URLSearchParams} address */
  async start(address) {
    const { opener, batchCarving, autosave, guard } = this.options_;
    if (address.has('sample')) opener.sampleText = address.get('text') ?? undefined;
    opener.started = this.startModule_(address);
    if (!(await opener.started)) return;
    if (opener.fileChosen) {
      // the user opened a file before the module was ready
      await batchCarving.offer();
      await autosave.begin('never');
      return;
    }
    await guard(() => this.open_(address));
  }

  /** Opens the page's first model, and does what the address asks for. @param {URLSearchParams} address */
  async open_(address) {
    const { exporter, model, batchCarving, autosave, carving } = this.options_;
    const { asksForSettings, refusal } = exporter.useAddress(address);
    const centreMm = spotFromAddress(address);
    await model.openSample(address.get('sample') ?? undefined, centreMm ? { centreMm } : {});
    const isOffered = await batchCarving.offer();
    const asks = asksForSettings || kAsked.some((name) => address.has(name));
    await autosave.begin(isOffered ? 'never' : asks ? 'same-address' : 'always');
    if (refusal) throw refusal;
    if (address.get('engrave') === '1') await carving.engrave();
  }

  /**
   * @param {URLSearchParams} address
   * @returns {Promise<boolean>}  false: the module did not start
   */
  async startModule_(address) {
    const { client, store, model, messages } = this.options_;
    store.update(({ text: typed }) => ({ text: address.get('text') ?? typed }));
    try {
      const [{ problems }, samples] = await Promise.all([client.start(), fetchJson('samples/manifest.json')]);
      if (problems.length > 0) {
        throw new EngineFailure(internal(message('no-graphics', { why: { cause: problems[0] } })));
      }
      model.setSamples(samples);
    } catch (thrown) {
      messages.say(() => text('page.notStarted'));
      messages.showError(describeThrown(thrown));
      return false;
    }
    await this.prepareView_();
    return true;
  }

  async prepareView_() {
    const { client, view, theme, toolbar } = this.options_;
    view.announceSize();
    await client.show({
      dark: theme.dark,
      buildPlate: toolbar.plateShown,
      construction: toolbar.constructionShown,
      lampLight: toolbar.lampLightShown,
    });
  }

  /** Restores the work in a new module. */
  async restore() {
    const { carving, batching, inspectorControl, messages, model, session } = this.options_;
    await carving.dropForGood();
    batching.forget();
    await this.prepareView_();
    await inspectorControl.restore();
    messages.say(() => text('page.chooseModel'));
    await model.reload();
    if (model.source) await session.begin();
    await carving.resume();
  }
}
