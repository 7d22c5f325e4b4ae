// SPDX-License-Identifier: GPL-3.0-or-later
// The kind of content, and the fields of the chosen kind.
import { localise, onLanguage } from '../i18n/catalogue.js';
import { byId, make } from '../dom/dom.js';
import { buildContent, kContents } from '../payloads/payloads.js';
import { FieldView } from './field_view.js';

/** @typedef {import('../payloads/types.js').Content} Content */
/** @typedef {import('../payloads/types.js').Values} Values */

const kForm = 'form'; // the field that selects the form, in kinds that can be written in several ways
const kPlain = 'text'; // no fields: the textbox holds the content
const kLetters = 'letters'; // the same, but the text itself is made, without a code

export class ContentPanel {
  /**
   * @param {object} listener
   * @param {(payload: string) => void} listener.onPayload  the fields have changed; '' while they are incomplete
   * @param {() => void} listener.onPlain                    the user wants to type the text directly
   * @param {(makes: 'code' | 'text') => void} listener.onMakes  the user wants a code, or the text alone
   */
  constructor({ onPayload, onPlain, onMakes }) {
    this.onPayload_ = onPayload;
    this.onPlain_ = onPlain;
    this.onMakes_ = onMakes;
    this.kind_ = makeKindChoice();
    this.fields_ = make('div', { className: 'content-fields' });
    this.fields_.hidden = true;
    this.fields_.setAttribute('role', 'group');
    const label = make('label');
    label.htmlFor = this.kind_.id;
    label.dataset.text = 'code.kind';
    const mount = byId('content-builder', HTMLElement);
    mount.append(make('div', { className: 'field' }, label, this.kind_), this.fields_);
    localise(mount);
    /** @type {Content | undefined} */ this.content_ = undefined;
    /** @type {FieldView[]} */ this.views_ = [];
    /** @type {Set<string>} */ this.visited_ = new Set(); // a field that the user has not visited yet shows no error
    /** @type {Map<string, Values>} */ this.kept_ = new Map(); // values of the other kinds, until the page closes
    this.kind_.addEventListener('change', () => this.choose_());
    onLanguage(() => this.views_.forEach((view) => view.relocalise()));
  }

  /** True while a required field is missing or wrong, so that there is no code yet. */
  get incomplete() {
    return this.content_ !== undefined && buildContent(this.content_, this.values_()).payload === '';
  }

  /** Shows whether a code or the text alone is made. @param {'code' | 'text'} makes */
  showMakes(makes) {
    if ((this.kind_.value === kLetters) === (makes === 'text')) return;
    this.kind_.value = makes === 'text' ? kLetters : kPlain;
    this.open_(undefined);
  }

  /** Closes the builder; the user edits the text directly from now on. */
  leave() {
    if (!this.content_) return;
    this.kind_.value = kPlain;
    this.open_(undefined);
  }

  /** Shows all missing fields and moves the focus to the first. */
  reveal() {
    this.views_.forEach(({ field }) => this.visited_.add(field.id));
    this.update_();
    this.views_.find(({ control }) => control.getAttribute('aria-invalid') === 'true')?.control.focus();
  }

  /** Returns the content in another form; '' if this kind has no such form. @param {string} form */
  payloadAs(form) {
    const known = this.content_?.fields.find(({ id }) => id === kForm)?.options?.some(({ value }) => value === form);
    return this.content_ && known ? buildContent(this.content_, { ...this.values_(), [kForm]: form }).payload : '';
  }

  /** @param {string} form */
  writeAs(form) {
    const view = this.views_.find(({ field }) => field.id === kForm);
    if (!view) return;
    view.control.value = form;
    this.update_();
  }

  choose_() {
    this.onMakes_(this.kind_.value === kLetters ? 'text' : 'code');
    this.open_(kContents.find(({ id }) => id === this.kind_.value));
    if (this.content_) this.update_();
    else this.onPlain_();
  }

  /** @param {Content | undefined} content */
  open_(content) {
    if (this.content_) this.kept_.set(this.content_.id, this.values_());
    this.content_ = content;
    this.visited_.clear();
    const values = content ? this.kept_.get(content.id) : undefined;
    this.views_ = (content?.fields ?? []).map((field) => this.makeView_(`content-${content?.id}`, field));
    for (const { field, control } of values ? this.views_ : []) {
      if (control instanceof HTMLInputElement && control.type === 'checkbox')
        control.checked = values?.[field.id] === 'true';
      else control.value = values?.[field.id] ?? '';
    }
    this.fields_.replaceChildren(...this.views_.map(({ element }) => element));
    this.fields_.hidden = content === undefined;
    if (content) this.fields_.dataset.textLabel = content.label;
    localise(byId('content-builder', HTMLElement));
  }

  /** @param {string} prefix @param {import('../payloads/types.js').Field} field */
  makeView_(prefix, field) {
    const view = new FieldView(prefix, field, { onInput: () => this.update_(), onLeave: () => this.visit_(view) });
    return view;
  }

  /** @param {FieldView} view */
  visit_(view) {
    if (this.visited_.has(view.field.id) || !this.views_.includes(view)) return; // removing a field also blurs it
    this.visited_.add(view.field.id);
    this.showProblems_();
  }

  update_() {
    const { payload } = this.showProblems_();
    this.onPayload_(payload);
  }

  showProblems_() {
    const content = /** @type {Content} */ (this.content_);
    const values = this.values_();
    const built = buildContent(content, values);
    for (const view of this.views_) {
      view.show(view.field.shownWhen?.(values) ?? true);
      const problems = built.problems.filter(({ field }) => field === view.field.id);
      const worst = problems.find(({ severity }) => severity === 'error') ?? problems[0];
      view.showProblem(this.visited_.has(view.field.id) ? worst : undefined);
    }
    return built;
  }

  /** @returns {Values} */
  values_() {
    return Object.fromEntries(this.views_.map(({ field, value }) => [field.id, value]));
  }
}

function makeKindChoice() {
  const select = make('select');
  select.id = 'content-kind';
  for (const { id, label } of [
    { id: kPlain, label: /** @type {const} */ ('code.kind.text') },
    ...kContents,
    { id: kLetters, label: /** @type {const} */ ('code.kind.letters') },
  ]) {
    const option = new Option('', id);
    option.dataset.text = label;
    select.append(option);
  }
  return select;
}
