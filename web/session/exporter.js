// SPDX-License-Identifier: GPL-3.0-or-later
// Saves the symbol, a picture of the view and the settings; shares the link that sets the page up; loads settings.
import { text } from '../i18n/catalogue.js';
import { saveFile } from '../dom/save_file.js';
import { fileNameOf, symbolFileName } from '../export/file_names.js';
import { addressFor, settingsFromAddress } from '../export/address_settings.js';
import { readSettingsFile, writeSettingsFile } from '../export/settings_file.js';
import { shareLink } from '../export/share_link.js';
import { symbolPng, symbolSvg } from '../export/symbol_file.js';
import { holdsSecret } from '../payloads/secrets.js';
import { keysOf, requestedSettings, restoredSettings } from '../settings/work_settings.js';

/** @typedef {import('../engine/types.js').SymbolFacts} SymbolFacts */
/** @typedef {import('../export/settings_file.js').SettingsFile} SettingsFile */
/** @typedef {import('../export/settings_file.js').ModelChoice} ModelChoice */

/**
 * @typedef {object} ExporterOptions
 * @property {import('../engine/client.js').EngineClient} client
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./work_store.js').WorkStore} store
 * @property {import('./placing.js').Placing} placing
 * @property {import('../ui/messages.js').Messages} messages
 * @property {import('../settings/work_settings.js').WorkSettings} defaults  of the settings that have a control
 * @property {Pick<import('./batching.js').Batching, 'settings'>} batching
 * @property {import('../ui/export_panel.js').ExportPanel} panel
 * @property {Pick<import('./work_editor.js').WorkEditor, 'apply'>} editor
 * @property {Pick<import('./carving.js').Carving, 'abort'>} carving
 * @property {Pick<import('./jobs.js').Jobs, 'untilIdle'>} jobs
 * @property {(action: () => Promise<unknown>) => Promise<void>} guard
 */

export class Exporter {
  /** @param {ExporterOptions} options */
  constructor({ client, model, store, placing, messages, defaults, batching, panel, editor, carving, jobs, guard }) {
    this.client_ = client;
    this.model_ = model;
    this.store_ = store;
    this.placing_ = placing;
    this.messages_ = messages;
    this.defaults_ = defaults;
    this.batching_ = batching;
    this.editor_ = editor;
    this.carving_ = carving;
    this.jobs_ = jobs;
    /** Settings that the address or the last settings file asked for. @type {import('../settings/work_settings.js').WorkSettings} */
    this.asked = {};
    panel.listen({
      onPicture: () => guard(() => this.savePicture()),
      onSettings: () => guard(async () => this.saveSettings()),
      onShare: () => guard(() => this.shareLink()),
      onSymbol: (format) => guard(() => this.saveSymbol(format)),
    });
    placing.placed.on(() => {
      panel.setSecret(holdsSecret(store.work.text));
      panel.setSymbol(store.work.settings.content !== 'text');
    });
  }

  /** @param {'svg' | 'png'} format */
  async saveSymbol(format) {
    const settings = this.batching_.settings();
    const facts = await this.client_.symbol(settings);
    if ('letters' in facts) return;
    const { rows } = facts;
    const blob =
      format === 'png'
        ? await symbolPng(rows)
        : new Blob([symbolSvg(rows, { title: settings.text, sizeMm: this.placing_.placement?.symbolMm })], {
            type: 'image/svg+xml',
          });
    saveFile(blob, symbolFileName(settings.text, format));
  }

  async savePicture() {
    const bytes = await this.client_.picture();
    saveFile(new Blob([bytes], { type: 'image/png' }), this.nameOf_('view', 'png'));
  }

  saveSettings() {
    const file = writeSettingsFile({ settings: this.settingsToSave_, model: this.modelChoice_() });
    saveFile(new Blob([file], { type: 'application/json' }), this.nameOf_('settings', 'json'));
  }

