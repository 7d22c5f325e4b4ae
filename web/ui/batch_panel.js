// SPDX-License-Identifier: GPL-3.0-or-later
// The choice between one code and a code for every part, the list or the numbers that the parts come from, and the
// problems found in them.
import { onLanguage, text } from '../i18n/catalogue.js';
import { formatNumber } from '../i18n/format.js';
import { hintOf, sentenceOf } from '../i18n/messages.js';
import { byId } from '../dom/dom.js';
import { ListPreview, columnAlone } from './list_preview.js';
import { showFindings } from './messages.js';

/** @typedef {import('../storage/last_work.js').BatchInput} BatchInput */
/** @typedef {import('../engine/types.js').BatchPlan} BatchPlan */
/** @typedef {import('../engine/types.js').BatchRow} BatchRow */

const kTypingPauseMs = 250;
const kMostShownBytes = 20_000; // the panel shows a longer list by its name only
const kNumberedText = 'https://example.org/p/{n:05}';
const kNumber = 'n'; // names a part's number in templates
const kPerPlate = 12; // used while the field holds no valid number of parts
const kPasted = ''; // the name of a list that was typed or pasted

/** The input before anything is typed. @type {BatchInput} */
export const kEmptyInput = Object.freeze({
  from: 'list',
  list: new Uint8Array(),
  listName: kPasted,
  count: 100,
  text: '',
  name: '',
  perPlate: 0,
  id: '',
  names: '',
});

/**
 * @typedef {object} BatchListener
 * @property {(input: BatchInput | undefined) => void} onChange  the input has changed; undefined for one code
 * @property {(file: File) => void} onFile  the user chose a list file
 */

export class BatchPanel {
  constructor() {
    /** @type {BatchListener | undefined} */ this.listener_ = undefined;
    this.isMany_ = byId('code-for-many', HTMLInputElement);
    this.isOne_ = byId('code-for-one', HTMLInputElement);
    this.fields_ = byId('batch', HTMLFieldSetElement);
    this.from_ = byId('batch-from', HTMLSelectElement);
    this.pasted_ = byId('batch-list', HTMLTextAreaElement);
    this.count_ = byId('batch-count', HTMLInputElement);
    this.text_ = byId('batch-text', HTMLInputElement);
    this.name_ = byId('batch-name', HTMLInputElement);
    this.files_ = byId('batch-files', HTMLSelectElement);
    this.perPlate_ = byId('batch-per-plate', HTMLInputElement);
    this.problems_ = byId('batch-problems', HTMLElement);
    this.first_ = byId('batch-first', HTMLElement);
    this.preview_ = new ListPreview({
      onText: (column) => {
        this.text_.value = `{${column}}`;
        this.take_();
      },
      onId: (id) => this.choose_({ id }),
    });
    /** @type {BatchInput} */ this.input_ = kEmptyInput;
    /** @type {ReturnType<typeof setTimeout> | undefined} */ this.pause_ = undefined;
    /** @type {() => void} */ this.writeFindings_ = () => {};
    // Input comes before change: undo records the change under the radio's own name.
    for (const radio of [this.isOne_, this.isMany_]) radio.addEventListener('input', () => this.changed_());
    this.from_.addEventListener('change', () => {
      const isCount = this.from_.value === 'count';
      if (isCount && (this.text_.value === '' || namesColumn(this.text_.value))) this.text_.value = kNumberedText;
      if (!isCount && this.text_.value === kNumberedText) this.text_.value = '';
      this.take_();
    });
    this.files_.addEventListener('change', () => this.take_());
    for (const field of [this.pasted_, this.count_, this.text_, this.name_, this.perPlate_]) {
      field.addEventListener('input', () => this.takeSoon_());
      field.addEventListener('change', () => this.take_());
      field.addEventListener('keydown', (event) => {
        const isEnter = event instanceof KeyboardEvent && event.key === 'Enter';
        if (isEnter && field !== this.pasted_) event.preventDefault(); // Enter would engrave before planning
        if (isEnter && field !== this.pasted_) this.take_();
      });
    }
    const file = byId('batch-open-file', HTMLInputElement);
    file.addEventListener('change', () => {
      const [chosen] = file.files ?? [];
      if (chosen) this.listener_?.onFile(chosen);
      file.value = ''; // allows choosing the same file again after correcting it
    });
    byId('batch-file-remove', HTMLButtonElement).addEventListener('click', () => {
      this.put_({ ...this.input_, list: new Uint8Array(), listName: kPasted, id: '', names: '' });
      this.pasted_.focus();
      this.report_();
    });
    onLanguage(() => this.showTexts_());
    this.showTexts_();
    this.showFields_();
  }

