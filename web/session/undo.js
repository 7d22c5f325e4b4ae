// SPDX-License-Identifier: GPL-3.0-or-later
// Undo and redo of all inputs of the carving, and of the carving itself.
import { text } from '../i18n/catalogue.js';
import { setDisabled } from '../dom/set_disabled.js';
import { byId } from '../dom/dom.js';
import { History } from './history.js';
import { sameButPlace, sameCentre, sameModel, sameWork } from './work.js';

/** @typedef {import('./work.js').Work} Work */
/** @typedef {import('./carving.js').Carved} Carved */
/** @typedef {Work & { carved: Carved | undefined }} State */

/**
 * @typedef {object} UndoOptions
 * @property {import('./work_store.js').WorkStore} store
 * @property {Pick<import('./work_editor.js').WorkEditor, 'restore'>} editor
 * @property {Pick<import('./autosave.js').Autosave, 'save'>} autosave
 * @property {import('./jobs.js').Jobs} jobs
 * @property {import('./model_session.js').ModelSession} model
 * @property {import('./placing.js').Placing} placing
 * @property {import('./spot_search.js').SpotSearch} spots
 * @property {import('./carving.js').Carving} carving
 * @property {import('../ui/messages.js').Messages} messages
 * @property {(action: () => Promise<unknown>) => Promise<void>} guard
 */

export class Undo {
  /** @param {UndoOptions} options */
  constructor(options) {
    this.options_ = options;
    /** @type {History<State>} */
    this.history_ = new History({
      same: (a, b) => sameWork(a, b) && a.carved === b.carved,
      bytesOf: ({ source }) => source?.bytes,
    });
    this.pauses_ = 0;
    this.restoring_ = false;
    this.steps_ = 0; // to go in the history once the state under way is restored; < 0: back
    this.editedMeanwhile_ = false; // while a state was being restored
    this.undo_ = byId('undo', HTMLButtonElement);
    this.redo_ = byId('redo', HTMLButtonElement);
    this.undo_.addEventListener('click', () => void this.undo());
    this.redo_.addEventListener('click', () => void this.redo());
    this.updateButtons();
    options.store.applied.on((field) => this.record(field));
    options.carving.finished.on(() => this.record());
    options.placing.proposed.on(() => this.amend_());
    byId('panel', HTMLFormElement).addEventListener('input', ({ target }) => {
      this.editedMeanwhile_ ||= this.restoring_;
      this.steps_ = 0; // the edit is newer
      // Recorded at once; the edit takes effect only after a pause.
      this.record(target instanceof HTMLElement ? (target.dataset.setting ?? target.id) : undefined);
    });
  }

  /** Records a change. @param {string} [field]  edited field; quick edits of the same field are one change */
  record(field) {
    if (this.pauses_ === 0) this.record_(field);
  }

  /** Records the current state before it is replaced, even amid an incomplete change. */
  recordNow() {
    if (!this.restoring_) this.record_();
  }

  /**
   * Runs an action and records all its changes as one.
   * @template T
   * @param {() => Promise<T>} action
   */
  async asOne(action) {
    this.pauses_ += 1;
    try {
      return await action();
    } finally {
      this.pauses_ -= 1;
      this.record();
    }
  }

  /** Enables the buttons when idle, and while a state is restored: the steps are counted. */
  updateButtons() {
    const isBusy = !this.restoring_ && (this.options_.jobs.busy || this.pauses_ > 0);
    const reaches = (/** @type {number} */ step) => this.history_.reaches(this.steps_ + step);
    setDisabled(this.undo_, !reaches(-1) ? 'page.whyNoUndo' : isBusy ? 'page.whyBusy' : undefined);
    setDisabled(this.redo_, !reaches(1) ? 'page.whyNoRedo' : isBusy ? 'page.whyBusy' : undefined);
  }

  /** Undoes the last change; a centre picked a moment ago, once it is known. */
  undo() {
    return this.step_(-1, this.undo_);
  }

  redo() {
    return this.step_(1, this.redo_);
  }

  /** @param {number} step @param {HTMLButtonElement} button */
  async step_(step, button) {
    const { moving } = this.options_.placing;
    if (moving) await moving;
    if (button.disabled) return;
    this.steps_ += step;
    if (this.restoring_) this.updateButtons();
    else await this.restore_();
  }

  /** @param {string} [field] */
  record_(field) {
    const { store, carving } = this.options_;
    this.history_.record({ ...store.work, carved: carving.latest }, field);
    this.updateButtons();
  }

  /** Adds a proposal to the current state: nothing that the user did, so nothing to undo. */
  amend_() {
    const { store, carving } = this.options_;
    this.history_.amend({ ...store.work, carved: carving.latest });
  }

  /** Goes the counted steps in the history, and those that are counted meanwhile. */
  async restore_() {
    const { guard, jobs, autosave } = this.options_;
    this.restoring_ = true;
    this.pauses_ += 1;
    try {
      while (this.steps_ !== 0 && !jobs.busy) {
        const state = this.history_.go(this.steps_);
        this.steps_ = 0;
        this.updateButtons();
        if (state) await guard(() => this.apply_(state));
      }
    } finally {
      this.restoring_ = false;
      this.steps_ = 0;
      this.pauses_ -= 1;
      if (this.editedMeanwhile_) this.record();
      this.editedMeanwhile_ = false;
      this.updateButtons();
      autosave.save();
    }
  }

  /** @param {State} state */
  async apply_(state) {
    const { editor, model, placing, spots, carving, messages, store } = this.options_;
    const before = store.work;
    messages.clearError();
    editor.restore(state);
    if (!sameModel(before.source, state.source) && state.source) {
      await model.load(state.source, state.centreIsGuess ? undefined : state.centreMm);
    } else {
      if (state.source && before.source?.upAxis !== state.source.upAxis) await model.turnUp(state.source.upAxis);
      if (!sameButPlace(before, state)) await spots.forget();
      if (!sameCentre(before.centreMm, state.centreMm)) {
        spots.unmark();
        await placing.restoreCentre(state.centreMm, state.centreIsGuess);
      }
      await placing.place();
    }
    if (!(await carving.restore(state.carved)) && state.carved) messages.say(() => text('page.carvingGone'));
  }
}
