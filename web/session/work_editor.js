// SPDX-License-Identifier: GPL-3.0-or-later
// Applies the user's edits to the work, and places the code again after each complete edit.
import { text } from '../i18n/catalogue.js';
import { controlName, valueName } from '../i18n/setting_names.js';
import { proposedChange, restoredSettings, settingsAfter } from '../settings/work_settings.js';
import { plannedWords } from './batching.js';
import { changeByHandles, withChanges } from './work.js';

/** @typedef {import('./work.js').Work} Work */
/** @typedef {import('../settings/work_settings.js').WorkSettings} WorkSettings */

/**
 * @typedef {object} WorkEditorOptions
 * @property {import('./work_store.js').WorkStore} store
 * @property {WorkSettings} defaults  of the settings that have a control
 * @property {Pick<import('../ui/settings_form.js').SettingsForm, 'listen' | 'showPlaced'>} form
 * @property {Pick<import('../ui/code_panel.js').CodePanel, 'listen' | 'refresh' | 'showParts' | 'showPlaced'>} code
 * @property {Pick<import('../ui/batch_panel.js').BatchPanel, 'listen'>} batchPanel
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./batching.js').Batching} batching
 * @property {import('./spot_search.js').SpotSearch} spots
 * @property {import('./placing.js').Placing} placing
 * @property {Pick<import('../ui/place_panel.js').PlacePanel, 'listenToRemedies'>} placePanel
 * @property {import('../ui/messages.js').Messages} messages
 * @property {(action: () => Promise<unknown>) => Promise<void>} guard
 */

export class WorkEditor {
  /** @param {WorkEditorOptions} options */
  constructor({
    store,
    defaults,
    form,
    code,
    batchPanel,
    placePanel,
    model,
    batching,
    spots,
    placing,
    messages,
    guard,
  }) {
    this.store_ = store;
    this.defaults_ = defaults;
    this.code_ = code;
    this.model_ = model;
    this.batching_ = batching;
    this.spots_ = spots;
    this.placing_ = placing;
    this.messages_ = messages;
    form.listen({
      onInput: (change) => store.update(({ settings }) => ({ settings: { ...settings, ...change } })),
      onChange: (change) => guard(() => this.editSettings(change)),
    });
    code.listen({
      onInput: (content) => store.update({ text: content }),
      onMakes: (content) => store.update(({ settings }) => ({ settings: { ...settings, content } })),
      onChange: () => guard(() => this.apply('text')),
      onIncomplete: () => guard(() => placing.place(true)), // no edit to undo or keep: the code only leaves the model
    });
    batchPanel.listen({
      onChange: (input) => guard(() => this.useParts(input)),
      onFile: (file) => guard(() => batching.openList(file)),
    });
    placing.placed.on((placement) => {
      code.showPlaced(placement);
      form.showPlaced(placement);
    });
    placePanel.listenToRemedies((change, label) => void guard(() => this.remedy({ changes: [change] }, label)));
    batching.changed.on((planned) =>
      code.showParts(
        planned && { words: () => plannedWords(planned), isWrong: planned.problems.length > 0, first: planned.first },
      ),
    );
  }

  /** Announces a complete edit, and places the code again. @param {string} [field]  edited field */
  async apply(field) {
    if (this.model_.engravable) this.messages_.clearError(); // else the page still shows why there is no model
    this.code_.refresh();
    this.store_.applied.emit(field);
    await this.batching_.ready();
    await this.spots_.forget();
    await this.placing_.place();
    this.spots_.proposeAgain();
    if (!this.placing_.placement && !this.placing_.missing) await this.batching_.explainMissingCode();
  }

  /** Changes settings, and those that follow them. @param {WorkSettings} change  the first one is the edited one */
  async editSettings(change) {
    this.store_.update(({ settings }) => ({ settings: settingsAfter(settings, change) }));
    await this.apply(Object.keys(change)[0]);
  }

  /** Applies the size and the rotation set by the code's handles. @param {{ rotateDeg?: number, symbolMm?: number }} change */
  async adjust(change) {
    const { rotationDeg = 0 } = this.placing_.placement ?? {};
    await this.editSettings(changeByHandles({ ...keptTurn(rotationDeg), ...change }, this.store_.work.settings));
  }

  /** Applies another list, or the change back to a single code. @param {Work['batch']} batch */
  async useParts(batch) {
    this.store_.update({ batch });
    await this.batching_.ready();
    await this.apply('parts');
  }

  /** @param {import('../engine/types.js').UpAxis} upAxis */
  async turnUp(upAxis) {
    await this.model_.turnUp(upAxis);
    await this.apply();
  }

  /** Applies a remedy. @param {Pick<import('../engine/types.js').Remedy, 'changes'>} remedy @param {string} label */
  async remedy({ changes }, label) {
    if (!changes) return this.spots_.suggest();
    this.store_.update((work) => withChanges(work, changes));
    await this.apply();
    if (!this.placing_.placement) return undefined; // the page shows why
    const [[key, value]] = Object.entries(proposedChange(changes[0]));
    return this.messages_.say(() =>
      text('check.done', { label, control: controlName(key), value: valueName(key, value) }),
    );
  }

  /**
   * Takes over text, settings and list of another work, but does not apply them. The list stays while its parts are carved.
   * @param {Pick<Work, 'text' | 'settings' | 'batch'>} other
   */
  restore({ text: content, settings, batch }) {
    this.store_.update((work) => ({
      text: content,
      settings: restoredSettings(settings, this.defaults_),
      batch: this.batching_.isLocked ? work.batch : batch,
    }));
  }

  /** Makes a carved model the model. Its file has the pose on the printer. @param {import('./model_session.js').Source} carved */
  async goOnWith(carved) {
    this.store_.update(({ settings }) => ({ settings: { ...settings, buildUp: 'as-modelled' } }));
    await this.model_.load(carved);
  }

  /** Continues with a stored work. @param {import('../storage/last_work.js').Work} stored */
  async continueWith({ text: content, settings, sampleId, bytes, batch, address: _, ...place }) {
    this.restore({ text: content ?? this.store_.work.text, settings, batch });
    const { centreMm, ...file } = place;
    if (sampleId) await this.model_.openSample(sampleId, place);
    else if (bytes) await this.model_.load({ ...file, bytes, credit: '' }, centreMm);
  }
}

/** Returns the rotation to which a code was turned to fit; a fixed size would not turn it. @param {number} rotationDeg */
const keptTurn = (rotationDeg) => (rotationDeg === 0 ? {} : { rotateDeg: Math.round(rotationDeg * 10) / 10 });
