// SPDX-License-Identifier: GPL-3.0-or-later
// Part of the build: draws the figures of study.html from the measured tables, states the findings, and writes figures
// and tables next to the page.
import { decoderRates } from './decoder_rates.js';
import { drawFigure } from './draw.js';
import { kWidths } from './figure.js';
import { kFigures } from './figures.js';
import { kFindings } from './findings.js';
import { figureMarkup, findingMarkup, linkMarkup, missingMarkup, tableMarkup, textMarkup } from './markup.js';
import { cases, kLanguages, models, said } from './say.js';
import { kLiteral } from './methods.js';
import { kStatements } from './statements.js';
import { measured, readTables } from './table.js';

/** @typedef {import('./table.js').Row} Row */
/** @typedef {import('./say.js').Said} Said */
/** @typedef {import('./table.js').Table} Table */

const kFolder = 'study';
const kRatesFile = `${kFolder}/carved_qr_rates.csv`;

/**
 * True if each of the figure's columns has a value.
 * @param {import('./figure.js').Figure} figure
 * @param {Row[]} rows
 */
const isShowable = ({ measures }, rows) =>
  measures.every((measure) => rows.some((row) => (row[measure] ?? null) !== null));

/** @param {Record<string, Table>} tables @returns {Record<string, Row[]>}  by table */
const measuredRows = (tables) =>
  Object.fromEntries(Object.entries(tables).map(([table, { rows }]) => [table, measured(rows)]));

/**
 * Returns the verdict on a statement, and the reason where it does not hold.
 * @param {import('./compare.js').Tally} tally
 * @param {import('./say.js').Word | undefined} why
 * @param {boolean} isMeasured  true if the statement's table is there
 * @returns {Said[]}
 */
function verdictOn({ holds, of }, why, isMeasured) {
  if (of === 0) return why && isMeasured ? [said(why)] : [];
  if (holds === of) return [said('claimHolds')];
  return [said(holds === 0 ? 'claimFails' : 'claimInPart'), ...(why ? [said(why)] : [])];
}

/**
 * Says how often a statement holds.
 * @param {import('./compare.js').Tally} tally
 * @param {import('./statements.js').Statement['over']} over
 * @param {import('./say.js').Word} none  if nothing can be judged
 */
function countWords(tally, over, none) {
  if (tally.of === 0) return said(none);
  return over === 'models' ? models(tally) : cases(tally);
}

/**
 * Returns the paper's statements, and how often each holds; with its search taken literally, where that was measured.
 * @param {Record<string, Row[]>} rowsOf  by table
 */
function statementsMarkup(rowsOf) {
  const judged = kStatements.map((statement) => {
    const rows = rowsOf[statement.table] ?? [];
    const literally = statement.hasSearch ? statement.judge(rows, kLiteral) : { holds: 0, of: 0 };
    return { statement, isMeasured: rows.length > 0, counted: statement.judge(rows), literally };
  });
  const literal = judged.filter(({ literally }) => literally.of > 0).map(({ statement }) => statement.section);
  const ifLiteral = (/** @type {any} */ cell) => (literal.length > 0 ? [cell] : []);
  const lines = judged.map(({ statement: { claim, section, over, why }, isMeasured, counted, literally }) => {
    const link = { words: said(/** @type {any} */ (`section-${section}`)), section };
    return [
      { words: [said(claim)] },
      { words: [countWords(counted, over, isMeasured ? 'claimNothingToCompare' : 'claimNotMeasured')] },
      ...ifLiteral({ words: [countWords(literally, over, 'ratesNone')] }),
      { words: verdictOn(counted, why, isMeasured), link },
    ];
  });
  const head = [said('claimPaper'), said('claimCount'), ...ifLiteral(said('claimCountLiteral')), said('claimVerdict')];
  const list = [...new Set(literal)].map((section) => said(/** @type {any} */ (`section-${section}`)));
  return `<div class="statements">${tableMarkup(head, lines)}</div>
${ifLiteral(textMarkup([said('claimLiteralIn', { list })])).join('')}`;
}

/** Returns the findings whose tables are there. @param {Record<string, Row[]>} rowsOf  by table */
function findingsMarkup(rowsOf) {
  const found = kFindings.flatMap(({ section, find }) => {
    const finding = find(rowsOf);
    return finding ? [findingMarkup(finding, section)] : [];
  });
  return found.length > 0 ? found.join('\n') : missingMarkup();
}

