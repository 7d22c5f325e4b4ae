// SPDX-License-Identifier: GPL-3.0-or-later
// The step Engrave: one line that sums up the carving to be made, the settings that count for it, and the price of a
// second colour.
import { text } from '../i18n/catalogue.js';
import { byId } from '../dom/dom.js';
import { choiceLabel } from '../i18n/setting_names.js';
import { formatPlain } from '../i18n/format.js';
import { colourCost } from './colour_cost.js';
import { describeStep } from './steps.js';

/** @param {import('../storage/last_work.js').Values} values  of the settings' controls */
export function showCarving({ mark, preset, nozzle }) {
  const nozzleMm = nozzle === '' ? NaN : Number(nozzle);
  describeStep('carve', () =>
    text('page.carveState', {
      way: mark === 'shadow' ? choiceLabel('preset', String(preset)).split(',')[0] : choiceLabel('mark', String(mark)),
      nozzle: Number.isFinite(nozzleMm) ? formatPlain(nozzleMm) : '?',
    }),
  );
  for (const part of /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('[data-marks]')))
    part.hidden = !part.dataset.marks?.split(' ').includes(String(mark));
}

/** Shows the price of the engraved code next to the choice. @param {import('../engine/types.js').Report} [report]  absent: none yet */
export function showMarkCost(report) {
  const hasCost = report !== undefined && report.mark !== 'shadow';
  byId('mark-cost', HTMLElement).textContent = hasCost
    ? text('page.markCost', { cost: colourCost(report.colour) })
    : '';
}
