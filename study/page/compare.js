// SPDX-License-Identifier: GPL-3.0-or-later
// Questions to tables: how often a statement holds, medians, and values between measured points.

/** @typedef {import('./table.js').Row} Row */
/** How often a statement holds, and the number of cases. @typedef {{ holds: number, of: number }} Tally */

/**
 * Returns the median: the mean of the middle two values of an even count; NaN of no values.
 * @param {number[]} values
 */
export function median(values) {
  const sorted = [...values].sort((a, b) => a - b);
  const half = sorted.length / 2;
  return (sorted[Math.ceil(half) - 1] + sorted[Math.floor(half)]) / 2;
}

/**
 * Groups rows by the value of a column, in the order of appearance.
 * @param {Row[]} rows
 * @param {string} column
 * @returns {Map<any, Row[]>}
 */
export function groupBy(rows, column) {
  /** @type {Map<any, Row[]>} */ const groups = new Map();
  for (const row of rows) groups.set(row[column], [...(groups.get(row[column]) ?? []), row]);
  return groups;
}

/**
 * Returns the distinct values of a column, in the order of appearance.
 * @param {Row[]} rows
 * @param {string} column
 * @returns {any[]}
 */
export const distinct = (rows, column) => [...new Set(rows.map((row) => row[column]))];

/**
 * Returns a measure by the value of a column, without empty values.
 * @param {Row[]} rows
 * @param {string} column
 * @param {string} measure
 * @returns {Record<string, number | undefined>}
 */
export const valuesBy = (rows, column, measure) =>
  Object.fromEntries(rows.filter((row) => row[measure] !== null).map((row) => [row[column], row[measure]]));

/**
 * @template T
 * @param {Iterable<T>} items
 * @param {(item: T) => boolean | undefined} judge  undefined: the item cannot be judged and does not count
 * @returns {Tally}
 */
export function tally(items, judge) {
  const judged = [...items].map(judge).filter((answer) => answer !== undefined);
  return { holds: judged.filter(Boolean).length, of: judged.length };
}

/**
 * Counts the models of a table for which a statement holds.
 * @param {Row[]} rows
 * @param {(ofModel: Row[]) => boolean | undefined} judge
 */
export const onModels = (rows, judge) => tally(groupBy(rows, 'model').values(), judge);

/**
 * Tells whether each value is greater than the one before; undefined if a value is missing.
 * @param {(number | undefined)[]} values
 */
export function rises(values) {
  const known = values.filter((value) => value !== undefined);
  return known.length < values.length ? undefined : known.every((value, at) => at === 0 || value > known[at - 1]);
}

/** @typedef {[depth: number, reads: number]} Point */

/**
 * Returns the most reads reached at no more than this depth. Straight lines join the levels, and a greater depth allows
 * every shallower level. The result is undefined if even the shallowest level is deeper.
 * @param {Point[]} levels
 * @param {number} depth
 */
export function frontierAt(levels, depth) {
  const sorted = [...levels].sort(([a], [b]) => a - b);
  if (sorted.length === 0 || depth < sorted[0][0]) return undefined;
  const reached = sorted.filter(([at]) => at <= depth).map(([, reads]) => reads);
  const next = sorted[reached.length];
  if (next) {
    const [from, reads] = sorted[reached.length - 1];
    reached.push(reads + (next[1] - reads) * (depth - from) / (next[0] - from));
  }
  return Math.max(...reached);
}