  /** Shares the link that sets the page up like this one; the user's own model is not in it. */
  async shareLink() {
    const link = new URL(location.pathname, location.href);
    const model = this.modelChoice_();
    const defaults = requestedSettings(this.defaults_, '');
    link.search = String(addressFor({ settings: this.settingsToSave_, defaults, model }));
    const way = await shareLink(link.href, { navigator, history });
    if (way === 'cancelled') return;
    const isWhole = model?.sample !== undefined;
    this.messages_.say(() => `${text(`exports.${way}`)}${isWhole ? '' : ` ${text('exports.linkWithoutModel')}`}`);
  }

  /** Settings of the work, with the text of the single code. */
  get settingsToSave_() {
    const { settings, text: content } = this.store_.work;
    return requestedSettings(settings, content);
  }

  /** @param {import('../engine/types.js').Settings} settings */
  write_(settings) {
    this.asked = restoredSettings(settings, this.defaults_);
    this.store_.update({ text: settings.text, settings: this.asked });
  }

  /**
   * Uses the settings from the page's address and keeps the others. They take effect with the next model.
   * @param {URLSearchParams} address
   * @returns {{ asksForSettings: boolean, refusal?: unknown }}  `refusal`: error of a setting that cannot be used; then
   *   none is used
   */
  useAddress(address) {
    try {
      const asked = settingsFromAddress(address, keysOf(this.defaults_));
      const asksForSettings = Object.keys(asked).length > 0;
      if (asksForSettings) this.write_({ ...this.settingsToSave_, ...asked });
      return { asksForSettings };
    } catch (refusal) {
      return { asksForSettings: true, refusal };
    }
  }

  /**
   * Uses a settings file: all settings, or none if one cannot be used.
   * @param {File} file
   */
  async useSettings(file) {
    const { settings, model } = readSettingsFile(await file.text(), file.name, keysOf(this.defaults_));
    this.carving_.abort();
    await this.jobs_.untilIdle();
    this.messages_.clearError();
    this.write_(settings);
    const onItsModel = !model || (await this.openModelOf_(model));
    const centre = onItsModel ? model?.centreMm : undefined;
    await this.editor_.apply();
    if (centre) await this.placing_.move(() => this.client_.setCentre({ mm: centre }));
    const words = onItsModel
      ? () => text('exports.settingsUsed', { file: file.name })
      : () => text('exports.settingsOtherModel', { file: file.name, model: model.file });
    this.messages_.say(words);
  }

  /**
   * Opens the sample of a settings file, or sets unit and up axis of the open model if the file is for it.
   * @param {ModelChoice} choice
   * @returns {Promise<boolean>}  true: the open model is the file's model
   */
  async openModelOf_(choice) {
    if (
      choice.sample !== undefined &&
      choice.sample !== this.model_.source?.sampleId &&
      this.model_.hasSample(choice.sample)
    ) {
      const { scaleToMm, upAxis, centreMm } = choice;
      await this.model_.openSample(choice.sample, { scaleToMm, upAxis, ...(centreMm ? { centreMm } : {}) });
    }
    const { source } = this.model_;
    if (!source || source.fileName !== choice.file || source.sampleId !== choice.sample) return false;
    if (source.upAxis !== choice.upAxis) await this.model_.turnUp(choice.upAxis);
    if (source.scaleToMm !== choice.scaleToMm) await this.model_.rescale(choice.scaleToMm);
    return true;
  }

  /** @returns {ModelChoice | undefined} */
  modelChoice_() {
    const { source, centreMm } = this.store_.work;
    if (!source) return undefined;
    const { fileName, sampleId, scaleToMm, upAxis } = source;
    return {
      file: fileName,
      ...(sampleId === undefined ? {} : { sample: sampleId }),
      scaleToMm,
      upAxis,
      ...(centreMm ? { centreMm } : {}),
    };
  }

  /** @param {string} addition @param {string} extension */
  nameOf_(addition, extension) {
    const { text: content, content: kind } = this.batching_.settings();
    return fileNameOf({
      modelFile: this.model_.source?.fileName ?? '',
      text: content,
      content: kind,
      symbolMm: this.placing_.placement?.symbolMm,
      addition,
      extension,
    });
  }
}
