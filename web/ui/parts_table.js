// SPDX-License-Identifier: GPL-3.0-or-later
// The table of a batch's parts. It holds one page of rows at a time, however many parts there are.
import { onLanguage, text } from '../i18n/catalogue.js';
import { formatNumber } from '../i18n/format.js';
import { localise } from '../i18n/catalogue.js';
import { setDisabled } from '../dom/set_disabled.js';
import { make } from '../dom/dom.js';

/** @typedef {import('../engine/types.js').BatchRowName} BatchRowName */
/** @typedef {import('../engine/types.js').RowState} RowState */
/** @typedef {import('../engine/types.js').TrackedRow} TrackedRow */
/** @typedef {Pick<import('../batch/tracker.js').Tracker, 'state'>} Tracker */

const kRows = 10;
/** @type {readonly (RowState | 'all')[]} */
const kShown = ['all', 'failed', 'done', 'running', 'waiting'];

export class PartsTable {
  /**
   * @param {HTMLElement} mount
   * @param {(index: number) => Promise<BatchRowName | undefined>} nameOf
   */
  constructor(mount, nameOf) {
    this.nameOf_ = nameOf;
    /** @type {Tracker | undefined} */ this.tracker_ = undefined;
    this.rows_ = 0;
    this.page_ = 0;
    this.asked_ = 0;
    this.filter_ = make('select');
    this.filter_.id = 'parts-shown';
    const label = make('label');
    label.htmlFor = this.filter_.id;
    label.dataset.text = 'batch.show';
    for (const state of kShown) {
      const option = new Option('', state);
      option.dataset.text = `batch.${state}`;
      this.filter_.append(option);
    }
    this.body_ = make('tbody');
    const caption = make('caption', { className: 'hidden' });
    caption.dataset.text = 'batch.table';
    const head = make(
      'tr',
      {},
      .../** @type {const} */ (['number', 'part', 'rowState']).map((key) => {
        const cell = make('th');
        cell.scope = 'col';
        cell.dataset.text = `batch.${key}`;
        return cell;
      }),
    );
    this.previous_ = makeButton('batch.previous', () => this.turn_(-1));
    this.next_ = makeButton('batch.next', () => this.turn_(1));
    this.range_ = make('span');
    this.range_.setAttribute('aria-live', 'polite');
    this.pages_ = make('div', { className: 'parts-pages' }, this.previous_, this.range_, this.next_);
    this.pages_.setAttribute('role', 'group');
    this.pages_.dataset.textLabel = 'batch.pages';
    mount.append(
      make('div', { className: 'field parts-filter' }, label, this.filter_),
      make('table', {}, caption, make('thead', {}, head), this.body_),
      this.pages_,
    );
    localise(mount);
    this.filter_.addEventListener('change', () => {
      this.page_ = 0;
      void this.update();
    });
    onLanguage(() => void this.update());
  }

  /** @param {Tracker} tracker @param {number} rows */
  show(tracker, rows) {
    this.tracker_ = tracker;
    this.rows_ = rows;
    this.page_ = 0;
    this.filter_.value = 'all';
    void this.update();
  }

  /** Shows the current states. */
  async update() {
    const { tracker_: tracker } = this;
    if (!tracker) return;
    const state = /** @type {RowState | 'all'} */ (this.filter_.value);
    const count = state === 'all' ? this.rows_ : tracker.state({})[state];
    this.page_ = Math.max(0, Math.min(this.page_, Math.ceil(count / kRows) - 1));
    const first = this.page_ * kRows;
    const { rows } = tracker.state({ page: { state, skipped: first, count: kRows } });
    const asked = (this.asked_ += 1);
    const names = await Promise.all(rows.map(({ index }) => this.nameOf_(index)));
    if (asked !== this.asked_) return;
    this.body_.replaceChildren(...rows.map((row, i) => rowOf(row, names[i])));
    this.range_.textContent =
      count === 0
        ? text('batch.none')
        : text('batch.range', { from: String(first + 1), to: String(first + rows.length), count: formatNumber(count) });
    setDisabled(this.previous_, first === 0 ? 'batch.whyFirstPage' : undefined);
    setDisabled(this.next_, first + kRows >= count ? 'batch.whyLastPage' : undefined);
    this.pages_.hidden = this.rows_ <= kRows;
  }

  /** @param {number} step */
  turn_(step) {
    this.page_ += step;
    void this.update();
  }
}

/** @param {TrackedRow} tracked @param {BatchRowName | undefined} name */
function rowOf({ index, state, reason }, name) {
  const row = make(
    'tr',
    { className: state },
    make('td', { text: String(name?.number ?? index + 1) }),
    make(
      'td',
      {},
      make('strong', { text: name?.id ?? '' }),
      make('span', { text: name?.text ?? '' }),
      make('span', { text: name?.file ?? '' }),
    ),
    make(
      'td',
      {},
      make('span', { className: 'row-state', text: text(`batch.${state}`) }),
      ...(reason ? [make('span', { text: reason })] : []),
    ),
  );
  return row;
}

/** @param {import('../i18n/catalogue.js').Key} label @param {() => void} onClick */
function makeButton(label, onClick) {
  const button = make('button', { className: 'quiet' });
  button.type = 'button';
  button.dataset.text = label;
  button.addEventListener('click', onClick);
  return button;
}
