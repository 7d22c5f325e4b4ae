// SPDX-License-Identifier: GPL-3.0-or-later
// The settings that count for the chosen content and mark, and the step Engrave: one line that sums up the carving to be made, and the price
// of a second colour.
import { text } from '../i18n/catalogue.js';
import { write } from '../i18n/live.js';
import { byId } from '../dom/dom.js';
import { choiceLabel } from '../i18n/setting_names.js';
import { formatPlain } from '../i18n/format.js';
import { colourCost } from './colour_cost.js';
import { describeStep } from './steps.js';

/** @param {import('../settings/work_settings.js').WorkSettings} settings */
export function showCarving({ content, mark, preset, nozzleMm = NaN }) {
  describeStep('carve', () =>
    text('page.carveState', {
      way:
        content === 'text' || mark !== 'shadow'
          ? choiceLabel('mark', String(mark))
          : choiceLabel('preset', String(preset)).split(',')[0],
      nozzle: Number.isFinite(nozzleMm) ? formatPlain(nozzleMm) : '?',
    }),
  );
  /** @type {NodeListOf<HTMLElement>} */ const parts = document.querySelectorAll(
    '[data-marks], [data-marks-of-text], [data-content]',
  );
  for (const part of parts) {
    const { marks = String(mark), marksOfText = marks, content: wanted = content } = part.dataset;
    const counted = content === 'text' ? marksOfText : marks;
    part.hidden = wanted !== content || !counted.split(' ').includes(String(mark));
  }
}

/** What is known about the price of a second colour. */
const known = { layers: 0, report: /** @type {import('../engine/types.js').Report | undefined} */ (undefined) };

function writeMarkCost() {
  const { layers, report } = known;
  write(byId('mark-cost', HTMLElement), () => {
    if (report && report.mark !== 'shadow') return text('page.markCost', { cost: colourCost(report.colour) });
    return layers > 0 ? text('page.markCostHere', { count: layers }) : '';
  });
}

/** Shows about how many filament changes a spot costs. @param {number} layers  that the code lies in; 0: not known */
export function showSpotCost(layers) {
  known.layers = layers;
  writeMarkCost();
}

/** Shows the price of the engraved code next to the choice. @param {import('../engine/types.js').Report} [report]  absent: none yet */
export function showMarkCost(report) {
  known.report = report;
  writeMarkCost();
}