  /** @param {BatchListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  /** Shows an input. Leaves the fields alone if it is theirs. @param {BatchInput | undefined} input  undefined: one code */
  showInput(input) {
    this.isMany_.checked = input !== undefined;
    this.isOne_.checked = input === undefined;
    if (input && input !== this.input_) this.put_(input);
    this.showFields_();
  }

  /** Takes over a list from a file. @param {Uint8Array} list @param {string} listName */
  takeList(list, listName) {
    this.isMany_.checked = true;
    this.from_.value = 'list';
    // A column of another list, or a text for parts without a list.
    const isStale = namesColumn(this.text_.value) || this.text_.value === kNumberedText;
    this.put_({
      ...this.input_,
      from: 'list',
      list,
      listName,
      text: isStale ? '' : this.text_.value,
      name: this.name_.value,
      id: '',
      names: '',
    });
    this.changed_();
  }

  /** Locks the input while parts are carved, so that the list cannot change. @param {boolean} locked */
  lock(locked) {
    this.fields_.disabled = locked;
    this.isOne_.disabled = locked;
    this.isMany_.disabled = locked;
    this.fields_.title = locked ? text('batch.locked') : '';
  }

  /** Moves the focus to the first problem, or to the field that is still empty. */
  reveal() {
    if (this.problems_.childElementCount > 0) this.problems_.focus();
    else (this.from_.value === 'count' ? this.count_ : this.pasted_).focus();
  }

  /**
   * Shows the problems and the first part of the planned batch.
   * @param {{ plan?: BatchPlan, problems: import('../engine/message.js').Message[], first?: BatchRow }} planned
   */
  show({ plan, problems, first }) {
    this.writeFindings_ = () => {
      const unused = plan?.unused.length
        ? [{ severity: 'warning', found: text('batch.unused', { columns: plan.unused.join(', ') }), help: '' }]
        : [];
      showFindings(this.problems_, [
        ...problems.map((problem) => ({
          severity: 'blocking',
          found: sentenceOf(problem),
          help: hintOf(problem),
          remedies: this.remediesFor_(problem),
        })),
        ...(plan?.warnings ?? []).map((warning) => ({
          severity: 'warning',
          found: sentenceOf(warning),
          help: hintOf(warning),
          remedies: this.remediesFor_(warning),
        })),
        ...unused,
      ]);
      this.preview_.show(plan, this.input_);
      this.first_.hidden = first === undefined;
      this.first_.textContent = first ? text('batch.firstShown', { id: first.id, text: first.text }) : '';
    };
    this.writeFindings_();
  }

  /**
   * Offers other readings of the table where the program could not know which one is meant.
   * @param {import('../engine/message.js').Message} finding
   * @returns {import('./messages.js').Remedy[]}
   */
  remediesFor_({ code }) {
    const namesAre = (/** @type {'yes' | 'no'} */ names, /** @type {import('../i18n/catalogue.js').Key} */ label) =>
      this.input_.names === names ? [] : [{ label: text(label), run: () => this.choose_({ names }) }];
    if (code === 'list-without-names') return namesAre('yes', 'batch.firstHasNames');
    return code === 'list-without-text' ? namesAre('no', 'batch.firstIsPart') : [];
  }

