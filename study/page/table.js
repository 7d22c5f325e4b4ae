// SPDX-License-Identifier: GPL-3.0-or-later
// The tables that were measured (study/table.h): CSV without quotes, the last column says why a case failed.
import { existsSync, readFileSync, readdirSync } from 'node:fs';

/** Values by column: a number, a word, or null where there is none. @typedef {Record<string, any>} Row */
/** @typedef {{ csv: string, rows: Row[] }} Table */

/** @param {string} cell */
const valueOf = (cell) => (cell === '' ? null : Number.isNaN(Number(cell)) ? cell : Number(cell));

/** Lines that are cut off are left out. @param {string} csv @returns {Row[]} */
export function parseTable(csv) {
  const [head = '', ...lines] = csv.slice(0, csv.lastIndexOf('\n') + 1).split('\n').slice(0, -1);
  const columns = head.split(',');
  return lines.map((line) => line.split(',')).filter((cells) => cells.length === columns.length)
    .map((cells) => Object.fromEntries(columns.map((column, at) => [column, valueOf(cells[at])])));
}

/** Those of a folder, by name; none where it is not there. @param {string} folder @returns {Record<string, Table>} */
export function readTables(folder) {
  const files = existsSync(folder) ? readdirSync(folder).filter((file) => file.endsWith('.csv')).sort() : [];
  return Object.fromEntries(files.map((file) => {
    const csv = readFileSync(`${folder}/${file}`, 'utf8');
    return [file.slice(0, -'.csv'.length), { csv, rows: parseTable(csv) }];
  }));
}

/** Rows whose case could be measured. @param {Row[]} rows */
export const measured = (rows) => rows.filter(({ failed = null }) => failed === null);
