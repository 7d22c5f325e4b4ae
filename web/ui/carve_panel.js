// SPDX-License-Identifier: GPL-3.0-or-later
// One line that sums up the carving to be made.
import { text } from '../i18n/catalogue.js';
import { choiceLabel } from '../i18n/setting_names.js';
import { formatPlain } from '../i18n/format.js';
import { describeStep } from './steps.js';

/** @param {import('../storage/last_work.js').Values} values  of the settings' controls */
export function showCarving({ preset, nozzle }) {
  const nozzleMm = nozzle === '' ? NaN : Number(nozzle);
  describeStep('carve', () =>
    text('page.carveState', {
      preset: choiceLabel('preset', String(preset)).split(',')[0],
      nozzle: Number.isFinite(nozzleMm) ? formatPlain(nozzleMm) : '?',
    }),
  );
}