  /** @param {Partial<BatchInput>} choice */
  choose_(choice) {
    this.input_ = { ...this.input_, ...choice };
    this.changed_();
  }

  /** @param {BatchInput} input */
  put_(input) {
    this.input_ = input;
    this.from_.value = input.from;
    this.count_.value = String(input.count);
    this.text_.value = input.text;
    this.name_.value = input.name;
    this.files_.value = input.perPlate > 0 ? 'plates' : 'each';
    if (input.perPlate > 0) this.perPlate_.value = String(input.perPlate);
    const isShown = input.listName === kPasted && input.list.length <= kMostShownBytes;
    this.pasted_.value = isShown ? new TextDecoder().decode(input.list) : '';
    this.showFields_();
  }

  takeSoon_() {
    clearTimeout(this.pause_);
    this.pause_ = setTimeout(() => this.take_(), kTypingPauseMs);
  }

  /** Takes over the values of the controls if they have changed. */
  take_() {
    clearTimeout(this.pause_);
    const { list, listName, id, names } = this.input_;
    const isFile = listName !== kPasted;
    const count = this.count_.validity.valid ? this.count_.valueAsNumber : 0;
    /** @type {BatchInput} */
    const now = {
      from: this.from_.value === 'count' ? 'count' : 'list',
      list,
      listName,
      count,
      text: this.text_.value,
      name: this.name_.value,
      perPlate:
        this.files_.value !== 'plates'
          ? 0
          : this.perPlate_.validity.valid
            ? this.perPlate_.valueAsNumber
            : this.input_.perPlate || kPerPlate,
      id,
      names,
    };
    const pasted = isFile ? list : new TextEncoder().encode(this.pasted_.value);
    const isSameList = pasted.length === list.length && pasted.every((byte, i) => byte === list[i]);
    if (!isSameList) now.list = pasted;
    const isSame = (/** @type {keyof BatchInput} */ key) => now[key] === this.input_[key];
    if (/** @type {(keyof BatchInput)[]} */ (Object.keys(now)).every(isSame)) return;
    this.input_ = now;
    this.changed_();
  }

  changed_() {
    this.showFields_();
    this.report_();
  }

  /** Reports the input. It stays the same object until something changes. */
  report_() {
    this.listener_?.onChange(this.isMany_.checked ? this.input_ : undefined);
  }

  showFields_() {
    const isMany = this.isMany_.checked,
      isList = this.from_.value === 'list',
      isFile = this.input_.listName !== kPasted;
    byId('one-code', HTMLElement).hidden = isMany;
    byId('step-parts', HTMLElement).hidden = !isMany;
    this.fields_.hidden = !isMany;
    byId('batch-list-fields', HTMLElement).hidden = !isList;
    byId('batch-count-fields', HTMLElement).hidden = isList;
    byId('batch-per-plate-field', HTMLElement).hidden = this.files_.value !== 'plates';
    byId('batch-name-field', HTMLElement).hidden = this.files_.value === 'plates';
    byId('batch-pasted', HTMLElement).hidden = isFile;
    byId('batch-file', HTMLElement).hidden = !isFile;
    if (!isMany) this.show({ problems: [] });
    this.showTexts_();
  }

  /** Writes the texts that contain values. */
  showTexts_() {
    byId('batch-hint', HTMLElement).textContent = text('batch.hint', { plain: '{n}', padded: '{n:05}' });
    this.text_.placeholder = this.from_.value === 'count' ? kNumberedText : text('batch.textAuto');
    byId('batch-file-name', HTMLElement).textContent = text('batch.listIs', {
      name: this.input_.listName,
      size: formatNumber(Math.max(1, this.input_.list.length / 1000)),
    });
    this.writeFindings_();
  }
}

/** Tells whether a template is a column of a list and nothing else. @param {string} template */
const namesColumn = (template) => (columnAlone(template) ?? kNumber) !== kNumber;

/** @param {BatchInput} input */
export const isEmptyInput = ({ from, list, count }) => (from === 'list' ? list.length === 0 : count < 1);