/** @param {Row[]} rows */
function decoderRatesMarkup(rows) {
  const { head, body, pictures, wrong } = decoderRates(rows);
  if (body.length === 0) return missingMarkup();
  return `${textMarkup([said('ratesShown', { pictures }), wrong === 0 ? said('ratesNoneWrong') : said('ratesWrong', { count: wrong })])}
<div class="scroll" tabindex="0" role="region" aria-label="CarvedQR">${tableMarkup(
    head,
    body.map((line) => line.map((words) => ({ words: [words] }))),
  )}</div>
${linkMarkup(kRatesFile, said('download', { count: rows.length }))}`;
}

/**
 * Returns the page's content for these tables.
 * @param {Record<string, Table>} tables  by name
 * @returns {Promise<{ files: Map<string, string>, markup: Map<string, string> }>}  contents by path; markup by figure, and of
 *   `findings`, and of the tables `statements` and `decoderRates`
 */
export async function makeStudy(tables) {
  /** @type {Map<string, string>} */ const files = new Map();
  /** @type {Map<string, string>} */ const markup = new Map();
  const rowsOf = measuredRows(tables);
  for (const figure of kFigures) {
    const rows = rowsOf[figure.table] ?? [];
    if (!isShowable(figure, rows)) {
      markup.set(figure.name, missingMarkup());
      continue;
    }
    /** @type {any} */ const drawn = {};
    for (const language of kLanguages) {
      drawn[language] = {};
      for (const width of /** @type {(keyof typeof kWidths)[]} */ (Object.keys(kWidths))) {
        const { svg, ...size } = await drawFigure(figure, rows, language, width, rowsOf);
        const path = `${kFolder}/${figure.name}.${language}.${width}.svg`;
        files.set(path, svg);
        drawn[language][width] = { path, ...size };
      }
    }
    const {
      csv,
      rows: { length: cases },
    } = tables[figure.table];
    const path = `${kFolder}/${figure.table}.csv`;
    files.set(path, csv);
    const values = figure.find(rows, rowsOf);
    markup.set(
      figure.name,
      figureMarkup({ figure, drawn, found: values, table: { path, cases, failed: cases - rows.length } }),
    );
  }
  markup.set('findings', findingsMarkup(rowsOf));
  markup.set('statements', statementsMarkup(rowsOf));
  markup.set('decoderRates', decoderRatesMarkup(rowsOf.carved_qr_rates ?? []));
  if (tables.carved_qr_rates) files.set(kRatesFile, tables.carved_qr_rates.csv);
  return { files, markup };
}

/**
 * Fills empty elements that name a figure.
 * @param {string} html
 * @param {Map<string, string>} markup  by figure
 * @throws {Error} for an unknown figure
 */
export const fillFigures = (html, markup) =>
  html.replace(/<div data-figure="(\w+)"><\/div>/g, (_, figure) => {
    const block = markup.get(figure);
    if (block === undefined) throw new Error(`There is no figure "${figure}"`);
    return block;
  });

/**
 * @param {{ tables: string }} options  folder of the tables
 * @returns {import('vite').Plugin}
 */
export function study({ tables }) {
  /** @type {ReturnType<typeof makeStudy> | undefined} */ let pages;
  const make = () => (pages ??= makeStudy(readTables(tables)));
  return {
    name: 'qrelief-study',
    transformIndexHtml: {
      order: 'post', // otherwise Vite would look for the pictures itself
      handler: async (html, { path }) =>
        path.endsWith('study.html') ? fillFigures(html, (await make()).markup) : html,
    },
    async generateBundle() {
      for (const [fileName, source] of (await make()).files) this.emitFile({ type: 'asset', fileName, source });
    },
    configureServer(server) {
      server.middlewares.use(`/${kFolder}`, async (request, response, next) => {
        const path = `${kFolder}${(request.url ?? '').split('?')[0]}`;
        const content = path.endsWith('.svg') || path.endsWith('.csv') ? (await make()).files.get(path) : undefined;
        if (content === undefined) next();
        else response.setHeader('Content-Type', path.endsWith('.svg') ? 'image/svg+xml' : 'text/csv').end(content);
      });
    },
  };
}
