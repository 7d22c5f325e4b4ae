// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of model (a sample, a chosen file, or a file dropped anywhere) and the findings about it.
import { onLanguage, text, textOr } from '../i18n/catalogue.js';
import { modelName } from '../i18n/model_name.js';
import { hintOf, sentenceOf, writtenValue } from '../i18n/messages.js';
import { choiceLabel } from '../i18n/setting_names.js';
import { byId } from '../dom/dom.js';
import { formatBox, formatPlain } from '../i18n/format.js';
import { showFindings } from './messages.js';
import { showStep } from './steps.js';

/** @typedef {import('../engine/types.js').ModelInfo} ModelInfo */
/** @typedef {import('../engine/types.js').UpAxis} UpAxis */
/** @typedef {{ id: string, name: string, file: string, centreMm: [number, number, number], credit: string }} Sample */
/** @typedef {{ sampleId?: string, fileName: string, credit: string, scaleToMm: number, upAxis: UpAxis }} ShownSource */

/** @type {Record<string, number>} */
const kUnitsMm = { m: 1000, in: 25.4, cm: 10, mm: 1, um: 0.001 };

/** The finding about a model that lies on its side. */
const kOnItsSide = 'stands-on-y';

/** A file of hundreds of letters would fill the panel. */
const kMostBodiesListed = 30;

/**
 * @typedef {object} ModelListener
 * @property {(id: string) => void} onSample
 * @property {(file: File, left: number) => void} onFile  `left`: number of other files that were dropped with it
 * @property {(scaleToMm: number) => void} onScale
 * @property {(axis: UpAxis) => void} onUpAxis
 * @property {(index: number) => void} onBody  shows a body of the model, from 0
 */

export class ModelPanel {
  constructor() {
    /** @type {ModelListener | undefined} */ this.listener_ = undefined;
    this.sample_ = byId('sample', HTMLSelectElement);
    this.file_ = byId('file', HTMLInputElement);
    this.unit_ = byId('unit', HTMLSelectElement);
    this.upAxis_ = byId('up-axis', HTMLSelectElement);
    this.height_ = byId('height', HTMLInputElement);
    this.drop_ = byId('drop', HTMLElement);
    this.sample_.addEventListener('change', () => this.sample_.value && this.listener_?.onSample(this.sample_.value));
    this.file_.addEventListener('change', () => {
      const file = this.file_.files?.[0];
      if (file) this.listener_?.onFile(file, 0);
    });
    this.unit_.addEventListener('change', () => this.listener_?.onScale(this.scaleToMm));
    this.upAxis_.addEventListener('change', () => {
      this.showHeight_();
      this.showTexts_();
      this.listener_?.onUpAxis(this.upAxis);
    });
    this.height_.addEventListener('change', () => this.takeHeight_());
    this.listenForDrops_();
    /** @type {Sample[]} */ this.samples_ = [];
    /** @type {{ model: ModelInfo, source: ShownSource } | undefined} */ this.shown_ = undefined;
    showStep('model', 'open', () => text('page.noModel'));
    onLanguage(() => this.showTexts_());
  }

  /** @param {ModelListener} listener */
  listen(listener) {
    this.listener_ = listener;
  }

  get upAxis() {
    return /** @type {UpAxis} */ (this.upAxis_.value);
  }

  get scaleToMm() {
    return Number(this.unit_.value);
  }

  /** @param {Sample[]} samples */
  setSamples(samples) {
    this.samples_ = samples;
    this.sample_.replaceChildren(...samples.map(({ id, name }) => new Option(textOr('samples', id, name), id)));
  }

  /**
   * Shows the loaded model, whatever its source.
   * @param {ModelInfo} model
   * @param {ShownSource} source
   */
  show(model, source) {
    this.shown_ = { model, source };
    this.showScale_(source.scaleToMm);
    this.upAxis_.value = source.upAxis;
    this.showHeight_();
    if (source.sampleId !== undefined) this.file_.value = '';
    byId('credit', HTMLElement).textContent = source.credit;
    showStep('model', model.engravable ? 'done' : 'bad', () =>
      text('page.modelState', { name: modelName(source), size: formatBox(model.sizeMm) }),
    );
    this.showTexts_();
  }

  /** Selects the unit with this scale, or adds the factor as an entry of its own. @param {number} scaleToMm */
  showScale_(scaleToMm) {
    const value = String(scaleToMm);
    this.unit_.querySelector('.own')?.remove();
    if (![...this.unit_.options].some((option) => option.value === value)) {
      const own = new Option(text('settings.ownScale', { factor: formatPlain(scaleToMm, 3) }), value);
      own.className = 'own';
      this.unit_.append(own);
    }
    this.unit_.value = value;
  }

  /** @returns {number}  of the model, mm; 0 without a model */
  get heightMm_() {
    return this.shown_?.model.sizeMm[this.upAxis === 'y' ? 1 : 2] ?? 0;
  }

  showHeight_() {
    this.height_.value = this.heightMm_ > 0 ? String(Number(this.heightMm_.toPrecision(4))) : '';
  }

