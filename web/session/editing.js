// SPDX-License-Identifier: GPL-3.0-or-later
// Applies the user's edits to the work, and places the code again after each complete edit.
import { text } from '../i18n/catalogue.js';
import { controlName, shownValue } from '../ui/verdict_lines.js';
import { plannedWords } from './batching.js';
import { valuesByHandles } from './work.js';

/** @typedef {import('./work.js').Work} Work */

/**
 * @typedef {object} EditingOptions
 * @property {import('./work_store.js').WorkStore} store
 * @property {import('../ui/setting_fields.js').SettingFields} fields
 * @property {Pick<import('../ui/settings_form.js').SettingsForm, 'listen'>} form
 * @property {Pick<import('../ui/code_panel.js').CodePanel, 'listen' | 'refresh' | 'showParts' | 'showPlaced'>} code
 * @property {Pick<import('../ui/batch_panel.js').BatchPanel, 'listen'>} batchPanel
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./batching.js').Batching} batching
 * @property {import('./spot_finding.js').SpotFinding} spots
 * @property {import('./placing.js').Placing} placing
 * @property {Pick<import('../ui/place_panel.js').PlacePanel, 'listenToRemedies'>} placePanel
 * @property {import('../ui/messages.js').Messages} messages
 * @property {(action: () => Promise<unknown>) => Promise<void>} guard
 */

export class Editing {
  /** @param {EditingOptions} options */
  constructor({ store, fields, form, code, batchPanel, placePanel, model, batching, spots, placing, messages, guard }) {
    this.store_ = store;
    this.fields_ = fields;
    this.code_ = code;
    this.model_ = model;
    this.batching_ = batching;
    this.spots_ = spots;
    this.placing_ = placing;
    this.messages_ = messages;
    form.listen({
      onInput: (id, value) => store.update(({ values }) => ({ values: { ...values, [id]: value } })),
      onChange: (id, value) => guard(() => this.editSetting(id, value)),
    });
    code.listen({
      onInput: (content) => store.update({ text: content }),
      onMakes: (makes) => store.update(({ values }) => ({ values: fields.edited(values, 'content', makes) })),
      onChange: () => guard(() => this.apply('text')),
    });
    batchPanel.listen({
      onChange: (input) => guard(() => this.useParts(input)),
      onFile: (file) => guard(() => batching.openList(file)),
    });
    placing.placed.on((placement) => code.showPlaced(placement));
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
    this.store_.applied.tell(field);
    await this.batching_.ready();
    await this.spots_.forget();
    await this.placing_.place();
    this.spots_.again();
    if (!this.placing_.placement) await this.batching_.explainMissingCode();
  }

  /**
   * Edits a setting's control.
   * @param {string} id
   * @param {string | boolean} value
   */
  async editSetting(id, value) {
    this.store_.update(({ values }) => ({ values: this.fields_.edited(values, id, value) }));
    await this.apply(id);
  }

  /** Applies the size and the rotation set by the code's handles. @param {{ rotateDeg?: number, symbolMm?: number }} change */
  async adjust(change) {
    const { rotationDeg = 0 } = this.placing_.placement ?? {};
    const changed = valuesByHandles({ ...keptTurn(rotationDeg), ...change }, this.store_.work.values);
    this.store_.update(({ values }) => ({ values: { ...values, ...changed } }));
    await this.apply(Object.keys(changed)[0]);
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
    this.store_.update(({ values }) => ({
      values: changes.reduce((before, change) => this.fields_.after(before, change), values),
    }));
    await this.apply();
    if (!this.placing_.placement) return undefined; // the page shows why
    const [{ id, value }] = changes.map((change) => this.fields_.controlFor(change));
    return this.messages_.say(() =>
      text('check.done', { label, control: controlName(id), value: shownValue(id, value) }),
    );
  }

  /**
   * Takes over text, values and list of another work, but does not apply them. The list stays while its parts are carved.
   * @param {Pick<Work, 'text' | 'values' | 'batch'>} other
   */
  restore({ text: content, values, batch }) {
    this.store_.update((work) => ({
      text: content,
      values: this.fields_.restored(work.values, values),
      batch: this.batching_.isLocked ? work.batch : batch,
    }));
  }

  /** Makes a carved model the model. Its file has the pose on the printer. @param {import('./model_session.js').Source} carved */
  async goOnWith(carved) {
    this.store_.update(({ values }) => ({
      values: this.fields_.after(values, { setting: 'buildUp', value: 'as-modelled' }),
    }));
    await this.model_.load(carved);
  }

  /** Continues with a stored work. @param {import('../storage/last_work.js').Work} stored */
  async continueWith({ text: content, values, sampleId, bytes, batch, address: _, ...place }) {
    this.restore({ text: content ?? this.store_.work.text, values, batch });
    const { centreMm, ...file } = place;
    if (sampleId) await this.model_.openSample(sampleId, place);
    else if (bytes) await this.model_.load({ ...file, bytes, credit: '' }, centreMm);
  }
}

/** Returns the rotation to which a code was turned to fit; a fixed size would not turn it. @param {number} rotationDeg */
const keptTurn = (rotationDeg) => (rotationDeg === 0 ? {} : { rotateDeg: Math.round(rotationDeg * 10) / 10 });
