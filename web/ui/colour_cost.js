// SPDX-License-Identifier: GPL-3.0-or-later
// Words for the price of a second colour.
import { text } from '../i18n/catalogue.js';
import { formatPlain } from '../i18n/format.js';

/** @param {number} grams */
const formatGrams = (grams) => formatPlain(grams, grams < 10 ? 1 : 0);

/** Says the filament changes of a code, and their waste where it is known. @param {import('../engine/types.js').Report['colour']} cost */
export function colourCost({ changes, firstWasteG, secondWasteG, wasteMinutes }) {
  const count = text('page.changes', { count: changes });
  if (firstWasteG === null || secondWasteG === null || wasteMinutes === null) return count;
  return text('page.changesWaste', {
    changes: count,
    grams: formatGrams(firstWasteG + secondWasteG),
    minutes: formatPlain(wasteMinutes, 0),
  });
}

/** Says the cost of a code and of a wipe tower, which not every printer needs. @param {import('../engine/types.js').Report['colour']} cost */
export function colourCostWithTower(cost) {
  const { towerG } = cost;
  if (!towerG) return colourCost(cost);
  return `${colourCost(cost)}; ${text('page.wipeTower', { grams: formatGrams(towerG) })}`;
}
