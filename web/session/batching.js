// SPDX-License-Identifier: GPL-3.0-or-later
// Where the parts of a batch come from: the list is checked as a whole, and the first part is worked on as one code is.
import { isReplaced } from '../engine/client.js';
import { describeThrown, isFatal } from '../engine/engine_error.js';
import { text } from '../i18n/catalogue.js';
import { isEmptyInput } from '../ui/batch_panel.js';

/** @typedef {import('../engine/types.js').Settings} Settings */
/** @typedef {import('../engine/types.js').BatchPlan} BatchPlan */
/** @typedef {import('../engine/types.js').BatchRow} BatchRow */
/** @typedef {import('../engine/types.js').WantedBatch} WantedBatch */
/** @typedef {import('../engine/message.js').Message} Message */
/** @typedef {import('../storage/last_work.js').BatchInput} BatchInput */
/** @typedef {{ input: BatchInput, wanted: WantedBatch, plan?: BatchPlan, problems: Message[], first?: BatchRow }} Planned
 *   `first`: none with problems */

const kMostListBytes = 64 * 1024 * 1024;

/**
 * @typedef {object} BatchingOptions
 * @property {Pick<import('../engine/client.js').EngineClient, 'planBatch' | 'batchRow'>} client
 * @property {Pick<import('../ui/batch_panel.js').BatchPanel, 'input' | 'show' | 'takeList'>} panel
 * @property {Pick<import('../ui/messages.js').Messages, 'showError' | 'clearError'>} messages
 * @property {(content: string) => Settings} settings  of the controls, with this text; throws an EngineFailure
 * @property {() => boolean} isLocked                  parts are being carved from the list
 * @property {(planned: Planned | undefined) => void} onPlanned  undefined: one code
 */

export class Batching {
  /** @param {BatchingOptions} options */
  constructor({ client, panel, messages, settings, isLocked, onPlanned }) {
    this.client_ = client;
    this.panel_ = panel;
    this.messages_ = messages;
    this.settings_ = settings;
    this.isLocked_ = isLocked;
    this.onPlanned_ = onPlanned;
    /** @type {Planned | undefined} */ this.planned = undefined;
    /** @type {Promise<void> | undefined} */ this.planning_ = undefined;
  }

  /** None: one code. */
  get input() {
    return this.panel_.input;
  }

  /** Into the controls, without any effect yet. @param {BatchInput | undefined} input */
  set input(input) {
    if (!this.isLocked_()) this.panel_.input = input;
  }

  /** Whether there is something to be said before a part can be carved. */
  get incomplete() {
    return this.input !== undefined && this.planned?.first === undefined;
  }

  /** The settings of the first part; those of one code, where there is none. @param {string} content  of one code */
  settings(content) {
    const first = this.input && this.planned?.first;
    return first ? { ...this.settings_(first.text), ...first.settings } : this.settings_(content);
  }

  /** Whether the list has the first part's value of a setting. @param {string} setting */
  decides(setting) {
    const first = this.input && this.planned?.first;
    return first !== undefined && setting in first.settings;
  }

  /** A new module does not know the list. */
  forget() {
    this.planned = undefined;
  }

  /** Until what the controls say is planned; nothing is to be done if it is already. */
  async ready() {
    while (this.planning_) await this.planning_;
    const { input } = this;
    if (!input) {
      if (this.planned) this.set_(undefined);
      return;
    }
    /** @type {WantedBatch} */
    const wanted = { settings: this.settings_(''), text: input.text, name: input.name, count: input.from === 'count' ? input.count : 0, perPlate: input.perPlate };
    const isSame = this.planned?.input === input && JSON.stringify(this.planned.wanted) === JSON.stringify(wanted);
    if (isSame) return;
    this.planning_ = this.plan_(input, wanted).finally(() => { this.planning_ = undefined; });
    await this.planning_;
  }

  /** @param {BatchInput} input @param {WantedBatch} wanted */
  async plan_(input, wanted) {
    if (isEmptyInput(input)) {
      this.set_({ input, wanted, problems: [] });
      return;
    }
    try {
      const plan = await this.client_.planBatch(input.list, wanted);
      const first = plan.rows > 0 ? await this.client_.batchRow(0) : undefined;
      this.set_({ input, wanted, plan, problems: plan.problems, first });
    } catch (thrown) {
      if (isReplaced(thrown) || isFatal(thrown)) throw thrown;
      this.set_({ input, wanted, problems: [describeThrown(thrown)] });
    }
  }

  /** @param {Planned | undefined} planned */
  set_(planned) {
    this.planned = planned;
    this.panel_.show(planned ?? { problems: [] });
    this.onPlanned_(planned);
  }

  /** @param {File} file  a list */
  async openList(file) {
    if (this.isLocked_()) return;
    if (file.size > kMostListBytes) {
      const values = { file: file.name, size: Math.round(file.size / 2 ** 20), limit: kMostListBytes / 2 ** 20 };
      this.messages_.showError({ found: () => text('batch.listTooLarge', values), help: () => text('batch.listTooLargeHint') });
      return;
    }
    this.panel_.takeList(new Uint8Array(await file.arrayBuffer()), file.name);
  }
}

/** What stands beside the step's heading. @param {Planned} planned */
export function plannedWords({ input, plan, problems }) {
  if (isEmptyInput(input)) return text('batch.listMissing');
  if (problems.length > 0) return text(plan?.mayBeMore ? 'batch.problemsAtLeast' : 'batch.problems', { count: problems.length });
  const { rows = 0, version = 0, modules = 0 } = plan ?? {};
  if (input.perPlate === 0) return text('batch.planned', { count: rows, version, modules });
  const parts = text('batch.parts', { count: rows }), plates = text('batch.plateCount', { count: Math.ceil(rows / input.perPlate) });
  return text('batch.plannedPlates', { parts, plates, version, modules });
}

/** Whether a file may be a list rather than a model. @param {{ name: string, type: string }} file */
export const looksLikeList = ({ name, type }) => /\.(csv|tsv|txt|jsonl|ndjson)$/i.test(name) || type === 'text/csv';
