// SPDX-License-Identifier: GPL-3.0-or-later
// Which model: a sample, a file, a file dropped anywhere; and what was found in it.
import { byId, make } from './dom.js';
import { formatNumber } from './format.js';
import { showFindings } from './messages.js';

/** @typedef {import('../engine/types.js').ModelInfo} ModelInfo */
/** @typedef {import('../engine/types.js').UpAxis} UpAxis */
/** @typedef {{ id: string, name: string, file: string, centreMm: [number, number, number], credit: string }} Sample */

/**
 * @typedef {object} ModelListener
 * @property {(id: string) => void} onSample
 * @property {(file: File) => void} onFile
 * @property {(scaleToMm: number) => void} onScale
 * @property {(axis: UpAxis) => void} onUpAxis
 */

export class ModelPanel {
  /** @param {ModelListener} listener */
  constructor(listener) {
    this.sample_ = byId('sample', HTMLSelectElement);
    this.file_ = byId('file', HTMLInputElement);
    this.unit_ = byId('unit', HTMLSelectElement);
    this.upAxis_ = byId('up-axis', HTMLSelectElement);
    this.drop_ = byId('drop', HTMLElement);
    this.sample_.addEventListener('change', () => this.sample_.value && listener.onSample(this.sample_.value));
    this.file_.addEventListener('change', () => {
      const file = this.file_.files?.[0];
      if (file) listener.onFile(file);
    });
    this.unit_.addEventListener('change', () => listener.onScale(this.scaleToMm));
    this.upAxis_.addEventListener('change', () => listener.onUpAxis(this.upAxis));
    this.listenForDrops_(listener);
  }

  get upAxis() {
    return /** @type {UpAxis} */ (this.upAxis_.value);
  }

  get scaleToMm() {
    return Number(this.unit_.value);
  }

  /** @param {Sample[]} samples */
  setSamples(samples) {
    this.sample_.replaceChildren(...samples.map(({ id, name }) => new Option(name, id)));
  }

  /**
   * Shows what is loaded, whichever way it came.
   * @param {ModelInfo} model
   * @param {{ sampleId?: string, fileName: string, credit: string, scaleToMm: number, upAxis: UpAxis }} source
   */
  show(model, { sampleId, fileName, credit, scaleToMm, upAxis }) {
    this.unit_.value = String(scaleToMm);
    this.upAxis_.value = upAxis;
    this.sample_.querySelector('option[value=""]')?.remove();
    if (sampleId === undefined) {
      const own = new Option('None: your own file', '');
      own.disabled = true;
      this.sample_.prepend(own);
      this.sample_.value = '';
    } else {
      this.sample_.value = sampleId;
      this.file_.value = '';
    }
    const size = model.sizeMm.map((mm) => formatNumber(mm, mm < 10 ? 2 : 1)).join(' × ');
    byId('model-facts', HTMLElement).replaceChildren(
      make('span', { text: `${sampleId === undefined ? `${fileName}: ` : ''}${size} mm` }),
      ` · ${formatNumber(model.triangles)} triangles${model.shells > 1 ? ` · ${formatNumber(model.shells)} shells` : ''}`);
    showFindings(byId('findings', HTMLElement), model.findings);
    byId('credit', HTMLElement).textContent = credit;
  }

  /** @param {ModelListener} listener */
  listenForDrops_(listener) {
    let depth = 0;  // dragenter and dragleave come for every element that is crossed
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
      const file = event.dataTransfer?.files[0];
      if (file) listener.onFile(file);
    });
  }
}
