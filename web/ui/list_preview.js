// SPDX-License-Identifier: GPL-3.0-or-later
// The first rows of a list as a table, and the choice of the columns with the texts and the names of the parts.
import { text } from '../i18n/catalogue.js';
import { byId, make } from '../dom/dom.js';

/** @typedef {import('../engine/types.js').BatchPlan} BatchPlan */
/** @typedef {import('../storage/last_work.js').BatchInput} BatchInput */
/** @typedef {{ onText: (column: string) => void, onId: (column: string) => void }} ListPreviewListener */

const kMostColumns = 20; // in the table; all can be chosen
const kNone = ''; // no column

/** Returns the column that a template names and nothing else. @param {string} template */
export const columnAlone = (template) => /^\{([^{}:]+)\}$/.exec(template)?.[1];

/** @param {string} a @param {string} b */
const isSameName = (a, b) => a.toLowerCase() === b.toLowerCase();

/**
 * Returns the column whose cells are the texts as they are.
 * @param {Pick<BatchPlan, 'columns' | 'textNames'>} plan
 * @param {Pick<BatchInput, 'text'>} input
 * @returns {string | undefined}  undefined: the texts come from a template, or no column has them
 */
export function textColumn({ columns, textNames }, { text: template }) {
  const isMore = template !== '' && columnAlone(template) === undefined;
  return isMore ? undefined : columns.find(({ name }) => textNames.some((one) => isSameName(one, name)))?.name;
}

/**
 * Returns the column with the ids.
 * @param {Pick<BatchPlan, 'columns'>} plan
 * @param {Pick<BatchInput, 'id'>} input
 * @returns {string | undefined}  undefined: the ids are numbers
 */
export const idColumn = ({ columns }, { id }) => columns.find(({ name }) => isSameName(name, id || 'id'))?.name;

export class ListPreview {
  /** @param {ListPreviewListener} listener */
  constructor({ onText, onId }) {
    this.box_ = byId('list-preview', HTMLElement);
    this.text_ = byId('batch-text-column', HTMLSelectElement);
    this.id_ = byId('batch-id-column', HTMLSelectElement);
    this.text_.addEventListener('change', () => this.text_.value !== kNone && onText(this.text_.value));
    this.id_.addEventListener('change', () => onId(this.id_.value));
  }

  /** @param {BatchPlan | undefined} plan  undefined: no list could be read @param {BatchInput} input */
  show(plan, input) {
    const columns = plan?.columns ?? [];
    this.box_.hidden = columns.length === 0;
    if (!plan || columns.length === 0) return;
    const texts = textColumn(plan, input),
      ids = idColumn(plan, input);
    const names = columns.map(({ name }) => name);
    const noText = text(input.text ? 'batch.ownTexts' : 'batch.chooseColumn');
    offer(this.text_, texts === undefined ? [[kNone, noText]] : [], names, texts);
    const hasIds = idColumn(plan, { id: '' }) !== undefined;
    offer(this.id_, hasIds ? [] : [[kNone, text('batch.idIsNumber')]], names, ids);
    const shown = columns.slice(0, kMostColumns);
    const kindOf = (/** @type {string} */ name) => (name === texts ? 'is-text' : name === ids ? 'is-id' : '');
    byId('list-head', HTMLElement).replaceChildren(
      make(
        'tr',
        {},
        ...shown.map(({ name }) => {
          const head = make('th', { className: kindOf(name), text: name });
          head.scope = 'col';
          return head;
        }),
      ),
    );
    byId('list-rows', HTMLElement).replaceChildren(
      ...shown[0].cells.map((_, row) =>
        make('tr', {}, ...shown.map(({ name, cells }) => make('td', { className: kindOf(name), text: cells[row] }))),
      ),
    );
  }
}

/**
 * Fills a select with columns.
 * @param {HTMLSelectElement} select
 * @param {[value: string, label: string][]} others  before the columns
 * @param {string[]} names
 * @param {string | undefined} chosen  undefined: the first of the others
 */
function offer(select, others, names, chosen) {
  const pairs = [...others, ...names.map((name) => /** @type {[string, string]} */ ([name, name]))];
  select.replaceChildren(...pairs.map(([value, label]) => Object.assign(make('option', { text: label }), { value })));
  select.value = chosen ?? kNone;
}
