// SPDX-License-Identifier: GPL-3.0-or-later
// One field of a kind of content: its label, its control and the note below.
import { localise, text } from '../i18n/catalogue.js';
import { make } from '../dom/dom.js';

/** @typedef {import('../payloads/types.js').Field} Field */
/** @typedef {import('../payloads/types.js').Problem} Problem */
/** @typedef {HTMLInputElement | HTMLSelectElement | HTMLTextAreaElement} Control */

/** @type {Record<Exclude<Field['kind'], 'choice' | 'lines'>, { type: string, mode?: string }>} */
const kInputs = {
  text: { type: 'text' },
  email: { type: 'text', mode: 'email' }, // the browser's own e-mail check would change the typed text
  tel: { type: 'tel' },
  url: { type: 'text', mode: 'url' },
  password: { type: 'password' },
  decimal: { type: 'text', mode: 'text' }, // a numeric keyboard may lack the minus
  datetime: { type: 'datetime-local' },
  check: { type: 'checkbox' },
};

/** @param {Field} field @returns {Control} */
function makeControl({ kind, options = [] }) {
  if (kind === 'choice') {
    const select = make('select');
    for (const { value, label } of options) {
      const option = new Option('', value);
      option.dataset.text = label;
      select.append(option);
    }
    return select;
  }
  if (kind === 'lines') return Object.assign(make('textarea'), { rows: 2 });
  const input = make('input');
  const { type, mode } = kInputs[kind];
  input.type = type;
  if (mode) input.inputMode = mode;
  if (kind !== 'check')
    Object.assign(input, { autocapitalize: kind === 'text' ? 'sentences' : 'off', spellcheck: kind === 'text' });
  return input;
}

export class FieldView {
  /**
   * @param {string} prefix  of its element ids
   * @param {Field} field
   * @param {{ onInput: () => void, onLeave: () => void }} listener
   */
  constructor(prefix, field, { onInput, onLeave }) {
    this.field = field;
    this.control = makeControl(field);
    const id = `${prefix}-${field.id}`;
    this.control.id = id;
    if (field.kind !== 'choice' && field.kind !== 'check')
      this.control.autocomplete = /** @type {AutoFill} */ (field.autocomplete ?? 'off');
    this.control.required = !field.optional && field.kind !== 'choice';
    this.hint_ = make('p', { className: 'field-hint' });
    this.hint_.id = `${id}-hint`;
    if (field.hint) this.hint_.dataset.text = field.hint;
    this.note_ = make('p', { className: 'field-note' });
    this.note_.id = `${id}-note`;
    this.note_.hidden = true;
    /** @type {Problem | undefined} */ this.problem_ = undefined;
    this.element = this.build_();
    this.describe_();
    this.control.addEventListener('input', onInput);
    this.control.addEventListener('change', onLeave);
    this.control.addEventListener('blur', onLeave);
    localise(this.element);
  }

  get value() {
    return this.control instanceof HTMLInputElement && this.control.type === 'checkbox'
      ? this.control.checked
        ? 'true'
        : ''
      : this.control.value;
  }

  /** @param {boolean} isShown */
  show(isShown) {
    this.element.hidden = !isShown;
  }

  /** @param {Problem | undefined} problem  undefined removes the note */
  showProblem(problem) {
    this.problem_ = problem;
    const words = problem ? text(problem.key, problem.values) : '';
    if (this.note_.textContent !== words) this.note_.textContent = words;
    this.note_.hidden = !problem;
    this.note_.classList.toggle('wrong', problem?.severity === 'error');
    if (problem?.severity === 'error') this.control.setAttribute('aria-invalid', 'true');
    else this.control.removeAttribute('aria-invalid');
    this.describe_();
  }

  /** Writes the note again in the current language. */
  relocalise() {
    this.showProblem(this.problem_);
  }

  describe_() {
    const ids = [...(this.note_.hidden ? [] : [this.note_.id]), ...(this.field.hint ? [this.hint_.id] : [])];
    if (ids.length > 0) this.control.setAttribute('aria-describedby', ids.join(' '));
    else this.control.removeAttribute('aria-describedby');
  }

  build_() {
    const label = make('label');
    const name = make('span');
    name.dataset.text = this.field.label;
    label.htmlFor = this.control.id;
    if (this.field.kind === 'check') {
      label.className = 'check';
      label.append(this.control, name);
      return make('div', { className: 'field' }, label, this.note_);
    }
    label.append(name);
    const head = make('div', { className: 'field-head' }, label);
    if (this.field.optional) {
      const optional = make('span', { className: 'optional' });
      optional.dataset.text = 'code.optional';
      optional.setAttribute('aria-hidden', 'true'); // screen readers announce “required” instead
      head.append(optional);
    }
    const control =
      this.field.kind === 'password'
        ? make('div', { className: 'with-button' }, this.control, this.makeReveal_())
        : this.control;
    return make(
      'div',
      { className: `field${this.field.half ? ' half' : ''}` },
      head,
      control,
      this.note_,
      ...(this.field.hint ? [this.hint_] : []),
    );
  }

  /** Makes the button that shows or hides a password. */
  makeReveal_() {
    const button = make('button', { className: 'quiet' });
    button.type = 'button';
    button.dataset.text = 'code.show';
    button.dataset.textLabel = 'code.showPassword';
    button.setAttribute('aria-pressed', 'false');
    button.setAttribute('aria-controls', this.control.id);
    button.addEventListener('click', () => {
      const isShown = button.getAttribute('aria-pressed') !== 'true';
      button.setAttribute('aria-pressed', String(isShown));
      /** @type {HTMLInputElement} */ (this.control).type = isShown ? 'text' : 'password';
    });
    return button;
  }
}
