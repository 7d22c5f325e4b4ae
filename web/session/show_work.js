// SPDX-License-Identifier: GPL-3.0-or-later
// Shows the work in the panels. A change updates only the panels of the changed parts.
import { showCarving } from '../ui/carve_panel.js';

/**
 * @typedef {object} Panels
 * @property {Pick<import('../ui/settings_form.js').SettingsForm, 'show'>} form
 * @property {Pick<import('../ui/code_panel.js').CodePanel, 'show' | 'showMakes'>} code
 * @property {Pick<import('../ui/place_panel.js').PlacePanel, 'showCentre'>} place
 * @property {Pick<import('../ui/batch_panel.js').BatchPanel, 'showInput'>} batch
 */

/** @param {import('./work_store.js').WorkStore} store @param {Panels} panels */
export function showWork(store, { form, code, place, batch }) {
  showCarving(store.work.settings);
  store.changed.on((work, before) => {
    if (work.text !== before.text) code.show(work.text);
    if (work.settings !== before.settings) {
      form.show(work.settings);
      showCarving(work.settings);
      const makes = work.settings.content;
      if (makes !== before.settings.content) code.showMakes(makes === 'text' ? 'text' : 'code');
    }
    if (work.batch !== before.batch) batch.showInput(work.batch);
    if (work.centreMm && work.centreMm !== before.centreMm) place.showCentre(work.centreMm);
  });
}
