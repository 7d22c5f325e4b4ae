// SPDX-License-Identifier: GPL-3.0-or-later
// Questions to tables: how often a statement holds, medians, and values between measured points.

/** @typedef {import('./table.js').Row} Row */
/** Number of cases in which a statement holds, and of all cases. @typedef {{ holds: number, of: number }} Tally */

/** Returns the median: of an even count the mean of the middle two; NaN of none. @param {number[]} values */
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
 * Returns a column's values, each once, in the order of appearance.
 * @param {Row[]} rows
 * @param {string} column
 * @returns {any[]}
 */
export const distinct = (rows, column) => [...new Set(rows.map((row) => row[column]))];

/**
 * Returns one measure by a column's value; leaves out empty cells.
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
 * @param {(item: T) => boolean | undefined} judge  undefined: not applicable, not counted
 * @returns {Tally}
 */
export function tally(items, judge) {
  const judged = [...items].map(judge).filter((answer) => answer !== undefined);
  return { holds: judged.filter(Boolean).length, of: judged.length };
}

/**
 * Counts the models of a table for which the statement holds.
 * @param {Row[]} rows
 * @param {(ofModel: Row[]) => boolean | undefined} judge
 */
export const onModels = (rows, judge) => tally(groupBy(rows, 'model').values(), judge);

/**
 * True if each value is greater than the previous one; undefined if one is missing.
 * @param {(number | undefined)[]} values
 */
export function rises(values) {
  const known = values.filter((value) => value !== undefined);
  return known.length < values.length ? undefined : known.every((value, at) => at === 0 || value > known[at - 1]);
}

/** @typedef {[depth: number, reads: number]} Point */

/**
 * Returns the most decoded tries at no more than this depth. Levels are joined by straight lines, and a shallower level
 * is always allowed. Undefined if even the shallowest level is deeper.
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
    reached.push(reads + ((next[1] - reads) * (depth - from)) / (next[0] - from));
  }
  return Math.max(...reached);
}
