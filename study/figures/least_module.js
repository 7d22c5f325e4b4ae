// SPDX-License-Identifier: GPL-3.0-or-later
// Smallest module that decodes as printed [Papp 2022, figure 11].
import { groupBy, tally } from '../page/compare.js';
import { inOrder } from '../page/figure.js';
import { patternPlots } from '../page/plots.js';
import { cases, mm, name, said } from '../page/say.js';

/** @typedef {import('../page/table.js').Row} Row */

/** Returns the row with the smallest module that decodes. @param {Row[]} rows @returns {Row | undefined} */
export const leastOf = (rows) =>
  rows.filter((row) => row.module_mm !== null).sort((a, b) => a.module_mm - b.module_mm)[0];

const kKeys = ['process', 'modules', 'finders', 'pose'];

/** Groups the smallest modules by a column's value, all else equal. @param {Row[]} rows @param {string} column */
function sizesBy(rows, column) {
  const others = kKeys.filter((key) => key !== column);
  const groups = groupBy(
    rows.map((row) => ({ ...row, others: others.map((key) => row[key]).join(' ') })),
    'others',
  );
  return [...groups.values()].map((group) => new Map(group.map((row) => [row[column], row.module_mm ?? Infinity])));
}

/**
 * Counts how often one value of a column allows a module at least as small as another value, all else equal.
 * @param {Row[]} rows @param {string} column @param {string} one @param {string} other
 */
export const asSmall = (rows, column, one, other) =>
  tally(sizesBy(rows, column), (sizes) => {
    const [a, b] = [sizes.get(one), sizes.get(other)];
    return a === undefined || b === undefined || (a === Infinity && b === Infinity) ? undefined : a <= b;
  });

/** Counts the prints of a module pattern that decode at some size. @param {Row[]} rows @param {string} pattern */
const read = (rows, pattern) =>
  tally(
    rows.filter(({ modules }) => modules === pattern),
    (row) => row.module_mm !== null,
  );

/**
 * Counts how often one value of a column allows a module at least as small as another value, where both decode.
 * @param {Row[]} rows @param {string} column @param {string} one @param {string} other
 */
export const asSmallIfBothRead = (rows, column, one, other) =>
  asSmall(
    rows.filter((row) => row.module_mm !== null),
    column,
    one,
    other,
  );

/**
 * Counts how often whole finder patterns allow a module at least as small as finder patterns in the pattern of the
 * modules. Whole modules are no such pattern: there the two are the same.
 * @param {Row[]} rows
 */
export const wholeAsSmallAsModules = (rows) =>
  asSmall(
    rows.filter(({ modules }) => modules !== 'none'),
    'finders',
    'none',
    'as-modules',
  );

/** Counts the same beside the paper's finder patterns, diamond and thick plus. @param {Row[]} rows */
export function wholeAsSmallAsOwn(rows) {
  const [diamond, thick] = ['diamond', 'thick-plus'].map((finders) => asSmall(rows, 'finders', 'none', finders));
  return { holds: diamond.holds + thick.holds, of: diamond.of + thick.of };
}

/** @type {import('../page/figure.js').Figure} */
export const leastModule = {
  name: 'leastModule',
  table: 'least_module',
  measures: ['module_mm'],
  draw: (rows, look) => {
    /** @param {any} process @param {any} pose */
    const print = (process, pose) =>
      look.word('printAs', { process: name('process', process), pose: name('pose', pose) });
    const prints = inOrder(rows, 'process', 'process').flatMap((process) =>
      inOrder(rows, 'pose', 'pose').map((pose) => print(process, pose)),
    );
    const labelled = rows.map((row) => ({ ...row, print: print(row.process, row.pose) }));
    return patternPlots(labelled, look, {
      plots: { field: 'print', names: prints },
      columns: look.narrow ? 1 : 2,
      x: { field: 'module_mm', title: look.word('axisModule') },
    });
  },
  find: (rows) => {
    const least = [...groupBy(rows, 'process').values()].flatMap((ofProcess) => {
      const row = leastOf(ofProcess);
      return row
        ? [
            said('leastOne', {
              process: name('process', row.process),
              module: mm(row.module_mm),
              pattern: name('pattern', row.modules),
              finders: name('finder', row.finders),
              pose: name('pose', row.pose),
            }),
          ]
        : [];
    });
    const unread = rows.filter((row) => row.module_mm === null).length;
    return [
      ...least,
      said('leastThick', { thick: cases(read(rows, 'thick-plus')), thin: cases(read(rows, 'thin-plus')) }),
      said('leastFinders', { own: cases(wholeAsSmallAsOwn(rows)), same: cases(wholeAsSmallAsModules(rows)) }),
      said('leastPrint', {
        standing: cases(asSmall(rows, 'pose', 'code-upright', 'code-up')),
        finer: cases(asSmall(rows, 'process', 'fdm-0.25/0.1', 'fdm-0.4/0.2')),
      }),
      ...(unread > 0 ? [said('leastUnread', { count: unread, of: rows.length })] : []),
      said('leastPaper'),
    ];
  },
};
