// SPDX-License-Identifier: GPL-3.0-or-later
// The measured tables (study/table.h): CSV without quotes; a column has the reason if a case failed.
import { existsSync, readFileSync, readdirSync } from 'node:fs';

/** Values by column: a number, a word, or null if empty. @typedef {Record<string, any>} Row */
/** @typedef {{ csv: string, rows: Row[] }} Table */

/** @param {string} cell */
const valueOf = (cell) => (cell === '' ? null : Number.isNaN(Number(cell)) ? cell : Number(cell));

/** Parses a table; leaves out truncated lines. @param {string} csv @returns {Row[]} */
export function parseTable(csv) {
  const [head = '', ...lines] = csv
    .slice(0, csv.lastIndexOf('\n') + 1)
    .split('\n')
    .slice(0, -1);
  const columns = head.split(',');
  return lines
    .map((line) => line.split(','))
    .filter((cells) => cells.length === columns.length)
    .map((cells) => Object.fromEntries(columns.map((column, at) => [column, valueOf(cells[at])])));
}

/**
 * Reads the tables of a folder, by name; none if the folder does not exist.
 * @param {string} folder
 * @returns {Record<string, Table>}
 */
export function readTables(folder) {
  const files = existsSync(folder)
    ? readdirSync(folder)
        .filter((file) => file.endsWith('.csv'))
        .sort()
    : [];
  return Object.fromEntries(
    files.map((file) => {
      const csv = readFileSync(`${folder}/${file}`, 'utf8');
      return [file.slice(0, -'.csv'.length), { csv, rows: parseTable(csv) }];
    }),
  );
}

/** Returns the rows whose case could be measured. @param {Row[]} rows */
export const measured = (rows) => rows.filter(({ failed = null }) => failed === null);
