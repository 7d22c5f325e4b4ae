// SPDX-License-Identifier: GPL-3.0-or-later
// Opens samples and files (models, settings, lists), and returns to the page's first state.
import { settingsForAnother } from '../settings/work_settings.js';
import { text } from '../i18n/catalogue.js';
import { looksLikeSettings } from '../export/settings_file.js';
import { looksLikeList } from './batching.js';

/**
 * @typedef {object} FileOpenerOptions
 * @property {Pick<import('../ui/model_panel.js').ModelPanel, 'listen'>} panel
 * @property {Pick<import('../ui/code_panel.js').CodePanel, 'initialText' | 'leaveBuilder'>} code
 * @property {import('../settings/work_settings.js').WorkSettings} defaults
 * @property {import('./work_store.js').WorkStore} store
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./batching.js').Batching} batching
 * @property {import('./work_editor.js').WorkEditor} editor
 * @property {import('./exporter.js').Exporter} exporter
 * @property {import('./undo.js').Undo} undo
 * @property {import('./jobs.js').Jobs} jobs
 * @property {Pick<import('../view/view_tools.js').ViewTools, 'act'>} tools
 * @property {Pick<import('../ui/messages.js').Messages, 'showError'>} messages
 * @property {(action: () => Promise<unknown>) => Promise<void>} guard
 */

export class FileOpener {
  /** @param {FileOpenerOptions} options */
  constructor({ panel, code, defaults, store, model, batching, editor, exporter, undo, jobs, tools, messages, guard }) {
    this.code_ = code;
    this.store_ = store;
    this.defaults_ = defaults;
    this.model_ = model;
    this.batching_ = batching;
    this.editor_ = editor;
    this.exporter_ = exporter;
    this.undo_ = undo;
    this.jobs_ = jobs;
    this.messages_ = messages;
    /** Resolves when the module has started; false: it did not. @type {Promise<boolean>} */
    this.started = Promise.resolve(false);
    /** True once the user has chosen a file. */
    this.fileChosen = false;
    /** The text that the page's address gives to its sample. @type {string | undefined} */ this.sampleText = undefined;
    /** @type {import('./model_session.js').SettingsFor} */
    this.settingsFor_ = (settings) => settingsForAnother(settings, exporter.asked);
    panel.listen({
      onSample: (id) => guard(() => model.openSample(id, {}, this.settingsFor_)),
      onFile: (file, left) => guard(() => this.openOneOf_(file, left)),
      onScale: (scaleToMm) => guard(() => model.rescale(scaleToMm)),
      onUpAxis: (upAxis) => guard(() => editor.turnUp(upAxis)),
      onBody: (index) => tools.act({ kind: 'body', index }),
    });
  }

  /** @param {File} file @param {number} left  number of files that were dropped with it */
  async openOneOf_(file, left) {
    await this.openFile(file);
    if (left === 0) return;
    this.messages_.showError({
      found: () => text('page.oneOfSeveral', { count: left + 1, file: file.name }),
      help: () => text('page.oneOfSeveralHint'),
    });
  }

  /** @param {File} file */
  async openFile(file) {
    this.fileChosen = true;
    if (!(await this.started)) return; // the page shows why
    const isList = looksLikeList(file) || (await holdsArray(file));
    if (!isList && !looksLikeSettings(file)) {
      await this.openModel_(file);
      return;
    }
    if (!this.model_.source) await this.model_.openSample();
    if (isList) await this.batching_.openList(file);
    else await this.useSettings_(file);
  }

  /** Opens the user's model. A sample's own text does not follow to it. @param {File} file */
  async openModel_(file) {
    const isSampleText = this.store_.work.text === this.sampleText;
    await this.model_.openFile(file, this.settingsFor_);
    if (!isSampleText || this.model_.source?.sampleId !== undefined) return;
    this.sampleText = undefined;
    this.store_.update({ text: this.code_.initialText });
    await this.editor_.apply('text');
  }

  /** @param {File} file */
  async useSettings_(file) {
    this.undo_.recordNow();
    await this.undo_.asOne(() => this.exporter_.useSettings(file));
  }

  /** Returns to the state in which the page opened. Can be undone. */
  async startOver() {
    this.jobs_.abort();
    this.undo_.recordNow();
    await this.undo_.asOne(async () => {
      this.code_.leaveBuilder();
      this.editor_.restore({ text: this.code_.initialText, settings: this.defaults_, batch: undefined });
      await this.model_.openSample();
    });
  }
}

const kStartBytes = 1024; // of a file, to tell what it holds

/** Tells whether a JSON file holds an array: a list of parts, and no settings. @param {File} file */
const holdsArray = async (file) =>
  looksLikeSettings(file) && (await file.slice(0, kStartBytes).text()).trimStart().startsWith('[');
