// SPDX-License-Identifier: GPL-3.0-or-later
// Plans the parts of a batch: checks the list as a whole and offers its first part to be edited like a single code.
import { isReplaced } from '../engine/client.js';
import { describeThrown, isFatal } from '../engine/engine_error.js';
import { text } from '../i18n/catalogue.js';
import { sentenceOf } from '../i18n/messages.js';
import { asSentence } from '../i18n/sentences.js';
import { kSettings } from '../generated/settings.js';
import { isEmptyInput } from '../ui/batch_panel.js';
import { requestedSettings } from '../settings/work_settings.js';
import { Signal } from './signal.js';

/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {import('../engine/types.js').BatchPlan} BatchPlan */
/** @typedef {import('../engine/types.js').BatchRow} BatchRow */
/** @typedef {import('../engine/types.js').BatchRequest} BatchRequest */
/** @typedef {import('../engine/message.js').Message} Message */
/** @typedef {import('../storage/last_work.js').BatchInput} BatchInput */
/** @typedef {{ input: BatchInput, request: BatchRequest, plan?: BatchPlan, problems: Message[], first?: BatchRow }} Planned
 *   `first`: absent if there are problems */

const kMostListBytes = 64 * 1024 * 1024;

/**
 * @typedef {object} BatchingOptions
 * @property {Pick<import('../engine/client.js').EngineClient, 'planBatch' | 'batchRow' | 'symbol'>} client
 * @property {Pick<import('../ui/batch_panel.js').BatchPanel, 'show' | 'takeList' | 'lock'>} panel
 * @property {import('./work_store.js').WorkStore} store
 * @property {Pick<import('../ui/messages.js').Messages, 'say' | 'showError' | 'clearError'>} messages
 * @property {() => boolean} isLocked                  true: a batch of this list is open
 */

export class Batching {
  /** @param {BatchingOptions} options */
  constructor({ client, panel, store, messages, isLocked }) {
    this.client_ = client;
    this.panel_ = panel;
    this.messages_ = messages;
    this.store_ = store;
    this.isLocked_ = isLocked;
    /** Announces the new plan; undefined: one code. @type {Signal<[Planned | undefined]>} */ this.changed =
      new Signal();
    /** @type {Planned | undefined} */ this.planned = undefined;
    /** @type {Promise<void> | undefined} */ this.planning_ = undefined;
  }

  /** The source of the parts; undefined: a single code. */
  get input() {
    return this.store_.work.batch;
  }

  /** True if problems prevent carving a part. */
  get incomplete() {
    return this.input !== undefined && this.planned?.first === undefined;
  }

  /** Says what the list lacks for placing its first part; undefined: nothing, or there is no list. */
  get missing() {
    const { planned } = this;
    return this.incomplete && planned ? () => asSentence(plannedWords(planned)) : undefined;
  }

  /**
   * Returns the settings of the first part or, without a list, of the single code.
   * @param {string} [content]  of the single code
   * @throws {EngineFailure} if a setting cannot be used
   */
  settings(content = this.store_.work.text) {
    const first = this.input && this.planned?.first;
    return first ? { ...this.settings_(first.text), ...first.settings } : this.settings_(this.input ? '' : content);
  }

  /** Returns the same settings after checking the current list. */
  async plannedSettings() {
    await this.ready();
    return this.settings();
  }

  /** Says why there is no code to place, if text and settings make none. */
  async explainMissingCode() {
    try {
      await this.client_.symbol(this.settings());
    } catch (thrown) {
      if (isReplaced(thrown) || isFatal(thrown)) throw thrown;
      const problem = describeThrown(thrown);
      this.messages_.say(() => asSentence(sentenceOf(problem)));
    }
  }

  /** @param {string} content */
  settings_(content) {
    return requestedSettings(this.store_.work.settings, content);
  }

  /** Keys of the settings that the list decides for the first part, not a control. */
  get decided() {
    const first = this.input && this.planned?.first;
    return first ? Object.keys(first.settings).filter((key) => key in kSettings) : [];
  }

  /** True while a batch of this list is open. */
  get isLocked() {
    return this.isLocked_();
  }

  /** Enables or disables the input. @param {boolean} locked */
  lock(locked) {
    this.panel_.lock(locked);
  }

  /** Forgets the plan: a new module does not know the list. */
  forget() {
    this.planned = undefined;
  }

  /** Plans the current input, unless it is planned already, and waits for the result. */
  async ready() {
    while (this.planning_) await this.planning_;
    const { input } = this;
    if (!input) {
      if (this.planned) this.set_(undefined);
      return;
    }
    /** @type {BatchRequest} */
    const request = {
      settings: this.settings_(''),
      text: input.text,
      name: input.name,
      count: input.from === 'count' ? input.count : 0,
      perPlate: input.perPlate,
      ...(input.id && { id: input.id }),
      ...(input.names && { hasNames: input.names === 'yes' }),
    };
    const isSame = this.planned?.input === input && JSON.stringify(this.planned.request) === JSON.stringify(request);
    if (isSame) return;
    this.planning_ = this.plan_(input, request).finally(() => {
      this.planning_ = undefined;
    });
    await this.planning_;
  }

  /** @param {BatchInput} input @param {BatchRequest} request */
  async plan_(input, request) {
    if (isEmptyInput(input)) {
      this.set_({ input, request, problems: [] });
      return;
    }
    try {
      const plan = await this.client_.planBatch(input.list, request);
      const first = plan.rows > 0 ? await this.client_.batchRow(0) : undefined;
      this.set_({ input, request, plan, problems: plan.problems, first });
    } catch (thrown) {
      if (isReplaced(thrown) || isFatal(thrown)) throw thrown;
      this.set_({ input, request, problems: [describeThrown(thrown)] });
    }
  }

  /** @param {Planned | undefined} planned */
  set_(planned) {
    this.planned = planned;
    this.panel_.show(planned ?? { problems: [] });
    this.changed.emit(planned);
  }

  /** Opens a list. @param {File} file */
  async openList(file) {
    if (this.isLocked_()) {
      this.messages_.showError({ found: () => text('batch.locked'), help: () => '' });
      return;
    }
    if (file.size > kMostListBytes) {
      const values = { file: file.name, size: Math.round(file.size / 2 ** 20), limit: kMostListBytes / 2 ** 20 };
      this.messages_.showError({
        found: () => text('batch.listTooLarge', values),
        help: () => text('batch.listTooLargeHint'),
      });
      return;
    }
    this.panel_.takeList(new Uint8Array(await file.arrayBuffer()), file.name);
  }
}

/** Returns the text next to the step's heading. @param {Planned} planned */
export function plannedWords({ input, plan, problems }) {
  if (isEmptyInput(input)) return text('batch.listMissing');
  if (problems.length > 0)
    return text(plan?.mayBeMore ? 'batch.problemsAtLeast' : 'batch.problems', { count: problems.length });
  const { rows = 0, version, modules = 0 } = plan ?? {};
  const parts = text('batch.parts', { count: rows }),
    plates = text('batch.plateCount', { count: Math.ceil(rows / input.perPlate) });
  if (version === undefined) return parts; // texts alone
  if (input.perPlate === 0) return text('batch.planned', { count: rows, version, modules });
  return text('batch.plannedPlates', { parts, plates, version, modules });
}

/** Tells whether a file may be a list rather than a model. @param {{ name: string, type: string }} file */
export const looksLikeList = ({ name, type }) => /\.(csv|tsv|txt|jsonl|ndjson)$/i.test(name) || type === 'text/csv';