  /** Scales the model to the typed height, or restores the field if the input is no valid height. */
  takeHeight_() {
    const heightMm = this.height_.valueAsNumber;
    if (this.shown_ && this.height_.validity.valid && this.heightMm_ > 0)
      this.listener_?.onScale((this.shown_.source.scaleToMm * heightMm) / this.heightMm_);
    else this.showHeight_();
  }

  /** Writes the texts in the current language. */
  showTexts_() {
    if (this.samples_.length > 0) this.setSamples(this.samples_);
    if (!this.shown_) return;
    const { model, source } = this.shown_;
    if (source.sampleId === undefined) {
      const own = new Option(text('page.ownFile'), '');
      own.disabled = true;
      this.sample_.prepend(own);
    }
    this.sample_.value = source.sampleId ?? '';
    const facts = [
      text('page.triangles', { count: model.triangles }),
      ...(model.shells > 1 ? [text('page.shells', { count: model.shells })] : []),
      ...(model.bodies.length > 1 ? [text('page.bodies', { count: model.bodies.length })] : []),
    ];
    byId('model-facts', HTMLElement).textContent = facts.join(' · ');
    this.showBodies_(model.bodies);
    showFindings(
      byId('findings', HTMLElement),
      model.findings
        .filter(({ code }) => code !== kOnItsSide || this.upAxis !== 'y')
        .map((finding) => ({
          severity: finding.severity,
          found: sentenceOf(finding),
          help: hintOf(finding),
          remedies: this.remediesFor_(finding),
        })),
    );
  }

  /** @param {import('../engine/types.js').Finding} finding @returns {import('./messages.js').Remedy[]} */
  remediesFor_(finding) {
    if (finding.code === kOnItsSide) return [{ label: text('page.turnYUp'), run: () => this.turnUp_('y') }];
    return suggestedUnits(finding)
      .filter(({ unit }) => unit in kUnitsMm)
      .map(({ unit, sizeMm }) => ({
        label: text('page.readInUnit', { unit: choiceLabel('units', unit), size: writtenValue({ extentMm: sizeMm }) }),
        run: () => this.listener_?.onScale(kUnitsMm[unit]),
      }));
  }

  /** @param {UpAxis} axis */
  turnUp_(axis) {
    this.upAxis_.value = axis;
    this.upAxis_.dispatchEvent(new Event('change', { bubbles: true }));
  }

  /**
   * Lists the bodies if there are several; a click shows one.
   * @param {ModelInfo['bodies']} bodies
   */
  showBodies_(bodies) {
    const list = byId('bodies', HTMLElement);
    list.hidden = bodies.length < 2;
    const buttons = bodies.slice(0, kMostBodiesListed).map(({ name, triangles }, index) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = name || text('page.body', { index: index + 1 });
      button.title = text('page.triangles', { count: triangles });
      button.addEventListener('click', () => this.listener_?.onBody(index));
      return button;
    });
    const left = bodies.length - buttons.length;
    list.replaceChildren(...buttons, ...(left > 0 ? [text('page.moreBodies', { count: left })] : []));
  }

  listenForDrops_() {
    let depth = 0; // dragenter and dragleave fire for every element that the pointer crosses
    const hasFiles = (/** @type {DragEvent} */ event) => event.dataTransfer?.types.includes('Files') ?? false;
    document.addEventListener('dragenter', (event) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      depth += 1;
      this.drop_.hidden = false;
    });
    document.addEventListener('dragover', (event) => {
      if (hasFiles(event)) event.preventDefault();
    });
    document.addEventListener('dragleave', () => {
      depth = Math.max(0, depth - 1);
      this.drop_.hidden = depth === 0;
    });
    document.addEventListener('drop', (event) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      depth = 0;
      this.drop_.hidden = true;
      const files = [...(event.dataTransfer?.files ?? [])];
      if (files.length > 0) this.listener_?.onFile(fileToOpen(files, this.file_.accept), files.length - 1);
    });
  }
}

/**
 * Returns the file to open: beside a model's materials or pictures, the model.
 * @param {File[]} files    at least one
 * @param {string} accepts  endings of names, most wanted first: ".stl,.obj"
 */
export function fileToOpen(files, accepts) {
  const ofEnding = (/** @type {string} */ ending) => files.find(({ name }) => name.toLowerCase().endsWith(ending));
  return accepts.split(',').map(ofEnding).find(Boolean) ?? files[0];
}

/**
 * Returns the units in which a model that is too small or too large would have a usual size.
 * @param {import('../engine/types.js').Finding} finding
 * @returns {{ unit: string, sizeMm: number[] }[]}
 */
function suggestedUnits({ values: { advice } }) {
  if (!advice || !('cause' in advice)) return [];
  const { unit, size, otherUnit, otherSize } = advice.cause.values;
  return [
    [unit, size],
    [otherUnit, otherSize],
  ].flatMap(([choice, extent]) =>
    choice && 'choice' in choice && extent && 'extentMm' in extent
      ? [{ unit: choice.choice.value, sizeMm: extent.extentMm }]
      : [],
  );
}
