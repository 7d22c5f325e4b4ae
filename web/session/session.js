// SPDX-License-Identifier: GPL-3.0-or-later
// Begins with each new model, starts the engraving, and enables the controls that need a model and no running job.

/**
 * @typedef {object} SessionOptions
 * @property {import('./work_store.js').WorkStore} store
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./jobs.js').Jobs} jobs
 * @property {import('./batching.js').Batching} batching
 * @property {import('./spot_search.js').SpotSearch} spots
 * @property {import('./placing.js').Placing} placing
 * @property {import('./carving.js').Carving} carving
 * @property {import('./undo.js').Undo} undo
 * @property {Pick<import('../ui/code_panel.js').CodePanel, 'incomplete' | 'reveal'>} code
 * @property {Pick<import('../ui/batch_panel.js').BatchPanel, 'reveal'>} batchPanel
 * @property {import('../ui/work_panel.js').WorkPanel} workPanel
 * @property {import('../view/view_tools.js').ViewTools} tools
 * @property {Pick<import('../view/live_view.js').LiveView, 'reset'>} live
 * @property {Pick<import('../ui/face_picker.js').FacePicker, 'setDisabled'>} picker
 * @property {(action: () => Promise<unknown>) => Promise<void>} guard
 */

export class Session {
  /** @param {SessionOptions} options */
  constructor(options) {
    this.options_ = options;
    const { workPanel, jobs, batching, guard } = options;
    workPanel.listen({ onEngrave: () => guard(() => this.engrave()), onCancel: () => jobs.cancel() });
    batching.changed.on((planned) => workPanel.nameEngrave(planned ? 'batch.engraveFirst' : 'page.engrave'));
  }

  /** Begins with a newly loaded model. @returns {Promise<void>} */
  useModel() {
    const { undo, carving, store, live } = this.options_;
    live.reset();
    return undo.asOne(async () => {
      await carving.drop();
      store.applied.emit(undefined);
      await this.begin();
    });
  }

  /** Enables work on the model, and places the code on it. */
  async begin() {
    const { spots, placing } = this.options_;
    this.updateControls();
    spots.clear();
    await placing.begin();
    spots.begin();
  }

  /** Enables the controls that need a model and no running job. */
  updateControls() {
    const { jobs, model, undo, workPanel, spots, tools, picker } = this.options_;
    const { busy } = jobs;
    const { engravable, info } = model;
    const why = busy ? 'page.whyBusy' : engravable ? undefined : info ? 'page.notEngravable' : 'page.whyNoModel';
    undo.updateButtons();
    workPanel.setEngraveDisabled(why);
    spots.setDisabled(why);
    picker.setDisabled(why);
    tools.set({ engravable, busy });
  }

  async engrave() {
    const { batching, batchPanel, code, carving, spots } = this.options_;
    await batching.ready();
    await spots.proposed;
    if (batching.incomplete) batchPanel.reveal();
    else if (code.incomplete) code.reveal();
    else await carving.engrave();
  }
}
